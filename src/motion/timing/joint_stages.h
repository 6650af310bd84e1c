// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_TIMING_JOINT_STAGES_H
#define PARALLEL_ASPECTS_MOTION_TIMING_JOINT_STAGES_H

#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/motion/plan_path.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Velocity limits of the actuated joints, one a leg [rad/s or m/s].
JointVector velocity_limits(const Manipulator& robot);

/// How the actuated joints go along a planned path: one stage from each stop to the next, in each of which
/// they move smoothly. Corners are rounded where the rounded curve is proved, others are stops. Through
/// a serial gate the joint that passes goes on, while the pose turns back.
class JointStages {
 public:
  using Stages = std::vector<std::vector<JointVector>>;

  /// Finds which corners can be rounded, by blends that begin at most this share of a segment before them; 0
  /// for none. The certifier and the path must outlive it.
  JointStages(const SegmentCertifier& certifier, const PlannedPath& path, PoseBetween between, double share);

  /// Values of the joints along each stage; about `count` of all stages.
  Stages sample(std::size_t count) const;

  std::size_t rounded() const noexcept { return rounded_; }  ///< how many corners are
  std::size_t stops() const noexcept { return stops_; }      ///< how many are not

 private:
  /// A point of the path; at a gate both of those that have its pose.
  struct Node {
    Pose pose;
    WorkingMode mode;  // of what leaves it
    bool is_gate = false;
    double radius = 0.0;  // of the blend: how far from the node it begins and ends [m]
  };
  class Sampler;

  double length(std::size_t segment) const;
  Pose on_segment(std::size_t segment, double distance) const;
  Pose on_blend(std::size_t node, double radius, double t) const;
  bool is_sharp(std::size_t node, double radius) const;
  bool is_proved(std::size_t node, double radius) const;
  double find_radius(std::size_t node, double share) const;

  const SegmentCertifier& certifier_;
  const Manipulator& robot_;
  const PlannedPath& path_;
  PoseBetween between_;
  JointVector speeds_;  // limits
  std::vector<Node> nodes_;
  std::size_t rounded_ = 0, stops_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_TIMING_JOINT_STAGES_H
