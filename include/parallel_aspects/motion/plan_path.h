// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_PATH_H
#define PARALLEL_ASPECTS_MOTION_PLAN_PATH_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What a path may pass.
enum class PathPolicy {
  stay,    ///< nothing: it stays in one aspect
  serial,  ///< serial singularities, where a leg changes its posture; the platform is under control all along
  any,     ///< parallel singularities, too, where control of the platform is lost; no more than it takes
};

/// Which of several paths is wanted.
enum class PathPreference {
  shortest,  ///< the shortest that is found, clear and fast ones among them
  clear,     ///< that with the largest least parallel index
  fast,      ///< that which takes the least time
  quick,     ///< a short one that is found soonest; sometimes another way is shorter
};

struct PlannedPath;

/// How long a path takes [s]; infinite where it cannot be timed.
using PathTime = std::function<double(const PlannedPath&)>;

/// What is asked of a path besides its ends.
struct PathWish {
  PathPolicy policy = PathPolicy::stay;           ///< what it may pass
  PathPreference prefer = PathPreference::quick;  ///< which of several
  PathTime time{};  ///< by which the fastest is chosen, as `path_timer` makes one; not empty where asked for
};

/// Where a path begins or ends.
struct PathEnd {
  Pose pose;                        ///< in the task frame
  std::optional<WorkingMode> mode;  ///< by default any

  /// Values of the actuated joints that go with the pose [rad or m]: a path begins with the whole turns that
  /// angles without limits have made at its start. By default none.
  std::optional<JointVector> q{};
};

/// A point of a path. From one to the next the pose runs as `pose_between` says, or, in a slice that holds an
/// actuated joint, straight in direction and phi; in the working mode of both, and by no more than a quarter
/// turn, so that it cannot be taken for a turn the other way round. At a serial crossing the two
/// points have one pose, and one leg changes its posture. Through a parallel one the pose runs straight in
/// the coordinates of the map: in SE2 in x, y and phi.
struct PathPoint {
  Pose pose;         ///< in the task frame
  WorkingMode mode;  ///< in which it is reached
  JointVector q;     ///< actuated joints there [rad or m]; of angles the nearest to those before
};

/// From where there is a path around a cusp.
struct CuspStart {
  int aspect = 0;  ///< that the cusp belongs to, see `Cusp` of uniqueness.h; 0 where it is not known
  /// Nothing where none is found.
  std::optional<PathPoint> point;
};

/// Where a path goes from one aspect into another.
struct PathCrossing {
  Crossing kind = Crossing::serial;  ///< through a parallel one control of the platform is lost
  std::size_t point = 0;             ///< index of the last point before it
  std::size_t behind = 0;            ///< index of the first point behind it
  std::size_t leg = 0;               ///< whose B_jj is zero, where serial
  int from = 0;                      ///< id of the aspect before it
  int to = 0;                        ///< id of the aspect behind it
};

/// A path, or why there is none.
struct PlannedPath {
  SameAspect answer = SameAspect::unknown;  ///< whether there is one; yes and no are proved
  std::string message;                      ///< why
  std::vector<PathPoint> points;            ///< from the start to the goal, where the answer is yes
  std::vector<PathCrossing> crossings;      ///< in their order
  double length = 0.0;  ///< of the way of the operational point, by 32 chords a segment [m]
  double turned = 0.0;  ///< of the rotation of the platform, likewise [rad]

  /// Smallest parallel index and |det A| (unit as in `direct_determinant`) at 32 poses a segment: no bounds,
  /// which the margins of the manipulator give. Infinite without a path.
  double least_index = std::numeric_limits<double>::infinity();
  double least_det_a = std::numeric_limits<double>::infinity();  ///< see above

  explicit operator bool() const noexcept { return answer == SameAspect::yes; }  ///< whether there is a path
};

/// Plans paths in the region of one map. Every path is a theorem: each segment between two points is proved
/// free of singularities and within limits in its working mode. A crossing is proved as `Neighbours` says:
/// between the two points with one pose, the platform goes on along the segment to where B_jj is zero and
/// comes back, and the two points are as close to there as the segment is proved in either mode. Through a
/// parallel crossing, det A is proved to vanish exactly once. That there is no path is proved by the sign of
/// det A or by the leaves of the map; not where any crossing is allowed.
class PathPlanner {
 public:
  /// The map is not null. Gates are searched for with the first question that needs them.
  explicit PathPlanner(std::shared_ptr<const AspectMap> map);
  ~PathPlanner();
  PathPlanner(PathPlanner&&) noexcept;  ///< leaves an object that can only be destroyed or assigned
  PathPlanner& operator=(PathPlanner&&) noexcept;  ///< likewise

