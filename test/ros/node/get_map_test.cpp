// SPDX-License-Identifier: BSD-3-Clause
//
// ~get_map and ~get_regular_workspace of a node of the five-bar, against what the library computes; of one
// whose map takes long, and of a hexapod, which has none.
#include "parallel_aspects/aspects/regular_workspace.h"
#include "ros/messages/conversions.h"
#include "ros/messages/map_messages.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/ComputeMapAction.h>
#include <parallel_aspects/GetRegularWorkspace.h>
#include <parallel_aspects/MapProgress.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <actionlib/client/simple_action_client.h>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {
namespace {

using test::call;

GetMap::Response get_map(const std::string& known = "", const std::string& service = "get_map") {
  GetMap::Request request;
  request.known_revision = known;
  return call<GetMap>(service, request);
}

class GetMapService : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const test::Recorder<MapProgress> progress("/aspect_node/map_progress");
    ASSERT_TRUE(
        test::eventually([&] { return progress.last() && progress.last()->state == MapProgress::COMPLETE; }));
  }
};

TEST_F(GetMapService, TheMapIsThatOfTheLibrary) {
  const GetMap::Response response = get_map();
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  EXPECT_EQ(response.task_space, "T2");
  EXPECT_EQ(response.base_frame, "base_link");
  const SharedMechanism mechanism = mechanism_of(response);
  const MapResult received = map_of(response, *mechanism);
  ASSERT_TRUE(received.map) << received.message;
  const MapResult computed = compute_aspect_map(test::five_bar_mechanism()->mapped_manipulator());
  ASSERT_EQ(received.map->aspects().size(), computed.map->aspects().size());
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> x(-4.0, 13.0), y(-13.0, 13.0);
  for (int i = 0; i < 2000; ++i) {
    const Pose pose = Pose::planar(x(random), y(random));
    for (const WorkingMode& mode : received.map->working_modes())
      ASSERT_EQ(received.map->locate(pose, mode).aspect, computed.map->locate(pose, mode).aspect)
          << pose.position.transpose() << " in " << to_string(mode);
  }
}

TEST_F(GetMapService, AMapThatIsKnownIsNotSentAgain) {
  const std::string revision = get_map().revision;
  ASSERT_FALSE(revision.empty());
  const GetMap::Response again = get_map(revision);
  EXPECT_EQ(again.status.code, Status::OK);
  EXPECT_EQ(again.revision, revision);
  EXPECT_TRUE(again.map.empty());
  EXPECT_FALSE(get_map("another").map.empty());
}

TEST_F(GetMapService, AnotherMapHasAnotherRevision) {
  const std::string revision = get_map().revision;
  actionlib::SimpleActionClient<ComputeMapAction> client("/aspect_node/compute_map", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(test::deadline)));
  ComputeMapGoal goal;
  goal.resolution = 0.3;
  client.sendGoal(goal);
  ASSERT_TRUE(client.waitForResult(ros::Duration(test::deadline)));
  const GetMap::Response response = get_map(revision);
  EXPECT_NE(response.revision, revision);
  EXPECT_LE(response.resolution, 0.3);
  const MapResult received = map_of(response, *mechanism_of(response));
  EXPECT_TRUE(received.map) << received.message;
}

TEST_F(GetMapService, SaysThatThereIsNoMapYet) {
  const GetMap::Response response = get_map("", "/slow/aspect_node/get_map");
  EXPECT_EQ(response.status.code, Status::MAP_NOT_READY);
  EXPECT_NE(response.status.message.find("no map yet"), std::string::npos) << response.status.message;
  EXPECT_TRUE(response.map.empty());
  EXPECT_EQ(mechanism_of(response)->manipulator()->task_space(), TaskSpace::SE2);
}

TEST_F(GetMapService, SaysThatAHexapodHasNone) {
  const GetMap::Response response = get_map("", "/stewart/aspect_node/get_map");
  EXPECT_EQ(response.status.code, Status::NO_MAP);
  EXPECT_FALSE(response.status.message.empty());
  EXPECT_EQ(response.task_space, "SE3");
  EXPECT_EQ(mechanism_of(response)->manipulator()->leg_count(), 6U);
}

TEST_F(GetMapService, AMapThatIsTooLargeIsNotSent) {
  const MapResult computed = compute_aspect_map(test::five_bar_mechanism()->mapped_manipulator());
  GetMap::Response response;
  add_map(*computed.map, response, 1000);
  EXPECT_EQ(response.status.code, Status::FAILED);
  EXPECT_NE(response.status.message.find("coarser"), std::string::npos) << response.status.message;
  EXPECT_TRUE(response.map.empty());
}

