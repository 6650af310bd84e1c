// SPDX-License-Identifier: BSD-3-Clause
#include "ros/probe/probe_picture.h"

#include "parallel_aspects/motion/motion_guard.h"
#include "ros/messages/conversions.h"
#include "ros/pictures/marker_batch.h"
#include "ros/pictures/scene.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using visualization_msgs::Marker;

// Shares of the robot's size.
constexpr double line_width = 0.004, dot_size = 0.02, arrow_length = 0.1;
constexpr double above = 0.06;  // of a planar robot, so that its links hide nothing

std_msgs::ColorRGBA faded(std_msgs::ColorRGBA color, float opacity) {
  color.a = opacity;
  return color;
}

// The aspect's; grey where none is known.
std_msgs::ColorRGBA robot_color(const ProbeFinding& finding) {
  return color(finding.color.value_or(0x707070));
}

Marker with_id(Marker marker, int id) {
  marker.id = id;
  return marker;
}

}  // namespace

ProbePicture::ProbePicture(std::shared_ptr<const Mechanism> mechanism, const std::string& urdf,
                           const NodeOptions& options)
    : mechanism_(std::move(mechanism)),
      robot_(*mechanism_->manipulator()),
      visuals_(mechanism_, urdf, options.display.radius),
      scene_(scene_of(*mechanism_, options, visuals_.still())) {}

visualization_msgs::MarkerArray ProbePicture::of(const ProbeFinding& finding, Markers extra) {
  Markers markers = std::move(extra);
  if (finding.reached) {
    draw_robots(finding, markers);
    draw_singularity(finding, markers);
  }
  draw_wanted(finding, markers);
  draw_words(finding, markers);
  return replaced_by(std::move(markers));
}

visualization_msgs::MarkerArray ProbePicture::none() { return replaced_by({}); }

visualization_msgs::MarkerArray ProbePicture::replaced_by(Markers markers) {
  std::set<Key> now;
  for (const Marker& marker : markers) now.insert({marker.ns, marker.id});
  for (const Key& key : shown_) {
    if (now.count(key) != 0) continue;
    Marker gone;
    gone.header.frame_id = robot_.base_frame();
    gone.ns = key.first;
    gone.id = key.second;
    gone.action = Marker::DELETE;
    markers.push_back(std::move(gone));
  }
  shown_ = std::move(now);
  visualization_msgs::MarkerArray array;
  array.markers = std::move(markers);
  return array;
}

void ProbePicture::draw_robots(const ProbeFinding& finding, Markers& markers) const {
  const Pose& pose = finding.reached->pose;
  const auto draw = [&](const JointVector& q, const std::string& group, const std_msgs::ColorRGBA& shade) {
    for (Marker& each : visuals_.at(pose, q, group, shade)) markers.push_back(std::move(each));
  };
  draw(finding.reached->q, "probe/robot", faded(robot_color(finding), 0.55F));
  for (std::size_t i = 0; i < finding.others.size(); ++i)
    draw(finding.others[i], "probe/other_" + std::to_string(i + 1), faded(color(0x707070), 0.15F));
}

// Of the parallel and the serial singularity the nearer one: a line from each point to where it is there.
void ProbePicture::draw_singularity(const ProbeFinding& finding, Markers& markers) const {
  const BoundaryDistances& distances = finding.distances;
  const bool parallel = distances.parallel.upper <= distances.serial.upper;
  const BoundaryDistance& nearest = parallel ? distances.parallel : distances.serial;
  if (!std::isfinite(nearest.upper)) return;
  const Pose& pose = finding.reached->pose;
  const auto shade = color(boundary_color(parallel ? BoundaryKind::parallel : BoundaryKind::serial));
  Marker lines = marker("probe/to_singularity", Marker::LINE_LIST, shade);
  Marker dots = marker("probe/singularity", Marker::SPHERE_LIST, shade);
  lines.scale.x = 1.5 * line_width * robot_.size();
  dots.scale.x = dots.scale.y = dots.scale.z = dot_size * robot_.size();
  for (const Vector3d& point : seen_points()) {
    lines.points.push_back(drawn(pose.transform(point)));
    lines.points.push_back(drawn(nearest.witness.transform(point)));
    dots.points.push_back(lines.points.back());
  }
  markers.push_back(std::move(lines));
  markers.push_back(std::move(dots));
  draw_escape(pose, nearest, finding.reached->q, markers);
}

