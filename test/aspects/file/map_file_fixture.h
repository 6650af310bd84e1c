// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ASPECTS_FILE_MAP_FILE_FIXTURE_H
#define PARALLEL_ASPECTS_TEST_ASPECTS_FILE_MAP_FILE_FIXTURE_H

#include "aspects/map/map_contents.h"
#include "model/linear_algebra.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects::test {

namespace fs = std::filesystem;
using RobotPtr = std::shared_ptr<const Manipulator>;

inline std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

inline Pose random_pose(const AspectMap& map, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const TaskSpace space = map.manipulator()->task_space();
  const Box region = map.region();
  Pose pose;
  if (space == TaskSpace::SO3) {
    pose.orientation =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    return pose;
  }
  PoseCoordinates coordinates(region.dimension);
  for (std::size_t i = 0; i < region.dimension; ++i)
    coordinates[static_cast<Eigen::Index>(i)] =
        std::uniform_real_distribution<double>(region.lower[i], region.upper[i])(random);
  return *pose_from_coordinates(space, coordinates);
}

using Numbers = std::vector<double>;

inline void append(Numbers& list, const Box& box) {
  list.insert(list.end(), box.lower.begin(), box.lower.end());
  list.insert(list.end(), box.upper.begin(), box.upper.end());
}

// Everything that the leaves of a map tell, in the order told.
inline Numbers leaves(const AspectMap& map) {
  Numbers list;
  for (const Aspect& aspect : map.aspects()) {
    map.visit_inside_leaves(aspect.id, [&list](const Box& box) { append(list, box); });
    map.visit_inside_poses(aspect.id, [&list](const Pose& pose, double measure) {
      list.insert(list.end(), {pose.position.x(), pose.position.y(), pose.position.z(), measure});
      for (const double each : coefficients_of(pose.orientation.coeffs())) list.push_back(each);
    });
  }
  for (const WorkingMode& mode : map.working_modes())
    map.visit_undecided_leaves(mode, [&list](const Box& box) { append(list, box); });
  return list;
}

inline void append(Numbers& list, const Pose& pose) {
  for (const double each : coefficients_of(pose.position)) list.push_back(each);
  for (const double each : coefficients_of(pose.orientation.coeffs())) list.push_back(each);
}

// Everything that a graph tells, in the order told.
inline Numbers numbers(const AspectGraph& graph) {
  Numbers list;
  for (const Neighbours& gate : graph.gates) {
    list.insert(list.end(), {double(gate.first), double(gate.second), double(gate.leg),
                             gate.crossing == Crossing::serial ? 1.0 : 0.0, gate.proved ? 1.0 : 0.0});
    append(list, gate.pose);
    for (const GateCrossing& crossing : gate.crossings) {
      for (const Pose& pose : crossing.segment) append(list, pose);
      append(list, crossing.pose);
      list.push_back(crossing.index);
    }
  }
  for (std::size_t i = 0; i < graph.sets.size(); ++i) {
    const AspectSet& set = graph.sets[i];
    list.insert(list.end(),
                {double(set.determinant_sign), set.workspace_lower, double(graph.set_group.at(i))});
    list.insert(list.end(), set.aspects.begin(), set.aspects.end());
  }
  list.push_back(static_cast<double>(graph.proved_set_count));
  return list;
}

// A folder of its own, gone at the end of the test.
class MapFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "map_file_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    file_ = folder_ / "map";
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string saved(const AspectMap& map) const {
    const SaveResult result = save_map(map, file_);
    EXPECT_TRUE(result.saved) << result.message;
    return contents(file_);
  }

  std::shared_ptr<const AspectMap> load(const std::string& bytes, const RobotPtr& robot,
                                        const MapOptions& options = {}) const {
    write(file_, bytes);
    return load_map(robot, options, file_).map;
  }

  void expect_refused(const std::string& bytes, const std::string& why) const {
    write(file_, bytes);
    expect_refused(five_bar_, options_, why);
  }

  void expect_refused(const RobotPtr& robot, const MapOptions& options, const std::string& why) const {
    const MapResult result = load_map(robot, options, file_);
    EXPECT_EQ(result.status, MapStatus::refused);
    EXPECT_EQ(result.map, nullptr);
    EXPECT_NE(result.message.find(file_.string()), std::string::npos) << result.message;
    EXPECT_NE(result.message.find(why), std::string::npos) << result.message;
    EXPECT_EQ(result.message.back(), '.');
  }

  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }

  static MapOptions coarse(double resolution) {
    MapOptions options;
    options.resolution = resolution;
    return options;
  }

  fs::path folder_, file_;
  RobotPtr five_bar_ = test::five_bar();
  MapOptions options_ = coarse(1.0);
  std::shared_ptr<const AspectMap> map_ = compute_aspect_map(five_bar_, options_).map;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ASPECTS_FILE_MAP_FILE_FIXTURE_H
