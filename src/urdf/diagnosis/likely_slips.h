// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_LIKELY_SLIPS_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_LIKELY_SLIPS_H

#include "urdf/corrections/edit.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Of a robot that loads: the actuated joint on the base that alone moves the other way round than those of
/// the other legs, seen from the middle of all, though it has the same limits and these are not the same to
/// both sides.
std::vector<std::string> reversed_axes_notes(const Tree& tree, const ResolvedConfig& resolved,
                                             const SourceNames& files);

/// Of a robot that loads: the actuated joint on the base that alone moves along or about another direction
/// than those of the other legs, which are alike, seen from the middle of all; where its robot with theirs
/// loads, too.
Notes other_axes_notes(const Subject& subject, const Attempt& attempt);

/// Of a robot that would load: that ends of closures are at a place which a like link has the other end at, a
/// length of that one, as where the plate is fixed to the first of six pins. A robot that nobody means, so
/// that it is refused, with the closures at the origins of their links; nothing where these make no robot.
std::optional<Note> length_of_another_link(const Subject& subject, const Attempt& attempt);

/// What looks like a slip, though it may be meant: a link that several closures hold, while one of its body
/// with such a name is in none; or one that a closure holds at its own joint, where another leg is, while a
/// frame of its body is in none. `size`: of the robot [m].
std::vector<std::string> shared_frame_notes(const Tree& tree, const ResolvedConfig& resolved, double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_LIKELY_SLIPS_H
