// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Where three direct solutions of a slice meet. A path of actuated values around it leads from one of the
/// three to another in the same aspect, without a singularity.
struct Cusp {
  JointVector actuated;  ///< all actuated joints, that which is held among them [m or rad]
  WorkingMode mode;      ///< of all three
  Pose pose;             ///< where the three meet
  /// A box about the pose, of half this width in both coordinates of the slice [rad], is proved to hold
  /// exactly one cusp, an ordinary one. In SE2 these are the direction of the held rod and phi; in SO3 the
  /// platform is turned about the anchor of the held rod, and then that about its proximal point.
  double accuracy = 0.0;
  /// Id, in the map of the slice, of the aspect that paths around it run in: beside the cusp both solutions
  /// of equal sign of det A are followed away from it until the map is certain to have both in this one. That
  /// they come from the cusp is not proved. 0 where it is not known, and where there is no map.
  int aspect = 0;
};

/// Where two pairs of direct solutions of a slice meet at once: two singular poses of the same actuated
/// values, where the image of det A = 0 crosses itself.
struct SolutionNode {
  JointVector actuated;       ///< all actuated joints, that which is held among them [m]
  std::array<Pose, 2> poses;  ///< where either pair meets
  /// Boxes about both, of half this width in the direction of the held rod and in phi [rad], are proved to
  /// hold exactly one such pair of poses.
  double accuracy = 0.0;
};

/// A connected set of poses of one aspect in which no two have the same actuated values, over a connected set
/// of actuated values with a constant number of solutions (a basic region).
struct BasicRegion {
  int aspect = 0;        ///< id, in the map; 0 where it is not known
  std::size_t over = 0;  ///< regions with the same lie over the same connected set of actuated values
  Pose pose;             ///< one of it
  JointVector actuated;  ///< the values of this pose [m]
  double measure_lower =
      0.0;  ///< of the actuated values for which all this is proved [m^2, or m^3 of all three]
  /// It is proved that no two of its poses have the same actuated values; else no domain is known to hold it.
  bool is_unique = false;
};

/// A set of poses of one aspect that is connected and has no two poses of the same actuated values: there the
/// actuated joints determine the pose (Ph. Wenger and D. Chablat, Uniqueness domains and regions of feasible
/// paths for fully-parallel manipulators, 1998). None of the basic regions that are listed can be added to it
/// by the paths between them that were found; one that was not found could make it larger.
struct UniquenessDomain {
  int aspect = 0;                            ///< id, in the map
  bool whole_aspect = false;                 ///< by the theorem for T1, T2 and T3
  std::vector<std::size_t> basic_regions{};  ///< else: indices in the list; proved paths join them
  double measure_lower = 0.0;                ///< of their actuated values [m^2 or m^3]
};

/// A direct solution that is proved: the ball about the pose holds exactly one pose that the actuated values,
/// as the numbers that they are, assemble with. A path in the ball without singularities and within all
/// constraints leads from there to `pose` itself, in this working mode, so that both lie in one aspect.
struct ProvedSolution {
  Pose pose;                 ///< in the task frame
  WorkingMode mode;          ///< of both
  int determinant_sign = 0;  ///< of both, 1 or -1
  double radius = 0.0;       ///< of the ball, in the metric of `PoseCertifier::distance` [m]
};

/// Numbers of poses, by the number of direct solutions that their actuated values have.
using PosesBySolutions = std::map<std::size_t, std::size_t>;

/// Two different direct solutions of the same actuated values, and a path from one to the other, all proved:
/// the aspect that holds it is no uniqueness domain.
struct AssemblyChange {
  JointVector actuated;    ///< of both [rad or m]
  ProvedSolution from;     ///< where the path begins
  ProvedSolution to;       ///< where it ends
  std::vector<Pose> path;  ///< of their poses; each `PoseSegment` is proved free of singularities
};

