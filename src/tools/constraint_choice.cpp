// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"
#include "tools/numbers.h"

#include <algorithm>
#include <optional>
#include <set>
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

/// Those that the two options leave.
ConstraintKinds chosen_kinds(const ConstraintArguments& arguments, ConstraintKinds all, Problems& problems) {
  const ConstraintKinds kinds =
      arguments.only.empty() ? all : parse_kinds("--constraint", arguments.only, all, problems);
  return kinds & ~parse_kinds("--no-constraint", arguments.without, all, problems);
}

/// Whether margins are named in `text` by their own name.
bool names_margins(const std::string& text) {
  Problems said_elsewhere;
  return parse_kinds("", text, {}, said_elsewhere)[index_of(ConstraintKind::margins)];
}

/// Margins can be given by an option, and links of a planar robot can be tested without being told of.
bool can_be_added(ConstraintKind kind, bool has_margins, const Manipulator& manipulator) {
  return kind == ConstraintKind::margins
             ? has_margins
             : kind == ConstraintKind::self_collision && is_planar(manipulator.task_space());
}

void require(ConstraintKinds kinds, bool has_margins, const Manipulator& manipulator, Problems& problems) {
  const ConstraintKinds known = manipulator.constraint_kinds();
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kinds[index_of(kind)] && !known[index_of(kind)] && !can_be_added(kind, has_margins, manipulator))
      problems.push_back("--constraint names " + std::string(name(kind)) + ", but '" + manipulator.name() +
                         "' has none; state them in the robot's YAML or URDF, or leave the name out.");
}

/// The margins that an option names, over those that hold without it.
class NamedMargins {
 public:
  NamedMargins(std::string option, const Margins& others, Problems& problems)
      : option_(std::move(option)), margins_(others), problems_(problems) {}

  void read(const std::string& word) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto found = std::find_if(named_margins.begin(), named_margins.end(),
                                    [&name](const NamedMargin& margin) { return margin.name == name; });
    if (equals == std::string::npos || found == named_margins.end())
      return problems_.push_back(option_ + " has '" + word +
                                 "'; give some of parallel, serial and det_a, such as "
                                 "\"parallel=0.05 serial=0.1\".");
    if (!named_.insert(name).second)
      return problems_.push_back(option_ + " names " + name + " twice; give one value for it.");
    const auto value = parse_numbers(option_, word.substr(equals + 1), {name}, problems_);
    if (!value.empty()) margins_.*found->member = value.front();
  }

  const Margins& margins() const noexcept { return margins_; }

 private:
  std::string option_;
  Margins margins_;
  Problems& problems_;
  std::set<std::string> named_;
};

std::optional<double> parse_tolerance(const std::string& text, Problems& problems) {
  if (text.empty()) return std::nullopt;
  const auto value = parse_numbers("--tolerance", text, {"the share"}, problems);
  if (value.empty()) return std::nullopt;
  if (value.front() >= 0.0 && value.front() <= 0.1) return value.front();
  problems.push_back("--tolerance is not from 0 to 0.1; give a share of the robot's size such as 0.001.");
  return std::nullopt;
}

}  // namespace

Margins parse_margins(const std::string& option, std::string text, const Margins& others,
                      Problems& problems) {
  NamedMargins margins(option, others, problems);
  for (const std::string& word : words_of_list(std::move(text))) margins.read(word);
  return margins.margins();
}

std::vector<Option> constraint_options(ConstraintArguments& arguments) {
  return {{"--constraint", "LIST",
           "Constraints that bound the aspects besides singularities, separated by commas: " + known_names() +
               "; by default all that the robot has",
           &arguments.only, false, Words::names},
          {"--no-constraint", "LIST", "Constraints to leave out", &arguments.without, false, Words::names},
          {"--margin", "LIST",
           "Least indices, each in place of the one that the robot has, such as \"parallel=0.05 "
           "serial=0.1\": |det A| "
           "over the norms of its rows and |B_jj| over its largest, 0 at singularities and 1 at most; "
           "det_a=20000: |det A| itself",
           &arguments.margins, false, Words::assignments},
          {"--tolerance", "SHARE",
           "Prove for every robot whose points and lengths differ from the description by at most this share "
           "of the robot's size, such as 0.001; by default that of the robot's YAML, or 0",
           &arguments.tolerance}};
}

std::shared_ptr<const Manipulator> choose_constraints(std::shared_ptr<const Manipulator> manipulator,
                                                      const ConstraintArguments& arguments) {
  Problems problems;
  const bool has_margins = !arguments.margins.empty();
  const ConstraintKinds all = manipulator->constraint_kinds();
  const ConstraintKinds kinds = chosen_kinds(arguments, all, problems);
  require(kinds, has_margins, *manipulator, problems);
  if (has_margins && names_margins(arguments.without))
    problems.emplace_back("--margin sets margins and --no-constraint leaves them out; give one of the two.");
  const Margins others =
      kinds[index_of(ConstraintKind::margins)] ? manipulator->constraints().margins : Margins();
  const Margins margins = parse_margins("--margin", arguments.margins, others, problems);
  const std::optional<double> tolerance = parse_tolerance(arguments.tolerance, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  if (tolerance) manipulator = manipulator->with_tolerance(*tolerance);
  if (kinds != all) manipulator = manipulator->with_constraints(kinds);
  return has_margins ? manipulator->with_margins(margins) : manipulator;
}

void refuse_tolerance(const ConstraintArguments& arguments, const Manipulator& robot, Problems& problems) {
  if (robot.tolerance() == 0.0) return;
  const std::string start = "Direct solutions are those of one robot, without tolerances; ";
  problems.push_back(start + (arguments.tolerance.empty()
                                  ? "'" + robot.name() + "' has one, so give --tolerance 0."
                                  : "leave --tolerance out."));
}

// A margin that an option states goes with the option; --no-constraint does not go with it.
void refuse_other_bounds(const ConstraintArguments& arguments, const Manipulator& robot, Problems& problems) {
  std::string others;
  bool has_margin = false;
  for (const ConstraintKind kind : all_constraint_kinds) {
    if (kind == ConstraintKind::actuated_limits || !robot.constraint_kinds()[index_of(kind)]) continue;
    if (kind == ConstraintKind::margins && !arguments.margins.empty())
      has_margin = true;
    else
      others += (others.empty() ? "" : ",") + std::string(name(kind));
  }
  const std::string start =
      "Cusps and regions of actuated values are bounded by limits of actuated joints alone";
  if (has_margin) problems.push_back(start + "; leave --margin out.");
  const std::string left_out = (arguments.without.empty() ? "" : arguments.without + ",") + others;
  if (!others.empty())
    problems.push_back(start + ", but '" + robot.name() + "' has " + others + "; give --no-constraint \"" +
                       left_out + "\".");
  refuse_tolerance(arguments, robot, problems);
}

}  // namespace parallel_aspects::tools
