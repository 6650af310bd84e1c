// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/workspace_queries.h"

#include "ros/messages/conversions.h"
#include "ros/pictures/workspace_picture.h"

#include <parallel_aspects/LargestShape.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Request = GetRegularWorkspace::Request;

constexpr std::size_t most_numbers = 3;  // of a list

void read_center(const Request& request, const std::vector<std::string>& positions,
                 WorkspaceQuestion& question, Problems& problems) {
  if (request.held.size() != request.center.size()) {
    problems.emplace_back("held and center have different lengths; give a value for each coordinate.");
    return;
  }
  for (std::size_t i = 0; i < request.held.size(); ++i) {
    const auto found = std::find(positions.begin(), positions.end(), request.held[i]);
    if (found == positions.end())
      problems.emplace_back("held names what is no free position; give some of x, y and z.");
    else
      question.center[static_cast<std::size_t>(found - positions.begin())] = request.center[i];
  }
}

WorkspaceQuestion question_of(const AspectMap& map, const Request& request, Problems& problems) {
  WorkspaceQuestion question;
  const auto shape = shape_named(request.shape);
  if (!shape) problems.emplace_back("shape must be box, square, disc, cylinder or ball.");
  if (request.ratio.size() > most_numbers)
    problems.emplace_back("ratio has more numbers than a shape has edges.");
  if (!request.angle.empty() && request.angle.size() != 2)
    problems.emplace_back("angle takes its lower and its upper end, or nothing.");
  if (!problems.empty()) return question;
  question.shape = *shape;
  question.ratio = request.ratio;
  if (!request.angle.empty()) question.angle = AngleRange{request.angle[0], request.angle[1]};
  const std::size_t free = free_positions(*map.manipulator(), map.slice());
  const std::vector<std::string> names = map.coordinates();
  read_center(request,
              {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(free, names.size()))},
              question, problems);
  if (problems.empty()) problems = problems_of(*map.manipulator(), map.slice(), question);
  return question;
}

/// Those that are asked for; with a problem where there is none.
std::vector<int> aspects_of(const AspectMap& map, const Request& request, Problems& problems) {
  std::vector<int> ids;
  for (const Aspect& aspect : map.aspects()) {
    const bool is_mode = request.working_mode.empty() || signs_message(aspect.mode) == request.working_mode;
    const bool is_asked = request.aspect == 0 || static_cast<std::uint32_t>(aspect.id) == request.aspect;
    if (is_mode && is_asked) ids.push_back(aspect.id);
  }
  if (ids.empty())
    problems.emplace_back("The map has no such aspect; ~list_aspects names those that it has.");
  return ids;
}

LargestShape message_of(const AspectMap& map, const WorkspaceQuestion& question,
                        const RegularWorkspace& workspace) {
  LargestShape message;
  const Aspect& aspect = map.aspects()[static_cast<std::size_t>(workspace.aspect - 1)];
  message.aspect = static_cast<std::uint32_t>(aspect.id);
  message.working_mode = signs_message(aspect.mode);
  message.determinant_sign = static_cast<std::int8_t>(aspect.determinant_sign);
  message.center = pose_message(center_in_base(map, workspace));
  message.lower = workspace.lower;
  message.upper = workspace.upper;
  message.proved = workspace.proved;
  for (const auto& [name, length] : lengths_of(map, question, workspace.lower)) {
    message.names.push_back(name);
    message.lengths.push_back(length);
  }
  return message;
}

}  // namespace

WorkspaceQueries::WorkspaceQueries(ros::NodeHandle private_nh, const Manipulator& manipulator,
                                   const MapWorker& worker)
    : space_(manipulator.task_space()),
      worker_(worker),
      markers_(private_nh.advertise<visualization_msgs::MarkerArray>("regular_workspace_markers", 1, true)) {}

GetRegularWorkspace::Response WorkspaceQueries::answer(const Request& request) const {
  GetRegularWorkspace::Response response;
  const std::shared_ptr<const AspectMap> map = worker_.map();
  if (!has_map(space_))
    response.status = make_status(Status::NO_MAP, "There is no map of six degrees of freedom, now or later.");
  else if (!map)
    response.status =
        make_status(Status::MAP_NOT_READY, "There is no map yet. " + worker_.progress().message);
  else
    response.status = find(*map, request, response);
  return response;
}

Status WorkspaceQueries::find(const AspectMap& map, const Request& request,
                              GetRegularWorkspace::Response& response) const {
  Problems problems;
  const WorkspaceQuestion question = question_of(map, request, problems);
  if (!std::isfinite(request.gap) || request.gap < 0.0 || request.gap >= 1.0)
    problems.emplace_back("gap must be from 0 to below 1; 0 stands for 0.01.");
  const std::vector<int> ids = aspects_of(map, request, problems);
  if (!problems.empty()) return invalid_request(problems.front());
  WorkspaceOptions options;
  if (request.gap > 0.0) options.gap = request.gap;
  options.control.cancelled = &cancelled_;
  const auto found = find_regular_workspaces(map, ids, question, options);
  if (!found) return make_status(Status::CANCELLED, "The node ends, or takes up another robot.");
  const auto best = std::max_element(found->begin(), found->end(),
                                     [](const auto& a, const auto& b) { return a.lower < b.lower; });
  for (const RegularWorkspace& each : *found) response.shapes.push_back(message_of(map, question, each));
  response.best = best->lower > 0.0 ? static_cast<std::uint32_t>(best->aspect) : 0;
  markers_.publish(workspace_markers(map, question, *best));
  return Status();
}

}  // namespace parallel_aspects
