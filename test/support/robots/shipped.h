// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SHIPPED_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SHIPPED_H

#include "parallel_aspects/urdf/mechanism.h"

#include <memory>
#include <string>

namespace parallel_aspects::test {

/// The text of a file of the source tree; empty when there is none.
std::string source_file(const std::string& path);

/// A robot of config/robots, loaded from its URDF and YAML.
std::shared_ptr<const Mechanism> shipped(const std::string& robot);

/// A shipped robot with the limits of its actuated joints, and no other constraint.
std::shared_ptr<const Manipulator> with_actuated_limits(const std::string& name);

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SHIPPED_H
