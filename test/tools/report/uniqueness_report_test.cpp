// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/uniqueness_report.h"

#include "tools/report/answer_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/robots/shipped.h"
#include "support/texts.h"
#include <cstddef>
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

// Numbers of a robot with several working modes as a whole are those of each, and its sets as well.
TEST(UniquenessReport, ReportsTheWorkingModeOfNumbers) {
  UniquenessOptions options;
  options.most_cells = 4000;
  const UniquenessResult result = compute_uniqueness(test::shipped("three_prr")->manipulator(), options);
  ASSERT_TRUE(result) << result.message;
  const Manipulator& robot = *result.uniqueness->map->manipulator();
  const json found = answer_json(robot, *result.uniqueness);
  const std::string text = uniqueness_text(robot, result.uniqueness);
  ASSERT_FALSE(found["regions"].empty());
  for (const json& region : found["regions"]) EXPECT_EQ(region["working_mode"].size(), 3U);
  ASSERT_FALSE(found["basic_regions"].empty());
  std::size_t below = 0;
  for (const json& region : found["basic_regions"]) {
    const int aspect = region["component"];
    if (aspect == 0 || region["basic_component"].is_null()) continue;
    ++below;
    const json& component = found["basic_components"][region["basic_component"].get<std::size_t>()];
    const auto index = static_cast<std::size_t>(aspect - 1);
    EXPECT_EQ(component["working_mode"], found["components"][index]["working_mode"]);
    EXPECT_EQ(component["actuated"], region["actuated"]);
  }
  EXPECT_GE(below, 16U);
  EXPECT_TRUE(test::has(text, "working mode  solutions"));
  EXPECT_TRUE(test::has(text, " over all working modes\n"));
}

}  // namespace
}  // namespace parallel_aspects::tools
