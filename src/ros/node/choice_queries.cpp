// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/choice_queries.h"

#include "ros/messages/conversions.h"
#include "ros/messages/motion_messages.h"
#include "ros/plan/plan_question.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

/// What belongs to the other kind of question; empty where nothing does.
std::string foreign_field(const ChooseWorkingMode::Request& request) {
  if (request.kind == ChooseWorkingMode::Request::PATH) {
    if (!request.coordinates.empty() || !request.lower.empty() || !request.upper.empty())
      return "A path has no ranges; leave coordinates, lower and upper empty, or ask with kind 1 (region).";
    return "";
  }
  if (!request.poses.empty() || !request.times.empty() || !request.prefer.empty() || request.changes)
    return "A region has no path; leave poses, times, prefer and changes empty, or ask with kind 0 (path).";
  return "";
}

/// The working modes that are asked for; empty where one of them does not exist.
std::vector<WorkingMode> modes_of(const Manipulator& manipulator, const std::vector<std::int8_t>& signs) {
  const std::vector<WorkingMode> all = working_modes(manipulator);
  if (std::all_of(signs.begin(), signs.end(), [](std::int8_t sign) { return sign == 0; })) return all;
  const auto mode = WorkingMode::from_signs({signs.begin(), signs.end()});
  return mode && std::find(all.begin(), all.end(), *mode) != all.end() ? std::vector<WorkingMode>{*mode}
                                                                       : std::vector<WorkingMode>{};
}

}  // namespace

ChoiceQueries::ChoiceQueries(std::shared_ptr<const Manipulator> manipulator, const MapWorker& worker,
                             PoseTransformer to_base)
    : manipulator_(std::move(manipulator)),
      worker_(worker),
      to_base_(std::move(to_base)),
      session_(manipulator_) {}

ChooseWorkingMode::Response ChoiceQueries::answer(const ChooseWorkingMode::Request& request) const {
  ChooseWorkingMode::Response response;
  response.answer = response.answer_with_changes = ModeChoice::UNKNOWN;
  const std::string foreign = foreign_field(request);
  if (request.kind > ChooseWorkingMode::Request::REGION)
    response.status = invalid_request("kind must be 0 (path) or 1 (region).");
  else if (!foreign.empty())
    response.status = invalid_request(foreign);
  else
    response.status = choose(request, response);
  return response;
}

Status ChoiceQueries::choose(const ChooseWorkingMode::Request& request,
                             ChooseWorkingMode::Response& response) const {
  ask::ChooseQuestion question;
  question.brief = true;
  question.changes = request.changes;
  std::string names;
  if (!request.prefer.empty() && !(question.prefer = ask::choice_named<Preference>(request.prefer, names)))
    return invalid_request("prefer must be " + names + ", or empty for clear.");
  Status status;
  if (request.kind == ChooseWorkingMode::Request::PATH)
    status = read_path(request, question.path.emplace());
  else
    status = read_region(*manipulator_, request, question);
  if (status.code != Status::OK) return status;
  ask::Session session(manipulator_);  // for one thread at a time, so that long questions do not wait
  session.know(worker_.map());
  const auto outcome = ask::answer(session, question);
  const auto field_of_request = [](const std::string& field) {
    return field == "region" ? std::string("The region") : field;
  };
  if (!outcome) return invalid_request(text_of(outcome.problems.front(), field_of_request));
  write_choice(*manipulator_, outcome.answer, response);
  return status;
}

Status ChoiceQueries::read_path(const ChooseWorkingMode::Request& request,
                                std::vector<PoseWaypoint>& waypoints) const {
  if (!request.times.empty() && request.times.size() != request.poses.size())
    return invalid_request("times must be empty, or have an entry for each of poses.");
  std::vector<geometry_msgs::PoseStamped> poses(request.poses.size());
  std::vector<double> times = request.times;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].header = request.header;
    poses[i].pose = request.poses[i];
    if (request.times.empty()) times.push_back(static_cast<double>(i));
  }
  return read_waypoints(*manipulator_, to_base_, poses, times, waypoints);
}

// One roadmap for all questions, so that the same question gets the same answer.
ask::Outcome<ask::ConnectAnswer> ChoiceQueries::connect(const ask::ConnectQuestion& question) const {
  const std::lock_guard<std::mutex> lock(session_mutex_);
  session_.know(worker_.map());
  if (const auto known = worker_.known().roadmap) session_.know(known);
  ask::ProblemList problems;
  if (const auto roadmap = session_.roadmap({}, {}, problems)) session_.know(roadmap);
  if (!problems.empty()) return {MapStatus::refused, std::move(problems), {}};
  return ask::answer(session_, question);
}

Connect::Response ChoiceQueries::answer(const Connect::Request& request) const {
  Connect::Response response;
  ask::ConnectQuestion question;
  question.brief = true;
  const std::vector<WorkingMode> modes = modes_of(*manipulator_, request.working_mode);
  if (modes.empty()) {
    response.status =
        invalid_request("working_mode must have a sign, 1 or -1, for each leg that has two, or be empty.");
    return response;
  }
  if (modes.size() == 1) question.mode = modes.front();
  response.status = read_pose(*manipulator_, to_base_, request.start, "start", question.start.emplace());
  if (response.status.code != Status::OK) return response;
  const Status read = read_pose(*manipulator_, to_base_, request.goal, "goal", question.goal.emplace());
  if (read.code != Status::OK || response.status.message.empty()) response.status = read;
  if (read.code != Status::OK) return response;
  const auto outcome = connect(question);
  if (!outcome) response.status = refused(outcome.problems);
  for (const ask::ConnectionInMode& each : outcome.answer.answers)
    response.answers.push_back(connection_message(*manipulator_, each));
  return response;
}

}  // namespace parallel_aspects
