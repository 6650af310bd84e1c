// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/queries.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/configurations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

ConfigurationAnswer refusal(std::uint8_t code, std::string message) {
  return {make_status(code, std::move(message)), {}, {}};
}

RoadmapComponents components_message(const RoadmapSide& side) {
  RoadmapComponents message;
  message.working_mode = signs_message(side.mode);
  message.determinant_sign = static_cast<std::int8_t>(side.determinant_sign);
  message.component_sizes.assign(side.component_sizes.begin(), side.component_sizes.end());
  return message;
}

// Whether one of the configurations has this working mode and sign.
bool any_on(const std::vector<SolvedConfiguration>& solutions, const RoadmapComponents& side) {
  return std::any_of(solutions.begin(), solutions.end(), [&](const SolvedConfiguration& solution) {
    return solution.working_mode == side.working_mode && solution.determinant_sign == side.determinant_sign;
  });
}

void list_aspects(const Manipulator& manipulator, const AspectMap& map, const ListAspects::Request& request,
                  const std::vector<SolvedConfiguration>& solutions, ListAspects::Response& response) {
  const auto holds_one = [&](const Aspect& aspect) {
    return std::any_of(solutions.begin(), solutions.end(), [&](const SolvedConfiguration& solution) {
      return solution.aspect == static_cast<std::uint32_t>(aspect.id);
    });
  };
  for (const Aspect& aspect : map.aspects())
    if (!request.at_configuration || holds_one(aspect))
      response.aspects.push_back(summary_message(manipulator, aspect));
  response.count_at_most = count_at_most(map);
  response.measure_undecided = map.measure_undecided();
}

}  // namespace

Queries::Queries(std::shared_ptr<const Manipulator> manipulator, RobotMonitor& monitor,
                 const MapWorker& worker, PoseTransformer to_base, bool read_only)
    : manipulator_(std::move(manipulator)),
      monitor_(monitor),
      worker_(worker),
      to_base_(std::move(to_base)),
      read_only_(read_only),
      session_(manipulator_) {}

ConfigurationAnswer Queries::resolve(const Configuration& configuration) const {
  const std::string fault = fault_of(*manipulator_, configuration);
  if (!fault.empty()) return refusal(Status::INVALID_REQUEST, fault);
  StatedSigns stated = stated_signs(configuration);
  // The working mode has chosen the joint values at a pose, also where a leg is stretched and has no sign.
  if (configuration.kind == Configuration::POSE) stated.working_mode.clear();
  ConfigurationAnswer answer = as_stated(*manipulator_, resolve_kind(configuration), stated);
  if (answer.status.code == Status::OK && answer.status.message.empty())
    answer.status.message = beyond_limits(*manipulator_, answer.configurations.front().q);
  if (answer.status.code == Status::OK && answer.status.message.empty())
    answer.status.message = beyond_margins(*manipulator_, answer.configurations);
  return answer;
}

ConfigurationAnswer Queries::resolve_kind(const Configuration& configuration) const {
  if (configuration.kind == Configuration::NOW) return resolve_now();
  return configuration.kind == Configuration::POSE ? resolve_pose(configuration)
                                                   : resolve_joints(configuration);
}

ConfigurationAnswer Queries::resolve_now() const {
  const CurrentConfiguration current = monitor_.current(ros::Time::now());
  ConfigurationAnswer answer{current.status, current.stamp, {}};
  if (current.status.code == Status::OK) answer.configurations = {current.solved};
  return answer;
}

ConfigurationAnswer Queries::resolve_pose(const Configuration& configuration) const {
  Pose pose;
  const Status read = read_pose(*manipulator_, to_base_, configuration.pose, "The pose", pose);
  if (read.code != Status::OK) return refusal(read.code, read.message);
  ConfigurationAnswer answer = configurations_at_pose(*manipulator_, pose, configuration.working_mode);
  answer.stamp = ros::Time::now();
  if (answer.status.code == Status::OK && !read.message.empty()) answer.status.message = read.message;
  return answer;
}

ConfigurationAnswer Queries::resolve_joints(const Configuration& configuration) const {
  const JointSample sample =
      actuated_values(*manipulator_, configuration.joint_names, configuration.joint_positions);
  if (sample.status != SampleStatus::usable)
    return refusal(Status::INVALID_REQUEST, "The joints cannot be used: " + sample.message);
  ConfigurationAnswer answer = configurations_at_joints(*manipulator_, sample.q);
  answer.stamp = ros::Time::now();
  return answer;
}

std::vector<SolvedConfiguration> Queries::solutions(const ConfigurationAnswer& answer,
                                                    const KnownAspects& known) const {
  std::vector<SolvedConfiguration> messages;
  for (const SolvedPose& solved : answer.configurations) {
    messages.push_back(solved_message(*manipulator_, solved, known.map.get(), answer.stamp));
    if (!has_map(manipulator_->task_space()))
      report_component(*manipulator_, solved, known.roadmap.get(), messages.back());
  }
  return messages;
}

