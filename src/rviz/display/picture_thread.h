// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_PICTURE_THREAD_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_PICTURE_THREAD_H

#include "draw/scene/surface_picture.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "ros/pictures/scene.h"

#include <parallel_aspects/GetMap.h>

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

namespace parallel_aspects {

/// A robot as it was received, which comes before its map.
struct ReceivedRobot {
  SharedMechanism mechanism;
  std::string base_frame;   ///< of tf
  Scene scene{};            ///< what the robot takes and reaches
  bool has_visuals = true;  ///< whether rviz can show it by its URDF

  const Manipulator& manipulator() const { return *mechanism->manipulator(); }
};

/// A map as it was received.
struct ReceivedMap {
  std::shared_ptr<const AspectMap> map;
  std::string revision;
  std::size_t bytes = 0;  ///< of the map; 0 for one that was computed here

  /// Id of the aspect that holds a pose; 0 where none does, or the map cannot decide. In a map that was
  /// computed here, of its position at the orientation of the map.
  int locate(Pose pose, const WorkingMode& mode) const;
};

/// Asks a node for its map and draws it, in a thread of its own: neither holds up who looks.
class PictureThread {
 public:
  struct Result {
    std::shared_ptr<const ReceivedRobot> robot;  ///< null before the first, and where it cannot be loaded
    std::shared_ptr<const ReceivedMap> map;  ///< its latest; null before the first, and where there is none
    std::string problem;                     ///< why there is none; empty otherwise
    bool has_volumes = false;  ///< of six degrees of freedom: maps are of positions at one orientation
    std::uint64_t robots = 0;  ///< counts the robots that were not the one before
    std::shared_ptr<const SurfacePicture> picture;  ///< the latest of this map; null before the first
    std::uint64_t pictures = 0;                     ///< how many were drawn
    double fetch_seconds = 0.0, draw_seconds = 0.0;
  };

  /// `node`: its full name.
  PictureThread(const ros::NodeHandle& nh, const std::string& node);
  ~PictureThread();
  PictureThread(const PictureThread&) = delete;
  PictureThread& operator=(const PictureThread&) = delete;

  /// Asks for the map; it is sent again only where another one is in use.
  void fetch();

  /// Draws this next.
  void draw(const PictureChoice& choice, const std::optional<Pose>& present);

  /// With six degrees of freedom: maps the positions at this orientation next, in this working mode.
  void map_volume(const Eigen::Quaterniond& orientation, const WorkingMode& mode);

  bool is_drawing() const;  ///< or has something to draw
  bool is_mapping() const;  ///< a volume, or has one to map
  Result result() const;

 private:
  struct Request {
    PictureChoice choice;
    std::optional<Pose> present;
  };

  struct Volume {
    Eigen::Quaterniond orientation;
    WorkingMode mode;
  };

  void run();
  void carry_out_volume(const Volume& volume);
  void take_robot(const GetMap::Response& response);
  void forget_robot(bool next_has_volumes);
  void carry_out_fetch();
  void carry_out_draw(const Request& request);
  void take(const GetMap::Response& response, double seconds);
  void fail(const std::string& problem);

  ros::NodeHandle nh_;
  const std::string service_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false, fetch_wanted_ = false, drawing_ = false, mapping_ = false;
  std::optional<Request> next_;
  std::optional<Volume> next_volume_;
  std::atomic<bool> cancelled_{false};
  ros::ServiceClient client_;
  Result result_;
  std::size_t texts_ = 0;                       // that the robot was loaded from, hashed
  std::shared_ptr<const ReceivedRobot> robot_;  // as in the result, for the thread alone
  std::unique_ptr<SurfaceStore> store_;
  std::thread thread_;
};

/// What a display says of its map. `said`: what the node said of it.
std::string words_of(const PictureThread::Result& result, const std::string& said);

/// What it draws of a robot of which the aspect is not known: these, where there are candidates.
std::string words_of_unknown(const std::set<int>& candidates, bool mode_was_known);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_PICTURE_THREAD_H
