// SPDX-License-Identifier: BSD-3-Clause
#include "ros/questions/map_queries.h"

#include "ros/messages/conversions.h"
#include "ros/messages/map_messages.h"
#include "ros/pictures/answer_pictures.h"

#include <parallel_aspects/LargestShape.h>

#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

GetMap::Response MapQueries::answer(const GetMap::Request& request) const {
  GetMap::Response response;
  const Manipulator& manipulator = *setup_.mechanism->manipulator();
  response.urdf = setup_.urdf;
  response.description = setup_.description;
  response.base_frame = manipulator.base_frame();
  response.task_space = std::string(name(manipulator.task_space()));
  const std::shared_ptr<const AspectMap> map = worker_.map();
  if (!map) {
    response.status = worker_.why_no_map();
    return response;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (map == known_ && request.known_revision == revision_) {
    response.revision = revision_;
    return response;
  }
  add_map(*map, response);
  known_ = map;
  revision_ = response.revision;
  if (response.revision == request.known_revision) response.map.clear();
  return response;
}

namespace {

using Request = GetRegularWorkspace::Request;

/// As the fields of a request.
std::string field_of_request(const std::string& field) {
  return field == "aspect_ratio"  ? "ratio"
         : field == "orientation" ? "angle"
         : field == "center"      ? "held and center"
         : field == "mode"        ? "working_mode"
                                  : field;
}

Status read(const AspectMap& map, const Request& request, ask::LargestShapeQuestion& question) {
  std::string names;
  question.shape.shape = ask::choice_named<RegularShape>(request.shape, names);
  if (!question.shape.shape) return invalid_request("shape must be " + names + ".");
  if (request.held.size() != request.center.size())
    return invalid_request("held and center have different lengths; give a value for each coordinate.");
  for (std::size_t i = 0; i < request.held.size(); ++i)
    question.shape.center.push_back({request.held[i], request.center[i]});
  if (!request.angle.empty() && request.angle.size() != 2)
    return invalid_request("angle takes its lower and its upper end, or nothing.");
  if (!request.angle.empty())
    question.shape.orientation.push_back({map.coordinates().back(), request.angle[0], request.angle[1]});
  question.shape.aspect_ratio = request.ratio;
  if (*question.shape.shape == RegularShape::cylinder && request.ratio.size() == 1)
    question.shape.aspect_ratio = {1.0, request.ratio[0]};
  if (request.gap != 0.0) question.shape.gap = request.gap;
  if (request.aspect != 0) question.aspects.emplace_back().value = request.aspect;
  if (request.working_mode.empty()) return {};
  const auto mode = WorkingMode::from_signs({request.working_mode.begin(), request.working_mode.end()});
  if (!mode) return invalid_request("working_mode must have a sign, 1 or -1, for each leg, or be empty.");
  question.modes = {*mode};
  return {};
}

LargestShape message_of(const AspectMap& map, const ask::ShapeInAspect& shape) {
  LargestShape message;
  message.aspect = static_cast<std::uint32_t>(shape.found.aspect);
  message.working_mode = signs_message(shape.mode);
  message.determinant_sign = static_cast<std::int8_t>(shape.determinant_sign);
  message.center = pose_message(center_in_base(map, shape.found));
  message.lower = shape.found.lower;
  message.upper = shape.found.upper;
  message.proved = shape.found.proved;
  for (const auto& [name, length] : shape.lengths) {
    message.names.push_back(name);
    message.lengths.push_back(length);
  }
  return message;
}

}  // namespace

WorkspaceQueries::WorkspaceQueries(ros::NodeHandle private_nh, const MapWorker& worker)
    : worker_(worker),
      markers_(private_nh.advertise<visualization_msgs::MarkerArray>("regular_workspace_markers", 1, true)) {}

GetRegularWorkspace::Response WorkspaceQueries::answer(const Request& request) const {
  GetRegularWorkspace::Response response;
  const std::shared_ptr<const AspectMap> map = worker_.map();
  response.status = map ? find(map, request, response) : worker_.why_no_map();
  return response;
}

Status WorkspaceQueries::find(const std::shared_ptr<const AspectMap>& map, const Request& request,
                              GetRegularWorkspace::Response& response) const {
  ask::LargestShapeQuestion question;
  const Status read_status = read(*map, request, question);
  if (read_status.code != Status::OK) return read_status;
  ask::Session session(map->manipulator());
  session.know(map);
  ask::Control control;
  control.cancelled = &cancelled_;
  const auto outcome = ask::answer(session, question, control);
  if (outcome.status == MapStatus::cancelled)
    return make_status(Status::CANCELLED, "The node ends, or takes up another robot.");
  if (!outcome && outcome.problems.front().field == "aspect")
    return invalid_request("The map has no such aspect; ~list_aspects names those that it has.");
  if (!outcome) return invalid_request(text_of(outcome.problems.front(), field_of_request));
  const ask::LargestShapeAnswer& answer = outcome.answer;
  for (const ask::ShapeInAspect& each : answer.workspaces) response.shapes.push_back(message_of(*map, each));
  const ask::ShapeInAspect* best = answer.best();
  response.best = best == nullptr ? 0 : static_cast<std::uint32_t>(best->found.aspect);
  markers_.publish(
      workspace_markers(*map, answer.question, best == nullptr ? RegularWorkspace() : best->found));
  return {};
}

}  // namespace parallel_aspects
