// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/shipped.h"

#include <cstddef>
#include <fstream>
#include <iterator>

namespace parallel_aspects::test {

std::string source_file(const std::string& path) {
  std::ifstream stream(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::shared_ptr<const Mechanism> shipped(const std::string& robot) {
  const std::string urdf = robot + ".urdf", config = robot + ".yaml";
  return load_mechanism(source_file("urdf/" + urdf), urdf, source_file("config/robots/" + config), config);
}

std::shared_ptr<const Manipulator> with_actuated_limits(const std::string& name) {
  ConstraintKinds kinds;
  kinds[static_cast<std::size_t>(ConstraintKind::actuated_limits)] = true;
  return shipped(name)->manipulator()->with_constraints(kinds);
}

}  // namespace parallel_aspects::test
