// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace parallel_aspects::tools {
namespace {

std::string known_names() {
  std::string text;
  for (const ConstraintKind kind : all_constraint_kinds) text += std::string(name(kind)) + ", ";
  return text + "all or none";
}

/// The kinds that are named in `text`; `all` are those that the robot has.
ConstraintKinds parse_kinds(const std::string& option, std::string text, ConstraintKinds all,
                            Problems& problems) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  ConstraintKinds kinds;
  for (std::string word; words >> word;) {
    const auto kind = constraint_named(word);
    if (word == "all")
      kinds |= all;
    else if (kind)
      kinds[index_of(*kind)] = true;
    else if (word != "none")
      problems.push_back(option + " names '" + word + "'; give some of " + known_names() + ".");
  }
  return kinds;
}

/// Links of a planar robot can be tested without being told of.
bool can_be_added(ConstraintKind kind, const Manipulator& manipulator) {
  return kind == ConstraintKind::self_collision && is_planar(manipulator.task_space());
}

void require(ConstraintKinds kinds, const Manipulator& manipulator, Problems& problems) {
  const ConstraintKinds known = manipulator.constraint_kinds();
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kinds[index_of(kind)] && !known[index_of(kind)] && !can_be_added(kind, manipulator))
      problems.push_back("--constraint names " + std::string(name(kind)) + ", which '" + manipulator.name() +
                         "' has none of; state it in the robot's YAML or URDF, or leave it out.");
}

}  // namespace

std::vector<Option> constraint_options(ConstraintArguments& arguments) {
  return {{"--constraint", "LIST",
           "Constraints that bound the aspects besides singularities, separated by commas: " + known_names() +
               "; by default all that the robot has",
           &arguments.only},
          {"--no-constraint", "LIST", "Constraints to leave out", &arguments.without}};
}

std::shared_ptr<const Manipulator> choose_constraints(std::shared_ptr<const Manipulator> manipulator,
                                                      const ConstraintArguments& arguments) {
  Problems problems;
  const ConstraintKinds all = manipulator->constraint_kinds();
  ConstraintKinds kinds =
      arguments.only.empty() ? all : parse_kinds("--constraint", arguments.only, all, problems);
  kinds &= ~parse_kinds("--no-constraint", arguments.without, all, problems);
  require(kinds, *manipulator, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return kinds == all ? manipulator : manipulator->with_constraints(kinds);
}

}  // namespace parallel_aspects::tools
