// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_START_H
#define PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_START_H

#include "kinematics/homotopy/platform_paths.h"

#include <vector>

namespace parallel_aspects::platform_paths {

/// A platform with generic complex parameters, from which every other one can be reached. Found once by
/// monodromy, with the program `generate_platform_start`.
const Parameters& start_parameters();

/// All 40 of its solutions.
const std::vector<Solution>& start_solutions();

}  // namespace parallel_aspects::platform_paths

#endif  // PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_START_H
