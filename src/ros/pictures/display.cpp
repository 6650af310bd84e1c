// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/display.h"

#include "draw/scene/placed_labels.h"
#include "ros/pictures/domain_picture.h"
#include "ros/pictures/gauge_picture.h"
#include "ros/pictures/map_picture.h"
#include "ros/pictures/scene.h"

#include <ros/console.h>

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

// Slices move with the robot; this leaves time for other things.
const ros::WallDuration between_galleries(0.5), between_present(0.2);

constexpr double ball = 1.5;  // below a name, over its height

Drawn drawn(const CurrentConfiguration& current) {
  if (current.status.code != Status::OK) return std::nullopt;
  return DrawnConfiguration{current.tracked.mode, current.tracked.aspect, current.solved};
}

MarkerFrames frames_of(const NodeSetup& setup) {
  return {setup.mechanism->manipulator()->base_frame(), setup.options.frame_prefix + "/aspects",
          setup.options.frame_prefix + "/joint_space"};
}

ros::Publisher latched(ros::NodeHandle& nh, const std::string& topic) {
  return nh.advertise<visualization_msgs::MarkerArray>(topic, 1, true);
}

// A cusp is one whichever actuated joint is held: at the same pose three solutions meet. So one joint does.
// With several working modes it takes minutes.
CuspCurves cusps_to_draw(const Manipulator& robot, const MapControl& control) {
  if (working_modes(robot).size() > 1) return {};
  const JointLimits& limits = robot.leg(0).limits;
  return find_cusp_curves(robot, {0, limits.lower, limits.upper}, control);
}

}  // namespace

Display::Display(const NodeSetup& setup, ros::NodeHandle private_nh)
    : manipulator_(setup.mechanism->manipulator()),
      frames_(frames_of(setup)),
      visuals_(setup.mechanism, setup.urdf, setup.options.display.radius),
      scene_(scene_of(*setup.mechanism, setup.options, visuals_.still())),
      markers_(latched(private_nh, "markers")),
      present_markers_(latched(private_nh, "present_markers")),
      position_markers_(latched(private_nh, "position_markers")),
      uniqueness_markers_(latched(private_nh, "uniqueness_markers")),
      options_(setup.options.display) {
  set_domains(nullptr);
  set_picture(make_gauge_picture(manipulator_, frames_, scene_));
}

void Display::set_options(const DisplayOptions& options) {
  std::shared_ptr<const AspectMap> map;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    options_ = options;
    map = map_;
  }
  if (map) set_map(map);
}

void Display::set_map(const std::shared_ptr<const AspectMap>& map) {
  DisplayOptions options;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    options = options_;
    map_ = map;
  }
  if (map->aspects().empty() || degrees_of_freedom(map->manipulator()->task_space()) < 2)
    return;  // the gauges stay
  if (map->manipulator()->task_space() == TaskSpace::T2)
    set_picture(make_map_picture(map, frames_, options));
  else
    set_picture(make_slice_picture(map, frames_, scene_, options));
  const std::lock_guard<std::mutex> lock(mutex_);
  mapped_ = true;
}

void Display::set_domains(const std::shared_ptr<const Uniqueness>& uniqueness, const MapControl& control) {
  if (!uniqueness) return uniqueness_markers_.publish(MarkerBatch().take());
  const Manipulator& robot = *uniqueness->map->manipulator();
  const CuspCurves cusps = cusps_to_draw(robot, control);
  const auto markers = domain_markers(*uniqueness, cusps, scene_, control);
  if (is_cancelled(control)) return;
  uniqueness_markers_.publish(markers);
  ROS_INFO_STREAM("Uniqueness domains: drawn on "
                  << uniqueness_markers_.getTopic()
                  << (working_modes(robot).size() > 1
                          ? ", without cusps."
                          : " with " + std::to_string(cusps.curves.size()) + " curves of cusps."));
}

void Display::set_picture(const std::shared_ptr<const Picture>& picture) {
  static_tf_.sendTransform(picture->frames());
  const std::lock_guard<std::mutex> lock(mutex_);
  picture_ = picture;
  fresh_ = true;
}

void Display::show(const CurrentConfiguration& current, const std::string& map_message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Drawn now = drawn(current);
  const ros::WallTime time = ros::WallTime::now();
  const bool gallery_rested = time - gallery_time_ > between_galleries;
  const bool present_rested = time - present_time_ > between_present;
  if (fresh_ || (gallery_rested && picture_->gallery_differs(drawn_gallery_, now))) publish_gallery(now);
  if (fresh_ || (present_rested && picture_->present_differs(drawn_present_, now))) publish_present(now);
  const std::string words = caption(current, map_message);
  if (fresh_ || now || words != caption_) publish_position(now, words);
  fresh_ = false;
}

