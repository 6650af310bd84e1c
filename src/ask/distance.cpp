// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/distance.h"

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/singularity/indices.h"

#include <utility>

namespace parallel_aspects::ask {
namespace {

void check_distance(const Session& session, const DistanceQuestion& question, ProblemList& problems) {
  if (!question.pose)
    problems.push_back({ProblemKind::missing, "pose", "{pose} is required", "give the pose of the platform"});
  if (question.tolerance && !(*question.tolerance > 0.0 && *question.tolerance < 1.0))
    problems.push_back({ProblemKind::value, "tolerance", "{tolerance} is not between 0 and 1",
                        "give a share of the distance, such as 0.01"});
  if (question.map.is_default()) return;
  if (session.robot()->task_space() == TaskSpace::SE3)
    problems.push_back({ProblemKind::robot, "map",
                        "With six degrees of freedom there is no map of all poses that distances could ask",
                        "leave out {map} and {resolution}"});
  else if (session.slice_of(question.map))
    problems.push_back({ProblemKind::robot, "map",
                        "{map} and {resolution} would be of a slice, which does not show what is beside it",
                        "leave them out"});
}

/// What is asked besides the robot; null where nothing is.
std::shared_ptr<const DistanceMap> map_for(Session& session, const DistanceQuestion& question,
                                           const Control& control, DistanceAnswer& answer,
                                           ProblemList& problems) {
  if (question.map.is_default()) return session.known_distances(control);
  const FoundMap found = session.map(question.map, {}, control, problems);
  if (!found.map) return nullptr;
  answer.loaded = found.loaded;
  return std::make_shared<const DistanceMap>(found.map, control.begin("Making the map ready."));
}

DistanceTo with_leg(const BoundaryDistance& distance) {
  DistanceTo result{distance};
  if (result.has_witness() || distance.status == DistanceStatus::touching)
    result.leg = LegIndex{distance.leg};
  return result;
}

}  // namespace

DistanceOptions DistanceQuestion::options() const {
  DistanceOptions options;
  if (tolerance) options.tolerance = *tolerance;
  if (boxes) options.max_boxes = static_cast<int>(boxes->value);
  return options;
}

bool DistancesInMode::is_reached() const noexcept {
  return distances || distances.status == ConfigurationStatus::outside_limits ||
         distances.status == ConfigurationStatus::at_serial_singularity;
}

DistanceTo DistancesInMode::serial() const { return with_leg(distances.serial); }

DistanceTo DistancesInMode::actuated_limit() const {
  DistanceTo result = with_leg(distances.actuated_limit);
  if (result.has_witness()) result.limit = distances.actuated_limit.end;
  return result;
}

Outcome<DistanceAnswer> answer(Session& session, const DistanceQuestion& question, const Control& control) {
  ProblemList problems;
  DistanceAnswer result;
  check_distance(session, question, problems);
  if (!problems.empty()) return outcome_of(std::move(problems), control, std::move(result));
  const Manipulator& robot = *session.robot();
  result.task_space = robot.task_space();
  result.pose = *question.pose;
  BoundaryDistanceMeter meter(session.robot(), question.options());
  const auto map = map_for(session, question, control, result, problems);
  if (!control.is_over()) meter.use(map);
  for (const WorkingMode& mode :
       question.mode ? std::vector<WorkingMode>{*question.mode} : working_modes(robot)) {
    if (!problems.empty() || control.is_over()) break;
    DistancesInMode found{mode, meter.measure(result.pose, mode), {}};
    if (found.is_reached()) found.missed_margins = missed_margins(robot, result.pose, found.distances.q);
    result.answers.push_back(std::move(found));
  }
  return outcome_of(std::move(problems), control, std::move(result));
}

}  // namespace parallel_aspects::ask
