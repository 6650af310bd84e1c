// SPDX-License-Identifier: BSD-3-Clause
//
// ~get_map of a node of the five-bar, against the map that the library computes; of one whose map takes long,
// and of a hexapod, which has none.
#include "ros/messages/conversions.h"
#include "ros/messages/map_messages.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/node/node_client.h"

#include <parallel_aspects/ComputeMapAction.h>
#include <parallel_aspects/MapProgress.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <actionlib/client/simple_action_client.h>
#include <random>
#include <string>

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
  response.map[response.map.size() / 2] ^= 1U;
  const MapResult received = map_of(response, *mechanism);
  EXPECT_FALSE(received.map);
  EXPECT_NE(received.message.find("damaged"), std::string::npos) << received.message;
  response.map.resize(3);
  EXPECT_FALSE(map_of(response, *mechanism).map);
}

}  // namespace
}  // namespace parallel_aspects
