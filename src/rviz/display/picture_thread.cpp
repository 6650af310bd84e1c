// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/picture_thread.h"

#include "parallel_aspects/model/problems.h"
#include "ros/messages/map_messages.h"

#include <parallel_aspects/Status.h>

#include <ros/time.h>

#include <exception>
#include <utility>

namespace parallel_aspects {
namespace {

double seconds_since(const ros::SteadyTime& start) { return (ros::SteadyTime::now() - start).toSec(); }

}  // namespace

PictureThread::PictureThread(const ros::NodeHandle& nh, const std::string& node)
    : nh_(nh), service_(node + "/get_map"), thread_([this] { run(); }) {}

// A call that waits for its answer ends with its connection.
PictureThread::~PictureThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    cancelled_ = true;
    client_.shutdown();
  }
  changed_.notify_all();
  thread_.join();
}

void PictureThread::fetch() {
  const std::lock_guard<std::mutex> lock(mutex_);
  fetch_wanted_ = true;
  changed_.notify_all();
}

void PictureThread::draw(const PictureChoice& choice, const std::optional<Pose>& present) {
  const std::lock_guard<std::mutex> lock(mutex_);
  next_ = Request{choice, present};
  changed_.notify_all();
}

bool PictureThread::is_drawing() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return drawing_ || next_;
}

PictureThread::Result PictureThread::result() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return result_;
}

void PictureThread::run() {
  while (true) {
    std::optional<Request> request;
    bool fetches = false;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [&] { return stopping_ || fetch_wanted_ || (next_ && result_.map); });
      if (stopping_) return;
      fetches = std::exchange(fetch_wanted_, false);
      if (!fetches) request = std::exchange(next_, std::nullopt);
      drawing_ = request.has_value();
    }
    try {
      if (fetches) carry_out_fetch();
      if (request) carry_out_draw(*request);
    } catch (const InvalidDescription& invalid) {
      fail(invalid.problems().empty() ? "The robot could not be loaded." : invalid.problems().front());
    } catch (const std::exception& failure) {  // as when there is not enough memory
      fail(failure.what());
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    drawing_ = false;
  }
}

void PictureThread::carry_out_fetch() {
  const ros::SteadyTime start = ros::SteadyTime::now();
  GetMap call;
  ros::ServiceClient client = nh_.serviceClient<GetMap>(service_, true);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stopping_) return client.shutdown();
    client_ = client;
    if (result_.map) call.request.known_revision = result_.map->revision;
  }
  const bool answered = client.call(call);
  client.shutdown();
  if (!answered) return fail("The node does not answer " + service_ + ".");
  if (call.response.status.code != Status::OK) return fail(call.response.status.message);
  if (!call.request.known_revision.empty() && call.response.revision == call.request.known_revision) {
    const std::lock_guard<std::mutex> lock(mutex_);
    result_.problem.clear();
    return;
  }
  take(call.response, seconds_since(start));
}

void PictureThread::take(const GetMap::Response& response, double seconds) {
  const SharedMechanism mechanism = mechanism_of(response);
  const MapResult read = map_of(response, *mechanism);
  if (!read.map) return fail(read.message);
  auto received = std::make_shared<ReceivedMap>();
  *received = {read.map, response.base_frame, response.revision, response.map.size()};
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.map = std::move(received);
  result_.problem.clear();
  result_.picture.reset();
  result_.fetch_seconds = seconds;
}

void PictureThread::carry_out_draw(const Request& request) {
  const ros::SteadyTime start = ros::SteadyTime::now();
  const auto map = result().map;
  if (!map) return;
  auto picture = std::make_shared<const SurfacePicture>(
      draw_surfaces(*map->map, request.choice, request.present, cancelled_));
  const std::lock_guard<std::mutex> lock(mutex_);
  if (result_.map != map) return;
  result_.picture = std::move(picture);
  ++result_.pictures;
  result_.draw_seconds = seconds_since(start);
}

void PictureThread::fail(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.map.reset();
  result_.picture.reset();
  result_.problem = problem;
}

}  // namespace parallel_aspects
