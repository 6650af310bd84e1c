// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_LEFT_OPEN_H
#define PARALLEL_ASPECTS_URDF_SETUP_LEFT_OPEN_H

#include "urdf/description/tree.h"
#include "urdf/setup/body_graph.h"

#include <vector>

namespace parallel_aspects {

/// Marks links that no loop is closed at by their names, as cameras and fingers, and with nothing else on
/// them.
std::vector<bool> fittings(const Tree& tree);

/// Marks besides those in `left_open` bodies that end a chain with one joint, two or more on one body that is
/// not the root, and are not named as ends of loops: as the fingers of a gripper.
std::vector<bool> with_fingers(const Tree& tree, const Bodies& bodies, std::vector<bool> left_open);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_LEFT_OPEN_H
