// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_MISPLACED_ENDS_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_MISPLACED_ENDS_H

#include "urdf/corrections/edit.h"
#include "urdf/description/messages.h"

#include <string>

namespace parallel_aspects {

/// Of a robot that loads: closures whose ends are exchanged, judging by their names or by the places of the
/// ends while all joints are zero; with the list for the YAML that has them in order.
Notes crossed_ends_notes(const Subject& subject, const Attempt& attempt);

/// For closures that hold a link beside its origin, by a place in the other link, though that link exists for
/// the closure alone: the place where its origin is while all joints are zero.
Edits end_place_edits(const Subject& subject);

/// Changes of origins of joints in loops whose ends are apart while all joints are zero.
Edits place_edits(const Subject& subject);

/// Those of them that put all ends together, where several ends of closures in a list are apart while all
/// joints are zero, or where those of others meet.
Edits edits_of_apart_ends(const Subject& subject);

/// Changes of the origin of one joint that join all ends of closures while all joints are zero: a few of
/// those that make a robot, as "write xyz=\"1 0 0\" in the origin of joint 'a', or write ..."; empty where
/// none does.
std::string remedies_of_places(const Subject& subject, const Attempt& attempt);

/// Of a robot that loads: edits of it that load, too, one for each element; "FAULT; CONDITION, REMEDY.".
Notes notes_of_working(const Subject& subject, const Edits& edits, const std::string& condition,
                       const Attempt& attempt);

/// Of a robot that loads: ends of closures in a list that are apart while all joints are zero, though those
/// of most others are together; or the ends of several closures, all apart, which the origin of one joint
/// joins.
Notes misplaced_ends_notes(const Subject& subject, const Attempt& attempt);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_MISPLACED_ENDS_H
