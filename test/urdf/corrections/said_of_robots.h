// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_SAID_OF_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_SAID_OF_ROBOTS_H

#include "urdf/corrections/faulty_robots.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include <algorithm>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// The one sentence that a robot is refused with.
inline std::string sentence(const Description& robot) {
  const Problems problems = test::refusal(robot.urdf, robot.config);
  EXPECT_EQ(problems.size(), 1U);
  return problems.empty() ? "" : problems.front();
}

inline void expect_remedies_work(const Description& robot, const std::string& said) {
  const std::vector<Description> corrected = test::followed(robot, said);
  EXPECT_FALSE(corrected.empty()) << said;
  for (const Description& one : corrected) EXPECT_EQ(test::refusal(one.urdf, one.config), Problems{}) << said;
}

inline bool has_note(const Description& robot, const std::string& note) {
  const auto notes = test::load(robot)->notes();
  return std::count(notes.begin(), notes.end(), note) == 1;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_SAID_OF_ROBOTS_H
