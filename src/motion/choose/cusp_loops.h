// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_CUSP_LOOPS_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_CUSP_LOOPS_H

#include "motion/plan/map_segments.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// An estimate of the largest error of the actuated joints at a pose with which no other assembly mode fits
/// them: 0 at det A = 0 [rad or m].
double room_at(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// The legs of SE2 whose joints are not held.
std::array<Eigen::Index, 2> free_legs(std::size_t held);

/// Ways in one aspect of a slice that holds an actuated joint, from one pose, whose actuated values go around
/// a cusp. They are searched for on a grid in direction and phi with that pose on it: first the largest least
/// room that a way has, then a short one with that much.
class CuspLoops {
 public:
  /// All but the pose outlive it.
  CuspLoops(const AspectMap& map, const MapSegments& segments, const WorkingMode& mode, int aspect,
            const Pose& from, const MapControl& control);

  /// From there around a cusp of these actuated values to another pose of the values of the start, each
  /// segment proved free; empty where none is found.
  std::vector<Pose> find(const JointVector& cusp, const Pose& goal);

 private:
  struct Node {
    double room = 0.0;  // 0 outside of the aspect
    JointVector q;
  };
  class Search;

  void fill(const MapControl& control);
  Pose pose(std::size_t node) const;
  std::vector<std::size_t> around(const Pose& pose) const;
  std::array<std::size_t, 8> neighbours(std::size_t node) const;
  int passes_cut(const JointVector& from, const JointVector& to, const JointVector& cusp) const;
  bool keeps(const Pose& from, const Pose& to, double room, int passes, const JointVector& cusp) const;
  std::vector<Pose> shortened_beside_cusp(const std::vector<Pose>& poses, double room,
                                          const JointVector& cusp, std::optional<std::size_t>& barred) const;
  JointVector values(const Pose& pose) const;

  const AspectMap& map_;
  const MapSegments& segments_;
  const Manipulator& robot_;
  WorkingMode mode_;
  int aspect_, sign_;
  Pose from_;
  AnchorCircle circle_;
  std::array<Eigen::Index, 2> legs_;
  Eigen::Vector2d origin_;  // direction and phi of the start
  std::vector<Node> nodes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_CUSP_LOOPS_H
