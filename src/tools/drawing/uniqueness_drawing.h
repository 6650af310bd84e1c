// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_UNIQUENESS_DRAWING_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_UNIQUENESS_DRAWING_H

#include "draw/page/page_elements.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <optional>

namespace parallel_aspects::tools {

/// The plane of poses of a slice and the plane of both actuated values: the number of direct solutions in
/// color, singular curves, and cusps as dots with their numbers in the list. For slices alone. The poses are
/// those of one working mode of the map, by default that of which the components are the largest together.
PagePicture draw_uniqueness(const Uniqueness& uniqueness,
                            const std::optional<WorkingMode>& mode = std::nullopt);

/// Curves of cusps in the plane of the other two actuated values, and the number of cusps over the value that
/// is held.
PagePicture draw_cusp_curves(const Manipulator& robot, const CuspCurves& found);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_UNIQUENESS_DRAWING_H
