// SPDX-License-Identifier: BSD-3-Clause
#include "ros/probe/probe_picture.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/conversions.h"
#include "ros/pictures/scene.h"
#include "ros/probe/probe_handle.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/urdf_frames.h"
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Eigen::Isometry3d isometry_of(const geometry_msgs::Pose& pose) {
  const geometry_msgs::Point& p = pose.position;
  const geometry_msgs::Quaternion& q = pose.orientation;
  return Eigen::Translation3d(p.x, p.y, p.z) * Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

std::string urdf_of(const std::string& robot) { return test::source_file("urdf/" + robot + ".urdf"); }

// Markers that are drawn, by namespace.
std::map<std::string, int> drawn(const MarkerArray& array) {
  std::map<std::string, int> counts;
  for (const Marker& marker : array.markers)
    if (marker.action == Marker::ADD) ++counts[marker.ns];
  return counts;
}

class PictureOf : public testing::TestWithParam<const char*> {
 protected:
  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped(GetParam());
  const Manipulator& robot_ = *mechanism_->manipulator();
  const AssembledConfiguration start_ = mechanism_->assembled();
  ProbeQuestion question_{start_.pose, *working_mode(robot_, start_.pose, start_.q), true};
};

// By walking up urdfdom's model: every visual is where the links of the closed mechanism are.
TEST_P(PictureOf, DrawsTheLinksWhereTheClosedMechanismHasThem) {
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism_->joint_names().size()));
  ASSERT_TRUE(mechanism_->complete(start_.pose, start_.q, positions));
  std::map<std::string, double> joints;
  for (std::size_t i = 0; i < mechanism_->joint_names().size(); ++i)
    joints[mechanism_->joint_names()[i]] = positions[static_cast<Eigen::Index>(i)];
  const auto model = urdf::parseURDF(urdf_of(GetParam()));
  ASSERT_TRUE(model);
  const Eigen::Isometry3d base = test::link_frame(*model, robot_.base_frame(), joints);
  std::vector<Eigen::Isometry3d> expected;
  for (const auto& [name, link] : model->links_)
    for (const auto& visual : link->visual_array)
      expected.push_back(base.inverse() * test::link_frame(*model, name, joints) *
                         test::isometry(visual->origin));
  const auto markers =
      RobotVisuals(mechanism_, urdf_of(GetParam()), 1.0).at(start_.pose, start_.q, "robot", {});
  ASSERT_FALSE(markers.empty());
  for (const Marker& marker : markers) {
    const Eigen::Isometry3d found = isometry_of(marker.pose);
    EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [&](const auto& each) {
      return found.isApprox(each, 1e-9);
    })) << marker.id;
    EXPECT_EQ(marker.header.frame_id, robot_.base_frame());
  }
}

// Without visuals the robot is drawn as lines: every rod from where its actuated joint holds it to its
// anchor.
TEST_P(PictureOf, DrawsLegsAndPlatformWhereThereAreNoVisuals) {
  static const std::regex visual(R"(<visual[\s>][\s\S]*?</visual>)");
  const std::string stripped = std::regex_replace(urdf_of(GetParam()), visual, "");
  const auto markers = RobotVisuals(mechanism_, stripped, 2.0).at(start_.pose, start_.q, "robot", {});
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].type, Marker::LINE_LIST);
  EXPECT_EQ(markers[0].header.frame_id, robot_.base_frame());
  const double scale = robot_.task_space() == TaskSpace::SO3 ? 2.0 : 1.0;
  std::vector<Eigen::Vector3d> ends;
  for (const auto& each : markers[0].points) ends.emplace_back(each.x, each.y, each.z);
  for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
    const Eigen::Vector3d from = scale * robot_.leg(j).proximal_point(start_.q[static_cast<Eigen::Index>(j)]),
                          to = scale * start_.pose.transform(robot_.leg(j).anchor);
    bool found = false;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      found = found || ((ends[i] - from).norm() < 1e-9 && (ends[i + 1] - to).norm() < 1e-9);
    EXPECT_TRUE(found) << robot_.leg(j).name;
  }
}

