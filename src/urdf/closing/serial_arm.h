// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_SERIAL_ARM_H
#define PARALLEL_ASPECTS_URDF_CLOSING_SERIAL_ARM_H

#include "urdf/description/tree.h"

#include <optional>
#include <string>

namespace parallel_aspects {

/// That an open tree is a serial arm, one chain on its root with any frames and fingers on it, and so has no
/// loop; nothing of other trees.
std::optional<std::string> serial_arm_text(const Tree& tree, const std::string& urdf_name);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_SERIAL_ARM_H