void ProbePicture::draw_escape(const Pose& pose, const BoundaryDistance& distance, const JointVector& q,
                               Markers& markers) const {
  const auto escape = escape_direction(robot_, pose, q, distance);
  if (!escape) return;
  const TaskVector step = arrow_length * robot_.size() * escape->twist;
  if (!step.allFinite()) return;
  const auto moves = static_cast<Eigen::Index>(directions(robot_.task_space()));
  const Eigen::Index turns = step.size() - moves;
  Vector3d velocity = Vector3d::Zero(), turn = Vector3d::Zero();
  velocity.head(moves) = step.tail(moves);
  if (turns == 1) turn.z() = step[0];
  if (turns == 3) turn = step.head<3>();
  int id = 0;
  for (const Vector3d& point : seen_points()) {
    const Vector3d from = pose.transform(point);
    const Vector3d along = velocity + turn.cross(pose.orientation * point);
    if (along.norm() < 1e-3 * arrow_length * robot_.size()) continue;
    Marker arrow = with_id(marker("probe/escape", Marker::ARROW, color(0x228833)), id++);
    arrow.points = {drawn(from), drawn(from + along)};
    arrow.scale.x = 2.0 * line_width * robot_.size();
    arrow.scale.y = arrow.scale.z = 5.0 * line_width * robot_.size();
    markers.push_back(std::move(arrow));
  }
}

// From where it is wanted to where it is.
void ProbePicture::draw_wanted(const ProbeFinding& finding, Markers& markers) const {
  if (finding.reached && finding.reached->distance == 0.0) return;
  const auto shade = color(0xE07B00);
  Marker dot = marker("probe/wanted", Marker::SPHERE_LIST, shade);
  dot.scale.x = dot.scale.y = dot.scale.z = dot_size * robot_.size();
  Marker lines = marker("probe/to_wanted", Marker::LINE_LIST, shade);
  lines.scale.x = line_width * robot_.size();
  for (const Vector3d& point : seen_points()) {
    dot.points.push_back(drawn(finding.question.wanted.transform(point)));
    if (!finding.reached) continue;
    lines.points.push_back(dot.points.back());
    lines.points.push_back(drawn(finding.reached->pose.transform(point)));
  }
  markers.push_back(std::move(dot));
  if (!lines.points.empty()) markers.push_back(std::move(lines));
}

// On the other side of the robot than its own caption; of planar robots as large as all lines have room.
void ProbePicture::draw_words(const ProbeFinding& finding, Markers& markers) const {
  Caption caption = caption_of(scene_, words_of(robot_, finding));
  const double room = 2.0 * Caption::line_pitch * caption.text_height;
  Vector3d at = scene_.robot.center();
  if (scene_.planar) {
    const double height = words_room / (1.0 + words_room) * scene_.robot.sizes().y();
    const auto lines = 1 + std::count(caption.words.begin(), caption.words.end(), '\n');
    caption.text_height =
        std::min(caption.text_height, height / (Caption::line_pitch * static_cast<double>(lines)));
    at = {at.x(), scene_.robot.max().y() - 0.5 * height, above * robot_.size()};
  } else {
    at = {at.x(), scene_.robot.min().y(), scene_.robot.min().z() - room};  // before it, as it is seen
  }
  Marker text = marker("probe/words", Marker::TEXT_VIEW_FACING, color(ink_color));
  text.pose = pose_message(drawing_frame(robot_) * Eigen::Translation3d(at));
  text.scale.z = caption.text_height;
  text.text = caption.words;
  markers.push_back(std::move(text));
}

Marker ProbePicture::marker(const std::string& group, int type, const std_msgs::ColorRGBA& color) const {
  Marker result;
  result.header.frame_id = robot_.base_frame();
  result.ns = group;
  result.type = type;
  result.pose = pose_message(robot_.task_frame());
  result.color = color;
  return result;
}

geometry_msgs::Point ProbePicture::drawn(const Vector3d& point) const {
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  message.z = point.z() + (is_planar(robot_.task_space()) ? above * robot_.size() : 0.0);
  return message;
}

// Where the platform does not turn all of its points move alike; else the anchors, which distances are of.
std::vector<Vector3d> ProbePicture::seen_points() const {
  if (!has_rotation(robot_.task_space())) return {Vector3d::Zero()};
  std::vector<Vector3d> points;
  for (const Leg& leg : robot_.legs()) points.push_back(leg.anchor);
  return points;
}

}  // namespace parallel_aspects