/// Of the poses of one component of a roadmap, all in one aspect.
struct ComponentSurvey {
  WorkingMode mode;                      ///< of that side of the roadmap
  int determinant_sign = 0;              ///< 1 or -1
  std::uint32_t component = 0;           ///< of that side of the roadmap, from 0
  std::size_t samples = 0;               ///< poses that the roadmap has in it
  std::size_t poses = 0;                 ///< of these, that were examined
  PosesBySolutions in_aspect;            ///< solutions that are proved to be in the same aspect, so at least
  std::size_t unknown = 0;               ///< solutions that may be in it, too
  std::optional<AssemblyChange> change;  ///< where one was found
};

/// How many direct solutions the actuated values of a roadmap's poses have, and in which aspects.
struct AssemblySurvey {
  std::size_t poses = 0;       ///< that were examined
  std::size_t incomplete = 0;  ///< poses whose solutions the direct solver says it may not have found all
  PosesBySolutions solutions;  ///< poses, by the solutions that were found, in whichever aspect
  std::vector<ComponentSurvey> components;  ///< of which there are poses, as the roadmap has them
};

/// What is known of uniqueness domains about two basic regions.
enum class DomainSharing {
  shared,   ///< one that is listed holds both
  apart,    ///< proved: none holds both, since they share actuated values or lie in different aspects
  unknown,  ///< none that is listed holds both
};

/// Actuated values that have one number of direct solutions.
struct SolutionRegion {
  WorkingMode mode;            ///< of the solutions that are counted; empty: of all working modes at once
  std::size_t solutions = 0;   ///< at least 1; proved of `measure_lower`
  double measure = 0.0;        ///< best estimate [m^2, or m^3 of all three joints]
  double measure_lower = 0.0;  ///< proved [m^2 or m^3]
  double measure_upper = 0.0;  ///< proved [m^2 or m^3]
};

/// A connected set of actuated values over which the number of solutions in each aspect is constant (a basic
/// component), as far as their division shows it.
struct BasicComponent {
  WorkingMode mode;             ///< of the solutions; empty: all working modes at once
  JointVector inside;           ///< actuated values in it [m]
  std::vector<Pose> solutions;  ///< all poses of these, proved
  std::vector<int> aspects;     ///< id of the aspect that holds each; 0 where no map can decide
  double measure = 0.0;         ///< best estimate [m^2, or m^3 of all three joints]
  double measure_lower = 0.0;   ///< proved [m^2 or m^3]
};

/// The cusps of a slice.
struct CuspList {
  std::vector<Cusp> cusps;  ///< within limits, by rising actuated values
  bool complete = false;    ///< it is proved that there are no others within limits
  /// Where it is not complete: bounds leave curves of poses, as those along which the platform can move while
  /// all actuated joints stand; such curves are not examined closely.
  bool leaves_curves = false;
};

/// An actuated joint that is held at each value of a range in turn.
struct HeldRange {
  std::size_t leg = 0;  ///< whose joint it is, from 0
  double lower = 0.0;   ///< [m or rad]
  double upper = 0.0;   ///< [m or rad]
};

/// What there is along a curve of cusps, or at its end.
enum class CuspEventKind {
  range_end,  ///< the value that is held comes to an end of its range
  limit,      ///< another joint comes to a limit
  turn,       ///< the value that is held turns back, so that two cusps of a slice meet and vanish there
  serial,   ///< the leg whose joint is held passes a serial singularity, and with it the working mode changes
  unknown,  ///< the curve was not followed farther, or more than one of these is there
};

/// Somewhere in this interval of the value that is held, by proof.
struct CuspEvent {
  CuspEventKind kind = CuspEventKind::unknown;  ///< what is there
  double lower = 0.0;                           ///< [m or rad]
  double upper = 0.0;                           ///< [m or rad]
};

/// A piece of a curve of cusps within limits, over the value that is held. That it is one, without any other
/// near it, is proved along all of it.
struct CuspCurve {
  /// Points of it in turn, near enough for pictures. A box about the pose and the value that is held, of half
  /// this `accuracy`, is proved to hold a cusp of the curve.
  std::vector<Cusp> points;
  bool closed = false;  ///< whether it comes back to its first point
  /// Those along the curve in turn, with its ends unless it is closed. Between two of them in turn the value
  /// that is held rises all the way, or falls.
  std::vector<CuspEvent> events;
};

