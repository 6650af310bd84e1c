// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_STOPPING_CAMPAIGN_H
#define PARALLEL_ASPECTS_TEST_ROS_STOPPING_CAMPAIGN_H

#include "model/linear_algebra.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"
#include "ros/monitor/robot_monitor.h"

#include "support/pose_pairs.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace parallel_aspects::test {

/// How robots are actuated, for each of these speeds and noises; lengths over the robot's size.
struct StoppingPlan {
  std::vector<double> speeds{0.02, 0.1, 0.4};   // [1/s]
  std::vector<double> noises{0.0, 1e-5, 1e-4};  // of the encoders, evenly between plus and minus [rad or 1]
  double deceleration = 4.0;                    // [1/s^2]
  double rate = 500.0;                          // of the samples [Hz]
  int samples_a_measurement = 10;
  int runs = 3;  // for each robot, hazard, speed and noise
};

/// What became of runs into one kind of hazard. Distances are to the nearest hazard of any kind, as they are
/// proved at the true pose.
struct StoppingCounts {
  long runs = 0;
  long lost = 0;      ///< of them, those in which UNKNOWN came before STOP
  long too_near = 0;  ///< the first STOP or UNKNOWN came more than one sample's travel inside the threshold
  long passed = 0;    ///< the robot did not come to rest before the hazard
  /// Largest way inside the threshold at the first STOP, in travels of one sample.
  double inside = -std::numeric_limits<double>::infinity();
  /// Largest error of the pose at the last state before STOP, over the robot's size: what noise did to it.
  double pose_error = 0.0;
  /// Least distance that is proved to be left at rest, over the threshold.
  double left = std::numeric_limits<double>::infinity();
  std::string first_failure;
};

/// Actuated joints a robot straight from random configurations towards the nearest hazard of one kind, and
/// brakes at the first state whose level is STOP or more.
class StoppingCampaign {
 public:
  StoppingCampaign(std::shared_ptr<const Mechanism> mechanism, const StoppingPlan& plan, std::uint64_t seed)
      : mechanism_(std::move(mechanism)),
        robot_(mechanism_->manipulator()),
        plan_(plan),
        pairs_(robot_, seed),
        engine_(seed),
        meter_(robot_) {}

  StoppingCounts run(Hazard hazard) {
    StoppingCounts counts;
    for (const double speed : plan_.speeds)
      for (const double noise : plan_.noises)
        for (int i = 0; i < plan_.runs; ++i) {
          const double threshold = threshold_for(speed, noise);
          if (const auto path = find_path(hazard, threshold))
            actuation(*path, speed, noise, threshold, counts);
        }
    return counts;
  }

 private:
  static constexpr int max_samples = 1000000;

  /// A straight path from a configuration to a hazard.
  struct Path {
    Pose from, to;
    WorkingMode mode;
    double length;  // [m]
  };

  double size() const { return robot_->size(); }
  double travel(double speed) const { return speed * size() / plan_.rate; }

  // What docs/howto/tracking.md says: braking, what is travelled before it begins, and noise.
  double threshold_for(double speed, double noise) const {
    return speed * speed * size() / (2.0 * plan_.deceleration) + 3.0 * travel(speed) + 4.0 * noise * size();
  }

  double least(const BoundaryDistances& found) const {
    return std::min({found.parallel.lower, found.serial.lower, found.actuated_limit.lower});
  }
  static const BoundaryDistance& of(const BoundaryDistances& found, Hazard hazard) {
    return hazard == Hazard::parallel_singularity ? found.parallel
           : hazard == Hazard::serial_singularity ? found.serial
                                                  : found.actuated_limit;
  }

