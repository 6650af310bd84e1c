// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_SAME_LEGS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_SAME_LEGS_H

#include "parallel_aspects/urdf/mechanism.h"

#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/robots/shipped.h"
#include <filesystem>
#include <fstream>
#include <string>

namespace parallel_aspects::test {

/// A robot of test/data, by the names of its files without their folder.
inline SharedMechanism loaded_from(const std::string& folder, const std::string& robot,
                                   const std::string& config) {
  const std::string path = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/" + folder + "/";
  return load_mechanism_files(path + robot, path + config);
}

/// Whether both robots have the same legs in the same order, whatever the zeros of their joints are: at
/// random poses about the home pose of `expected`, distances from base points to anchors agree.
inline void expect_same_legs(const Mechanism& mechanism, const Mechanism& expected, double tolerance = 1e-9) {
  const Manipulator &robot = *mechanism.manipulator(), &other = *expected.manipulator();
  ASSERT_EQ(robot.task_space(), other.task_space());
  ASSERT_EQ(robot.leg_count(), other.leg_count());
  for (std::size_t k = 0; k < robot.leg_count(); ++k) {
    const Leg &leg = robot.legs()[k], &same = other.legs()[k];
    EXPECT_LT((leg.base_point() - same.base_point()).norm(), tolerance) << leg.name;
    EXPECT_LT((leg.anchor - same.anchor).norm(), tolerance) << leg.name;
    EXPECT_NEAR(leg.rod_length, same.rod_length, tolerance) << leg.name;
    EXPECT_NEAR(leg.largest_entry(), same.largest_entry(), tolerance) << leg.name;
  }
  EXPECT_EQ(open_loops(mechanism), 0);
}

/// What is wrong with this text in a file of this name; it stands in a folder of its own.
inline Problems refusal_of_file(const std::string& name, const std::string& text) {
  namespace fs = std::filesystem;
  std::string folder = (fs::temp_directory_path() / "description_XXXXXX").string();
  EXPECT_NE(mkdtemp(folder.data()), nullptr);
  const std::string file = folder + "/" + name, config = folder + "/robot.yaml";
  std::ofstream(file) << text;
  std::ofstream(config) << "mechanism: {operational_point: tool}\n";
  Problems problems;
  try {
    load_mechanism_files(file, config);
  } catch (const InvalidDescription& invalid) {
    problems = invalid.problems();
  }
  for (std::string& problem : problems)
    for (std::size_t at; (at = problem.find(folder + "/")) != std::string::npos;)
      problem.erase(at, folder.size() + 1);
  fs::remove_all(folder);
  return problems;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_SAME_LEGS_H
