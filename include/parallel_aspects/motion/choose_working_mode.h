// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_WORKING_MODE_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_WORKING_MODE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// What the best working mode of a path is best by.
enum class Preference {
  clear,   ///< the largest `PathClearance::lower`
  travel,  ///< the least travel of the actuated joints, in sum [rad, m]
  fast,    ///< the least time at the velocity limits
};

/// How far a path stays from singularities, in the metric of `BoundaryDistance`.
struct PathClearance {
  double lower = 0.0;  ///< proved: at no pose of the path is a singularity nearer than this [m]

  /// The least proved distance at the poses that were measured [m]; infinite where none was.
  double measured = std::numeric_limits<double>::infinity();

  double time = 0.0;         ///< of that pose [s]
  bool serial = false;       ///< whether the singularity near it is a serial one
  std::size_t leg = 0;       ///< whose, where serial
  std::size_t measures = 0;  ///< poses that were measured
};

/// What a path asks of one working mode.
struct ModeOnPath {
  WorkingMode mode;          ///< one sign a leg
  int determinant_sign = 0;  ///< of det A at the start, proved; 0 where it is not
  int aspect = 0;            ///< that holds the start; 0 where it is not known

  /// Whether all of the path can be done in it; where it cannot, why, and where it first fails.
  TrajectoryCheck check;

  // What follows is of all of the path, where it is proved to be safe.
  std::optional<PathClearance> clearance;  ///< to singularities
  std::vector<double> travel;              ///< of each actuated joint, from samples [rad or m]

  /// At the velocity limits of the actuated joints, from samples, however fast they start and stop [s];
  /// joints without a limit cost none.
  double least_time = 0.0;

  double total_travel() const noexcept;  ///< the sum of `travel`
};

/// In which working modes a path can be done.
struct PathChoice {
  /// Safe: in one of them or more. Unsafe: proved to fail in each.
  TrajectoryAnswer answer = TrajectoryAnswer::unknown;

  std::string reason;  ///< a sentence

  /// Every working mode: safe ones first, the best of them before all; then unknown ones; those that come
  /// farthest first.
  std::vector<ModeOnPath> modes;
};

/// How a path is looked at.
struct PathChoiceOptions {
  Preference preference = Preference::clear;  ///< what is best
  TrajectoryCheckOptions check{};             ///< how each working mode is checked
  int measures = 200;                         ///< poses at which distances are measured, at most
  const AspectMap* map = nullptr;             ///< that tells aspects, of the same manipulator; null for none
  MapControl control{};  ///< where cancelled, the working modes that are left are unknown
};

/// Every reason why no working mode can be chosen: those of a trajectory besides its working mode, and a
/// preference for `fast` where no actuated joint has a velocity limit.
Problems problems_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     Preference preference);

/// Checks a path as `check_trajectory` in every working mode, and puts the best first. There must be no
/// problems.
PathChoice choose_working_mode(const SegmentCertifier& certifier, const std::vector<PoseWaypoint>& waypoints,
                               const PathChoiceOptions& options = {});

/// A change of posture: the platform leaves a path, runs straight to a serial singularity of one leg, and
/// straight back in the other working mode.
///
/// Proved, as of `Neighbours`: on the way there the legs reach within limits, B of no other leg is zero, and
/// det A has the same sign in both modes, where B_jj = 0 too. Straight is meant in pose coordinates (of SO3
/// in those of its charts); poses are those of the path to rounding.
struct PostureChange {
  double time = 0.0;    ///< of the path, where it is left and gone on with [s]
  Pose pose;            ///< there
  Pose singular;        ///< where B_jj = 0, in floating point
  std::size_t leg = 0;  ///< j
  WorkingMode from;     ///< working mode before
  WorkingMode to;       ///< and after, which differs in that leg
  double detour = 0.0;  ///< how far it is there and back [m], rotations by the characteristic length
};

/// Part of a path in one working mode.
struct PathPiece {
  WorkingMode mode;    ///< in which all of it is proved to be safe
  double start = 0.0;  ///< [s]
  double end = 0.0;    ///< [s]
};

