// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/choice_messages.h"

#include "ros/messages/conversions.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

using Names = std::vector<std::string>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::uint8_t answer_message(TrajectoryAnswer answer) {
  return answer == TrajectoryAnswer::safe     ? ModeChoice::YES
         : answer == TrajectoryAnswer::unsafe ? ModeChoice::NO
                                              : ModeChoice::UNKNOWN;
}

std::uint8_t answer_message(SameAspect answer) {
  return answer == SameAspect::yes  ? ModeChoice::YES
         : answer == SameAspect::no ? ModeChoice::NO
                                    : ModeChoice::UNKNOWN;
}

geometry_msgs::Pose in_base(const Manipulator& manipulator, const Pose& pose) {
  return pose_message(platform_in_base(manipulator, pose));
}

ModeChoice empty_choice(const WorkingMode& mode, TrajectoryAnswer answer, const std::string& reason) {
  ModeChoice message;
  message.working_mode = signs_message(mode);
  message.answer = answer_message(answer);
  message.reason = reason;
  message.violation_after = message.violation_before = none;
  message.clearance = message.clearance_time = message.least_time = message.least_index = none;
  return message;
}

ModeChoice choice_message(const ModeOnPath& mode) {
  ModeChoice message = empty_choice(mode.mode, mode.check.answer, mode.check.reason);
  message.determinant_sign = static_cast<std::int8_t>(mode.determinant_sign);
  message.aspect = static_cast<std::uint32_t>(mode.aspect);
  message.free_until = mode.check.free_until;
  if (mode.check.violation) {
    message.violation_after = mode.check.violation->after;
    message.violation_before = mode.check.violation->before;
  }
  if (!mode.clearance) return message;
  message.clearance = mode.clearance->lower;
  message.clearance_time = mode.clearance->time;
  message.travel = mode.travel;
  message.least_time = mode.least_time;
  return message;
}

ModeChoice choice_message(const Manipulator& manipulator, const ModeInRegion& mode) {
  ModeChoice message = empty_choice(mode.mode, mode.answer, mode.reason);
  message.determinant_sign = static_cast<std::int8_t>(mode.determinant_sign);
  message.undecided = mode.undecided;
  if (mode.answer == TrajectoryAnswer::safe) message.least_index = mode.least_index.lower;
  for (const Pose& witness : mode.witnesses) message.witnesses.push_back(in_base(manipulator, witness));
  return message;
}

ChangeOfPosture change_message(const Manipulator& manipulator, const PostureChange& change) {
  ChangeOfPosture message;
  message.time = change.time;
  message.pose = in_base(manipulator, change.pose);
  message.singular_pose = in_base(manipulator, change.singular);
  message.leg = manipulator.leg(change.leg).name;
  message.from_mode = signs_message(change.from);
  message.to_mode = signs_message(change.to);
  message.detour = change.detour;
  return message;
}

/// Where a name stands; the end where it does not.
std::size_t place(const Names& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

void require_names(const Names& given, const Names& known, Problems& problems) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (place(known, given[i]) == known.size())
      problems.push_back("'" + given[i] + "' is no coordinate of this robot's poses; leave it out.");
    if (place(given, given[i]) != i)
      problems.push_back("coordinates has '" + given[i] + "' twice; name it once.");
  }
}

}  // namespace

RegionQuestion region_of(const Manipulator& manipulator, const ChooseWorkingMode::Request& request,
                         Problems& problems) {
  RegionQuestion question;
  if (request.lower.size() != request.coordinates.size() ||
      request.upper.size() != request.coordinates.size()) {
    problems.emplace_back("coordinates, lower and upper must have as many entries each.");
    return question;
  }
  std::vector<HeldCoordinate> held;
  for (std::size_t i = 0; i < request.coordinates.size(); ++i)
    if (request.lower[i] == request.upper[i]) held.push_back({request.coordinates[i], request.lower[i]});
  if (!held.empty()) question.slice = make_slice(manipulator, held, problems);
  if (!problems.empty()) return question;
  const Names names =
      question.slice ? coordinate_names(*question.slice) : coordinate_names(manipulator.task_space());
  if (names.size() > max_map_dimension) return question;  // refused, with what to hold
  Names known = names;
  for (const HeldCoordinate& each : held) known.push_back(each.name);
  require_names(request.coordinates, known, problems);
  question.region.dimension = names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t at = place(request.coordinates, names[i]);
    if (at == request.coordinates.size()) {
      problems.push_back("coordinates has no range of " + names[i] + "; give one, or hold it by equal ends.");
      continue;
    }
    question.region.lower[i] = request.lower[at];
    question.region.upper[i] = request.upper[at];
  }
  return question;
}

void write_choice(const PathChoice& choice, ChooseWorkingMode::Response& response) {
  response.answer = answer_message(choice.answer);
  response.reason = choice.reason;
  for (const ModeOnPath& mode : choice.modes) response.modes.push_back(choice_message(mode));
}

void write_choice(const Manipulator& manipulator, const RegionChoice& choice,
                  ChooseWorkingMode::Response& response) {
  response.answer = answer_message(choice.answer);
  response.reason = choice.reason;
  for (const ModeInRegion& mode : choice.modes) response.modes.push_back(choice_message(manipulator, mode));
  if (choice.apart)
    response.apart = {in_base(manipulator, choice.apart->first), in_base(manipulator, choice.apart->second)};
}

void write_changes(const Manipulator& manipulator, const ChangingPath& path,
                   ChooseWorkingMode::Response& response) {
  response.answer_with_changes = answer_message(path.answer);
  response.reason_with_changes = path.reason;
  if (!path.pieces.empty()) response.first_mode = signs_message(path.pieces.front().mode);
  for (const PostureChange& change : path.changes)
    response.posture_changes.push_back(change_message(manipulator, change));
}

ModeConnection connection_message(const Manipulator& manipulator, const ask::ConnectionInMode& connection) {
  ModeConnection message;
  message.working_mode = signs_message(connection.mode);
  message.answer = answer_message(connection.comparison.answer);
  message.reason = connection.comparison.message;
  for (const Pose& pose : connection.comparison.path) message.path.push_back(in_base(manipulator, pose));
  message.clearance = connection.clearance ? connection.clearance->lower : none;
  message.narrowest = in_base(manipulator, connection.narrowest.value_or(Pose()));
  return message;
}

}  // namespace parallel_aspects
