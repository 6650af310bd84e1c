// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SEGMENT_CERTIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_SEGMENT_CERTIFIER_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/constraints.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

namespace parallel_aspects {

/// What stands in the way at a pose or on a segment.
enum class Violation {
  none,          ///< nothing that is known
  singularity,   ///< det A is zero, or has the other sign
  out_of_reach,  ///< a leg cannot reach, or just reaches: B_jj = 0
  joint_limit,   ///< an actuated joint is outside its limits
  constraint,    ///< another constraint of the manipulator does not hold
};

/// What is proved of one configuration.
struct ConfigurationProof {
  /// Of det A, where every leg is proved to reach and all constraints to hold; 0 where that is not proved.
  int sign = 0;

  Violation proved_violation = Violation::none;  ///< where it is proved to lie in no aspect
  std::optional<ConstraintKind> failing;         ///< which constraint, where the violation is one
  std::optional<std::size_t> leg;  ///< which leg cannot reach, or whose actuated joint is outside its limits
};

/// What is proved of all poses about one.
struct NeighbourhoodProof {
  bool free = false;  ///< proved of each: every leg reaches, all constraints hold, B_jj != 0
  Violation proved_violation = Violation::none;  ///< proved of each; never `singularity`
  std::optional<ConstraintKind> failing;         ///< which constraint, where the violation is one
  std::optional<std::size_t> leg;                ///< at fault, where it is one
};

/// What is proved of a whole segment.
enum class SegmentVerdict {
  free,       ///< proved: every leg reaches, all constraints hold, B_jj != 0 and det A != 0 all along
  blocked,    ///< proved not to be free
  undecided,  ///< neither, with the parts allowed
};

/// What is proved of a segment of poses; t runs from 0 to 1 along it.
struct SegmentProof {
  SegmentVerdict verdict = SegmentVerdict::undecided;  ///< of all of it
  Violation violation = Violation::none;               ///< where blocked: what is proved to stand in the way
  double free_until = 0.0;                             ///< proved free from t = 0 to here
  double witness = 0.0;             ///< where blocked: proved to be violated at or before this t
  int parts = 0;                    ///< that were tried
  ConfigurationProof at_witness{};  ///< where `prove_to_violation` says blocked: what is proved at `witness`
};

/// What is proved of how fast actuated joints move, in rad or m over t; one entry a leg.
struct SpeedBounds {
  std::array<double, max_legs> least{};  ///< nowhere slower
  std::array<double, max_legs> most{};   ///< nowhere faster
};

/// Proves segments of poses (see `PoseSegment`) free of singularities within one working mode, in every task
/// space, by interval arithmetic with outward rounding: parts of the segment are enclosed to the second order
/// and A is preconditioned by its inverse at the middle of the part. Immutable; may be used from any number
/// of threads. Neither allocates nor throws once it is made.
class SegmentCertifier {
 public:
  /// Allocates; `manipulator` is not null.
  explicit SegmentCertifier(std::shared_ptr<const Manipulator> manipulator);

  /// Whose segments it proves.
  const std::shared_ptr<const Manipulator>& manipulator() const noexcept { return manipulator_; }

  /// What is proved of the pose in this working mode. Nothing where numbers are not
  /// finite, lengths are beyond 1e12 m, or the quaternion is far from unit length.
  ConfigurationProof prove(const Pose& pose, const WorkingMode& mode) const noexcept;

  /// What is proved of the segment in this working mode; both poses must lie in the task space. At most
  /// `max_parts` parts are tried, each some microseconds.
  SegmentProof prove(const Pose& from, const Pose& to, const WorkingMode& mode,
                     int max_parts = 400) const noexcept;

  /// The same, but goes as far as it can towards `to` (see `free_until`), which may be anywhere.
  SegmentProof prove_start(const Pose& from, const Pose& to, const WorkingMode& mode,
                           int max_parts = 400) const noexcept;

  /// The same over all of the segment, both poses in the task space, and where it is blocked as near as it
  /// can to the first violation: `witness` and `free_until` are at most `width` apart unless the parts are
  /// used up. Where the start is violated itself, both are there. It starts at t = `begin`, 0 to 1.
  SegmentProof prove_to_violation(const Pose& from, const Pose& to, const WorkingMode& mode, double width,
                                  int max_parts = 2000, double begin = 0.0) const noexcept;

  /// Bounds of |dq/dt| over the part from `begin` < `end` of a segment. Nothing where the part is not proved
  /// to be within reach and constraints, or is too long for that.
  std::optional<SpeedBounds> joint_speeds(const Pose& from, const Pose& to, const WorkingMode& mode,
                                          double begin, double end) const noexcept;

  /// What is proved of every pose of the task space that is at most so far from this one: by `displacement`
  /// of the operational point [m] and by `angle` [rad]. In R2 both angles change by at most `angle`.
  NeighbourhoodProof prove_around(const Pose& pose, double displacement, double angle,
                                  const WorkingMode& mode) const noexcept;

  /// Whether all constraints but limits of actuated joints are proved at each of these poses that the legs
  /// reach in this working mode, B_jj = 0 too.
  bool constraints_hold_around(const Pose& pose, double displacement, double angle,
                               const WorkingMode& mode) const noexcept;

 private:
  struct Parts;
  class Evaluation;
  enum class Reach;

  NeighbourhoodProof prove_around(const Pose& pose, double displacement, double angle,
                                  const WorkingMode& mode, Reach reach) const noexcept;

  SegmentProof march(const Pose& from, const Pose& to, const WorkingMode& mode, int sign, int max_parts,
                     double first_step) const noexcept;

  std::shared_ptr<const Manipulator> manipulator_;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SEGMENT_CERTIFIER_H
