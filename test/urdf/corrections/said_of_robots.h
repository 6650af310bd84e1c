// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_SAID_OF_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_SAID_OF_ROBOTS_H

#include "urdf/corrections/faulty_robots.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// The one sentence that a robot is refused with.
inline std::string sentence(const Description& robot) {
  const Problems problems = test::refusal(robot);
  EXPECT_EQ(problems.size(), 1U);
  return problems.empty() ? "" : problems.front();
}

inline void expect_remedies_work(const Description& robot, const std::string& said) {
  const std::vector<Description> corrected = test::followed(robot, said);
  EXPECT_FALSE(corrected.empty()) << said;
  for (const Description& one : corrected) EXPECT_EQ(test::refusal(one), Problems{}) << said;
}

inline bool has_note(const Description& robot, const std::string& note) {
  const auto notes = test::load(robot)->notes();
  return std::count(notes.begin(), notes.end(), note) == 1;
}

/// Notes on what is perhaps not meant.
inline std::vector<std::string> warnings(const Description& robot) {
  std::vector<std::string> found;
  const auto loaded = test::load(robot);
  for (const std::string& note : loaded->notes())
    if (note.find("; if ") != std::string::npos) found.push_back(note);
  return found;
}

/// The one of them.
inline std::string only_warning(const Description& robot) {
  const std::vector<std::string> found = warnings(robot);
  EXPECT_EQ(found.size(), 1U) << testing::PrintToString(found);
  return found.empty() ? "" : found.front();
}

/// What is in the first brackets of the pattern; empty where it does not fit.
inline std::string matched(const std::string& text, const std::string& pattern) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : "";
}

/// Whether both make the same legs.
inline bool are_same(const Description& one, const Description& other) {
  constexpr double rounding = 1e-6;
  const auto a = test::load(one)->manipulator(), b = test::load(other)->manipulator();
  if (a->task_space() != b->task_space() || a->leg_count() != b->leg_count()) return false;
  for (std::size_t k = 0; k < a->leg_count(); ++k)
    if ((a->leg(k).anchor - b->leg(k).anchor).norm() > rounding ||
        std::abs(a->leg(k).rod_length - b->leg(k).rod_length) > rounding ||
        (a->leg(k).base_point() - b->leg(k).base_point()).norm() > rounding)
      return false;
  return true;
}

/// Each of two words in the place of the other, where both stand once.
inline std::string exchanged(std::string text, const std::string& one, const std::string& other) {
  text = replaced(text, one, "@@");
  text = replaced(text, other, one);
  return replaced(text, "@@", other);
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_URDF_CORRECTIONS_SAID_OF_ROBOTS_H