  // Legs with right angles on a sphere are singular, to the first order of B_jj and of det A, in single poses
  // of which no witness is found: where an anchor lies on the axis of its actuated joint. The nearest such
  // pose.
  std::optional<Pose> on_an_axis(const Pose& pose) const {
    std::optional<Pose> nearest;
    for (const Leg& leg : robot_->legs())
      for (const double side : {-1.0, 1.0}) {
        const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation);
        if (crank == nullptr || robot_->task_space() != TaskSpace::SO3) return std::nullopt;
        Pose turned = pose;
        turned.orientation =
            shortest_rotation(pose.transform(leg.anchor), side * crank->axis) * pose.orientation;
        if (!nearest || anchor_distance(*robot_, pose, turned) < anchor_distance(*robot_, pose, *nearest))
          nearest = turned;
      }
    return nearest;
  }

  // A pose to move to: the nearest of this kind that is known.
  std::optional<Pose> target(const Pose& pose, const BoundaryDistance& nearest) const {
    if (nearest.upper < 1e9) return nearest.witness;
    return nearest.lower < 1e9 ? on_an_axis(pose) : std::nullopt;
  }

  // Some thresholds long, with all hazards beyond theirs where it begins.
  std::optional<Path> find_path(Hazard hazard, double threshold) {
    for (int i = 0; i < 300; ++i) {
      const WorkingMode mode = pairs_.mode();
      const auto pose = pairs_.reached(mode);
      if (!pose) continue;
      const auto to = target(*pose, of(meter_.measure(*pose, mode), hazard));
      if (!to) continue;
      const double distance = anchor_distance(*robot_, *pose, *to);
      if (distance < 2.0 * threshold) continue;
      const Pose from = pose_between(*pose, *to, 1.0 - std::min(1.0, 4.0 * threshold / distance));
      const BoundaryDistances there = meter_.measure(from, mode);
      if (there.status != ConfigurationStatus::measured || !(least(there) > 1.5 * threshold)) continue;
      return Path{from, *to, mode, anchor_distance(*robot_, from, *to)};
    }
    return std::nullopt;
  }

  Pose at(const Path& path, double travelled) const {
    return pose_between(path.from, path.to, travelled / path.length);
  }

  std::optional<sensor_msgs::JointState> sample(const Path& path, double travelled, double noise,
                                                double time) {
    const InverseSolution solution = inverse(*robot_, at(path, travelled), path.mode);
    if (solution.status == InverseStatus::out_of_reach) return std::nullopt;
    sensor_msgs::JointState message;
    message.header.stamp = ros::Time(100.0 + time);
    for (std::size_t j = 0; j < robot_->leg_count(); ++j) {
      const Leg& leg = robot_->leg(j);
      const double unit = leg.actuated_by_angle() ? 1.0 : size();
      message.name.push_back(leg.actuated_joint);
      message.position.push_back(solution.q[static_cast<Eigen::Index>(j)] +
                                 noise * unit * std::uniform_real_distribution<double>(-1.0, 1.0)(engine_));
    }
    return message;
  }

  NodeOptions options(const Path& path, double noise, double threshold) const {
    const PoseCoordinates start = pose_coordinates(robot_->task_space(), path.from);
    NodeOptions options;
    options.start.pose = std::vector<double>(start.data(), start.data() + start.size());
    options.tracking.samples.encoder_noise = noise;
    ThresholdParameters& given = options.thresholds;
    given.parallel_stop = given.serial_stop = given.limit_stop = threshold;
    return options;
  }

  void actuation(const Path& path, double speed, double noise, double threshold, StoppingCounts& counts) {
    RobotMonitor monitor(mechanism_, options(path, noise, threshold));
    double travelled = 0.0, error = 0.0;
    bool clear = false;
    AspectState state;
    std::vector<Pose> measured{path.from};
    for (int i = 0; i < max_samples && (state.level < AspectState::STOP || !clear); ++i) {
      if (i > 2) travelled = std::min(path.length, travelled + travel(speed));  // the first stand still
      const auto message = sample(path, travelled, noise, i / plan_.rate);
      if (!message || (i > 2 && !clear)) return;  // lost at once
      const MonitorUpdate update = monitor.update(*message, message->header.stamp);
      state = *update.state;
      if (state.level < AspectState::STOP)
        error = anchor_distance(*robot_, update.tracked->pose, at(path, travelled));
      clear = clear || state.level == AspectState::CLEAR;
      if (i % plan_.samples_a_measurement != 0) continue;
      monitor.work();
      measured.push_back(at(path, travelled));
      if (update.tracked) measured.push_back(update.tracked->pose);
    }
    measured.push_back(at(path, travelled));
    judge(path, speed, threshold, travelled, error, measured, state, counts);
  }

  // Proved at the present pose, or at others that were measured lately, less the path from there: what is
  // proved may depend on the last digits of a pose, where the budget of the measurement was used up.
  double proved_distance(const Path& path, const std::vector<Pose>& measured, const Pose& now) {
    double best = 0.0;
    for (auto pose = measured.rbegin(); pose != measured.rend() && pose - measured.rbegin() < 6; ++pose)
      best = std::max(best, least(meter_.measure(*pose, path.mode)) - anchor_distance(*robot_, *pose, now));
    return best;
  }

  // Whether a singularity or a limit lies between, by signs at some poses.
  bool passes(const Path& path, double from, double to) const {
    const int sign = sign_in_doubles(*robot_, at(path, from), path.mode);
    for (int i = 0; i <= 20; ++i)
      if (sign_in_doubles(*robot_, at(path, from + (to - from) * i / 20.0), path.mode) != sign) return true;
    return sign == 0 || !(to < path.length);
  }

  void judge(const Path& path, double speed, double threshold, double travelled, double error,
             std::vector<Pose>& measured, const AspectState& state, StoppingCounts& counts) {
    ++counts.runs;
    counts.lost += state.level == AspectState::UNKNOWN;
    counts.pose_error = std::max(counts.pose_error, error / size());
    const double inside = threshold - proved_distance(path, measured, at(path, travelled)) - error;
    counts.inside = std::max(counts.inside, inside / travel(speed));
    const double velocity = speed * size();
    const double rest = travelled + travel(speed) + velocity * velocity / (2.0 * plan_.deceleration * size());
    measured.push_back(at(path, rest));
    const double left = proved_distance(path, measured, at(path, rest));
    counts.left = std::min(counts.left, left / threshold);
    const bool too_near = inside > (1.0 + 1e-6) * travel(speed), passed = passes(path, 0.0, rest);
    counts.too_near += too_near;
    counts.passed += passed;
    if ((too_near || passed) && counts.first_failure.empty())
      counts.first_failure = to_string(path.mode) + " from " + to_string(robot_->task_space(), path.from) +
                             " to " + to_string(robot_->task_space(), path.to) + " at " +
                             std::to_string(speed) + ", threshold " + std::to_string(threshold) +
                             ", inside by " + std::to_string(inside / travel(speed)) + " travels, left " +
                             std::to_string(left) + ", " + state.status.message + state.reason;
  }

  std::shared_ptr<const Mechanism> mechanism_;
  std::shared_ptr<const Manipulator> robot_;
  StoppingPlan plan_;
  PosePairs pairs_;
  std::mt19937_64 engine_;
  BoundaryDistanceMeter meter_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_STOPPING_CAMPAIGN_H
