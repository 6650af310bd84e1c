// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_BOUNDARY_DISTANCES_H
#define PARALLEL_ASPECTS_DISTANCE_BOUNDARY_DISTANCES_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <limits>
#include <memory>

namespace parallel_aspects {

class SingularLeaves;

/// A map, made ready for `BoundaryDistanceMeter::use`: the parts of it that may hold a parallel singularity,
/// within limits or not, each with the plane that singularities in it lie near. Immutable; any number of
/// meters, of any threads, may use one. docs/development/benchmarks.md says how long it takes to make.
class DistanceMap {
 public:
  /// Looks into every leaf that is not inside an aspect, on all threads of the calling arena. Where `control`
  /// cancels it, it is not asked. Throws `InvalidDescription` for no map, and for that of a slice, which does
  /// not show what is beside it.
  explicit DistanceMap(std::shared_ptr<const AspectMap> map, const MapControl& control = {});
  ~DistanceMap();
  DistanceMap(const DistanceMap&) = delete;
  DistanceMap& operator=(const DistanceMap&) = delete;

  const std::shared_ptr<const AspectMap>& map() const noexcept { return map_; }  ///< never null
  const SingularLeaves& leaves() const noexcept { return *leaves_; }             ///< what may be singular

 private:
  std::shared_ptr<const AspectMap> map_;
  std::unique_ptr<const SingularLeaves> leaves_;
};

class DistanceMap;

/// What is known of the distance to one kind of boundary.
enum class DistanceStatus {
  tight,        ///< `lower` is proved and at least (1 - tolerance) `upper`
  loose,        ///< `lower` is proved, but the budget was used up before it came near `upper`
  no_witness,   ///< `lower` is proved; no pose of the boundary was found, so `upper` is infinite
  absent,       ///< proved: there is no such boundary in this working mode; `lower` is infinite
  touching,     ///< the configuration is on the boundary to rounding, or beyond its limits; `lower` is 0
  unavailable,  ///< nothing is known; see `ConfigurationStatus`
};

/// Which limit of an actuated joint.
enum class LimitEnd { lower, upper };

/// Distance from a configuration to the nearest boundary of one kind, in the metric
///
///     D^2 = mean |p_j(X) - p_j(X')|^2   over the anchors p_j of the legs   [m],
///
/// which is the distance of the operational points where the platform does not turn (T1, T2, T3).
struct BoundaryDistance {
  DistanceStatus status = DistanceStatus::unavailable;  ///< what the bounds are worth

  /// Proved, with outward rounding: no pose of the boundary is closer than this [m].
  double lower = 0.0;

  /// Distance of the witness [m]; infinite where there is none.
  double upper = std::numeric_limits<double>::infinity();

  /// Whether `upper` is a theorem too: the boundary is proved to have a pose at most this far away, within
  /// `upper` - D(witness) of the witness, by a change of sign. Where false, `upper` comes from floating-point
  /// arithmetic: as where det A touches zero without a change of sign.
  bool upper_proved = false;

  /// The nearest pose of the boundary that was found, of no meaning where `upper` is infinite.
  Pose witness;

  /// The actuated joint values at the witness [rad or m].
  JointVector witness_q;

  /// The path from the pose to the witness, as it starts: twist (w, v) as in `displaced`, such that the
  /// anchors move by 1 m a unit in the mean (D = 1 m to first order) [rad and m, a metre].
  TaskVector direction;

  /// `witness_q` less the present joint values [rad or m], angles of actuated joints without limits the short
  /// path round. An upper bound of how far each actuated joint has to go to the boundary, as far as `upper`
  /// is one: the witness is reached with these displacements. It is no lower bound; a smaller displacement
  /// may lead to another pose of the boundary.
  JointVector joint_displacement;

  std::size_t leg = 0;             ///< at fault; serial singularities and limits only
  LimitEnd end = LimitEnd::lower;  ///< which of its limits; limits only

