// SPDX-License-Identifier: BSD-3-Clause
#include "ros/probe/probe_solver.h"

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

geometry_msgs::Pose pose_of(double x, double w) {
  geometry_msgs::Pose pose;
  pose.position.x = x;
  pose.orientation.w = w;
  return pose;
}

std::string words_at(const std::shared_ptr<const Manipulator>& robot, const ProbeQuestion& question,
                     const KnownAspects& known) {
  return words_of(*robot, ProbeSolver(robot).find(question, known, ros::Time(1.0)));
}

class ProbeOfFiveBar : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    MapOptions options;
    options.resolution = 0.5;
    known_.map = compute_aspect_map(robot_, options).map;
  }
  static void TearDownTestSuite() { known_ = {}; }

  ProbeFinding find(double x, double y, const std::vector<int>& signs = {1, 1}, bool others = false) {
    return solver_.find({Pose::planar(x, y), *WorkingMode::from_signs(signs), others}, known_,
                        ros::Time(1.0));
  }

  static const std::shared_ptr<const Manipulator> robot_;
  static KnownAspects known_;
  ProbeSolver solver_{robot_};
};

const std::shared_ptr<const Manipulator> ProbeOfFiveBar::robot_ = test::shipped("five_bar")->manipulator();
KnownAspects ProbeOfFiveBar::known_;

TEST(ProbePose, IsRefusedWithTheNumberAtFault) {
  EXPECT_EQ(fault_of(pose_of(1.0, 1.0)), "");
  EXPECT_NE(fault_of(pose_of(nan, 1.0)).find("position.x is nan"), std::string::npos);
  EXPECT_NE(fault_of(pose_of(0.0, std::numeric_limits<double>::infinity())).find("orientation.w is inf"),
            std::string::npos);
  EXPECT_NE(fault_of(pose_of(0.0, 0.0)).find("length 0.0"), std::string::npos);
  EXPECT_NE(fault_of(pose_of(0.0, 2.0)).find("unit quaternion"), std::string::npos);
}

TEST_F(ProbeOfFiveBar, IsWhereItIsWantedWithItsAspectAndDistances) {
  const ProbeFinding found = find(4.5, 8.0);
  ASSERT_TRUE(found.reached);
  EXPECT_EQ(found.state.status.code, Status::OK);
  EXPECT_EQ(found.state.off, 0.0);
  EXPECT_EQ(found.state.header.stamp, ros::Time(1.0));
  EXPECT_EQ(found.state.header.frame_id, "base_link");
  const Location location = known_.map->locate(Pose::planar(4.5, 8.0), *WorkingMode::from_signs({1, 1}));
  ASSERT_TRUE(location);
  EXPECT_EQ(found.state.report.configuration.aspect, static_cast<std::uint32_t>(location.aspect));
  const BoundaryDistances expected =
      BoundaryDistanceMeter(robot_).measure(Pose::planar(4.5, 8.0), *WorkingMode::from_signs({1, 1}));
  EXPECT_EQ(found.state.report.parallel_distance.lower, expected.parallel.lower);
  EXPECT_EQ(found.state.report.serial_distance.upper, expected.serial.upper);
  const std::string words = words_of(*robot_, found);
  EXPECT_NE(words.find("aspect " + std::to_string(location.aspect) + ", (+,+), det A"), std::string::npos)
      << words;
  EXPECT_EQ(words.find("out of reach"), std::string::npos) << words;
}

TEST_F(ProbeOfFiveBar, StaysAtTheNearestPoseAndSaysHowFarAndWhose) {
  const ProbeFinding found = find(-10.0, 0.0);
  ASSERT_TRUE(found.reached);
  EXPECT_EQ(found.state.status.code, Status::NO_SOLUTION);
  EXPECT_NE(found.state.status.message.find("out of reach of leg_2"), std::string::npos)
      << found.state.status.message;
  EXPECT_NEAR(found.state.off, 6.0, 1e-5);
  EXPECT_NEAR(found.state.wanted.position.x, -10.0, 1e-12);
  EXPECT_NEAR(found.state.report.configuration.pose.position.x, -4.0, 1e-5);
  EXPECT_NE(words_of(*robot_, found).find("out of reach: it stays at the nearest pose found, 6 m from"),
            std::string::npos);
}

TEST_F(ProbeOfFiveBar, ReportsTheOtherWorkingModesOfItsPoseWhereAsked) {
  EXPECT_TRUE(find(4.5, 8.0).others.empty());
  const ProbeFinding found = find(4.5, 8.0, {1, -1}, true);
  ASSERT_EQ(found.others.size(), 3U);
  for (const JointVector& q : found.others) {
    EXPECT_LT(residuals(*robot_, found.reached->pose, q).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NE(working_mode(*robot_, found.reached->pose, q), WorkingMode::from_signs({1, -1}));
  }
}

TEST_F(ProbeOfFiveBar, SaysThatThereIsNoMapYet) {
  EXPECT_NE(words_at(robot_, {Pose::planar(4.5, 8.0), WorkingMode(2), false}, {}).find("no map yet"),
            std::string::npos);
}

// The colours under the probe are then those of other poses.
TEST(Probe, SaysThatAspectsAreDrawnAtAnotherAngle) {
  const auto robot = test::shipped("three_rrr")->manipulator();
  const AssembledConfiguration start = test::shipped("three_rrr")->assembled();
  ProbeFinding found = ProbeSolver(robot).find(
      {start.pose, *working_mode(*robot, start.pose, start.q), false}, {}, ros::Time(1.0));
  ASSERT_TRUE(found.reached);
  EXPECT_EQ(words_of(*robot, found).find("drawn at"), std::string::npos);
  const double phi = PoseSlice::through(TaskSpace::SE2, start.pose).level();
  found.section = PoseSlice(TaskSpace::SE2, phi + 0.5);
  const std::string expected = PoseSlice(TaskSpace::SE2, phi).text() + ", but aspects are drawn at " +
                               PoseSlice(TaskSpace::SE2, phi + 0.5).text();
  EXPECT_NE(words_of(*robot, found).find(expected), std::string::npos) << words_of(*robot, found);
  EXPECT_TRUE(is_near(*robot, PoseSlice(TaskSpace::SE2, phi + 0.01), start.pose));
  EXPECT_TRUE(is_near(*robot, PoseSlice(TaskSpace::SE2, phi + 2.0 * EIGEN_PI), start.pose)) << "a turn on";
  EXPECT_FALSE(is_near(*robot, PoseSlice(TaskSpace::SE2, phi + 0.1), start.pose));
}

TEST(Probe, OfAWristReportsDistancesAsAngles) {
  const auto mechanism = test::shipped("spherical_3rrr");
  const AssembledConfiguration start = mechanism->assembled();
  const auto mode = working_mode(*mechanism->manipulator(), start.pose, start.q);
  ASSERT_TRUE(mode);
  const std::string words = words_at(mechanism->manipulator(), {start.pose, *mode, false}, {});
  EXPECT_NE(words.find(" deg ("), std::string::npos) << words;
  EXPECT_EQ(words.find(" m,"), std::string::npos) << words;
}

TEST(Probe, OfSixDegreesOfFreedomHasNoMap) {
  const auto mechanism = test::shipped("stewart");
  const AssembledConfiguration start = mechanism->assembled();
  const auto mode = working_mode(*mechanism->manipulator(), start.pose, start.q);
  ASSERT_TRUE(mode);
  EXPECT_NE(words_at(mechanism->manipulator(), {start.pose, *mode, false}, {}).find("roadmap"),
            std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects
