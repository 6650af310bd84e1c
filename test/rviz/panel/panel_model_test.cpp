// SPDX-License-Identifier: BSD-3-Clause
//
// What the panel says of what it has heard; without widgets and without a node.
#include "rviz/panel/panel_model.h"

#include <parallel_aspects/Status.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

DistanceBounds bounds(double lower, double upper, double speed) {
  DistanceBounds result;
  result.lower = lower;
  result.upper = upper;
  result.speed = speed;
  return result;
}

NodeView followed() {
  NodeView view;
  view.node = "/left/aspect_node";
  view.connected = view.hears = true;
  view.state.emplace();
  view.state->level = AspectState::CLEAR;
  view.state->working_mode = {1, -1};
  view.state->determinant_sign = -1;
  view.state->aspect = 7;
  view.state->parallel_distance = bounds(0.3, 0.31, -0.05);
  view.state->serial_distance = bounds(0.5, 0.7, 0.0);
  view.state->limit_distance = bounds(infinity, infinity, unknown);
  view.largest_distance = 0.7;
  return view;
}

NodeView ambiguous() {
  NodeView view = followed();
  view.state->status.code = Status::AMBIGUOUS;
  view.state->status.message = "det A came too close to zero.";
  view.candidates.complete = true;
  view.candidates.candidates.resize(2);
  SolvedConfiguration& first = view.candidates.candidates.front();
  first.working_mode = {1, 1};
  first.determinant_sign = 1;
  first.aspect = 3;
  first.pose.position.x = 4.5;
  first.pose.position.y = -8.0;
  first.pose.orientation.w = 1.0;
  view.candidates.candidates.back().pose.orientation.w = 1.0;
  return view;
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& each : words) EXPECT_NE(text.find(each), std::string::npos) << text << ": " << each;
}

TEST(PanelModel, SaysWhatItWaitsFor) {
  NodeView view;
  view.master_answers = false;
  EXPECT_EQ(banner_of(view).safety, SafetyLevel::unknown);
  expect_words(banner_of(view).text, {"ROS master", "roscore"});
  view.master_answers = true;
  expect_words(banner_of(view).text, {"none is running", "roslaunch"});
  view.node = "/left/aspect_node";
  expect_words(banner_of(view).text, {"/left/aspect_node", "not running"});
  view.connected = true;
  expect_words(banner_of(view).text, {"/left/aspect_node/state"});
  EXPECT_FALSE(may_ask(view));
  EXPECT_EQ(may_choose(view).refusal, banner_of(view).text);
}

TEST(PanelModel, NamesLevelPlaceAndReason) {
  NodeView view = followed();
  EXPECT_EQ(banner_of(view).title, "CLEAR");
  EXPECT_EQ(banner_of(view).text, "Aspect 7, (+,-), det A < 0");
  view.state->level = AspectState::STOP;
  view.state->reason = "too near";
  EXPECT_EQ(banner_of(view).safety, SafetyLevel::stop);
  EXPECT_EQ(banner_of(view).text, "Aspect 7, (+,-), det A < 0\ntoo near");
  view.state->level = AspectState::WARN;
  EXPECT_EQ(banner_of(view).title, "WARN");
  view.state->aspect = 0;
  expect_words(banner_of(view).text, {"Aspect not known"});
  view.state->level = AspectState::NO_THRESHOLD;
  view.state->reason = "no threshold is set";
  EXPECT_EQ(banner_of(view).safety, SafetyLevel::unknown);
  EXPECT_EQ(banner_of(view).title, "NO THRESHOLD");
  expect_words(banner_of(view).text, {"no threshold is set"});
  view.state->level = 0;  // a message that nobody has filled
  EXPECT_EQ(banner_of(view).safety, SafetyLevel::unknown);
}

TEST(PanelModel, NamesTheBasicRegionAndWhetherADomainHoldsWhereTrackingBegan) {
  NodeView view = followed();
  UniquenessState& domains = view.state->uniqueness;
  const auto expect_line = [&view](const char* text, SafetyLevel safety) {
    EXPECT_EQ(domain_line_of(view).text, text);
    EXPECT_EQ(domain_line_of(view).safety, safety) << text;
  };
  domains.known = UniquenessState::REGIONS;
  expect_line("Basic region not known", SafetyLevel::clear);
  domains.basic_region = domains.reference_region = 3;
  domains.sharing = UniquenessState::SHARED;
  expect_line("Basic region 3, where tracking began", SafetyLevel::clear);
  domains.basic_region = 7;
  domains.domains = {1, 5};
  expect_line("Basic region 7, in one domain with 3", SafetyLevel::clear);
  expect_words(domain_line_of(view).tip, {"hold it: 2."});
  domains.sharing = UniquenessState::UNKNOWN;
  expect_line("Basic region 7, perhaps in no domain with 3", SafetyLevel::clear);
  domains.sharing = UniquenessState::APART;
  domains.warns = true;
  expect_line("Basic region 7, in no known domain with 3", SafetyLevel::warn);
  domains.basic_region = 0;  // in a strip
  expect_line("Basic region not known, last in no known domain with 3", SafetyLevel::warn);
  view.state->status.code = Status::STALE;
  expect_line("Basic region not known", SafetyLevel::unknown);
}

TEST(PanelModel, SaysOfUniquenessDomainsWhatIsKnown) {
  NodeView view = followed();
  EXPECT_TRUE(domain_line_of(NodeView()).text.empty());
  for (const auto known : {UniquenessState::OFF, UniquenessState::NONE}) {
    view.state->uniqueness.known = known;
    EXPECT_TRUE(domain_line_of(view).text.empty()) << int{known};
  }
  view.state->uniqueness.known = UniquenessState::WAITING;
  EXPECT_EQ(domain_line_of(view).text, "Uniqueness domains are being computed");
  view.state->uniqueness.known = UniquenessState::ASPECTS;
  EXPECT_EQ(domain_line_of(view).text, "Each aspect is a uniqueness domain");
}

TEST(PanelModel, SaysThatANodeIsSilentWhereItsRobotWasFollowed) {
  NodeView view = followed();
  view.silence = 3.7;
  EXPECT_EQ(banner_of(view).safety, SafetyLevel::unknown);
  EXPECT_EQ(banner_of(view).title, "SILENT");
  expect_words(banner_of(view).text, {"3 s", "Aspect 7"});
  view.state->status.code = Status::STALE;  // then it has nothing to say
  view.state->status.message = "nothing came";
  EXPECT_EQ(banner_of(view).title, "STALE");
  EXPECT_EQ(banner_of(view).text, "nothing came");
}

TEST(PanelModel, DrawsDistancesOnOneScale) {
  const auto gauges = gauges_of(followed());
  EXPECT_EQ(scale_of(followed()), 1.0);
  EXPECT_DOUBLE_EQ(gauges[0].lower, 0.3);
  EXPECT_DOUBLE_EQ(gauges[0].upper, 0.31);
  EXPECT_EQ(gauges[0].text, "0.3 m, shrinks 0.05 m/s");
  EXPECT_EQ(gauges[1].text, "0.5 m");
  EXPECT_EQ(gauges[2].text, "none");
  EXPECT_EQ(gauges[2].lower, 0.0) << "an empty bar";
  EXPECT_EQ(gauges[2].upper, 0.0);
  EXPECT_EQ(gauges[2].safety, SafetyLevel::clear);
  for (const DistanceGauge& each : {gauges[0], gauges[1]}) {
    EXPECT_EQ(each.safety, SafetyLevel::unknown) << "without a threshold nothing is near";
    expect_words(each.tip, {"No threshold is set"});
  }
}

// The state has chords, thresholds are angles.
TEST(PanelModel, ReportsDistancesOfWristsAsAngles) {
  NodeView view = followed();
  view.unit = DistanceUnit::of_angles();
  view.state->parallel_distance = bounds(2.0 * std::sin(0.5), 2.0 * std::sin(0.55), -0.5 * std::cos(0.5));
  view.thresholds[0] = {0.99, 0.2};
  const auto gauges = gauges_of(view);
  EXPECT_EQ(gauges[0].text, "1 rad, shrinks 0.5 rad/s");
  EXPECT_EQ(gauges[0].safety, SafetyLevel::clear) << "though the chord is below the threshold";
  expect_words(gauges[0].tip, {"1.1 rad", "WARN below 0.99 rad", "STOP below 0.2 rad"});
}

TEST(PanelModel, ScalesAreOneTwoOrFive) {
  for (const auto& [largest, scale] : std::vector<std::pair<double, double>>{
           {0.7, 1.0}, {1.0, 1.0}, {1.01, 2.0}, {2.5, 5.0}, {6.0, 10.0}, {0.013, 0.02}}) {
    NodeView view = followed();
    view.largest_distance = largest;
    EXPECT_DOUBLE_EQ(scale_of(view), scale) << largest;
  }
  EXPECT_EQ(scale_of(NodeView()), 1.0);
}

TEST(PanelModel, ComparesDistancesWithThresholds) {
  NodeView view = followed();
  view.thresholds[0] = {0.4, 0.2};
  EXPECT_EQ(gauges_of(view)[0].safety, SafetyLevel::warn);
  expect_words(gauges_of(view)[0].tip, {"0.31 m", "WARN below 0.4 m", "STOP below 0.2 m"});
  view.thresholds[0] = {0.4, 0.3};
  EXPECT_EQ(gauges_of(view)[0].safety, SafetyLevel::stop);
  view.thresholds[0] = {0.2, 0.1};
  EXPECT_EQ(gauges_of(view)[0].safety, SafetyLevel::clear);
  view.thresholds[2] = {0.4, 0.3};
  EXPECT_EQ(gauges_of(view)[2].safety, SafetyLevel::clear) << "there is none";
}

