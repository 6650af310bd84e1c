// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_END_NOTES_H
#define PARALLEL_ASPECTS_URDF_END_NOTES_H

#include "urdf/corrections/edit.h"
#include "urdf/mechanism_contents.h"

#include <functional>
#include <memory>

namespace parallel_aspects {

/// The mechanism that a description makes; null where none.
using RecogniseIn = std::function<std::unique_ptr<Mechanism::Contents>(const std::shared_ptr<const Tree>&,
                                                                       const ResolvedConfig&, Problems&)>;

/// A description that has been recognised, and how others are.
struct RecognisedEnds {
  const Subject& subject;  ///< as it is written
  bool ends_meet = false;  ///< whether ends that are apart at zero were put together
  const RecogniseIn& recognise;
  const Attempt& attempt;
};

/// Adds what of the ends of its closures may not be meant: ends that are crossed, or apart while all joints
/// are zero.
void note_ends(const RecognisedEnds& ends, Mechanism::Contents& contents);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_END_NOTES_H
