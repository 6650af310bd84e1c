// SPDX-License-Identifier: BSD-3-Clause
//
// What may be wrong with a description: a generator of edits for each kind of element. Each edit has its
// reason in the file: legs that are alike but for it, ends that then meet, axes that then fit, names that
// then pair.
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_EDITS_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_EDITS_H

#include "urdf/corrections/edit.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Edits of the type and the axis of a joint: those of its siblings first, then other types, and axes along
/// the coordinates.
Edits motion_edits(const Subject& subject, std::size_t joint);

/// Fixes all passive slides that are next to another one along the same direction, as in a telescope of which
/// one stage is actuated.
Edits series_edits(const Subject& subject);

/// Edits of the axes of slides between base and platform, in a part without an actuated joint.
Edits passive_slide_edits(const Subject& subject);

/// Where a leg has one passive joint less than two or more others, which are alike: adds that joint in the
/// same place.
Edits missing_joint_edits(const Subject& subject);

/// Edits of a joint together with all its siblings that move as it does, since a mistake is mostly made in
/// each leg.
Edits motions_of_like_legs(const Subject& subject);

/// Edits of the origin of a joint. First the place or the rotation of its siblings. Then a coordinate of the
/// other sign; millimetres; a place or an rpy that completes the pattern of the frames beside it; the rpy of
/// another frame; an rpy of the other sign, or without one of its angles.
Edits origin_edits(const Subject& subject, std::size_t joint);

/// Edits of axes of joints in the loops, at joint values that need not close these. An axis may miss the
/// direction that most share, a direction near by that some share, or the point that most go through.
Edits axis_edits(const Subject& subject, const Eigen::VectorXd& values);

/// Edits of units. Millimetres, where limits of slides are far beyond the robot, lengths far beyond those of
/// a robot, or places of closures far beyond the lengths. Degrees, where origins are turned by angles far
/// beyond a full turn: for those angles alone, or for whole numbers beside them too. The same for the frames
/// of closures that the YAML lists. `joints`: those that are examined. `loads`: whether the description loads
/// as it is; fewer edits are then offered.
Edits unit_edits(const Subject& subject, const LoopJoints& joints, bool loads = false);

/// Gives one closure another type.
Edits closure_edits(const Subject& subject);

/// Edits of all closures, and of those of one kind by their names, since a mistake is mostly made in each
/// leg. The first gives this type to closures with another stated type. The second changes axes of revolute
/// closures of SDF: with balls in their place the links of some turn about one axis, which is not the stated
/// one.
Edits types_of_like_closures(const Subject& subject, ClosureType type);
Edits axes_of_like_closures(const Subject& subject);

/// Exchanges the second frames of two closures. Frames that are beside their links are exchanged only where
/// both are given, or `with_places_at_zero`.
Edits exchanged_ends(const Subject& subject, bool with_places_at_zero = false);

/// Exchanges ends of closures on the platform, where numbers, letters or words in the names of the ends, or
/// of the joints that carry them, pair all ends otherwise than the closures do. None where they agree, or
/// leave any end open.
Edits ends_paired_by_names(const Subject& subject);

/// Edits of the places of these closures: a coordinate of the other sign, or two places exchanged.
Edits closure_place_edits(const Subject& subject, const std::vector<std::size_t>& closures);

/// Edits of the frames that closures hold: another link in a closure, a missing closure, another parent of a
/// frame. Edits of one kind are together; kinds are in the order in which they are to be tried. None gives
/// two legs one anchor, unless legs share one already or the platform is a point.
std::vector<Edits> frame_edits(const Subject& subject);

/// Where a closure holds the start of the body that carries the operational point: that point instead.
Edits point_frame_edits(const Subject& subject);

/// Where all closures but one hold a leg to the platform: a link of the platform in that one.
Edits platform_frame_edits(const Subject& subject);

/// Edits of the list of actuated joints: one more for a leg that has none, one less for a leg that has
/// several, or both.
Edits actuation_edits(const Subject& subject);

/// Makes the link that most of the actuated joints are on the base, or else the root.
Edits base_edits(const Subject& subject);

/// Moves the operational point to origins of links where loops are closed, or that several joints move.
Edits operational_point_edits(const Subject& subject);

/// An end of a closure that its description gives by coordinates.
struct PlacedEnd {
  std::size_t closure = 0, end = 0;
  Eigen::Vector3d place;  ///< in its link [m]
};
std::vector<PlacedEnd> placed_ends(const std::vector<Closure>& closures);

/// "puts the end of closure 'a' in link 'b' at (1, 0, 0) m".
std::string place_text(const Subject& subject, const PlacedEnd& end);

/// The change that moves an end to another place.
FrameChange moved(const Subject& subject, const PlacedEnd& end, const Eigen::Vector3d& place);

inline constexpr double millimetre = 1e-3;    // [m]
inline constexpr double out_of_scale = 30.0;  // of a length in millimetres against others in metres, at least

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_EDITS_H
