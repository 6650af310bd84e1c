// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/check_trajectory.h"

#include "motion/check/check_text.h"
#include "motion/check/joint_assembly.h"
#include "motion/check/segment_times.h"
#include "motion/check/trajectory_survey.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "tracking/pose_certifier.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

bool is_usable(const PoseWaypoint& waypoint) {
  return is_usable_number(waypoint.time) && is_usable_number(waypoint.pose.position.cwiseAbs().maxCoeff()) &&
         waypoint.pose.position.allFinite() && waypoint.pose.orientation.coeffs().allFinite();
}

std::string start_problem(const Manipulator& manipulator, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(manipulator, pose, mode);
  if (solution.status != InverseStatus::out_of_reach) return missed_at_start(manipulator, pose, solution.q);
  return "The first pose is out of reach of leg '" + manipulator.leg(solution.leg).name +
         "' in working mode " + to_string(mode) + "; start from a pose that it reaches.";
}

// Bound of the rounding of poses, over the size of the robot; generous.
constexpr double sample_rounding = 0x1p-40;

/// Goes from segment to segment as long as they are free.
class PoseCheck {
 public:
  PoseCheck(const SegmentCertifier& certifier, const std::vector<PoseWaypoint>& waypoints,
            const WorkingMode& mode, const TrajectoryCheckOptions& options)
      : certifier_(certifier),
        manipulator_(*certifier.manipulator()),
        times_(waypoints),
        mode_(mode),
        options_(options),
        survey_(manipulator_, options.keep_samples, check_),
        distances_(manipulator_) {}

  TrajectoryCheck run() {
    check_.free_until = times_.from(0).time;
    check_.answer = TrajectoryAnswer::safe;
    check_.mode = mode_;
    for (std::size_t i = 0; i < times_.count() && check_.answer == TrajectoryAnswer::safe; ++i) {
      if (is_cancelled(options_.control))
        leave_open("the check was cancelled");
      else
        pass(i);
      times_.report(i, options_.control);
    }
    if (!check_.violation) check_.followed_until = check_.free_until;
    if (check_.answer == TrajectoryAnswer::safe) check_.reason = safe_text();
    if (check_.answer == TrajectoryAnswer::unknown) check_.not_followed = check_.reason;
    return check_;
  }

 private:
  void pass(std::size_t i) {
    const SegmentProof proof = certifier_.prove_to_violation(times_.from(i).pose, times_.to(i).pose, mode_,
                                                             options_.bracket, options_.max_parts);
    sample(i, proof.free_until);
    check_.free_until = times_.before(i, proof.free_until);
    if (proof.verdict == SegmentVerdict::undecided) leave_open(near_something_text());
    if (proof.verdict == SegmentVerdict::blocked) block(i, proof);
  }

  void block(std::size_t i, const SegmentProof& proof) {
    check_.answer = TrajectoryAnswer::unsafe;
    const bool at_start = proof.free_until == 0.0 &&
                          certifier_.prove(times_.from(i).pose, mode_).proved_violation == proof.violation;
    check_.violation =
        TrajectoryViolation{proof.violation, proof.at_witness.leg, proof.at_witness.failing,
                            check_.free_until, at_start ? check_.free_until : times_.after(i, proof.witness)};
    check_.reason = unsafe_text(manipulator_, *check_.violation);
    if (!is_crossing(proof.violation)) return follow(i, proof.free_until);
    if (cross(i, proof)) follow(i, proof.witness);
  }

  /// Goes on behind the first violation: by the legs alone, without constraints.
  void follow(std::size_t first, double share) {
    const SegmentCertifier legs(manipulator_.with_constraints({}));
    for (std::size_t i = first; i < times_.count(); ++i) {
      SegmentProof proof;
      for (proof.witness = share; proof.verdict != SegmentVerdict::free;) {
        proof = legs.prove_to_violation(times_.from(i).pose, times_.to(i).pose, mode_, options_.bracket,
                                        options_.max_parts, proof.witness);
        check_.followed_until = times_.before(i, proof.free_until);
        if (proof.verdict == SegmentVerdict::undecided) {
          check_.not_followed = not_followed_text(check_.followed_until, near_something_text());
          return;
        }
        if (proof.verdict == SegmentVerdict::blocked && !cross(i, proof)) return;
      }
      share = 0.0;
    }
  }

