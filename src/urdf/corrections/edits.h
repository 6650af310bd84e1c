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

/// Of the type and the axis of a joint: those of its siblings first, then other types, and axes along the
/// coordinates.
Edits motion_edits(const Subject& subject, std::size_t joint);

/// Passive slides next to another one along the same direction, as of a telescope of which one stage is
/// actuated: all of them fixed.
Edits series_edits(const Subject& subject);

/// Of slides between base and platform in a part without actuated joint: their axes.
Edits passive_slide_edits(const Subject& subject);

/// Of legs that have one passive joint less than two others or more, which are alike: that joint, where these
/// have it.
Edits missing_joint_edits(const Subject& subject);

/// The same of a joint and all its siblings that move as it does: a mistake in one leg is as a rule made in
/// each.
Edits motions_of_like_legs(const Subject& subject);

/// Of the origin of a joint: the place or the rotation of its siblings first, then a coordinate of the other
/// sign, millimetres, a place or an rpy that the frames beside it make a pattern with, the rpy of another
/// frame, one of the other sign or without one of its angles.
Edits origin_edits(const Subject& subject, std::size_t joint);

/// Of joints in the loops at these joint values, which need not close them: axes that miss a direction that
/// most share, the direction of some that is near, or the point that most go through.
Edits axis_edits(const Subject& subject, const Eigen::VectorXd& values);

/// Where slides have limits far beyond the robot, lengths are far beyond a robot's, or places of closures far
/// beyond the lengths: millimetres. Where origins are turned by angles far beyond a full turn: degrees, of
/// those angles alone, or of whole numbers beside them, too. The same of the frames of closures that the YAML
/// lists. `joints`: those that are examined. `loads`: whether the description loads as it is; fewer edits are
/// then offered.
Edits unit_edits(const Subject& subject, const LoopJoints& joints, bool loads = false);

/// Of the closures: another type of one.
Edits closure_edits(const Subject& subject);

/// What is wrong in one leg is as a rule wrong in each: edits of all closures, and of those of one kind by
/// their names. Points where all have another type, as for authors who write revolute joints for all ball
/// joints; fewer than three belong to planar robots. And axes of revolute closures: with balls in their
/// place, the links of some turn about one axis, and it is another one than that which is stated.
Edits points_for_all_closures(const Subject& subject);
Edits axes_of_like_closures(const Subject& subject);

/// Second frames of closures that are in one another's place; such as are beside their links only where both
/// frames are given, or `with_places_at_zero`.
Edits exchanged_ends(const Subject& subject, bool with_places_at_zero = false);

/// Ends of closures on the platform in one another's place, where numbers, letters or words in the names of
/// the ends, or of the joints that carry them, pair all ends otherwise than the closures do. None where they
/// agree, or leave any end open.
Edits ends_paired_by_names(const Subject& subject);

/// Of the places of these closures: a coordinate of the other sign, and two exchanged.
Edits closure_place_edits(const Subject& subject, const std::vector<std::size_t>& closures);

/// Of the frames that closures hold: another link in a closure, a closure that is missing, another parent of
/// a frame. Those of one kind are together, the kinds in the order in which they are to be tried. None gives
/// two legs one anchor, unless legs share one already or the platform is a point.
std::vector<Edits> frame_edits(const Subject& subject);

/// Of a closure that holds the start of the body that the operational point is on: that point in its place.
Edits point_frame_edits(const Subject& subject);

/// One closure elsewhere, where all others hold a leg to the platform: a link of this in its place.
Edits platform_frame_edits(const Subject& subject);

/// Of the list of actuated joints: one of a leg that has none, one less of a leg that has several, or both.
Edits actuation_edits(const Subject& subject);

/// The link that most of the actuated joints are on, or else the root.
Edits base_edits(const Subject& subject);

/// Origins of links where loops are closed, or that several joints move.
Edits operational_point_edits(const Subject& subject);

/// An end of a closure that its description gives by coordinates.
struct PlacedEnd {
  std::size_t closure = 0, end = 0;
  Eigen::Vector3d place;  ///< in its link [m]
};
std::vector<PlacedEnd> placed_ends(const std::vector<Closure>& closures);

/// "puts the end of closure 'a' in link 'b' at (1, 0, 0) m".
std::string place_text(const Subject& subject, const PlacedEnd& end);

/// With another place.
FrameChange moved(const Subject& subject, const PlacedEnd& end, const Eigen::Vector3d& place);

inline constexpr double millimetre = 1e-3;     // [m]
inline constexpr double widest_robot = 100.0;  // [m]; wider ones are taken for such in millimetres
inline constexpr double out_of_scale = 30.0;  // of a length in millimetres against others in metres, at least

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_EDITS_H
