// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/choose_working_mode.h"

#include "aspects/map/map_contents.h"
#include "motion/check/check_text.h"
#include "motion/choose/path_measures.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace parallel_aspects {
namespace {

bool has_velocity_limit(const Manipulator& manipulator) {
  return std::any_of(manipulator.legs().begin(), manipulator.legs().end(),
                     [](const Leg& leg) { return std::isfinite(leg.limits.velocity); });
}

/// The answer for a start that is out of reach by floating-point arithmetic, or below a margin.
TrajectoryCheck fail_at_start(const SegmentCertifier& certifier, const PoseWaypoint& start,
                              const WorkingMode& mode) {
  TrajectoryCheck check;
  check.free_until = start.time;
  const ConfigurationProof proof = certifier.prove(start.pose, mode);
  if (proof.proved_violation == Violation::none) {
    check.reason = "The start is too close to a singularity or a limit to be determined.";
    return check;
  }
  check.answer = TrajectoryAnswer::unsafe;
  check.violation =
      TrajectoryViolation{proof.proved_violation, proof.leg, proof.failing, start.time, start.time};
  check.reason = "Proved: " + violation_text(*certifier.manipulator(), *check.violation) + " at the start.";
  return check;
}

/// Smaller is better.
double cost(const ModeOnPath& mode, Preference preference) {
  switch (preference) {
    case Preference::clear:
      return -mode.clearance->lower;
    case Preference::travel:
      return mode.total_travel();
    case Preference::fast:
      break;
  }
  return mode.least_time;
}

bool is_better(const ModeOnPath& a, const ModeOnPath& b, Preference preference) {
  if (a.check.answer != b.check.answer) return rank(a.check.answer) < rank(b.check.answer);
  if (a.check.answer != TrajectoryAnswer::safe) return a.check.free_until > b.check.free_until;
  return cost(a, preference) < cost(b, preference);
}

class PathSurvey {
 public:
  PathSurvey(const SegmentCertifier& certifier, const std::vector<PoseWaypoint>& waypoints,
             const PathChoiceOptions& options, std::size_t modes)
      : certifier_(certifier),
        manipulator_(*certifier.manipulator()),
        waypoints_(waypoints),
        options_(options),
        modes_(modes),
        meter_(certifier.manipulator()) {}

  ModeOnPath look_at(const WorkingMode& mode) {
    ModeOnPath result;
    result.mode = mode;
    if (is_cancelled(options_.control)) {
      result.check.free_until = waypoints_.front().time;
      result.check.reason = "Not examined: the question was cancelled.";
      return result;
    }
    result.determinant_sign = certifier_.prove(waypoints_.front().pose, mode).sign;
    if (options_.map != nullptr) result.aspect = options_.map->locate(waypoints_.front().pose, mode).aspect;
    TrajectoryCheckOptions check = options_.check;
    check.control = control_of_check();
    result.check = check_trajectory(certifier_, waypoints_, mode, check);
    if (result.check.refused) result.check = fail_at_start(certifier_, waypoints_.front(), mode);
    ++done_;
    if (result.check.answer != TrajectoryAnswer::safe) return result;
    result.clearance =
        measure_clearance(meter_, manipulator_, waypoints_, mode, options_.measures, options_.control);
    PathEffort effort = effort_of(manipulator_, waypoints_, mode);
    result.travel = std::move(effort.travel);
    result.least_time = effort.least_time;
    return result;
  }

 private:
  /// Progress of the check of one working mode, as part of all.
  MapControl control_of_check() const {
    MapControl control;
    control.cancelled = options_.control.cancelled;
    if (options_.control.progress)
      control.progress = [this](double share) {
        options_.control.progress((static_cast<double>(done_) + share) / static_cast<double>(modes_));
      };
    return control;
  }

