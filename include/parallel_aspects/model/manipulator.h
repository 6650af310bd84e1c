// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_MANIPULATOR_H
#define PARALLEL_ASPECTS_MODEL_MANIPULATOR_H

#include "parallel_aspects/model/constraints.h"
#include "parallel_aspects/model/leg.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What a manipulator is made of; plain data that `Manipulator` checks.
struct ManipulatorDescription {
  std::string name;                      ///< for people and messages
  TaskSpace task_space = TaskSpace::T2;  ///< where the platform moves
  std::vector<Leg> legs;                 ///< as many as the task space has degrees of freedom
  std::string base_frame = "base_link";  ///< link that `task_frame` is given in
  Eigen::Isometry3d task_frame = Eigen::Isometry3d::Identity();  ///< task frame in the base frame [m]
  Constraints constraints{};                                     ///< none by default
  HingePair hinges{};                                            ///< what holds the platform, in R2
};

/// A fully parallel manipulator (Definition 1 of the paper) with one distance equation a leg. Immutable.
class Manipulator {
 public:
  /// Throws `InvalidDescription` with every problem: wrong number of legs; lengths that are not finite and
  /// positive; directions that are not unit or not orthogonal; empty or repeated names; limits that are NaN
  /// or crossed; constraints that do not fit the legs.
  explicit Manipulator(ManipulatorDescription description);

  /// What it was made of; what follows are parts of it.
  const ManipulatorDescription& description() const noexcept { return description_; }
  const std::string& name() const noexcept { return description_.name; }     ///< for people and messages
  TaskSpace task_space() const noexcept { return description_.task_space; }  ///< where the platform moves
  /// The task space with the passive chain that it stands on in R2.
  Motions motions() const noexcept { return {description_.task_space, description_.hinges}; }
  const std::vector<Leg>& legs() const noexcept { return description_.legs; }         ///< see `JointVector`
  const Leg& leg(std::size_t index) const { return description_.legs[index]; }        ///< below `leg_count()`
  std::size_t leg_count() const noexcept { return description_.legs.size(); }         ///< 1 to `max_legs`
  const std::string& base_frame() const noexcept { return description_.base_frame; }  ///< as tf names it
  const Constraints& constraints() const noexcept { return description_.constraints; }  ///< none by default

  /// In the base frame.
  const Eigen::Isometry3d& task_frame() const noexcept { return description_.task_frame; }

  /// The kinds of constraints that there are, limits of actuated joints among them.
  ConstraintKinds constraint_kinds() const noexcept;

  /// The same manipulator with no constraints but those of these kinds that it has. Links of a planar robot
  /// that has no `self_collision` become segments without thickness there.
  /// Throws `InvalidDescription` where a kind is asked for that does not fit the legs.
  std::shared_ptr<const Manipulator> with_constraints(ConstraintKinds kinds) const;

  /// The same manipulator with other margins. Throws `InvalidDescription` where they are out of their range.
  std::shared_ptr<const Manipulator> with_margins(const Margins& margins) const;

  /// The same manipulator with a tolerance for each leg: this share of its size (see `Leg::tolerance`).
  /// Throws `InvalidDescription` where it is negative or not finite.
  std::shared_ptr<const Manipulator> with_tolerance(double share) const;

  /// The largest tolerance of a leg [m]; 0 by default.
  double tolerance() const noexcept;

  /// Root mean square distance of the anchors from the operational point [m]; the length that makes rotations
  /// and displacements comparable. 1 when the platform does not turn or all anchors are at the operational
  /// point.
  double characteristic_length() const noexcept { return characteristic_length_; }

  /// Size of the robot: the longest distance between two base points plus the longest reach of a leg that has
  /// one [m]. Residuals are judged relative to it.
  double size() const noexcept { return size_; }

  /// Whether every joint value is finite and inside its limits; `q` must have `leg_count()` entries.
  bool within_limits(const JointVector& q) const noexcept;

 private:
  ManipulatorDescription description_;
  double characteristic_length_;
  double size_;
};

/// How far two poses are apart: root mean square displacement of the anchors [m], in floating point.
inline double anchor_distance(const Manipulator& manipulator, const Pose& a, const Pose& b) noexcept {
  double sum = 0.0;
  for (const Leg& leg : manipulator.legs())
    sum += (a.transform(leg.anchor) - b.transform(leg.anchor)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(manipulator.leg_count()));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_MANIPULATOR_H