/// The number of cusps of each slice between two values.
struct CuspCount {
  double lower = 0.0;     ///< [m or rad]
  double upper = 0.0;     ///< [m or rad]
  std::size_t cusps = 0;  ///< exactly, for each value between these two
};

/// All cusps of the slices that hold a joint in a range, within limits.
struct CuspCurves {
  HeldRange range;                ///< that was asked for
  std::vector<CuspCurve> curves;  ///< all that were found
  /// By rising value, all proved. Between them are events, where the number may change, and what is
  /// `undecided`.
  std::vector<CuspCount> counts;
  bool complete = false;  ///< it is proved that there are no other curves
  /// Where there may be more, else: values of the joint, by rising value.
  std::vector<CuspEvent> undecided;
};

/// What to compute.
struct UniquenessOptions {
  /// One that holds an actuated joint, in SE2 alone; needed there with an actuated elbow, or with a strut or
  /// slide that has no limits.
  std::optional<MapSlice> slice;
  std::optional<double> resolution;  ///< of the map of the aspects, see `MapOptions`
  /// The division of actuated values for numbers of solutions ends at so many cells, that for basic regions
  /// at a quarter of them; by default at 250,000. With several working modes all share in them. In slices
  /// that is never reached.
  std::optional<std::size_t> most_cells;
};

/// How many direct solutions actuated values have.
struct SolutionNumbers {
  /// Whether they were searched for: in SE2 and in slices of SO3, unless a leg has an actuated elbow. Else
  /// what is below is empty.
  bool has_regions = false;
  /// Whether they are numbers of solutions in each working mode, not in all at once: of robots with several
  /// of these as a whole. All is of one mode then, and `measure_unknown` the sum over them.
  bool by_mode = false;
  /// Of measures of actuated values, as "m^2" or "rad^2". Angles that are whole turns apart count once.
  std::string region_unit;
  std::vector<SolutionRegion> regions;           ///< by mode and number of solutions
  double measure_unknown = 0.0;                  ///< where no number of solutions is proved [that unit]
  std::vector<BasicComponent> basic_components;  ///< those with solutions, the largest first
  /// Index in `basic_components` of that which holds these actuated values (of which a held one is not
  /// read), for a working mode where these are `by_mode`. Nothing where they have no solution, no number of
  /// solutions is proved, or these are no values.
  std::function<std::optional<std::size_t>(const JointVector&, const WorkingMode&)> component_of;

  /// The same. Unless components are `by_mode`, the mode is not read.
  std::optional<std::size_t> component_at(const JointVector& actuated, const WorkingMode& mode = {}) const {
    return component_of ? component_of(actuated, mode) : std::nullopt;
  }
};

/// Which poses of an aspect have the same actuated values, and where direct solutions meet.
struct Uniqueness : SolutionNumbers {
  std::shared_ptr<const AspectMap> map;  ///< of the aspects of the robot, or of the slice
  /// The direct problem has at most two solutions, at which det A has opposite signs. So each aspect,
  /// whatever limits and constraints bound it, is a uniqueness domain, and no three solutions meet anywhere.
  bool at_most_one_a_sign = false;
  /// Of a slice, within limits, by rising actuated values. Of all poses cusps form curves, and none are
  /// listed.
  std::vector<Cusp> cusps;
  bool cusps_complete = false;  ///< it is proved that there are no others within limits
  bool has_nodes = false;       ///< whether nodes were searched for, of slices of robots with three struts
  std::vector<SolutionNode> nodes;  ///< likewise
  bool nodes_complete = false;      ///< it is proved that there are no others within limits
  /// Whether basic regions and domains were searched for, where there are numbers of solutions; else they are
  /// empty.
  bool has_domains = false;
  std::vector<BasicRegion> basic_regions;  ///< over sets of actuated values that are not tiny
  /// Index in `basic_regions` of that which holds a pose in a working mode, or the direct solution beside it
  /// that has its actuated values as they are rounded; nothing where that is not proved, and outside of
  /// limits. It takes some steps of interval arithmetic, and may be called from any thread.
  std::function<std::optional<std::size_t>(const Pose&, const WorkingMode&)> region_of;
  /// Indices of the basic regions that a path visits which goes from pose to pose as `pose_between` does, and
  /// is known to be free of singularities. Nothing unless it is proved that these regions and the path
  /// together form a connected set without two poses of the same actuated values, so that a uniqueness domain
  /// holds it. Of all poses; empty for slices.
  std::function<std::optional<std::vector<std::size_t>>(const std::vector<Pose>&)> regions_along;
  bool domains_complete = true;           ///< whether all domains that these regions form are listed
  std::vector<UniquenessDomain> domains;  ///< by aspect

