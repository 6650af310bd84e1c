// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/config/mechanism_config.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/texts.h"
#include <string>

namespace parallel_aspects {
namespace {

TEST(MechanismConfig, ARobotsFileMayStateEveryParameterOfTheNode) {
  const YAML::Node defaults =
      YAML::LoadFile(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/config/default.yaml");
  ASSERT_GT(defaults.size(), 10U);
  for (const auto& entry : defaults) {
    const auto key = entry.first.as<std::string>();
    Problems problems;
    read_mechanism_config("mechanism: {}\n" + key + ": 1\n", "robot.yaml", problems);
    for (const std::string& problem : problems) EXPECT_FALSE(test::has(problem, "'" + key + "'"));
  }
}

}  // namespace
}  // namespace parallel_aspects