void Display::set_candidates(const AssemblyCandidates& candidates) {
  const std::lock_guard<std::mutex> lock(mutex_);
  candidates_.clear();
  for (const SolvedConfiguration& each : candidates.candidates)
    if (const auto pose = pose_from_base(*manipulator_, each.pose))
      candidates_.emplace_back(
          *pose, Eigen::Map<const Eigen::VectorXd>(each.joint_positions.data(),
                                                   static_cast<Eigen::Index>(each.joint_positions.size())));
  caption_.clear();  // so that they are drawn
}

std::optional<PoseSlice> Display::section() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return picture_->section(drawn_present_ ? drawn_present_ : drawn_gallery_);
}

std::vector<visualization_msgs::Marker> Display::dots_of(const DrawnConfiguration& other) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!mapped_) return {};
  return added_by(picture_->position(other));
}

void Display::publish_gallery(const Drawn& now) {
  markers_.publish(picture_->gallery(now));
  drawn_gallery_ = now;
  gallery_time_ = ros::WallTime::now();
}

void Display::publish_present(const Drawn& now) {
  present_markers_.publish(picture_->present(now));
  drawn_present_ = now;
  present_time_ = ros::WallTime::now();
}

void Display::publish_position(const Drawn& now, const std::string& words) {
  visualization_msgs::MarkerArray array = picture_->position(now);
  const Caption caption = caption_of(scene_, words);
  MarkerBatch batch;
  batch.text({frames_.base, drawing_frame(*manipulator_) * Eigen::Translation3d(caption.at)}, "caption",
             Eigen::Vector2d::Zero(), 0.0, caption.text_height, caption.words, color(ink_color));
  array.markers.push_back(batch.take().markers.back());
  draw_robots(now, array.markers);
  position_markers_.publish(array);
  caption_ = words;
}

// The robot itself where rviz has no visuals of it; while it is not known which one it is, all that it may
// be.
void Display::draw_robots(const Drawn& now, std::vector<visualization_msgs::Marker>& markers) const {
  if (!now) return draw_candidates(markers);
  if (!visuals_.empty()) return;
  for (auto& each : visuals_.skeleton_at(now->solved.pose, now->solved.q, "robot", color(ink_color)))
    markers.push_back(std::move(each));
}

// Each in a colour of its own, with the name that the panel has for it.
void Display::draw_candidates(std::vector<visualization_msgs::Marker>& markers) const {
  std::vector<Pose> poses;
  for (const auto& [pose, q] : candidates_) poses.push_back(pose);
  const std::vector<Eigen::Vector3d> places = candidate_places(*manipulator_, poses, scene_.radius);
  MarkerBatch names;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const auto& [pose, q] = candidates_[i];
    for (auto& each :
         visuals_.skeleton_at(pose, q, "candidate_" + std::to_string(i + 1), color(candidate_color(i))))
      markers.push_back(std::move(each));
    draw_name(i, places[i], names);
  }
  for (auto& each : added_by(names.take())) markers.push_back(std::move(each));
}

// On a ball of the candidate's colour, before what it stands upon: letters alone are lost among lines.
void Display::draw_name(std::size_t candidate, const Eigen::Vector3d& at, MarkerBatch& batch) const {
  const double size = drawn_size(*manipulator_, scene_.radius), height = candidate_name_height * size;
  const Eigen::Vector3d to_viewer = scene_.planar
                                        ? Eigen::Vector3d(0.0, 0.0, 1.0)
                                        : Eigen::Vector3d(0.0, -std::cos(view_pitch), std::sin(view_pitch));
  const Eigen::Vector3d place = at + (scene_.planar ? 0.1 * size : 0.0) * to_viewer;
  const auto plane = [&](const Eigen::Vector3d& point) {
    return MarkerBatch::Plane{frames_.base, drawing_frame(*manipulator_) * Eigen::Translation3d(point)};
  };
  const Rgb shade = candidate_color(candidate);
  batch.dots(plane(place), "candidate_names", {Eigen::Vector2d::Zero()}, 0.0, ball * height, color(shade));
  batch.text(plane(place + 0.51 * ball * height * to_viewer), "candidate_names", Eigen::Vector2d::Zero(), 0.0,
             height, candidate_name(candidate), color(readable_on(shade)));
}

std::string Display::caption(const CurrentConfiguration& current, const std::string& map_message) const {
  std::string words = manipulator_->name() + ": ";
  if (current.status.code == Status::OK) {
    const TrackedState& state = current.tracked;
    if (state.aspect != 0) words += "aspect " + std::to_string(state.aspect) + ", ";
    words += "working mode " + branch_text(state.mode, state.determinant_sign);
  } else {
    words += current.status.message;
  }
  return mapped_ || map_message.empty() ? words : words + "\n" + map_message;
}

}  // namespace parallel_aspects
