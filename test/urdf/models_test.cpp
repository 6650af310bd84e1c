// SPDX-License-Identifier: BSD-3-Clause
// Robots without a file, robots from two files, and results that read as yes or no.
#include "parallel_aspects/parallel_aspects.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;

const fs::path root = PARALLEL_ASPECTS_SOURCE_DIR;

const std::vector<SharedMechanism (*)()> all_models{
    models::bipod,          models::five_bar, models::three_prr,    models::three_rpr,
    models::three_rrr,      models::delta,    models::linear_delta, models::agile_eye,
    models::spherical_3rrr, models::hexa,     models::six_pus,      models::stewart,
    models::ankle,          models::four_bar, models::tilt_table,   models::skew_wrist};

SharedMechanism from_files(const std::string& name) {
  return load_mechanism_files(root / "urdf" / (name + ".urdf"), root / "config/robots" / (name + ".yaml"));
}

TEST(Models, AreTheShippedRobots) {
  for (const auto& model : all_models) {
    const SharedMechanism built_in = model();
    const std::string& name = built_in->manipulator()->name();
    const SharedMechanism loaded = from_files(name);
    ASSERT_EQ(built_in->manipulator()->leg_count(), loaded->manipulator()->leg_count()) << name;
    EXPECT_EQ(built_in->assembled().q, loaded->assembled().q) << name;
    for (std::size_t j = 0; j < loaded->manipulator()->leg_count(); ++j)
      EXPECT_EQ(built_in->manipulator()->leg(j).anchor, loaded->manipulator()->leg(j).anchor) << name;
  }
}

TEST(Models, NoneIsMissing) {
  const fs::directory_iterator files(root / "config/robots");
  EXPECT_EQ(static_cast<std::ptrdiff_t>(all_models.size()), std::distance(begin(files), end(files)));
}

TEST(MechanismFiles, ThatCannotBeReadAreAllNamed) {
  try {
    load_mechanism_files("/no/such.urdf", "/no/such.yaml");
    FAIL() << "loaded what is not there";
  } catch (const InvalidDescription& invalid) {
    ASSERT_EQ(invalid.problems().size(), 2U);
    EXPECT_EQ(invalid.problems()[0],
              "File '/no/such.urdf' cannot be read; give one that exists and is readable.");
  }
}

TEST(Results, AreTrueWhereTheyHoldWhatWasAskedFor) {
  const auto robot = models::five_bar()->manipulator();
  const WorkingMode mode = *WorkingMode::from_signs({1, -1});
  const Pose near = Pose::planar(4.5, 8.0), far = Pose::planar(45.0, 8.0);
  EXPECT_TRUE(inverse(*robot, near, mode));
  EXPECT_FALSE(inverse(*robot, far, mode));
  EXPECT_TRUE(direct(*robot, inverse(*robot, near, mode).q));
  EXPECT_FALSE(direct(*robot, JointVector::Constant(2, std::nan(""))));
  MapOptions options;
  options.resolution = 1.0;
  const MapResult result = compute_aspect_map(robot, options);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result.map->locate(near, mode));
  EXPECT_FALSE(result.map->locate(far, mode));
  EXPECT_FALSE(save_map(*result.map, "/no/such/folder/five_bar.map"));
  options.resolution = -1.0;
  EXPECT_FALSE(compute_aspect_map(robot, options));
  RoadmapOptions none;
  none.samples = 0;
  EXPECT_FALSE(compute_pose_roadmap(robot, none));
  BoundaryDistanceMeter meter(robot);
  EXPECT_TRUE(meter.measure(near, mode));
  EXPECT_FALSE(meter.measure(far, mode));
}

TEST(Pose, OfThePlaneTurnsAboutZ) {
  const Pose pose = Pose::planar(1.0, 2.0, 0.5 * EIGEN_PI);
  EXPECT_TRUE(pose.transform({1.0, 0.0, 0.0}).isApprox(Eigen::Vector3d(1.0, 3.0, 0.0), 1e-15));
  EXPECT_NEAR(pose_coordinates(TaskSpace::SE2, pose)[2], 0.5 * EIGEN_PI, 1e-15);
}

}  // namespace
}  // namespace parallel_aspects
