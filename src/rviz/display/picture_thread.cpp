// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/picture_thread.h"

#include "parallel_aspects/model/problems.h"
#include "ros/messages/map_messages.h"
#include "ros/pictures/robot_visuals.h"
#include "ros/pictures/scene.h"

#include <parallel_aspects/Status.h>

#include <ros/time.h>

#include <cstdio>
#include <exception>
#include <functional>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double volume_resolution = 0.04;  // of the robot's size: of maps that follow it

ReceivedRobot robot_of(const GetMap::Response& response) {
  const SharedMechanism mechanism = mechanism_of(response);
  const RobotVisuals visuals(mechanism, response.urdf, 1.0);
  NodeOptions options;
  options.display.radius = ball_radius * mechanism->manipulator()->size();
  return {mechanism, response.base_frame, scene_of(*mechanism, options, visuals.still()), !visuals.empty()};
}

double seconds_since(const ros::SteadyTime& start) { return (ros::SteadyTime::now() - start).toSec(); }

}  // namespace

int ReceivedMap::locate(Pose pose, const WorkingMode& mode) const {
  if (bytes == 0 && map->slice()) pose.orientation = map->slice()->held.orientation;
  return map->locate(pose, mode).aspect;
}

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

void PictureThread::map_volume(const Eigen::Quaterniond& orientation, const WorkingMode& mode) {
  const std::lock_guard<std::mutex> lock(mutex_);
  next_volume_ = Volume{orientation, mode};
  changed_.notify_all();
}

bool PictureThread::is_mapping() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return mapping_ || next_volume_;
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
    std::optional<Volume> volume;
    bool fetches = false;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock,
                    [&] { return stopping_ || fetch_wanted_ || next_volume_ || (next_ && result_.map); });
      if (stopping_) return;
      fetches = std::exchange(fetch_wanted_, false);
      if (!fetches && next_ && result_.map) request = std::exchange(next_, std::nullopt);
      if (!fetches && !request) volume = std::exchange(next_volume_, std::nullopt);
      drawing_ = request.has_value();
      mapping_ = volume.has_value();
    }
    try {
      if (fetches) carry_out_fetch();
      if (request) carry_out_draw(*request);
      if (volume) carry_out_volume(*volume);
    } catch (const InvalidDescription& invalid) {
      fail(invalid.problems().empty() ? "The robot could not be loaded." : invalid.problems().front());
    } catch (const std::exception& failure) {  // as when there is not enough memory
      fail(failure.what());
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    drawing_ = mapping_ = false;
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
  take_robot(call.response);
  if (call.response.status.code == Status::NO_MAP && call.response.task_space == "SE3") return;
  if (call.response.status.code != Status::OK) return fail(call.response.status.message);
  if (!call.request.known_revision.empty() && call.response.revision == call.request.known_revision) {
    const std::lock_guard<std::mutex> lock(mutex_);
    result_.problem.clear();
    return;
  }
  take(call.response, seconds_since(start));
}

// Another robot than before takes what was drawn of it with it.
void PictureThread::take_robot(const GetMap::Response& response) {
  const std::size_t texts = std::hash<std::string>()(response.urdf + '\n' + response.description);
  if (robot_ && texts == texts_) return;
  robot_.reset();
  forget_robot(response.task_space == "SE3");
  robot_ = std::make_shared<const ReceivedRobot>(robot_of(response));
  const std::lock_guard<std::mutex> lock(mutex_);
  if (texts_ != 0) ++result_.robots;
  texts_ = texts;
  result_.robot = robot_;
}

void PictureThread::forget_robot(bool next_has_volumes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.robot.reset();
  result_.map.reset();
  result_.picture.reset();
  result_.problem.clear();
  result_.has_volumes = next_has_volumes;
  next_volume_.reset();
}

void PictureThread::take(const GetMap::Response& response, double seconds) {
  const MapResult read = map_of(response, *robot_->mechanism);
  if (!read.map) return fail(read.message);
  auto received = std::make_shared<ReceivedMap>();
  *received = {read.map, response.revision, response.map.size()};
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.map = std::move(received);
  result_.problem.clear();
  result_.picture.reset();
  result_.fetch_seconds = seconds;
}

void PictureThread::carry_out_volume(const Volume& volume) {
  if (!robot_) return;
  const ros::SteadyTime start = ros::SteadyTime::now();
  const auto robot = robot_->mechanism->mapped_manipulator();
  MapOptions options;
  options.slice.emplace();
  options.slice->moves = {true, true, true};
  options.slice->held.orientation = volume.orientation.normalized();
  options.modes = {volume.mode};
  options.resolution = volume_resolution * robot->size();
  options.extra_levels = 2;
  options.threads = 1;  // it is not the display that the computer is for
  const MapResult computed = compute_aspect_map(robot, options, {{}, &cancelled_});
  if (computed.status == MapStatus::cancelled) return;
  if (!computed.map) return fail(computed.message);
  auto received = std::make_shared<ReceivedMap>();
  *received = {computed.map, "", 0};
  const std::lock_guard<std::mutex> lock(mutex_);
  result_.map = std::move(received);
  result_.problem.clear();
  result_.fetch_seconds = seconds_since(start);
}

void PictureThread::carry_out_draw(const Request& request) {
  const ros::SteadyTime start = ros::SteadyTime::now();
  const auto map = result().map;
  if (!map) return;
  if (!store_ || &store_->map() != map->map.get()) store_ = std::make_unique<SurfaceStore>(map->map);
  auto picture = std::make_shared<const SurfacePicture>(
      draw_surfaces(*store_, request.choice, request.present, cancelled_));
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

std::string words_of(const PictureThread::Result& result, const std::string& said) {
  if (!result.problem.empty()) return result.problem;
  if (result.has_volumes && !result.map)
    return "Maps the positions at the present orientation, once the robot is tracked.";
  if (!result.map) return said.empty() ? "Waits for the node." : said;
  char words[240];
  std::snprintf(words, sizeof words, "%zu aspects, %.1f MB in %.2f s; %zu triangles drawn in %.2f s",
                result.map->map->aspects().size(), static_cast<double>(result.map->bytes) / 1e6,
                result.fetch_seconds, result.picture ? result.picture->triangles : 0, result.draw_seconds);
  if (!result.has_volumes) return words;
  return "Positions at one orientation, mapped here, of which parts may be joined by turning: " +
         std::string(words);
}

std::string words_of_unknown(const std::set<int>& candidates, bool mode_was_known) {
  if (candidates.empty())
    return mode_was_known ? "Drawn is the working mode that was known last."
                          : "No aspect is drawn; set Shown to All to see them.";
  std::string words = "Drawn is where it may be: aspect ";
  for (const int id : candidates) words += (id == *candidates.begin() ? "" : ", ") + std::to_string(id);
  return words + ". Choose one in the panel.";
}

}  // namespace parallel_aspects