  /// Notes a crossing; false where the trajectory is not followed behind it.
  bool cross(std::size_t i, const SegmentProof& proof) {
    TrajectoryCrossing crossing{proof.violation,
                                proof.at_witness.leg,
                                times_.before(i, proof.free_until),
                                times_.after(i, proof.witness),
                                {},
                                proof.at_witness.sign};
    const bool goes_on = proof.violation == Violation::singularity;
    if (goes_on) crossing.mode = mode_;
    if (!goes_on) check_.not_followed = not_followed_text(crossing.after, "a leg cannot reach the poses");
    check_.followed_until = crossing.after;
    check_.crossings.push_back(crossing);
    return goes_on;
  }

  void leave_open(const std::string& why) {
    check_.answer = TrajectoryAnswer::unknown;
    check_.reason = undecided_text(check_.free_until, why);
  }

  void sample(std::size_t i, double until) {
    const Pose &from = times_.from(i).pose, &to = times_.to(i).pose;
    const int count = std::max(1, options_.samples / static_cast<int>(times_.count()) + 1);
    for (int k = i == 0 ? 0 : 1; k <= count; ++k) {
      const double share = until * k / count;
      const Pose pose = pose_between(manipulator_.motions(), from, to, share);
      const InverseSolution solution = inverse(manipulator_, pose, mode_);
      if (solution.status == InverseStatus::out_of_reach) continue;
      survey_.add(times_.at(i, share), pose, solution.q, radius_to(pose));
    }
    SpeedSearch(check_.speeds)
        .pass(times_.from(i).time, times_.to(i).time - times_.from(i).time, until,
              [&](double begin, double end) { return certifier_.joint_speeds(from, to, mode_, begin, end); });
  }

  /// An upper bound of the distance of poses between the last sample and this one from either: positions run
  /// straight and orientations turn about one axis. Samples are off the path by their rounding.
  double radius_to(const Pose& pose) {
    if (!options_.keep_samples) return 0.0;
    const RoundingUpward upward;
    const double radius = check_.samples.empty() ? 0.0
                                                 : distances_.distance(check_.samples.back().pose, pose) +
                                                       sample_rounding * manipulator_.size();
    return radius;
  }

  const SegmentCertifier& certifier_;
  const Manipulator& manipulator_;
  SegmentTimes<PoseWaypoint> times_;
  const WorkingMode& mode_;
  const TrajectoryCheckOptions& options_;
  TrajectoryCheck check_;
  TrajectorySurvey survey_;
  PoseCertifier distances_;
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

Problems waypoint_problems(const std::vector<PoseWaypoint>& waypoints) {
  if (waypoints.empty()) return {"The trajectory has no waypoint; give one or more."};
  Problems problems;
  for (std::size_t i = 0; i < waypoints.size(); ++i)
    if (!is_usable(waypoints[i]))
      problems.push_back(waypoint_text(i) + " has a number that is not finite or beyond 1e12; correct it.");
  if (problems.empty()) require_rising_times(waypoints, problems);
  return problems;
}

Problems problems_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     const WorkingMode& mode) {
  const std::vector<WorkingMode> modes = working_modes(manipulator);
  if (std::find(modes.begin(), modes.end(), mode) == modes.end())
    return {"'" + manipulator.name() + "' has no working mode " + to_string(mode) + "."};
  Problems problems = waypoint_problems(waypoints);
  if (!problems.empty()) return problems;
  const std::string start = start_problem(manipulator, waypoints.front().pose, mode);
  if (!start.empty()) problems.push_back(start);
  return problems;
}

TrajectoryCheck check_trajectory(const SegmentCertifier& certifier,
                                 const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode,
                                 const TrajectoryCheckOptions& options) {
  const Problems problems = problems_of(*certifier.manipulator(), waypoints, mode);
  if (!problems.empty()) return refused(problems);
  return PoseCheck(certifier, waypoints, mode, options).run();
}

