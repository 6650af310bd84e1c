// SPDX-License-Identifier: BSD-3-Clause
#include "ask/constraint_choice.h"

#include "model/message_text.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

namespace parallel_aspects::ask {

std::string constraint_names() {
  std::string text;
  for (const ConstraintKind kind : all_constraint_kinds) text += std::string(name(kind)) + ", ";
  return text + "all or none";
}

namespace {

/// The kinds that are named in `text`; `all` are those that the robot has.
ConstraintKinds kinds_in(const std::string& field, std::string text, ConstraintKinds all,
                         ProblemList& problems) {
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
      problems.push_back({ProblemKind::value, field, "{" + field + "} names '" + given(word) + "'",
                          "give some of " + constraint_names()});
  }
  return kinds;
}

/// Those that the two fields leave.
ConstraintKinds chosen_kinds(const ConstraintChoice& choice, ConstraintKinds all, ProblemList& problems) {
  const ConstraintKinds kinds =
      choice.only.empty() ? all : kinds_in("constraint", choice.only, all, problems);
  return kinds & ~kinds_in("no_constraint", choice.without, all, problems);
}

/// Whether margins are named in `text` by their own name.
bool names_margins(const std::string& text) {
  ProblemList said_elsewhere;
  return kinds_in("", text, {}, said_elsewhere)[index_of(ConstraintKind::margins)];
}

/// Margins can be given by a field, and links of a planar robot can be tested without being stated.
bool can_be_added(ConstraintKind kind, bool has_margins, const Manipulator& robot) {
  return kind == ConstraintKind::margins
             ? has_margins
             : kind == ConstraintKind::self_collision && is_planar(robot.task_space());
}

void require(ConstraintKinds kinds, bool has_margins, const Manipulator& robot, ProblemList& problems) {
  const ConstraintKinds known = robot.constraint_kinds();
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kinds[index_of(kind)] && !known[index_of(kind)] && !can_be_added(kind, has_margins, robot))
      problems.push_back(
          {ProblemKind::robot, "constraint",
           "{constraint} names " + std::string(name(kind)) + ", but '" + given(robot.name()) + "' has none",
           "state them in the robot's YAML or URDF, or leave the name out"});
}

/// Those that are named over those that hold without.
Margins margins_over(const std::vector<HeldCoordinate>& values, Margins margins, ProblemList& problems) {
  std::set<std::string> names;
  for (const HeldCoordinate& each : values) {
    const auto found = std::find_if(named_margins.begin(), named_margins.end(),
                                    [&each](const NamedMargin& margin) { return margin.name == each.name; });
    if (found == named_margins.end())
      problems.push_back({ProblemKind::value, "margin",
                          "{margin} has '" + given(each.name) + "=" + number_text(each.value) + "'",
                          "give some of parallel, serial and det_a, such as \"parallel=0.05 serial=0.1\""});
    else if (!names.insert(each.name).second)
      problems.push_back(
          {ProblemKind::value, "margin", "{margin} names " + each.name + " twice", "give one value for it"});
    else
      margins.*found->member = each.value;
  }
  return margins;
}

void check_tolerance(const std::vector<double>& tolerance, ProblemList& problems) {
  constexpr double largest = 0.1;
  if (tolerance.empty() || (tolerance.size() == 1 && tolerance[0] >= 0.0 && tolerance[0] <= largest)) return;
  problems.push_back({ProblemKind::value, "tolerance", "{tolerance} is not from 0 to 0.1",
                      "give a share of the robot's size such as 0.001"});
}

}  // namespace

std::shared_ptr<const Manipulator> constrained(std::shared_ptr<const Manipulator> robot,
                                               const ConstraintChoice& choice, ProblemList& problems) {
  const bool has_margins = !choice.margins.empty();
  const ConstraintKinds all = robot->constraint_kinds(), kinds = chosen_kinds(choice, all, problems);
  require(kinds, has_margins, *robot, problems);
  if (has_margins && names_margins(choice.without))
    problems.push_back({ProblemKind::together, "margin",
                        "{margin} sets margins and {no_constraint} leaves them out", "give one of the two"});
  const bool keeps = kinds[index_of(ConstraintKind::margins)];
  const Margins margins =
      margins_over(choice.margins, keeps ? robot->constraints().margins : Margins(), problems);
  check_tolerance(choice.tolerance, problems);
  if (!problems.empty()) return robot;
  if (!choice.tolerance.empty()) robot = robot->with_tolerance(choice.tolerance[0]);
  if (kinds != all) robot = robot->with_constraints(kinds);
  return has_margins ? robot->with_margins(margins) : robot;
}

void refuse_tolerance(const ConstraintChoice& choice, const Manipulator& robot, ProblemList& problems) {
  if (robot.tolerance() == 0.0) return;
  const std::string start = "Direct solutions are those of one robot, without tolerances";
  if (choice.tolerance.empty())
    problems.push_back({ProblemKind::robot, "tolerance", start,
                        "'" + given(robot.name()) + "' has one, so give {tolerance} 0"});
  else
    problems.push_back({ProblemKind::together, "tolerance", start, "leave {tolerance} out"});
}

// A margin that a field states goes with the field; leaving out constraints does not go with it.
void refuse_other_bounds(const ConstraintChoice& choice, const Manipulator& robot, ProblemList& problems) {
  std::string others;
  bool has_margin = false;
  for (const ConstraintKind kind : all_constraint_kinds) {
    if (kind == ConstraintKind::actuated_limits || !robot.constraint_kinds()[index_of(kind)]) continue;
    if (kind == ConstraintKind::margins && !choice.margins.empty())
      has_margin = true;
    else
      others += (others.empty() ? "" : ",") + std::string(name(kind));
  }
  const std::string start =
      "Cusps and regions of actuated values are bounded by limits of actuated joints alone";
  if (has_margin) problems.push_back({ProblemKind::together, "margin", start, "leave {margin} out"});
  const std::string left_out = (choice.without.empty() ? "" : choice.without + ",") + others;
  if (!others.empty())
    problems.push_back({ProblemKind::robot, "no_constraint",
                        start + ", but '" + given(robot.name()) + "' has " + others,
                        "give {no_constraint} \"" + left_out + "\""});
  refuse_tolerance(choice, robot, problems);
}

}  // namespace parallel_aspects::ask