  /// Looks for a path; of several that are found the one that is preferred, so too where an end leaves the
  /// mode open. `unknown` where cancelled.
  PlannedPath plan(const PathEnd& from, const PathEnd& to, const PathWish& wish,
                   const MapControl& control = {});

  /// A short one that is found soonest.
  PlannedPath plan(const PathEnd& from, const PathEnd& to, PathPolicy policy, const MapControl& control = {});

  /// The pose at t, 0 to 1, from a point of a path to the next, but through a parallel crossing.
  Pose between(const Pose& from, const Pose& to, double t) const;

  /// The gates and sets that it plans with; nothing where cancelled.
  const AspectGraph* graph(const MapControl& control = {});

 private:
  class Search;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Looks for a path over a roadmap, in every task space, with six degrees of freedom too. `no` is proved by
/// signs and limits alone; that none is found proves nothing, and the answer is unknown. Parallel gates are
/// not searched for. At a serial crossing the actuated joints run straight from the one point to the other,
/// and that is certified by continuation: det A is not zero, of all B_jj that of `leg` alone is passed, in a
/// bracket, and all constraints hold, in both postures of the leg. `from`, `to` of a crossing are 0, as
/// aspects have no numbers here.
PlannedPath plan_in_roadmap(const PoseRoadmap& roadmap, const PathEnd& from, const PathEnd& to,
                            const PathWish& wish = {}, const MapControl& control = {});

/// "stay", "serial" or "any".
const char* name(PathPolicy policy) noexcept;

/// "short", "clear", "fast" or "quick".
const char* name(PathPreference preference) noexcept;

/// A component of a roadmap: sampled poses that proved segments join, all of one aspect. Two may belong to
/// one aspect.
struct RoadmapPart {
  int id = 0;                ///< from 1: by side of the roadmap, then falling number of poses
  WorkingMode mode;          ///< one sign a leg
  int determinant_sign = 0;  ///< +1 or -1
  std::size_t samples = 0;   ///< poses of it
};

/// The components of a roadmap as nodes, and the serial gates between them that are proved.
struct RoadmapGraph {
  std::vector<RoadmapPart> parts;  ///< by id

  /// Gates and sets of parts. The segment of a crossing has three poses: a sampled one of both parts, and two
  /// on the way to where B_jj is zero, all proved free in either mode. From the last of them the actuated
  /// joints run straight to their values in the other mode, as `plan_in_roadmap` says, and back to that pose.
  /// What joins a set is proved. Only the sign of det A proves sets different: `proved_set_count` is that of
  /// the signs, and workspaces are not measured.
  AspectGraph graph;
};

/// Looks for serial gates between the components of a roadmap, from some poses of each towards random poses.
/// Of components between which none is found nothing is claimed. Nothing where cancelled.
std::optional<RoadmapGraph> compute_roadmap_graph(const PoseRoadmap& roadmap, const MapControl& control = {});

/// The pose at t, 0 to 1, between two points of a path: `pose_between`, or that of the planner.
using PoseBetween = std::function<Pose(const Pose& from, const Pose& to, double t)>;

/// `pose_between` of these motions.
inline PoseBetween between_poses(const Motions& motions) {
  return [motions](const Pose& from, const Pose& to, double t) { return pose_between(motions, from, to, t); };
}

/// A planned path in time.
struct TimedPath {
  /// Positions and velocities of the actuated joints, from rest to rest, and no accelerations: between them
  /// the joints run as cubics. Times are whole nanoseconds. Empty where there is none that is proved.
  std::vector<JointWaypoint> waypoints;

  double seconds = 0.0;     ///< of all of it
  std::size_t rounded = 0;  ///< corners of the path that are rounded
  std::size_t stops = 0;    ///< corners at which it stops
  TrajectoryCheck check;    ///< what is proved of the waypoints
  std::string message;      ///< what was done, or why there is none; a sentence

  explicit operator bool() const noexcept { return !waypoints.empty(); }  ///< whether there is one
};

/// Every reason why paths of this robot cannot be timed, a message each: actuated joints without a velocity
/// limit, accelerations that are not one a leg, positive and finite, or a tolerance.
Problems problems_of(const Manipulator& manipulator, const JointVector& acceleration);

/// Times a path that was found: in the least time along it that the velocity limits of the joints and these
/// acceleration limits allow [rad/s^2 or m/s^2], which the cubics between the waypoints keep at every time.
/// The corners are rounded where that is proved. All of it is proved again by `check_trajectory`, and sampled
/// more densely until it is. There must be no `problems_of`.
TimedPath time_path(const SegmentCertifier& certifier, const PlannedPath& path, const PoseBetween& between,
                    const JointVector& acceleration, const MapControl& control = {});

/// How long a path takes as `time_path` times it, for `PathWish`. The certifier outlives it.
PathTime path_timer(const SegmentCertifier& certifier, PoseBetween between, const JointVector& acceleration,
                    const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_PATH_H