TEST_P(PictureOf, HasRobotSingularityAndWordsAndTakesAwayWhatIsNoMore) {
  ProbePicture picture(mechanism_, urdf_of(GetParam()), NodeOptions());
  ProbeSolver solver(mechanism_->manipulator());
  const ProbeFinding found = solver.find(question_, {}, ros::Time(1.0));
  ASSERT_TRUE(found.reached);
  const auto all = drawn(picture.of(found));
  EXPECT_GT(all.at("probe/robot"), 0);
  EXPECT_EQ(all.at("probe/words"), 1);
  EXPECT_EQ(all.count("probe/wanted"), 0U);
  const bool near = std::isfinite(std::min(found.distances.parallel.upper, found.distances.serial.upper));
  EXPECT_EQ(all.count("probe/to_singularity"), near ? 1U : 0U);
  question_.others = false;
  const MarkerArray fewer = picture.of(solver.find(question_, {}, ros::Time(1.0)));
  std::set<std::string> gone;
  for (const Marker& marker : fewer.markers)
    if (marker.action == Marker::DELETE) gone.insert(marker.ns);
  for (const auto& [name, count] : all) EXPECT_EQ(gone.count(name) + drawn(fewer).count(name), 1U) << name;
  EXPECT_TRUE(drawn(picture.none()).empty());
}

// Above all that a planar robot reaches, also where there are as many lines as there can be.
TEST_P(PictureOf, WordsLieBesideAPlanarRobot) {
  const Scene scene =
      scene_of(*mechanism_, NodeOptions(), RobotVisuals(mechanism_, urdf_of(GetParam()), 1.0).still());
  if (!scene.planar) GTEST_SKIP();
  ProbePicture picture(mechanism_, urdf_of(GetParam()), NodeOptions());
  ProbeFinding found = ProbeSolver(mechanism_->manipulator()).find(question_, {}, ros::Time(1.0));
  found.section = PoseSlice::through(robot_.task_space(), start_.pose);
  for (const Marker& marker : picture.of(found).markers) {
    if (marker.ns != "probe/words" || marker.action != Marker::ADD) continue;
    const auto lines = 1 + std::count(marker.text.begin(), marker.text.end(), '\n');
    EXPECT_GE(lines, 3);
    const double half = 0.5 * Caption::line_pitch * marker.scale.z * static_cast<double>(lines);
    const double reach = scene.robot.min().y() + scene.robot.sizes().y() / (1.0 + words_room);
    EXPECT_GE(marker.pose.position.y - half, reach - 1e-9);
    EXPECT_LE(marker.pose.position.y + half, scene.robot.max().y() + 1e-9);
  }
}

TEST_P(PictureOf, HandleHasAControlForEachDegreeOfFreedom) {
  const auto marker = handle_marker(robot_, pose_message(platform_in_base(robot_, start_.pose)), 1.0);
  EXPECT_EQ(marker.header.stamp, ros::Time());
  std::size_t arrows = 0, rings = 0;
  for (const InteractiveMarkerControl& control : marker.controls) {
    if (control.name == "move") continue;  // the ball
    arrows += control.interaction_mode == InteractiveMarkerControl::MOVE_AXIS ? 1 : 0;
    rings += control.interaction_mode == InteractiveMarkerControl::ROTATE_AXIS ? 1 : 0;
    const auto& q = control.orientation;
    const Eigen::Vector3d axis = Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d::UnitX();
    EXPECT_NEAR(axis[control.name.back() - 'x'], 1.0, 1e-12) << control.name;
  }
  EXPECT_EQ(arrows, directions(robot_.task_space()));
  EXPECT_EQ(arrows + rings, degrees_of_freedom(robot_.task_space()));
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, PictureOf,
                         testing::Values("five_bar", "three_rrr", "delta", "agile_eye", "stewart", "hexa"),
                         [](const auto& robot) { return std::string(robot.param); });

TEST(Handle, BallOfAPlanarRobotMovesInItsPlane) {
  const auto mechanism = test::shipped("five_bar");
  const auto marker = handle_marker(*mechanism->manipulator(), {}, 1.0);
  const InteractiveMarkerControl& ball = marker.controls.front();
  EXPECT_EQ(ball.interaction_mode, InteractiveMarkerControl::MOVE_PLANE);
  const auto& q = ball.orientation;
  const Eigen::Vector3d across = Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(across.z(), 1.0, 1e-12);
}

TEST(Handle, OfAWristIsAsLargeAsItIsDrawn) {
  const auto mechanism = test::shipped("agile_eye");
  const auto unit = handle_marker(*mechanism->manipulator(), {}, 1.0);
  const auto drawn = handle_marker(*mechanism->manipulator(), {}, 0.1);
  EXPECT_NEAR(drawn.scale, 0.1 * unit.scale, 1e-6);
  EXPECT_NEAR(drawn.controls.front().markers.front().scale.x,
              0.1 * unit.controls.front().markers.front().scale.x, 1e-9);
  const auto planar = test::shipped("five_bar");
  EXPECT_EQ(handle_marker(*planar->manipulator(), {}, 0.1).scale,
            handle_marker(*planar->manipulator(), {}, 1.0).scale);
}

}  // namespace
}  // namespace parallel_aspects