namespace {

bool is_usable(const JointVector& values, Eigen::Index legs, bool required) {
  if (values.size() == 0) return !required;
  return values.size() == legs && values.allFinite() && is_usable_number(values.cwiseAbs().maxCoeff());
}

void check_numbers(const JointWaypoint& waypoint, const std::string& which, Eigen::Index legs,
                   Problems& problems) {
  if (!is_usable_number(waypoint.time) || !is_usable(waypoint.q, legs, true) ||
      !is_usable(waypoint.velocity, legs, false) || !is_usable(waypoint.acceleration, legs, false))
    problems.push_back(which + " needs " + std::to_string(legs) +
                       " finite joint values up to 1e12, and as many velocities and accelerations or none.");
  else if (waypoint.acceleration.size() > 0 && waypoint.velocity.size() == 0)
    problems.push_back(which + " has accelerations but no velocities; give both.");
}

}  // namespace

Problems problems_of(const Manipulator& manipulator, const std::vector<JointWaypoint>& waypoints,
                     const TrajectoryStart& start) {
  if (waypoints.empty()) return {"The trajectory has no waypoint; give one or more."};
  Problems problems;
  const auto legs = static_cast<Eigen::Index>(manipulator.leg_count());
  for (std::size_t i = 0; i < waypoints.size(); ++i)
    check_numbers(waypoints[i], waypoint_text(i), legs, problems);
  if (!problems.empty()) return problems;
  require_rising_times(waypoints, problems);
  if (manipulator.tolerance() > 0.0)
    problems.emplace_back(
        "Trajectories of actuated joints are not checked within a tolerance; leave it out.");
  const std::string misfit = start_misfit(manipulator, waypoints.front().q, start);
  if (!misfit.empty()) problems.push_back(misfit);
  return problems;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SampleDistances measured(BoundaryDistanceMeter& meter, const Pose& pose, const WorkingMode& mode) {
  const BoundaryDistances found = meter.measure(pose, mode);
  return {true, {found.parallel.lower, found.serial.lower, found.actuated_limit.lower}};
}

// A distance changes by no more than the robot moves.
void carry(const TrajectorySample& from, const SampleDistances& known, const TrajectorySample& to,
           SampleDistances& there) {
  if (there.measured) return;
  const double moved = std::abs(to.travel - from.travel) * (1.0 + 0x1p-50);
  for (std::size_t k = 0; k < known.lower.size(); ++k)
    there.lower[k] = std::max(there.lower[k], known.lower[k] - moved);
}

}  // namespace

std::vector<SampleDistances> distances_on(const std::shared_ptr<const Manipulator>& manipulator,
                                          const TrajectoryCheck& check, std::size_t points) {
  const std::vector<TrajectorySample>& samples = check.samples;
  if (points == 0 || samples.empty() || !check.mode) return {};
  std::vector<SampleDistances> distances(samples.size());
  BoundaryDistanceMeter meter(manipulator);
  const std::size_t last = samples.size() - 1, count = std::min(std::max<std::size_t>(points, 2), last + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = count == 1 ? 0 : i * last / (count - 1);
    distances[at] = measured(meter, samples[at].pose, *check.mode);
  }
  for (std::size_t i = 1; i <= last; ++i) carry(samples[i - 1], distances[i - 1], samples[i], distances[i]);
  for (std::size_t i = last; i-- > 0;) carry(samples[i + 1], distances[i + 1], samples[i], distances[i]);
  return distances;
}

std::array<double, 3> least_distances(const TrajectoryCheck& check,
                                      const std::vector<SampleDistances>& distances) {
  std::array<double, 3> least{infinity, infinity, infinity};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const SampleDistances& other = distances[i == 0 ? 0 : i - 1];
    const double moved =
        i == 0 ? 0.0 : (check.samples[i].travel - check.samples[i - 1].travel) * (1.0 + 0x1p-50);
    for (std::size_t k = 0; k < least.size(); ++k)
      least[k] = std::min(least[k], std::max(0.0, std::max(distances[i].lower[k], other.lower[k]) - moved));
  }
  return least;
}

}  // namespace parallel_aspects
