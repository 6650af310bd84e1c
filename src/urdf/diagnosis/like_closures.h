// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_LIKE_CLOSURES_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_LIKE_CLOSURES_H

#include "urdf/corrections/correction.h"

#include <memory>

namespace parallel_aspects {

/// What is wrong in one leg is as a rule wrong in each: corrections of all closures, and of those of one kind
/// by their names, by the same edit of each.
///
/// Axes of revolute closures of SDF: with balls in their place, the links of some turn about one axis, and it
/// is another one than that which is stated.
Corrections axes_of_like_closures(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                  const SourceNames& files);

/// This type, for those that have another one stated.
Corrections types_of_like_closures(const ResolvedConfig& resolved, ClosureType type,
                                   const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_LIKE_CLOSURES_H
