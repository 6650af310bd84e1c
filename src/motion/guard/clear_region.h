// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_GUARD_CLEAR_REGION_H
#define PARALLEL_ASPECTS_MOTION_GUARD_CLEAR_REGION_H

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/tracking/hazards.h"

#include <array>
#include <cstddef>
#include <memory>

namespace parallel_aspects {

/// Proved: of a hazard, or a part of it that one leg makes, no pose with |y| <= radius has
/// clearance + normal . y > 0. The normal is of unit length, or zero where no pose of the hazard is there.
struct ClearHalfSpace {
  TaskVector normal;               ///< points away from the hazard
  double clearance = 0.0;          ///< [m]; negative where the pose itself is not proved to be clear
  std::size_t leg = 0;             ///< of serial singularities and limits
  LimitEnd end = LimitEnd::lower;  ///< of limits
};

/// As many as one hazard has: two a leg.
struct ClearHalfSpaces {
  static constexpr std::size_t most = 2 * max_legs;
  std::array<ClearHalfSpace, most> list;
  std::size_t count = 0;
};

/// How a twist moves the platform in the metric of distances.
struct MetricSpeed {
  TaskVector rate;        ///< of the coordinates y, at the pose [m/s]
  double path = 0.0;      ///< no path of this twist is longer in a second, wherever it leads [m/s]
  double turn = 0.0;      ///< of the platform [rad/s]
  double off = 0.0;       ///< `rate` and `path` may be off by this [m/s]
  double turn_off = 0.0;  ///< `turn` may be off by this [rad/s]
};

/// What is proved to be clear of hazards about one pose, by one enclosure over a ball: half spaces in the
/// coordinates y of LocalChart, in which the metric is the length. Made once; then it neither allocates nor
/// throws. Everything but the constructor needs a live `RoundingUpward`.
class ClearRegion {
 public:
  virtual ~ClearRegion() = default;

  /// Whether the metric sees every motion of the platform.
  virtual bool usable() const noexcept = 0;

  virtual void move_to(const Pose& pose, const WorkingMode& mode) noexcept = 0;

  virtual MetricSpeed speed_of(const TaskVector& twist) const noexcept = 0;

  /// No twist that turns and slides so fast has a longer rate [m/s].
  virtual double speed_at_most(double turn, double slide) const noexcept = 0;

  /// Half spaces that together hold what is clear of the hazard within `radius`; none where all is.
  virtual ClearHalfSpaces find(Hazard hazard, double radius) const noexcept = 0;

  /// Whether no pose of the hazard with |y| <= radius has ahead . y >= 0, where that is proved by few boxes;
  /// never with six degrees of freedom. `ahead` is of unit length.
  virtual bool is_ahead_clear(Hazard hazard, const TaskVector& ahead, double radius) noexcept = 0;

  /// Poses with |y|, |y'| <= radius are at least (1 - distortion) |y - y'| apart. At most 1.
  virtual double distortion(double radius) const noexcept = 0;

  /// Motions that turn by `angle` in all are off the straight line of their coordinates, along the rates at
  /// the pose, by no more than this [m].
  virtual double bend(double angle) const noexcept = 0;
};

/// Allocates.
std::unique_ptr<ClearRegion> make_clear_region(std::shared_ptr<const Manipulator> manipulator);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_GUARD_CLEAR_REGION_H