  int boxes = 0;  ///< that were evaluated
};

/// Whether a configuration could be measured.
enum class ConfigurationStatus {
  measured,        ///< all three distances
  outside_limits,  ///< an actuated joint is at or beyond a limit; singularities are measured, the limit is
                   ///< `touching`
  at_serial_singularity,  ///< each leg reaches, but B_jj of one is 0 to rounding: the serial singularity is
                          ///< `touching`, det A = 0 is not measured, nor a limit unless it is `touching`
  out_of_reach,           ///< a leg does not reach; nothing is measured
  invalid,  ///< numbers not finite or beyond 1e9 m, a quaternion far from unit length, a mode that the legs
            ///< do not have, or anchors in one point or line, about which the metric sees no rotation
};

/// All of one configuration.
struct BoundaryDistances {
  ConfigurationStatus status = ConfigurationStatus::invalid;  ///< what was measured
  JointVector q;                    ///< joint values at the pose in the working mode [rad or m]
  BoundaryDistance parallel;        ///< to det A = 0
  BoundaryDistance serial;          ///< to B_jj = 0 of some leg
  BoundaryDistance actuated_limit;  ///< to a limit of some actuated joint
  /// Whether the distances are of a pose that is reached within limits.
  explicit operator bool() const noexcept { return status == ConfigurationStatus::measured; }
};

/// How much work is spent.
struct DistanceOptions {
  /// Relative gap between the bounds that is aimed at, in (0, 1). With a map five times as much is enough to
  /// the search for det A = 0 once it has evaluated 20 boxes.
  double tolerance = 0.01;
  /// Evaluated in one search, at least 1; there are three. In six degrees of freedom the search for det A = 0
  /// evaluates a 32nd of it, for its boxes take so much longer, but 5 at least.
  int max_boxes = 400;
};

/// Measures how far a configuration (pose X, working mode s) is from
///  - the nearest parallel singularity: poses where every leg reaches on branch s and det A = 0;
///  - the nearest serial singularity: poses where every leg reaches and some B_jj = 0;
///  - the nearest limit: poses where every leg reaches on branch s and some actuated joint is at its limit.
/// Each is the distance to a set of poses of the working mode, whether or not the path there leaves the mode;
/// so the ball of poses with D < lower holds no such pose, and its part of the aspect none at all. Ranges of
/// a full turn or more limit no pose. docs/theory/distance.md says how, and what is proved.
///
/// One object for each thread: `measure` uses memory that is taken by the constructor. Its results depend on
/// the arguments and the map alone, not on earlier calls.
class BoundaryDistanceMeter {
 public:
  /// Allocates. Throws `InvalidDescription` for options out of range.
  explicit BoundaryDistanceMeter(std::shared_ptr<const Manipulator> manipulator,
                                 const DistanceOptions& options = {});
  ~BoundaryDistanceMeter();
  BoundaryDistanceMeter(BoundaryDistanceMeter&&) noexcept;             ///< takes the memory along
  BoundaryDistanceMeter& operator=(BoundaryDistanceMeter&&) noexcept;  ///< takes the memory along

  /// From now on asks this map, too, of the same manipulator, or none where it is null. What it proves is
  /// searched for no more, so that bounds are tighter and come sooner; they are to the same boundaries.
  /// Throws `InvalidDescription` for the map of another manipulator.
  void use(std::shared_ptr<const DistanceMap> map);

  /// Neither allocates nor throws.
  BoundaryDistances measure(const Pose& pose, const WorkingMode& mode) noexcept;

 private:
  class Searches;
  template <TaskSpace>
  class SearchesIn;
  class HingeSearches;

  std::unique_ptr<Searches> searches_;
};

/// "tight", "loose", "no witness", "absent", "touching" or "unavailable".
const char* name(DistanceStatus status) noexcept;

/// "measured", "outside limits", "at a serial singularity", "out of reach" or "invalid".
const char* name(ConfigurationStatus status) noexcept;

/// "lower" or "upper".
const char* name(LimitEnd end) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_BOUNDARY_DISTANCES_H