TEST(PanelModel, MeasuresNothingWhereNothingIsKnown) {
  for (NodeView view : {NodeView(), ambiguous()}) {
    view.thresholds[0] = {0.4, 0.2};
    const DistanceGauge gauge = gauges_of(view)[0];
    EXPECT_TRUE(std::isnan(gauge.lower) && std::isnan(gauge.upper));
    EXPECT_EQ(gauge.safety, SafetyLevel::unknown);
    EXPECT_EQ(gauge.text, "not measured");
  }
}

TEST(PanelModel, OffersCandidatesUntilTheRobotIsFollowed) {
  NodeView view = ambiguous();
  EXPECT_EQ(banner_of(view).title, "AMBIGUOUS");
  EXPECT_EQ(banner_of(view).text, "det A came too close to zero.");
  const auto lines = candidates_of(view);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].branch, "Aspect 3, (+,+), det A > 0");
  EXPECT_EQ(lines[0].text, "x 4.5, y -8");
  EXPECT_EQ(lines[1].branch, "working mode not known");
  EXPECT_EQ(lines[0].name, "A");
  EXPECT_EQ(lines[1].name, "B");
  EXPECT_NE(lines[0].color, lines[1].color) << "as in the pictures";
  for (const auto code : {Status::OK, Status::NO_JOINT_STATES}) {
    view.state->status.code = code;
    EXPECT_TRUE(candidates_of(view).empty()) << int{code};
  }
}

TEST(PanelModel, PosesOfCandidatesFitIntoTheirButtons) {
  NodeView view = ambiguous();
  geometry_msgs::Pose& pose = view.candidates.candidates[0].pose;
  pose.position.x = -2.1e-16;
  pose.position.y = 0.0;
  pose.position.z = 1.3;
  pose.orientation.x = 0.6;
  pose.orientation.w = 0.8;
  EXPECT_EQ(candidates_of(view)[0].text, "x 0, y 0, z 1.3\nroll 1.29, pitch 0, yaw 0");
}

TEST(PanelModel, ReadOnlyRefusesWithItsReason) {
  NodeView view = ambiguous();
  view.progress.emplace();
  view.progress->state = MapProgress::COMPUTING;
  EXPECT_TRUE(may_choose(view) && may_compute_map(view) && may_cancel_map(view));
  view.read_only = true;
  for (const Permission& each : {may_choose(view), may_compute_map(view), may_cancel_map(view)})
    expect_words(each.refusal, {"read-only", "~read_only"});
  EXPECT_TRUE(may_ask(view));
}

TEST(PanelModel, WaitsUntilGoalsAreHeard) {
  NodeView view = followed();
  EXPECT_TRUE(may_compute_map(view));
  view.hears = false;
  expect_words(may_compute_map(view).refusal, {"Waits for /left/aspect_node/compute_map"});
  EXPECT_FALSE(may_cancel_map(view));
  EXPECT_TRUE(may_ask(view));
}

TEST(PanelModel, ReportsHowFarTheMapIs) {
  NodeView view = followed();
  EXPECT_TRUE(map_line_of(view).text.empty());
  view.progress.emplace();
  view.progress->state = MapProgress::COMPUTING;
  view.progress->progress = 0.4;
  view.progress->message = "refining";
  EXPECT_TRUE(map_line_of(view).runs);
  EXPECT_DOUBLE_EQ(map_line_of(view).share, 0.4);
  view.progress->state = MapProgress::COMPLETE;
  EXPECT_FALSE(map_line_of(view).runs);
  expect_words(may_cancel_map(view).refusal, {"No map is being computed"});
}

TEST(PanelModel, ListsTheNewestTransitionFirst) {
  NodeView view = followed();
  view.transitions.resize(2);
  view.transitions[0].message = "first";
  view.transitions[1].message = "second";
  view.transitions[1].header.stamp = ros::Time(100, 5000000);
  const auto lines = events_of(view);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].text, "second");
  EXPECT_EQ(lines[0].time.substr(5), ":40.005") << lines[0].time;
  EXPECT_EQ(lines[1].text, "first");
}

TEST(PanelModel, WritesPoses) {
  geometry_msgs::Pose pose;
  pose.position.x = 1.0;
  pose.orientation.w = 1.0;
  EXPECT_EQ(pose_of(pose), "x 1, y 0");
  EXPECT_EQ(pose_of(pose, DistanceUnit::of_angles()), "not turned") << "a wrist does not move";
  pose.orientation.w = std::cos(0.25);
  pose.orientation.z = std::sin(0.25);
  EXPECT_EQ(pose_of(pose), "x 1, y 0, phi 0.5");
  EXPECT_EQ(pose_of(pose, DistanceUnit::of_angles()), "phi 0.5");
  pose.orientation.z = 0.0;
  pose.orientation.y = std::sin(0.25);
  pose.position.z = -2.0;
  EXPECT_EQ(pose_of(pose), "x 1, y 0, z -2, roll 0, pitch 0.5, yaw 0");
}

}  // namespace
}  // namespace parallel_aspects
