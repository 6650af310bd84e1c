// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/workspace.h"

#include "model/message_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace parallel_aspects::ask {
namespace {

using Names = std::vector<std::string>;

/// As the library has it: of a cylinder its height over its diameter.
void take_ratio(const std::vector<double>& given, std::size_t free, WorkspaceQuestion& question,
                ProblemList& problems) {
  const bool stands = question.shape == RegularShape::cylinder;
  question.ratio = given;
  if (given.empty()) return;
  if (given.size() != (stands ? 2 : free))
    problems.push_back(
        {ProblemKind::value, "aspect_ratio",
         "{aspect_ratio} has " + std::to_string(given.size()) + (given.size() == 1 ? " number" : " numbers"),
         stands ? "give two, diameter and height"
                : "give " + std::to_string(free) + ", an edge for each free position"});
  else if (stands)
    question.ratio = {given[1] / given[0]};
}

void take_center(const std::vector<HeldCoordinate>& held, const Names& positions, WorkspaceQuestion& question,
                 ProblemList& problems) {
  for (const HeldCoordinate& each : held) {
    const auto found = std::find(positions.begin(), positions.end(), each.name);
    if (found == positions.end())
      problems.push_back(
          {ProblemKind::value, "center", "{center} has '" + each.name + "=" + number_text(each.value) + "'",
           "give free positions with their values, such as \"" + positions.front() + "=0.5\""});
    else
      question.center[static_cast<std::size_t>(found - positions.begin())] = each.value;
  }
}

void take_angle(const std::vector<NamedRange>& given, const Names& names, std::size_t free,
                WorkspaceQuestion& question, ProblemList& problems) {
  if (given.empty()) return;
  if (names.size() <= free)
    return problems.push_back({ProblemKind::robot, "orientation",
                               "{orientation} is of a free angle, but none is free here", "leave it out"});
  if (given.size() > 1 || given.front().name != names[free])
    return problems.push_back({ProblemKind::value, "orientation",
                               "{orientation} is not one range of " + names[free],
                               "give \"" + names[free] + "=-0.2:0.2\", in rad"});
  question.angle = AngleRange{given.front().lower, given.front().upper};
}

}  // namespace

WorkspaceQuestion ShapeQuestion::of(const Manipulator& robot, const std::optional<MapSlice>& slice,
                                    ProblemList& problems) const {
  WorkspaceQuestion question;
  ProblemList own;
  if (gap && !(*gap > 0.0 && *gap < 1.0))
    problems.push_back(
        {ProblemKind::value, "gap", "{gap} is a share of the size", "give one below 1, such as 0.01"});
  if (!shape) {
    problems.push_back(
        {ProblemKind::missing, "shape", "{shape} is required", "give box, square, disc, cylinder or ball"});
    return question;
  }
  question.shape = *shape;
  add_told(problems_of(robot, slice, question), own);
  if (own.empty()) {
    const std::size_t free = free_positions(robot, slice);
    const Names names = slice ? coordinate_names(*slice) : coordinate_names(robot.task_space());
    take_ratio(aspect_ratio, free, question, own);
    take_center(center, {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(free)}, question, own);
    take_angle(orientation, names, free, question, own);
    if (own.empty()) add_told(problems_of(robot, slice, question), own);
  }
  problems.insert(problems.end(), own.begin(), own.end());
  return question;
}

const ShapeInAspect* LargestShapeAnswer::best() const noexcept {
  const auto best = std::max_element(
      workspaces.begin(), workspaces.end(),
      [](const ShapeInAspect& a, const ShapeInAspect& b) { return a.found.lower < b.found.lower; });
  return best == workspaces.end() || best->found.lower <= 0.0 ? nullptr : &*best;
}

namespace {

bool contains_mode(const std::vector<WorkingMode>& modes, const WorkingMode& mode) {
  return modes.empty() || std::find(modes.begin(), modes.end(), mode) != modes.end();
}

/// Those that are asked for, by their ids.
std::vector<int> aspects_of(const AspectMap& map, const LargestShapeQuestion& question,
                            ProblemList& problems) {
  const std::size_t count = map.aspects().size();
  std::vector<int> ids;
  for (const auto& each : question.aspects) {
    if (each.value <= count)
      ids.push_back(static_cast<int>(each.value));
    else
      problems.push_back({ProblemKind::value, "aspect",
                          "{aspect} is " + std::to_string(each.value) + ", but the map has " +
                              std::to_string(count) + (count == 1 ? " aspect" : " aspects") +
                              ", counted from 1",
                          "`aspects map` lists them"});
  }
  if (question.aspects.empty())
    for (const Aspect& aspect : map.aspects()) ids.push_back(aspect.id);
  const auto is_of_other_mode = [&](int id) {
    return !contains_mode(question.modes, map.aspects()[static_cast<std::size_t>(id - 1)].mode);
  };
  ids.erase(std::remove_if(ids.begin(), ids.end(), is_of_other_mode), ids.end());
  if (ids.empty() && problems.empty() && !(question.modes.empty() && question.aspects.empty()))
    problems.push_back(
        {ProblemKind::together, "mode", "The map has no such aspect in {mode}", "leave {mode} out"});
  return ids;
}

ShapeInAspect described(const AspectMap& map, const WorkspaceQuestion& question,
                        const RegularWorkspace& found) {
  const Aspect& aspect = map.aspects()[static_cast<std::size_t>(found.aspect - 1)];
  ShapeInAspect result{found,          aspect.mode, aspect.determinant_sign,
                       question.shape, {},          lengths_of(map, question, found.lower)};
  const Names names = map.coordinates();
  for (std::size_t i = 0; found.lower > 0.0 && i < free_positions(*map.manipulator(), map.slice()); ++i)
    result.center.push_back({names[i], found.center[i]});
  return result;
}

}  // namespace

Outcome<LargestShapeAnswer> answer(Session& session, const LargestShapeQuestion& question,
                                   const Control& control) {
  ProblemList problems;
  LargestShapeAnswer result;
  result.task_space = session.robot()->task_space();
  result.slice = session.slice_of(question.map);
  result.question = question.shape.of(*session.robot(), result.slice, problems);
  FoundMap map;
  if (problems.empty()) map = session.map(question.map, question.modes, control, problems);
  if (!map.map) return outcome_of(std::move(problems), control, std::move(result));
  result.map = map.map;
  result.loaded = map.loaded;
  const std::vector<int> ids = aspects_of(*map.map, question, problems);
  if (!problems.empty()) return outcome_of(std::move(problems), control, std::move(result));
  WorkspaceOptions options;
  if (question.shape.gap) options.gap = *question.shape.gap;
  result.gap = options.gap;
  options.control = control.begin("Looking for the largest shapes.");
  if (const auto found = find_regular_workspaces(*map.map, ids, result.question, options))
    for (const RegularWorkspace& each : *found)
      result.workspaces.push_back(described(*map.map, result.question, each));
  return outcome_of(std::move(problems), control, std::move(result));
}

}  // namespace parallel_aspects::ask