// With OK and NO_MAP there is something to answer.
Status Queries::map_status(const KnownAspects& known) const {
  if (known.map) return {};
  const std::string message = worker_.progress().message;
  if (!has_map(manipulator_->task_space()))
    return make_status(Status::NO_MAP, "No map exists in " + std::string(name(manipulator_->task_space())) +
                                           ", so aspects have no ids. " + message);
  return make_status(Status::MAP_NOT_READY, message.empty() ? "The map is about to be computed." : message);
}

GetWorkingMode::Response Queries::answer(const GetWorkingMode::Request& request) const {
  const KnownAspects known = worker_.known();
  const ConfigurationAnswer found = resolve(request.configuration);
  GetWorkingMode::Response response;
  response.status = found.status;
  response.solutions = solutions(found, known);
  return response;
}

GetCurrentAspect::Response Queries::answer(const GetCurrentAspect::Request& request) const {
  const KnownAspects known = worker_.known();
  GetCurrentAspect::Response response;
  response.proved_count = known.proved_count();
  response.status = map_status(known);
  if (response.status.code == Status::MAP_NOT_READY) return response;
  const ConfigurationAnswer found = resolve(request.configuration);
  if (known.map || found.status.code != Status::OK) response.status = found.status;
  response.solutions = solutions(found, known);
  return response;
}

GetSingularityDistance::Response Queries::answer(const GetSingularityDistance::Request& request) const {
  const auto map = worker_.map();
  const ConfigurationAnswer found = resolve(request.configuration);
  GetSingularityDistance::Response response;
  response.status = found.status;
  for (const SolvedPose& solved : found.configurations)
    response.reports.push_back(
        report_message(*manipulator_, solved, distances(solved), map.get(), found.stamp));
  return response;
}

GetJacobian::Response Queries::answer(const GetJacobian::Request& request) const {
  const auto map = worker_.map();
  const ConfigurationAnswer found = resolve(request.configuration);
  GetJacobian::Response response;
  response.status = found.status;
  for (const SolvedPose& solved : found.configurations)
    response.jacobians.push_back(jacobian_message(*manipulator_, solved, map.get(), found.stamp));
  return response;
}

ListAspects::Response Queries::answer(const ListAspects::Request& request) const {
  const KnownAspects known = worker_.known();
  ListAspects::Response response;
  response.count_at_most = -1;
  response.proved_count = known.proved_count();
  response.status = map_status(known);
  if (response.status.code == Status::MAP_NOT_READY) return response;
  ConfigurationAnswer found;
  if (request.at_configuration) found = resolve(request.configuration);
  if (known.map || found.status.code != Status::OK) response.status = found.status;
  if (found.status.code != Status::OK) return response;
  const auto at = solutions(found, known);
  if (known.map) list_aspects(*manipulator_, *known.map, request, at, response);
  if (!known.roadmap) return response;
  for (const RoadmapSide& side : known.roadmap->sides()) {
    const RoadmapComponents message = components_message(side);
    if (!request.at_configuration || any_on(at, message)) response.roadmap.push_back(message);
  }
  return response;
}

// Where B_jj = 0 the working mode has no distances.
BoundaryDistances Queries::distances(const SolvedPose& solved) const {
  const auto mode = working_mode(*manipulator_, solved.pose, solved.q);
  if (!mode) return {};
  ask::DistanceQuestion question;
  question.pose = solved.pose;
  question.mode = *mode;
  const std::lock_guard<std::mutex> lock(session_mutex_);
  session_.know(worker_.known().distances_of(manipulator_));
  return ask::answer(session_, question).answer.answers.front().distances;
}

Status Queries::start(const Configuration& configuration) const {
  const ros::Time now = ros::Time::now();
  const std::string fault = fault_of(*manipulator_, configuration);
  if (!fault.empty()) return invalid_request(fault);
  const StatedSigns stated = stated_signs(configuration);
  if (configuration.kind == Configuration::NOW) {
    if (stated.determinant_sign != 0) return monitor_.start_with_sign(stated, now);
    return invalid_request("determinant_sign must be 1 or -1, or kind 1 (pose) or 2 (joints).");
  }
  if (configuration.kind == Configuration::POSE) {
    std::string message;
    const auto in_base = to_base_(configuration.pose, message);
    if (!in_base) return make_status(Status::NO_TRANSFORM, std::move(message));
    const auto pose = pose_from_base(*manipulator_, *in_base);
    return pose ? monitor_.start_near(*pose, now, stated) : invalid_request("The pose must be finite.");
  }
  const ConfigurationAnswer found = resolve(configuration);
  if (found.status.code != Status::OK) return found.status;
  if (found.configurations.size() != 1)
    return make_status(
        Status::INVALID_REQUEST,
        "More than one assembly mode is meant; set determinant_sign to 1 or -1, or, where that "
        "was done, give a pose (kind 1).");
  return monitor_.start_near(found.configurations.front().pose, now, stated);
}

SetAssemblyMode::Response Queries::answer(const SetAssemblyMode::Request& request) const {
  SetAssemblyMode::Response response;
  response.status = read_only_ ? refused_as_read_only() : start(request.configuration);
  if (response.status.code != Status::OK) return response;
  const ConfigurationAnswer now = resolve_now();
  response.status = now.status;
  response.solutions = solutions(now, worker_.known());
  return response;
}

}  // namespace parallel_aspects
