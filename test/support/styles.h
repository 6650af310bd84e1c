// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_STYLES_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_STYLES_H

#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/reading/description_file.h"
#include "urdf/setup/setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

/// Descriptions in the styles that people publish, and what setup makes of each: the robot, a question that
/// can be answered, or a refusal with a true reason.
namespace parallel_aspects::test {

inline SetupResult set_up_style(const std::string& file, const SetupAnswers& answers = {}) {
  const std::string path = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/styles/" + file;
  SetupResult result;
  const auto text = read_description_file(path, result.problems);
  return text ? set_up(*text, file, "robot.yaml", answers, SetupControl{1000000}) : result;
}

inline std::string text_of(const SetupResult& result) {
  std::string text = result.question ? result.question->text + '\n' : "";
  for (const std::string& problem : result.problems) text += problem + '\n';
  return text;
}

/// Of a robot: how far each anchor is from its proximal point at the joint value zero, by the lengths that
/// the description was written with.
struct FoundStyle {
  std::string file;
  TaskSpace space;
  std::string base, platform;
  std::vector<std::string> joints;
  std::vector<double> rods;  ///< one for each leg, or one for all [m or rad]
};

inline void PrintTo(const FoundStyle& style, std::ostream* stream) { *stream << style.file; }

inline double rod_of(const Leg& leg) {
  if (leg.rod_length > 0.0) return leg.rod_length;
  return std::sqrt(leg.squared_distance(0.0));
}

inline void expect_found(const FoundStyle& style) {
  const SetupResult result = set_up_style(style.file);
  ASSERT_TRUE(result.mechanism) << text_of(result);
  const Manipulator& robot = *result.mechanism->manipulator();
  EXPECT_EQ(name(robot.task_space()), name(style.space));
  EXPECT_EQ(result.choices.at(0).taken.values.front(), style.base);
  EXPECT_EQ(result.choices.at(2).taken.values.front(), style.platform);
  ASSERT_EQ(robot.leg_count(), style.joints.size());
  for (std::size_t k = 0; k < robot.leg_count(); ++k) {
    EXPECT_EQ(robot.leg(k).actuated_joint, style.joints[k]);
    const double rod = style.rods.size() == 1 ? style.rods.front() : style.rods.at(k);
    const double found = robot.task_space() == TaskSpace::SO3
                             ? 2.0 * std::asin(0.5 * rod_of(robot.leg(k)))  // a chord of the unit sphere
                             : rod_of(robot.leg(k));
    EXPECT_NEAR(found, rod, 2e-5 * rod) << k;
  }
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_STYLES_H
