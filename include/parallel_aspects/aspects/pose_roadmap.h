// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_POSE_ROADMAP_H
#define PARALLEL_ASPECTS_ASPECTS_POSE_ROADMAP_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

  std::shared_ptr<const Manipulator> manipulator_;
  std::shared_ptr<const Parts> parts_;
};

/// What to sample.
struct RoadmapOptions {
  std::size_t samples = 1000;  ///< reachable poses, 1 to 100,000
  std::uint64_t seed = 1;      ///< the same seed gives the same roadmap, whatever the threads
  std::size_t neighbors = 10;  ///< nearest poses that each pose is joined to where that is proved, 1 to 100

  /// Positions to sample [m]; by default all that the legs reach.
  std::optional<Box> region;

  /// Orientations turn from the identity by at most this [rad], 0 to pi; by default all.
  double largest_rotation = EIGEN_PI;

  std::vector<WorkingMode> modes;  ///< by default all that the legs allow

  unsigned threads = 0;  ///< 0 for one a core
};

/// The part of a roadmap that has one working mode and one sign of det A: both proved for each of its poses.
struct RoadmapSide {
  WorkingMode mode;          ///< one sign a leg
  int determinant_sign = 0;  ///< +1 or -1

  /// Indices of its poses in the roadmap, rising. What follows counts by the place in this list.
  std::vector<std::uint32_t> poses;

  /// Segments that are proved free join each pose to these; a forest.
  std::vector<std::vector<std::uint32_t>> links;

  std::vector<std::uint32_t> component;      ///< of each pose
  std::vector<std::size_t> component_sizes;  ///< poses in each component, falling
};

/// A certified roadmap of every working mode and sign of det A: sampled reachable poses, joined by segments
/// that are proved free of singularities. So every connection is a theorem; that two poses are not connected
/// proves nothing, and the number of components may fall with more samples. For every task space. Immutable;
/// may be read from any number of threads.
class PoseRoadmap {
 public:
  /// What was computed with these options, in so many seconds; `compute_pose_roadmap` makes one.
  PoseRoadmap(SegmentCertifier certifier, std::vector<Pose> poses, std::vector<RoadmapSide> sides,
              const RoadmapOptions& options, double seconds);

  /// What its segments were proved with.
  const SegmentCertifier& certifier() const noexcept { return certifier_; }

  /// What it was computed with.
  const RoadmapOptions& options() const noexcept { return options_; }

  /// All that were sampled, in the task frame.
  const std::vector<Pose>& poses() const noexcept { return poses_; }

  /// Those with at least one pose: by mode index, then positive before negative det A.
  const std::vector<RoadmapSide>& sides() const noexcept { return sides_; }

  /// Lower bound of the number of aspects, proved: one for each side, as aspects do not share signs.
  std::size_t proved_count() const noexcept { return sides_.size(); }

  /// Sets of poses that are proved connected, over all sides: the poses lie in at most so many aspects.
  std::size_t component_count() const noexcept;

  /// Time that the computation took [s].
  double seconds() const noexcept { return seconds_; }

  /// The poses of one mode and sign; null where there are none.
  const RoadmapSide* side(const WorkingMode& mode, int sign) const noexcept;

 private:
  SegmentCertifier certifier_;
  std::vector<Pose> poses_;
  std::vector<RoadmapSide> sides_;
  RoadmapOptions options_;
  double seconds_;
};

/// A roadmap, or why there is none.
struct RoadmapResult {
  MapStatus status = MapStatus::refused;       ///< how the computation ended
  std::string message;                         ///< why, unless complete
  std::shared_ptr<const PoseRoadmap> roadmap;  ///< set when complete

  explicit operator bool() const noexcept { return roadmap != nullptr; }  ///< whether there is a roadmap
};

/// Samples poses and joins them. Options out of range, and legs that leave the positions unbounded, are
/// refused with a message.
RoadmapResult compute_pose_roadmap(std::shared_ptr<const Manipulator> manipulator,
                                   const RoadmapOptions& options = {}, const MapControl& control = {});

/// How much is tried to join a pose to a roadmap.
struct LocationBudget {
  std::size_t samples = 24;  ///< the nearest ones of the same working mode and sign of det A
  int parts = 100;           ///< of each segment, some microseconds each
};

/// What a roadmap says of a configuration. Whatever is set is proved.
struct RoadmapLocation {
  int determinant_sign = 0;                ///< 1 or -1; 0 where it is not proved
  std::optional<std::uint32_t> component;  ///< of that side; nothing where no segment to it was proved free
};

/// The component that a segment proved free of singularities joins the pose to.
RoadmapLocation locate(const PoseRoadmap& roadmap, const Pose& pose, const WorkingMode& mode,
                       const LocationBudget& budget = {});

/// A configuration: a pose, and the branch of each leg.
struct PoseInMode {
  Pose pose;         ///< in the task frame
  WorkingMode mode;  ///< one sign a leg
};

/// Both yes and no are proved.
enum class SameAspect { yes, no, unknown };

/// What `same_aspect` found.
struct AspectComparison {
  SameAspect answer = SameAspect::unknown;  ///< whether both are in one aspect
  std::string message;                      ///< why

  /// Where the answer is yes: poses from the first to the second; each `PoseSegment` from one to the next is
  /// proved free of singularities and within limits.
  std::vector<Pose> path;

  /// The sign of det A at both where a path was searched for and none was found; 0 where no search can help.
  int searched_sign = 0;

  /// Where the answer is no since one of them lies in no aspect: the constraint that is proved to fail there,
  /// if it is one.
  std::optional<ConstraintKind> failing{};
};

/// Whether two configurations lie in one aspect, by what is proved of them and of the segment between them.
///  - no: they differ in the working mode or in the sign of det A, or one is proved to lie in no aspect.
///  - yes: the segment is proved free.
///  - unknown: neither; or one is too close to a singularity or a limit.
AspectComparison same_aspect(const SegmentCertifier& certifier, const PoseInMode& first,
                             const PoseInMode& second);

/// How long a path is searched for where the roadmap has none.
enum class SearchEffort {
  brief,     ///< some milliseconds; for questions of which there are many
  thorough,  ///< up to a second or so; through narrow passages, too
};

/// The same, and yes also where a path is found over the roadmap or over poses sampled for this question.
/// That none was found proves nothing. The same roadmap gives the same answer.
AspectComparison same_aspect(const PoseRoadmap& roadmap, const PoseInMode& first, const PoseInMode& second,
                             SearchEffort effort = SearchEffort::thorough);

/// "yes", "no" or "unknown".
const char* name(SameAspect answer) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_POSE_ROADMAP_H
