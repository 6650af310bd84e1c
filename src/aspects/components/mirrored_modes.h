// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_MIRRORED_MODES_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_MIRRORED_MODES_H

#include "aspects/components/components.h"
#include "aspects/symmetry/map_symmetry.h"
#include "aspects/tree/pose_tree.h"

#include <vector>

namespace parallel_aspects {

/// Gives each mode that has a representative the states that this has at the images of its nodes, dividing
/// nodes where need be, and its components. `components` holds those of the representatives, by mode, and has
/// room for all.
void mirror_modes(PoseTree& tree, const std::vector<MapSymmetry>& symmetries,
                  const std::vector<ModeSource>& sources, std::vector<ModeComponents>& components);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_MIRRORED_MODES_H