/// How a path can be done with changes of posture.
struct ChangingPath {
  /// Safe: as the pieces and changes say. Unsafe: a pose of the path is proved to lie in no aspect. Unknown:
  /// no changes were found, which proves nothing.
  TrajectoryAnswer answer = TrajectoryAnswer::unknown;

  std::string reason;                  ///< a sentence
  std::vector<PathPiece> pieces;       ///< where safe; each begins where the one before ends
  std::vector<PostureChange> changes;  ///< by rising time; several may be made at one pose
};

/// Looks for changes of posture that let all of a path be done: for as few as possible, and of those for the
/// shortest detours, at stations along the path. Lifts of the path are a graph: its nodes are a working mode
/// and a station; the path joins two of them where the piece between the stations is proved safe, and a
/// change where one is proved. There must be no problems. With six degrees of freedom nothing is found.
/// Where cancelled, unknown.
ChangingPath choose_posture_changes(const SegmentCertifier& certifier,
                                    const std::vector<PoseWaypoint>& waypoints,
                                    const MapControl& control = {});

/// What is known of a region in one working mode.
struct ModeInRegion {
  WorkingMode mode;  ///< one sign a leg

  /// Safe: all of the region is proved to lie in one aspect. Unsafe: it is proved not to.
  TrajectoryAnswer answer = TrajectoryAnswer::unknown;

  std::string reason;        ///< a sentence
  int determinant_sign = 0;  ///< of det A, where safe

  /// Where safe: the least normalised parallel index in the region is proved to lie in this range.
  IndexRange least_index;

  /// Where unsafe: a pose of the region that lies in no aspect of this mode, or two whose det A differ in
  /// sign. No path joins such two in this mode, and none leads to such a one.
  std::vector<Pose> witnesses;

  double undecided = 0.0;  ///< where unknown: how much of the region is not proved, of 1
};

/// In which working modes a region lies in one aspect.
struct RegionChoice {
  /// Safe: the region is t-connected, so that in some working mode every continuous path in it can be
  /// followed. Unsafe: proved not to be.
  TrajectoryAnswer answer = TrajectoryAnswer::unknown;

  std::string reason;  ///< a sentence

  /// Every working mode: those that hold the region first, the largest `least_index` before all.
  std::vector<ModeInRegion> modes;

  /// Where unsafe and found: two poses of the region that no path joins in any working mode, within the
  /// region or not, as long as the working mode is kept.
  std::optional<std::pair<Pose, Pose>> apart;
};

/// What region.
struct RegionQuestion {
  Box region;  ///< in the order of `coordinate_names` of the task space, or of the slice [m or rad]
  std::optional<MapSlice> slice{};  ///< which holds the other coordinates; needed with six degrees of freedom
};

/// How much work is done for a region.
struct RegionChoiceOptions {
  std::size_t boxes = 200000;  ///< that are looked at, at most
  MapControl control{};        ///< where cancelled, what is left is not proved
};

/// Every reason why a region cannot be looked at: ranges that are empty, not finite or of more than a
/// turn; another number of coordinates; a slice that is refused; orientations that have no coordinates.
Problems problems_of(const Manipulator& manipulator, const RegionQuestion& question);

/// Divides the region into boxes until each is proved, in every working mode. There must be no problems.
RegionChoice choose_working_mode(const std::shared_ptr<const Manipulator>& manipulator,
                                 const RegionQuestion& question, const RegionChoiceOptions& options = {});

/// How clear a way is.
struct PathMeasure {
  PathClearance clearance;  ///< `time` counts segments
  Pose narrowest;           ///< of the path, where `clearance.measured` was measured
};

/// Of at least two poses, from each of which the straight way to the next is proved free in this mode.
PathMeasure measure_path(const std::shared_ptr<const Manipulator>& manipulator,
                         const std::vector<Pose>& poses, const WorkingMode& mode);

/// What a map knows where neither poses nor roadmaps tell: sets an answer where it is yes or no. Yes comes
/// without a path.
void ask_map(const AspectMap& map, const PoseInMode& first, const PoseInMode& second,
             AspectComparison& comparison);

/// "clear", "travel" or "fast".
const char* name(Preference preference) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_WORKING_MODE_H