  /// The basic region of a pose, as `region_of` has it. Of a robot with one working mode, as with three
  /// struts, the mode is not read.
  std::optional<std::size_t> locate(const Pose& pose, const WorkingMode& mode = {}) const {
    return region_of ? region_of(pose, mode) : std::nullopt;
  }

  /// Indices of the domains that hold a basic region.
  std::vector<std::size_t> domains_of(std::size_t region) const;

  /// Whether one domain holds both basic regions.
  DomainSharing sharing(std::size_t region, std::size_t other) const;
};

/// What was computed, or why there is nothing.
struct UniquenessResult {
  MapStatus status = MapStatus::refused;         ///< how the computation ended
  std::string message;                           ///< why, unless complete
  std::shared_ptr<const Uniqueness> uniqueness;  ///< set when complete

  explicit operator bool() const noexcept { return uniqueness != nullptr; }  ///< whether there is an answer
};

/// Computes all of it. In T1, T2 and T3 it follows from a theorem. In SE2 there are slices with an actuated
/// joint held: their cusps, and unless a leg has an actuated elbow all the rest; and robots without actuated
/// elbows as a whole, but for cusps, where struts and slides have limits. What remains is refused with a
/// message.
UniquenessResult compute_uniqueness(std::shared_ptr<const Manipulator> manipulator,
                                    const UniquenessOptions& options = {}, const MapControl& control = {});

/// The same with a map that is there, of all poses or of such a slice; slice and resolution of the options
/// are not read.
UniquenessResult compute_uniqueness(std::shared_ptr<const AspectMap> map,
                                    const UniquenessOptions& options = {}, const MapControl& control = {});

/// The cusps alone of a robot of SE2 or SO3 with a joint held; a cancelled list is not complete. Where there
/// is a `find_cusps_problem` there is no answer.
CuspList find_cusps(const Manipulator& manipulator, const HeldJoint& joint, const MapControl& control = {});

/// The numbers alone, in the slice of SE2 or SO3 that holds a joint there: without a map, so that no aspects
/// are known. Empty with an actuated elbow, or when cancelled.
SolutionNumbers count_direct_solutions(const Manipulator& manipulator, const HeldJoint& joint,
                                       const MapControl& control = {});

/// Why there is no list of cusps with this joint held; empty where there is one.
std::string find_cusps_problem(const Manipulator& manipulator, const HeldJoint& joint);

/// The curves that cusps form over the value that is held; a cancelled list is not complete. Of a range with
/// a `find_held_range_problem` there is no answer.
CuspCurves find_cusp_curves(const Manipulator& manipulator, const HeldRange& range,
                            const MapControl& control = {});

/// Why there is no answer for this range; empty where there is one.
std::string find_held_range_problem(const Manipulator& manipulator, const HeldRange& range);

/// "end of the range", "limit", "turn", "serial singularity" or "unknown".
const char* name(CuspEventKind kind) noexcept;

/// Why there is no answer for this; empty where there is one.
std::string find_uniqueness_problem(const Manipulator& manipulator, const UniquenessOptions& options);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_H
