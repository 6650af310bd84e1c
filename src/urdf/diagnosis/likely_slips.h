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

/// Of a robot that loads: names the one actuated joint on the base that moves the other way round than those
/// of the other legs, seen from the middle of all, though it has the same limits, which differ to both sides.
std::vector<std::string> reversed_axes_notes(const Tree& tree, const ResolvedConfig& resolved,
                                             const SourceNames& files);

/// Of a robot that loads: names the one actuated joint on the base that moves along or about another
/// direction than those of the other legs, which are alike, seen from the middle of all. Only where the robot
/// with the direction of the others loads, too.
Notes other_axes_notes(const Subject& subject, const Attempt& attempt);

/// Of a robot that loads: ends of closures are at a place where a like link has its other end, so that they
/// have the length of that link, as where the plate is fixed to the first of six pins. The note has the
/// closures at the origins of their links; nothing where these make no robot.
std::optional<Note> borrowed_length_note(const Subject& subject, const Attempt& attempt);

/// What looks like a slip, though it may be meant: several closures hold one link, while another link of its
/// body with such a name is in none; or a closure holds a link at its own joint, where another leg is, while
/// a frame of its body is in none. `size`: of the robot [m].
std::vector<std::string> shared_frame_notes(const Tree& tree, const ResolvedConfig& resolved, double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_LIKELY_SLIPS_H