  const SegmentCertifier& certifier_;
  const Manipulator& manipulator_;
  const std::vector<PoseWaypoint>& waypoints_;
  const PathChoiceOptions& options_;
  std::size_t modes_, done_ = 0;
  BoundaryDistanceMeter meter_;
};

/// `modes` are sorted.
void conclude(PathChoice& choice) {
  const auto count = [&](TrajectoryAnswer answer) {
    return std::count_if(choice.modes.begin(), choice.modes.end(),
                         [&](const ModeOnPath& mode) { return mode.check.answer == answer; });
  };
  const auto safe = count(TrajectoryAnswer::safe), unknown = count(TrajectoryAnswer::unknown);
  choice.answer = safe > 0      ? TrajectoryAnswer::safe
                  : unknown > 0 ? TrajectoryAnswer::unknown
                                : TrajectoryAnswer::unsafe;
  const std::string all = std::to_string(choice.modes.size());
  if (safe > 0)
    choice.reason = "Proved: all of the path can be done in " + std::to_string(safe) + " of " + all +
                    " working modes, best in " + to_string(choice.modes.front().mode) + ".";
  else if (unknown > 0)
    choice.reason = "In no working mode is all of the path proved to be safe, but in " +
                    std::to_string(unknown) + " of " + all + " it could be.";
  else
    choice.reason = "Proved: in none of the " + all + " working modes can all of the path be done.";
}

}  // namespace

double ModeOnPath::total_travel() const noexcept {
  return std::accumulate(travel.begin(), travel.end(), 0.0);
}

// A start that is out of reach or below a margin rules out a working mode, not the path.
Problems problems_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     Preference preference) {
  Problems problems = waypoint_problems(waypoints);
  if (preference == Preference::fast && !has_velocity_limit(manipulator))
    problems.push_back("No actuated joint of '" + manipulator.name() +
                       "' has a velocity limit, so that no time can be computed; state them in the URDF, or "
                       "prefer clear or travel.");
  return problems;
}

PathChoice choose_working_mode(const SegmentCertifier& certifier, const std::vector<PoseWaypoint>& waypoints,
                               const PathChoiceOptions& options) {
  const std::vector<WorkingMode> modes = working_modes(*certifier.manipulator());
  PathSurvey survey(certifier, waypoints, options, modes.size());
  PathChoice choice;
  for (const WorkingMode& mode : modes) choice.modes.push_back(survey.look_at(mode));
  std::stable_sort(choice.modes.begin(), choice.modes.end(), [&](const ModeOnPath& a, const ModeOnPath& b) {
    return is_better(a, b, options.preference);
  });
  conclude(choice);
  return choice;
}

const char* name(Preference preference) noexcept {
  switch (preference) {
    case Preference::clear:
      return "clear";
    case Preference::travel:
      return "travel";
    case Preference::fast:
      break;
  }
  return "fast";
}

namespace {

constexpr int measures = 400;

/// The poses of a path, a second apart.
std::vector<PoseWaypoint> timed(const std::vector<Pose>& path) {
  std::vector<PoseWaypoint> waypoints;
  waypoints.reserve(path.size());
  for (const Pose& pose : path) waypoints.push_back({static_cast<double>(waypoints.size()), pose});
  return waypoints;
}

Pose pose_at(const Motions& motions, const std::vector<PoseWaypoint>& waypoints, double time) {
  const auto segment = std::min(static_cast<std::size_t>(time), waypoints.size() - 2);
  return waypoint_between(motions, waypoints, segment, time - static_cast<double>(segment)).pose;
}

}  // namespace

void ask_map(const AspectMap& map, const PoseInMode& first, const PoseInMode& second,
             AspectComparison& comparison) {
  const Location start = map.locate(first.pose, first.mode), end = map.locate(second.pose, second.mode);
  if (!start || !end) return;
  if (start.aspect == end.aspect)
    comparison = {SameAspect::yes, "The map proves it: both are in the same connected set of boxes.", {}, 0};
  else if (!may_be_one(map, start.aspect, end.aspect))
    comparison = {SameAspect::no, "The map proves the two aspects separate.", {}, 0};
}

PathMeasure measure_path(const std::shared_ptr<const Manipulator>& manipulator,
                         const std::vector<Pose>& poses, const WorkingMode& mode) {
  const std::vector<PoseWaypoint> path = timed(poses);
  BoundaryDistanceMeter meter(manipulator);
  PathMeasure result;
  result.clearance = measure_clearance(meter, *manipulator, path, mode, measures);
  result.narrowest = pose_at(manipulator->motions(), path, result.clearance.time);
  return result;
}

}  // namespace parallel_aspects
