// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"
#include "tools/report/numbers.h"

#include <algorithm>
#include <optional>
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

void read_margin(const std::string& option, const std::string& word, Margins& margins, Problems& problems) {
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const auto found = std::find_if(named_margins.begin(), named_margins.end(),
                                  [&name](const NamedMargin& margin) { return margin.name == name; });
  if (equals == std::string::npos || found == named_margins.end())
    return problems.push_back(option + " has '" + word +
                              "'; give some of parallel, serial and det_a, such as "
                              "\"parallel=0.05 serial=0.1\".");
  const auto value = parse_numbers(option, word.substr(equals + 1), {name}, problems);
  if (!value.empty()) margins.*found->member = value.front();
}

std::optional<double> parse_tolerance(const std::string& text, Problems& problems) {
  if (text.empty()) return std::nullopt;
  const auto value = parse_numbers("--tolerance", text, {"the share"}, problems);
  if (value.empty()) return std::nullopt;
  if (value.front() >= 0.0 && value.front() <= 0.1) return value.front();
  problems.push_back("--tolerance is not from 0 to 0.1; give a share of the robot's size such as 0.001.");
  return std::nullopt;
}

}  // namespace

Margins parse_margins(const std::string& option, std::string text, Problems& problems) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  Margins margins;
  for (std::string word; words >> word;) read_margin(option, word, margins, problems);
  return margins;
}

std::vector<Option> constraint_options(ConstraintArguments& arguments) {
  return {
      {"--constraint", "LIST",
       "Constraints that bound the aspects besides singularities, separated by commas: " + known_names() +
           "; by default all that the robot has",
       &arguments.only},
      {"--no-constraint", "LIST", "Constraints to leave out", &arguments.without},
      {"--margin", "LIST",
       "Least indices, in place of those that the robot has, such as \"parallel=0.05 serial=0.1\": |det A| "
       "over the norms of its rows and |B_jj| over its largest, 0 at singularities and 1 at most; "
       "det_a=20000: |det A| itself",
       &arguments.margins},
      {"--tolerance", "SHARE",
       "Prove for every robot whose points and lengths differ from the description by at most this share of "
       "the robot's size, such as 0.001; by default that of the robot's YAML, or 0",
       &arguments.tolerance}};
}

std::shared_ptr<const Manipulator> choose_constraints(std::shared_ptr<const Manipulator> manipulator,
                                                      const ConstraintArguments& arguments) {
  Problems problems;
  const ConstraintKinds all = manipulator->constraint_kinds();
  ConstraintKinds kinds =
      arguments.only.empty() ? all : parse_kinds("--constraint", arguments.only, all, problems);
  kinds &= ~parse_kinds("--no-constraint", arguments.without, all, problems);
  require(kinds, *manipulator, problems);
  const Margins margins = parse_margins("--margin", arguments.margins, problems);
  const std::optional<double> tolerance = parse_tolerance(arguments.tolerance, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  if (tolerance) manipulator = manipulator->with_tolerance(*tolerance);
  if (kinds != all) manipulator = manipulator->with_constraints(kinds);
  return arguments.margins.empty() ? manipulator : manipulator->with_margins(margins);
}

}  // namespace parallel_aspects::tools
