// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/check_trajectory.h"

#include "model/number_text.h"
#include "motion/check/trajectory_survey.h"
#include "parallel_aspects/kinematics/inverse.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

std::string numbered(std::size_t index) { return "Waypoint " + std::to_string(index + 1); }

bool is_finite(const PoseWaypoint& waypoint) {
  return std::isfinite(waypoint.time) && waypoint.pose.position.allFinite() &&
         waypoint.pose.orientation.coeffs().allFinite();
}

std::string unreached(const Manipulator& manipulator, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(manipulator, pose, mode);
  if (solution.status != InverseStatus::out_of_reach) return "";
  return "The first pose is out of reach of leg '" + manipulator.leg(solution.leg).name +
         "' in working mode " + to_string(mode) + "; start from a pose that it reaches.";
}

/// Where times are compared with a proof, rounding must not shorten the bracket.
constexpr double time_rounding = 0x1p-50;

/// Goes from segment to segment for as long as they are free.
class PoseCheck {
 public:
  PoseCheck(const SegmentCertifier& certifier, const std::vector<PoseWaypoint>& waypoints,
            const WorkingMode& mode, const TrajectoryCheckOptions& options)
      : certifier_(certifier),
        manipulator_(*certifier.manipulator()),
        waypoints_(waypoints),
        mode_(mode),
        options_(options),
        survey_(manipulator_, check_) {}

  TrajectoryCheck run() {
    check_.free_until = waypoints_.front().time;
    check_.answer = TrajectoryAnswer::safe;
    const std::size_t segments = std::max<std::size_t>(waypoints_.size() - 1, 1);
    for (std::size_t i = 0; i < segments && check_.answer == TrajectoryAnswer::safe; ++i) pass(i);
    if (check_.answer == TrajectoryAnswer::safe) check_.reason = safe_text();
    return check_;
  }

 private:
  const PoseWaypoint& end_of(std::size_t i) const {
    return waypoints_[std::min(i + 1, waypoints_.size() - 1)];
  }

  // A trajectory of one waypoint is a segment of no length.
  void pass(std::size_t i) {
    const SegmentProof proof = certifier_.prove_to_violation(waypoints_[i].pose, end_of(i).pose, mode_,
                                                             options_.bracket, options_.max_parts);
    sample(i, proof.free_until);
    const double rounding = time_rounding * std::max(std::abs(waypoints_[i].time), std::abs(end_of(i).time));
    check_.free_until = proof.verdict == SegmentVerdict::free
                            ? end_of(i).time
                            : std::max(waypoints_[i].time, time_at(i, proof.free_until) - rounding);
    if (proof.verdict == SegmentVerdict::undecided) leave_open();
    if (proof.verdict == SegmentVerdict::blocked)
      block(proof, std::min(end_of(i).time, time_at(i, proof.witness) + rounding));
  }

  double time_at(std::size_t i, double share) const {
    return waypoints_[i].time + share * (end_of(i).time - waypoints_[i].time);
  }

  void block(const SegmentProof& proof, double before) {
    check_.answer = TrajectoryAnswer::unsafe;
    check_.violation = TrajectoryViolation{proof.violation, proof.at_witness.leg, proof.at_witness.failing,
                                           check_.free_until, before};
    check_.reason = unsafe_text(manipulator_, *check_.violation);
  }

  void leave_open() {
    check_.answer = TrajectoryAnswer::unknown;
    check_.reason = "Proved free until " + number_text(check_.free_until, 9) +
                    " s; just after it comes too near to a singularity or a limit to be determined.";
  }

  void sample(std::size_t i, double until) {
    const auto segments = static_cast<int>(waypoints_.size());
    const int count = std::max(2, options_.samples / segments + 1);
    for (int k = 0; k <= count; ++k) {
      const double share = until * k / count;
      const Pose pose = pose_between(waypoints_[i].pose, end_of(i).pose, share);
      const InverseSolution solution = inverse(manipulator_, pose, mode_);
      if (solution.status != InverseStatus::out_of_reach) survey_.add(time_at(i, share), pose, solution.q);
    }
  }

  const SegmentCertifier& certifier_;
  const Manipulator& manipulator_;
  const std::vector<PoseWaypoint>& waypoints_;
  const WorkingMode& mode_;
  const TrajectoryCheckOptions& options_;
  TrajectoryCheck check_;
  TrajectorySurvey survey_;
};

}  // namespace

const char* name(TrajectoryAnswer answer) noexcept {
  switch (answer) {
    case TrajectoryAnswer::safe:
      return "yes";
    case TrajectoryAnswer::unsafe:
      return "no";
    case TrajectoryAnswer::unknown:
      break;
  }
  return "unknown";
}

Problems problems_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     const WorkingMode& mode) {
  if (waypoints.empty()) return {"The trajectory has no waypoint; give one or more."};
  const std::vector<WorkingMode> modes = working_modes(manipulator);
  if (std::find(modes.begin(), modes.end(), mode) == modes.end())
    return {"'" + manipulator.name() + "' has no working mode " + to_string(mode) + "."};
  Problems problems;
  for (std::size_t i = 0; i < waypoints.size(); ++i)
    if (!is_finite(waypoints[i]))
      problems.push_back(numbered(i) + " has a number that is not finite; correct it.");
  if (!problems.empty()) return problems;
  for (std::size_t i = 1; i < waypoints.size(); ++i)
    if (!(waypoints[i].time > waypoints[i - 1].time))
      problems.push_back(numbered(i) + " is not later than the one before; times must rise.");
  const std::string start = unreached(manipulator, waypoints.front().pose, mode);
  if (!start.empty()) problems.push_back(start);
  return problems;
}

TrajectoryCheck check_trajectory(const SegmentCertifier& certifier,
                                 const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode,
                                 const TrajectoryCheckOptions& options) {
  const Problems problems = problems_of(*certifier.manipulator(), waypoints, mode);
  if (problems.empty()) return PoseCheck(certifier, waypoints, mode, options).run();
  TrajectoryCheck check;
  check.reason = problems.front();
  return check;
}

}  // namespace parallel_aspects
