// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/homotopy/platform_start.h"

namespace parallel_aspects::platform_paths {
namespace {

// Written by generate_platform_start: `table_parameters` and `table_solutions`.
#include "platform_start.inc"

}  // namespace

const Parameters& start_parameters() {
  static const Parameters parameters = table_parameters;
  return parameters;
}

const std::vector<Solution>& start_solutions() {
  static const std::vector<Solution> solutions(table_solutions.begin(), table_solutions.end());
  return solutions;
}

}  // namespace parallel_aspects::platform_paths
