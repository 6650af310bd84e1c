// SPDX-License-Identifier: BSD-3-Clause
//
// ~choose_working_mode and ~connect of a node of the five-bar, against what the library answers.
#include "parallel_aspects/motion/choose_working_mode.h"
#include "ros/messages/conversions.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/ChooseWorkingMode.h>
#include <parallel_aspects/Connect.h>
#include <parallel_aspects/MapProgress.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using test::call;
using Question = ChooseWorkingMode::Request;

geometry_msgs::Pose at(double x, double y) {
  geometry_msgs::Pose pose;
  pose.position.x = x;
  pose.position.y = y;
  pose.orientation.w = 1.0;
  return pose;
}

Question path(const std::vector<std::pair<double, double>>& positions) {
  Question request;
  for (const auto& [x, y] : positions) request.poses.push_back(at(x, y));
  return request;
}

Question region(double x_lower, double x_upper, double y_lower, double y_upper) {
  Question request;
  request.kind = Question::REGION;
  request.coordinates = {"y", "x"};
  request.lower = {y_lower, x_lower};
  request.upper = {y_upper, x_upper};
  return request;
}

ChooseWorkingMode::Response choose(const Question& request) {
  return call<ChooseWorkingMode>("choose_working_mode", request);
}

void expect_refused(const Question& request, const std::string& word) {
  const auto response = choose(request);
  EXPECT_EQ(response.status.code, Status::INVALID_REQUEST) << word;
  EXPECT_NE(response.status.message.find(word), std::string::npos) << response.status.message;
  EXPECT_TRUE(response.modes.empty());
}

class ChoiceServices : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const test::Recorder<MapProgress> progress("/aspect_node/map_progress");
    ASSERT_TRUE(
        test::eventually([&] { return progress.last() && progress.last()->state == MapProgress::COMPLETE; }));
  }

  const std::shared_ptr<const Manipulator> robot_ = test::five_bar_mechanism()->mapped_manipulator();
  const SegmentCertifier certifier_{robot_};
};

TEST_F(ChoiceServices, APathIsAnsweredAsByTheLibrary) {
  const auto response = choose(path({{3.0, 6.0}, {5.0, 7.0}, {6.0, 5.0}}));
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  EXPECT_EQ(response.answer, ModeChoice::YES) << response.reason;
  const PathChoice expected = choose_working_mode(
      certifier_,
      {{0.0, Pose::planar(3.0, 6.0)}, {1.0, Pose::planar(5.0, 7.0)}, {2.0, Pose::planar(6.0, 5.0)}});
  ASSERT_EQ(response.modes.size(), expected.modes.size());
  for (std::size_t i = 0; i < response.modes.size(); ++i) {
    const ModeChoice& found = response.modes[i];
    const ModeOnPath& mode = expected.modes[i];
    EXPECT_EQ(found.working_mode, signs_message(mode.mode));
    EXPECT_EQ(found.answer == ModeChoice::YES, mode.check.answer == TrajectoryAnswer::safe);
    EXPECT_EQ(found.reason, mode.check.reason);
    EXPECT_GT(found.aspect, 0U);
    if (mode.clearance) {
      EXPECT_NEAR(found.clearance, mode.clearance->lower, 1e-9);
      EXPECT_EQ(found.travel.size(), 2U);
    } else {
      EXPECT_TRUE(std::isnan(found.clearance));
      EXPECT_NEAR(found.violation_before, mode.check.violation->before, 1e-9);
    }
  }
}

TEST_F(ChoiceServices, APathThatNeedsAChangeOfPostureGetsIt) {
  Question request = path({{2.0, -7.0}, {8.4, 8.8}});
  request.changes = true;
  const auto response = choose(request);
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  EXPECT_EQ(response.answer, ModeChoice::NO);
  EXPECT_EQ(response.answer_with_changes, ModeChoice::YES) << response.reason_with_changes;
  EXPECT_EQ(response.first_mode, (std::vector<std::int8_t>{-1, 1}));
  ASSERT_EQ(response.posture_changes.size(), 1U);
  const ChangeOfPosture& change = response.posture_changes.front();
  EXPECT_EQ(change.leg, "leg_1");
  EXPECT_EQ(change.to_mode, (std::vector<std::int8_t>{1, 1}));
  EXPECT_NEAR(std::hypot(change.singular_pose.position.x, change.singular_pose.position.y), 3.0, 1e-6);
}

