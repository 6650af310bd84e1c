// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_H

#include "urdf/closing/resolved_config.h"
#include "urdf/description/note.h"
#include "urdf/description/source_names.h"
#include "urdf/description/tree.h"

#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A change of one element of a description that may be what it needs. A guess: whether the element is at
/// fault shows where the corrected description is recognised.
struct Correction {
  std::string element;  ///< "joint 'a'", "closure 'a - b'"; corrections of one element exclude each other
  Note fault;           ///< "robot.urdf lets joint 'a' turn about (1, 0, 0)"
  std::string remedy;   ///< "write <axis xyz=\"0 0 1\"/> for joint 'a'"
  bool like_others = false;  ///< whether it makes the element what most others of its kind are
  std::function<void(Tree&, ResolvedConfig&)> apply;
  bool fixes_joint = false;  ///< whether it takes a joint out that may be one too many
};

using Corrections = std::vector<Correction>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_H
