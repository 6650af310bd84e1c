// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_SHIPPED_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_SHIPPED_H

#include "parallel_aspects/urdf/mechanism.h"

#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace parallel_aspects::test {

/// The text of a file of the source tree; empty when there is none.
inline std::string source_file(const std::string& path) {
  std::ifstream stream(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A robot of config/robots, loaded from its URDF and YAML.
inline std::shared_ptr<const Mechanism> shipped(const std::string& robot) {
  const std::string urdf = robot + ".urdf", config = robot + ".yaml";
  return load_mechanism(source_file("urdf/" + urdf), urdf, source_file("config/robots/" + config), config);
}

/// A shipped robot with the limits of its actuated joints, and no other constraint.
inline std::shared_ptr<const Manipulator> with_actuated_limits(const std::string& name) {
  ConstraintKinds kinds;
  kinds[static_cast<std::size_t>(ConstraintKind::actuated_limits)] = true;
  return shipped(name)->manipulator()->with_constraints(kinds);
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_SHIPPED_H
