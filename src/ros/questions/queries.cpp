// SPDX-License-Identifier: BSD-3-Clause
#include "ros/questions/queries.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/configurations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

std::uint8_t code_of(DirectStatus status) {
  return status == DirectStatus::solved      ? Status::NO_SOLUTION
         : status == DirectStatus::continuum ? Status::AMBIGUOUS
                                             : Status::FAILED;
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

void list_aspects(const std::shared_ptr<const AspectMap>& map, const ListAspects::Request& request,
                  const std::vector<SolvedConfiguration>& solutions, ListAspects::Response& response) {
  const auto holds_one = [&](const AspectSummary& aspect) {
    return std::any_of(solutions.begin(), solutions.end(),
                       [&](const SolvedConfiguration& solution) { return solution.aspect == aspect.id; });
  };
  for (AspectSummary& aspect : summary_messages(map))
    if (!request.at_configuration || holds_one(aspect)) response.aspects.push_back(std::move(aspect));
  response.count_at_most = count_at_most(*map);
  response.measure_undecided = map->measure_undecided();
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

// One session for each: it is for one thread at a time.
Queries::Meant Queries::locate(const Configuration& configuration, const KnownAspects& known) const {
  Meant meant;
  ask::LocateQuestion question;
  question.brief = true;
  meant.status = read(configuration, question, meant.stamp);
  if (meant.status.code != Status::OK) return meant;
  ask::Session session(manipulator_);
  session.know(known.map);
  session.know(known.roadmap);
  auto [status, problems, answer] = ask::answer(session, question);
  meant.configurations = std::move(answer.configurations);
  std::string& message = meant.status.message;
  if (meant.configurations.empty())
    meant.status = make_status(code_of(answer.status), answer.reason);
  else if (message.empty())
    message = beyond_limits(*manipulator_, meant.configurations.front().q);
  if (message.empty()) message = beyond_margins(meant.configurations);
  return meant;
}

Status Queries::read(const Configuration& configuration, ask::LocateQuestion& question,
                     ros::Time& stamp) const {
  const std::string fault = fault_of(*manipulator_, configuration);
  if (!fault.empty()) return invalid_request(fault);
  const StatedSigns stated = stated_signs(configuration);
  question.mode = stated.mode;
  if (stated.determinant_sign != 0)
    question.sign = stated.determinant_sign > 0 ? ask::Sign::plus : ask::Sign::minus;
  stamp = ros::Time::now();
  if (configuration.kind == Configuration::POSE)
    return read_pose(*manipulator_, to_base_, configuration.pose, "The pose", question.pose.emplace());
  if (configuration.kind == Configuration::NOW) {
    const CurrentConfiguration current = monitor_.current(stamp);
    stamp = current.stamp;
    question.pose = current.solved.pose;
    question.joints = current.solved.q;
    return current.status;
  }
  const JointSample sample =
      actuated_values(*manipulator_, configuration.joint_names, configuration.joint_positions);
  question.joints = sample.q;
  return sample.status == SampleStatus::usable
             ? Status()
             : invalid_request("The joints cannot be used: " + sample.message);
}

std::vector<SolvedConfiguration> Queries::messages(const Meant& meant) const {
  std::vector<SolvedConfiguration> all;
  for (const ask::LocatedConfiguration& each : meant.configurations)
    all.push_back(solved_message(*manipulator_, each, meant.stamp));
  return all;
}

GetWorkingMode::Response Queries::answer(const GetWorkingMode::Request& request) const {
  const Meant meant = locate(request.configuration, worker_.known());
  GetWorkingMode::Response response;
  response.status = meant.status;
  response.solutions = messages(meant);
  return response;
}

GetCurrentAspect::Response Queries::answer(const GetCurrentAspect::Request& request) const {
  const KnownAspects known = worker_.known();
  GetCurrentAspect::Response response;
  response.proved_count = known.proved_count();
  if (!known.map) response.status = worker_.why_no_map();  // NO_MAP: there is something to answer
  if (response.status.code == Status::MAP_NOT_READY) return response;
  const Meant meant = locate(request.configuration, known);
  if (known.map || meant.status.code != Status::OK) response.status = meant.status;
  response.solutions = messages(meant);
  return response;
}

GetSingularityDistance::Response Queries::answer(const GetSingularityDistance::Request& request) const {
  const Meant meant = locate(request.configuration, worker_.known());
  GetSingularityDistance::Response response;
  response.status = meant.status;
  for (const ask::LocatedConfiguration& each : meant.configurations)
    response.reports.push_back(report_message(*manipulator_, each, distances(each), meant.stamp));
  return response;
}

GetJacobian::Response Queries::answer(const GetJacobian::Request& request) const {
  const Meant meant = locate(request.configuration, worker_.known());
  GetJacobian::Response response;
  response.status = meant.status;
  for (const ask::LocatedConfiguration& each : meant.configurations)
    response.jacobians.push_back(jacobian_message(*manipulator_, each, meant.stamp));
  return response;
}

ListAspects::Response Queries::answer(const ListAspects::Request& request) const {
  const KnownAspects known = worker_.known();
  ListAspects::Response response;
  response.count_at_most = -1;
  response.proved_count = known.proved_count();
  if (!known.map) response.status = worker_.why_no_map();  // NO_MAP: there is something to answer
  if (response.status.code == Status::MAP_NOT_READY) return response;
  Meant meant;
  if (request.at_configuration) meant = locate(request.configuration, known);
  if (known.map || meant.status.code != Status::OK) response.status = meant.status;
  if (meant.status.code != Status::OK) return response;
  const auto at = messages(meant);
  if (known.map) list_aspects(known.map, request, at, response);
  if (!known.roadmap) return response;
  for (const RoadmapSide& side : known.roadmap->sides()) {
    const RoadmapComponents message = components_message(side);
    if (!request.at_configuration || any_on(at, message)) response.roadmap.push_back(message);
  }
  return response;
}

// Where B_jj = 0 the working mode has no distances.
BoundaryDistances Queries::distances(const ask::LocatedConfiguration& located) const {
  if (!located.mode) return {};
  ask::DistanceQuestion question;
  question.pose = located.pose;
  question.mode = located.mode;
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
  const Meant meant = locate(configuration, {});
  if (meant.status.code != Status::OK) return meant.status;
  if (meant.configurations.size() != 1)
    return make_status(
        Status::INVALID_REQUEST,
        "More than one assembly mode is meant; set determinant_sign to 1 or -1, or, where that "
        "was done, give a pose (kind 1).");
  return monitor_.start_near(meant.configurations.front().pose, now, stated);
}

SetAssemblyMode::Response Queries::answer(const SetAssemblyMode::Request& request) const {
  SetAssemblyMode::Response response;
  response.status = read_only_ ? refused_as_read_only() : start(request.configuration);
  if (response.status.code != Status::OK) return response;
  const Meant now = locate({}, worker_.known());
  response.status = now.status;
  response.solutions = messages(now);
  return response;
}

}  // namespace parallel_aspects