TEST_F(ChoiceServices, ARegionIsTConnectedOrHasAPairThatIsApart) {
  const auto small = choose(region(3.0, 6.0, 5.0, 8.0));
  ASSERT_EQ(small.status.code, Status::OK) << small.status.message;
  EXPECT_EQ(small.answer, ModeChoice::YES) << small.reason;
  EXPECT_GT(small.modes.front().least_index, 0.0);
  const auto large = choose(region(-3.0, 12.0, -10.0, 10.0));
  ASSERT_EQ(large.status.code, Status::OK) << large.status.message;
  EXPECT_EQ(large.answer, ModeChoice::NO) << large.reason;
  EXPECT_EQ(large.apart.size(), 2U);
  for (const ModeChoice& mode : large.modes) EXPECT_FALSE(mode.witnesses.empty());
  const auto line = choose(region(3.0, 6.0, 5.0, 5.0));
  EXPECT_EQ(line.status.code, Status::OK) << line.status.message;
}

TEST_F(ChoiceServices, BadQuestionsAreRefusedInOneSentence) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(path({}), "no waypoint");
  expect_refused(path({{nan, 0.0}}), "finite");
  Question bad = path({{3.0, 6.0}, {5.0, 7.0}});
  bad.prefer = "best";
  expect_refused(bad, "prefer");
  bad.prefer = "";
  bad.times = {0.0};
  expect_refused(bad, "times");
  bad.times = {1.0, 0.0};
  expect_refused(bad, "rise");
  bad.times.clear();
  bad.coordinates = {"x"};
  expect_refused(bad, "ranges");
  bad.coordinates.clear();
  bad.kind = 2;
  expect_refused(bad, "kind");
  bad.kind = Question::REGION;
  expect_refused(bad, "no path");
  expect_refused(region(3.0, 2.0, 5.0, 8.0), "below the upper");
  expect_refused(region(nan, 2.0, 5.0, 8.0), "finite");
  Question other = region(3.0, 6.0, 5.0, 8.0);
  other.coordinates[0] = "w";
  expect_refused(other, "'w=");
  other.coordinates = {"x", "x"};
  expect_refused(other, "twice");
  other.coordinates = {"x"};
  expect_refused(other, "entries");
  Question far = path({{3.0, 6.0}});
  far.header.frame_id = "nowhere";
  EXPECT_EQ(choose(far).status.code, Status::NO_TRANSFORM);
}

TEST_F(ChoiceServices, PosesAreConnectedOrNotInEveryWorkingMode) {
  Connect::Request request;
  request.start.pose = at(4.5, 8.0);
  request.goal.pose = at(4.5, -8.0);
  const auto response = call<Connect>("connect", request);
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  ASSERT_EQ(response.answers.size(), 4U);
  int connected = 0;
  for (const ModeConnection& answer : response.answers) {
    EXPECT_NE(answer.answer, ModeChoice::UNKNOWN) << answer.reason;
    if (answer.answer != ModeChoice::YES) continue;
    ++connected;
    ASSERT_GE(answer.path.size(), 2U);
    EXPECT_NEAR(answer.path.front().position.y, 8.0, 1e-12);
    EXPECT_NEAR(answer.path.back().position.y, -8.0, 1e-12);
    EXPECT_GT(answer.clearance, 0.0);
    const auto mode = *WorkingMode::from_signs({answer.working_mode.begin(), answer.working_mode.end()});
    for (std::size_t i = 1; i < answer.path.size(); ++i) {
      const auto pose = [&](std::size_t k) {
        return Pose::planar(answer.path[k].position.x, answer.path[k].position.y);
      };
      EXPECT_EQ(certifier_.prove(pose(i - 1), pose(i), mode).verdict, SegmentVerdict::free);
    }
  }
  EXPECT_GT(connected, 0);
  EXPECT_LT(connected, 4);
}

TEST_F(ChoiceServices, BadPosesAndModesAreRefused) {
  Connect::Request request;
  request.start.pose = request.goal.pose = at(4.5, 8.0);
  request.working_mode = {1, -1};
  EXPECT_EQ(call<Connect>("connect", request).answers.size(), 1U);
  request.working_mode = {1};
  EXPECT_EQ(call<Connect>("connect", request).status.code, Status::INVALID_REQUEST);
  request.working_mode.clear();
  request.goal.pose.position.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(call<Connect>("connect", request).status.code, Status::INVALID_REQUEST);
  request.goal.header.frame_id = "nowhere";
  EXPECT_EQ(call<Connect>("connect", request).status.code, Status::NO_TRANSFORM);
}

}  // namespace
}  // namespace parallel_aspects
