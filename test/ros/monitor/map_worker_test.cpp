// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/map_worker.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::chrono::milliseconds deadline{60000};

MapOptions resolution(double value) {
  MapOptions options;
  options.resolution = value;
  return options;
}

class MapWorkerTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { ros::Time::init(); }

  std::mutex mutex_;
  std::vector<MapProgress> reports_;
  MapWorker worker_{test::five_bar(), "", [this](const MapProgress& report, const auto&) {
                      const std::lock_guard<std::mutex> lock(mutex_);
                      reports_.push_back(report);
                    }};
};

TEST_F(MapWorkerTest, KeepsTheMapThatItComputes) {
  EXPECT_FALSE(worker_.map());
  const MapProgress end = worker_.wait(worker_.compute(resolution(0.2)), deadline);
  ASSERT_EQ(end.state, MapProgress::COMPLETE) << end.message;
  ASSERT_TRUE(worker_.map());
  EXPECT_EQ(end.aspects, worker_.map()->aspects().size());
  EXPECT_EQ(end.proved_count, 10U);
  EXPECT_EQ(end.count_at_most, 10);
  EXPECT_EQ(end.progress, 1.0);
  const std::lock_guard<std::mutex> lock(mutex_);
  ASSERT_FALSE(reports_.empty());
  EXPECT_EQ(reports_.front().state, MapProgress::COMPUTING);
  EXPECT_EQ(reports_.front().count_at_most, -1);
  EXPECT_EQ(reports_.back().state, MapProgress::COMPLETE);
  for (std::size_t i = 1; i < reports_.size(); ++i) EXPECT_GE(reports_[i].progress, reports_[i - 1].progress);
  for (const MapProgress& report : reports_) {
    EXPECT_EQ(report.header.frame_id, test::five_bar()->base_frame());
    EXPECT_FALSE(report.header.stamp.isZero());
  }
}

TEST_F(MapWorkerTest, MakesTheMapReadyForDistances) {
  worker_.wait(worker_.compute(resolution(0.2)), deadline);
  const auto end = std::chrono::steady_clock::now() + deadline;
  while (!worker_.known().distances && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  const KnownAspects known = worker_.known();
  ASSERT_TRUE(known.distances);
  EXPECT_EQ(known.distances->map(), known.map);
  EXPECT_EQ(known.distances_of(known.map->manipulator()), known.distances);
  EXPECT_EQ(known.distances_of(std::make_shared<const Manipulator>(*known.map->manipulator())), nullptr);
}

TEST_F(MapWorkerTest, CancelsAndKeepsThePreviousMap) {
  worker_.wait(worker_.compute(resolution(0.2)), deadline);
  const auto before = worker_.map();
  const MapWorker::Job job = worker_.compute(resolution(1e-4));
  EXPECT_EQ(worker_.wait(job, std::chrono::milliseconds(1)).state, MapProgress::COMPUTING);
  worker_.cancel(job);
  const MapProgress end = worker_.wait(job, deadline);
  EXPECT_EQ(end.state, MapProgress::CANCELLED);
  EXPECT_EQ(end.proved_count, 10U) << "of the map that stays in use";
  EXPECT_EQ(worker_.map(), before);
}

TEST_F(MapWorkerTest, ANewJobTakesThePlaceOfARunningOne) {
  const MapWorker::Job first = worker_.compute(resolution(1e-4));
  const MapWorker::Job second = worker_.compute(resolution(0.2));
  const MapProgress displaced = worker_.wait(first, deadline);
  EXPECT_EQ(displaced.state, MapProgress::CANCELLED);
  EXPECT_EQ(displaced.header.frame_id, test::five_bar()->base_frame());
  EXPECT_EQ(worker_.wait(second, deadline).state, MapProgress::COMPLETE);
}

// With three degrees of freedom small aspects are searched for where that is asked for.
TEST(MapWorkerOfThreeFreedoms, ReportsTheExactNumberOfAspects) {
  ros::Time::init();
  MapWorker worker(test::shipped("linear_delta")->mapped_manipulator(), "", [](const auto&, const auto&) {});
  MapOptions options;
  EXPECT_EQ(worker.wait(worker.compute(options), deadline).count_at_most, -1);
  options.complete = true;
  const MapProgress end = worker.wait(worker.compute(options), deadline);
  ASSERT_EQ(end.state, MapProgress::COMPLETE) << end.message;
  EXPECT_EQ(end.count_at_most, 14);
  EXPECT_NE(end.message.find("exactly 14"), std::string::npos) << end.message;
}

TEST_F(MapWorkerTest, SaysWhyItRefuses) {
  const MapProgress end = worker_.wait(worker_.compute(resolution(-1.0)), deadline);
  EXPECT_EQ(end.state, MapProgress::REFUSED);
  EXPECT_FALSE(end.message.empty());
}

TEST_F(MapWorkerTest, SaysWhyNoAspectIsThere) {
  MapOptions options;
  options.region = Box{2, {50.0, 0.0}, {60.0, 3.0}};
  const MapProgress end = worker_.wait(worker_.compute(options), deadline);
  EXPECT_EQ(end.state, MapProgress::COMPLETE);
  EXPECT_NE(end.message.find("The region lies outside of what the legs can reach"), std::string::npos)
      << end.message;
}

// A map this fine takes minutes: it is given up, and said to be.
TEST(MapWorkerThatEnds, GivesUpWhatItComputes) {
  ros::Time::init();
  std::promise<void> started;
  std::vector<int> states;
  {
    MapWorker worker(test::five_bar(), "", [&](const MapProgress& progress, const auto&) {
      if (states.empty()) started.set_value();
      states.push_back(progress.state);
    });
    worker.compute(resolution(1e-4));
    ASSERT_EQ(started.get_future().wait_for(deadline), std::future_status::ready);
  }
  EXPECT_EQ(states.front(), MapProgress::COMPUTING);
  EXPECT_EQ(states.back(), MapProgress::CANCELLED);
}

// With six degrees of freedom a roadmap is made, in all its modes, and told of; there is no map.
TEST(MapWorkerOfSixFreedoms, ReportsARoadmap) {
  ros::Time::init();
  auto legs = test::stewart()->legs();
  for (Leg& leg : legs) leg.limits = JointLimits{0.4, 0.8};
  MapWorker worker(test::manipulator("stewart", TaskSpace::SE3, legs), "",
                   [](const MapProgress&, const auto& map) { EXPECT_FALSE(map); });
  const MapProgress end = worker.wait(worker.compute({}), deadline);
  ASSERT_EQ(end.state, MapProgress::COMPLETE) << end.message;
  EXPECT_EQ(end.proved_count, 2U);
  EXPECT_EQ(end.count_at_most, -1);
  EXPECT_EQ(end.progress, 1.0);
  EXPECT_NE(end.message.find("roadmap"), std::string::npos);
  EXPECT_FALSE(worker.map());
  ASSERT_TRUE(worker.known().roadmap);
  EXPECT_EQ(worker.known().proved_count(), end.proved_count);
}

// Struts without limits reach everywhere.
TEST(MapWorkerOfSixFreedoms, SaysWhyItRefuses) {
  ros::Time::init();
  MapWorker worker(test::stewart(), "", [](const MapProgress&, const auto&) {});
  const MapProgress end = worker.wait(worker.compute({}), deadline);
  EXPECT_EQ(end.state, MapProgress::REFUSED);
  EXPECT_FALSE(end.message.empty());
}

}  // namespace
}  // namespace parallel_aspects
