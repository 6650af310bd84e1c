// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/serial_margin.h"
#include "motion/timing/joint_stages.h"
#include "motion/timing/timed_curve.h"
#include "parallel_aspects/motion/plan_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double blend_share = 0.5;      // of a segment, at either of its ends
constexpr double allowed_speed = 0.998;  // of a limit; a check bounds speeds to a thousandth
constexpr double small_loss = 0.001;     // of the time, for the sake of fewer samples
constexpr std::size_t first_samples = 200;
constexpr int doublings = 4;

/// One attempt to time a path, and what came of it.
class Attempt {
 public:
  Attempt(const SegmentCertifier& certifier, const PlannedPath& path, const JointVector& acceleration)
      : certifier_(certifier), path_(path) {
    limits_ = {allowed_speed * velocity_limits(*certifier.manipulator()), acceleration};
  }

  /// Whether it is proved, and has enough samples to be nearly as fast as possible.
  bool run(const JointStages& stages, std::size_t samples) {
    timed_ = {};
    timed_.rounded = stages.rounded();
    timed_.stops = stages.stops();
    const double lost = append(stages.sample(samples));
    timed_.seconds = timed_.waypoints.back().time;
    check();
    return is_safe() && lost <= small_loss * timed_.seconds;
  }

  const TimedPath& timed() const noexcept { return timed_; }
  bool is_safe() const noexcept { return timed_.check.answer == TrajectoryAnswer::safe; }

 private:
  /// How much time is lost since there are too few samples [s].
  double append(const JointStages::Stages& stages) {
    double lost = 0.0;
    keeps_limits_ = true;
    std::vector<JointWaypoint>& all = timed_.waypoints;
    for (const std::vector<JointVector>& stage : stages) {
      const double begin = all.empty() ? 0.0 : all.back().time;
      const TimedCurve curve = timed_curve(spline_through(stage, limits_.velocity), limits_, begin);
      keeps_limits_ = keeps_limits_ && curve.keeps_limits;
      lost += curve.loss * (curve.waypoints.back().time - begin);
      all.insert(all.end(), curve.waypoints.begin() + (all.empty() ? 0 : 1), curve.waypoints.end());
    }
    return lost;
  }

  void check() {
    TrajectoryStart start;
    start.pose = path_.points.front().pose;
    TrajectoryCheckOptions options;
    options.pass_serial = !path_.crossings.empty();
    timed_.check = check_trajectory(certifier_, timed_.waypoints, start, options);
    const Manipulator& robot = *certifier_.manipulator();
    const std::string fast =
        exceeded_speeds(robot, timed_.check, true) + exceeded_speeds(robot, timed_.check, false);
    if (!is_safe() || (keeps_limits_ && fast.empty())) return;
    timed_.check.answer = TrajectoryAnswer::unknown;
    timed_.check.reason = "No samples of it were found that keep the limits of the joints.";
  }

  const SegmentCertifier& certifier_;
  const PlannedPath& path_;
  MotionLimits limits_;
  TimedPath timed_;
  bool keeps_limits_ = true;
};

std::string corner_text(const TimedPath& timed) {
  if (timed.rounded + timed.stops == 0) return "";
  return ", " + std::to_string(timed.rounded) + " corners rounded, a stop at " + std::to_string(timed.stops);
}

TimedPath without_time(const TimedPath& tried, std::string message) {
  TimedPath timed;
  timed.check = tried.check;
  timed.message = std::move(message);
  return timed;
}

bool loses_control(const PlannedPath& path) {
  return std::any_of(path.crossings.begin(), path.crossings.end(),
                     [](const PathCrossing& crossing) { return crossing.kind == Crossing::parallel; });
}

}  // namespace

Problems problems_of(const Manipulator& manipulator, const JointVector& acceleration) {
  Problems problems;
  for (const Leg& leg : manipulator.legs())
    if (!std::isfinite(leg.limits.velocity))
      problems.push_back("Joint '" + leg.actuated_joint +
                         "' has no velocity limit, which a path in time needs; give it one in the URDF: "
                         "<limit velocity=\"...\"/>.");
  const bool fits = acceleration.size() == static_cast<Eigen::Index>(manipulator.leg_count());
  if (!fits || !acceleration.allFinite() || !(acceleration.minCoeff() > 0.0))
    problems.push_back("A path in time needs " + std::to_string(manipulator.leg_count()) +
                       " acceleration limits, one for each actuated joint, positive and finite.");
  if (manipulator.tolerance() > 0.0)
    problems.emplace_back("Trajectories of actuated joints are not proved within a tolerance; leave it out.");
  return problems;
}

TimedPath time_path(const SegmentCertifier& certifier, const PlannedPath& path, const PoseBetween& between,
                    const JointVector& acceleration, const MapControl& control) {
  if (path.points.empty()) return without_time({}, "There is no path to be timed.");
  if (loses_control(path))
    return without_time({}, "The path passes det A = 0, where the actuated joints do not hold the platform.");
  if (!path.crossings.empty() && has_serial_margin(*certifier.manipulator()))
    return without_time({},
                        "The path passes B_jj = 0, which a serial margin shuts out; set that margin to 0, or "
                        "stay in one aspect.");
  Attempt attempt(certifier, path, acceleration);
  TimedPath best;
  for (const double share : {blend_share, 0.0}) {
    const JointStages stages(certifier, path, between, share);
    std::size_t samples = first_samples;
    for (int k = 0; k <= doublings; ++k, samples *= 2) {
      if (is_cancelled(control)) return without_time({}, "Cancelled.");
      const bool is_done = attempt.run(stages, samples);
      if (attempt.is_safe() && (!best || attempt.timed().seconds < best.seconds)) best = attempt.timed();
      if (is_done) break;
    }
    if (best || stages.rounded() == 0) break;
  }
  if (!best)
    return without_time(attempt.timed(),
                        "No trajectory along the path is proved: " + attempt.timed().check.reason);
  best.message = "Proved at every time" + corner_text(best) + ".";
  return best;
}

PathTime path_timer(const SegmentCertifier& certifier, PoseBetween between, const JointVector& acceleration,
                    const MapControl& control) {
  return [&certifier, control, between = std::move(between), acceleration](const PlannedPath& path) {
    const TimedPath timed = time_path(certifier, path, between, acceleration, control);
    return timed ? timed.seconds : std::numeric_limits<double>::infinity();
  };
}

}  // namespace parallel_aspects