TEST_F(GetMapService, BytesThatAreDamagedAreRefused) {
  GetMap::Response response = get_map();
  const SharedMechanism mechanism = mechanism_of(response);
  // Some of them: of packed bytes a single bit may not matter, as where it tells which of equal bytes to
  // repeat.
  for (std::size_t i = 0; i < 16; ++i) response.map[response.map.size() / 2 + i] ^= 0x55U;
  const MapResult received = map_of(response, *mechanism);
  EXPECT_FALSE(received.map);
  EXPECT_NE(received.message.find("damaged"), std::string::npos) << received.message;
  response.map.resize(3);
  EXPECT_FALSE(map_of(response, *mechanism).map);
}

GetRegularWorkspace::Request largest(const std::string& shape) {
  GetRegularWorkspace::Request request;
  request.shape = shape;
  return request;
}

GetRegularWorkspace::Response answer(const GetRegularWorkspace::Request& request) {
  return call<GetRegularWorkspace>("get_regular_workspace", request);
}

TEST_F(GetMapService, LargestDiscsAreThoseOfTheLibraryAndTheBestIsDrawn) {
  const test::Recorder<visualization_msgs::MarkerArray> markers("/aspect_node/regular_workspace_markers");
  const GetRegularWorkspace::Response response = answer(largest("disc"));
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  const GetMap::Response sent = get_map();  // of the map in use, which other tests may have changed
  const MapResult received = map_of(sent, *mechanism_of(sent));
  ASSERT_TRUE(received.map) << received.message;
  std::vector<int> ids;
  for (const Aspect& aspect : received.map->aspects()) ids.push_back(aspect.id);
  WorkspaceQuestion question;
  question.shape = RegularShape::disc;
  const auto found = find_regular_workspaces(*received.map, ids, question);
  ASSERT_EQ(response.shapes.size(), ids.size());
  double best = 0.0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(response.shapes[i].lower, (*found)[i].lower);
    EXPECT_EQ(response.shapes[i].upper, (*found)[i].upper);
    EXPECT_EQ(response.shapes[i].center.position.x, (*found)[i].center[0]);
    EXPECT_EQ(response.shapes[i].names, std::vector<std::string>{"radius"});
    best = std::max(best, (*found)[i].lower);
  }
  ASSERT_GT(response.best, 0U);
  EXPECT_EQ(response.shapes[response.best - 1].lower, best);
  ASSERT_TRUE(test::eventually([&] { return markers.last() && markers.last()->markers.size() == 2; }));
  const visualization_msgs::Marker marker = markers.last()->markers.back();
  EXPECT_EQ(marker.type, visualization_msgs::Marker::CYLINDER);
  EXPECT_EQ(marker.scale.x, 2.0 * best);
  EXPECT_EQ(marker.scale.y, 2.0 * best);
  EXPECT_EQ(marker.pose.position.x, response.shapes[response.best - 1].center.position.x);
}

TEST_F(GetMapService, ABoxWithItsCenterAndEdgesInOneAspect) {
  GetRegularWorkspace::Request request = largest("box");
  request.aspect = 3;
  request.held = {"x"};
  request.center = {4.5};
  request.ratio = {1.0, 2.0};
  const GetRegularWorkspace::Response response = answer(request);
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  ASSERT_EQ(response.shapes.size(), 1U);
  EXPECT_EQ(response.shapes[0].aspect, 3U);
  EXPECT_EQ(response.shapes[0].center.position.x, 4.5);
  ASSERT_EQ(response.shapes[0].lengths.size(), 2U);
  EXPECT_NEAR(response.shapes[0].lengths[1], 2.0 * response.shapes[0].lengths[0], 1e-9);
}

TEST_F(GetMapService, WorkspacesThatCannotBeAskedForAreRefused) {
  std::vector<GetRegularWorkspace::Request> bad(7, largest("disc"));
  bad[0].shape = "ball";  // which needs three positions
  bad[1].shape = "x";
  bad[2].held = {"x"};
  bad[3].held = {"phi"};
  bad[3].center = {1.0};
  bad[4].aspect = 11;
  bad[5].gap = std::numeric_limits<double>::quiet_NaN();
  bad[6].angle = {0.0, 1.0};  // of which the five-bar has none
  for (const GetRegularWorkspace::Request& request : bad) {
    const GetRegularWorkspace::Response response = answer(request);
    EXPECT_EQ(response.status.code, Status::INVALID_REQUEST) << request;
    EXPECT_FALSE(response.status.message.empty());
  }
  EXPECT_EQ(call<GetRegularWorkspace>("/slow/aspect_node/get_regular_workspace", largest("disc")).status.code,
            Status::MAP_NOT_READY);
  EXPECT_EQ(
      call<GetRegularWorkspace>("/stewart/aspect_node/get_regular_workspace", largest("ball")).status.code,
      Status::NO_MAP);
}

}  // namespace
}  // namespace parallel_aspects
