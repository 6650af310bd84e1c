// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/scene.h"

#include "model/overloaded.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/pictures/robot_visuals.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double largest_base = 2.0;  // that is examined, over the size of the box
constexpr double links = 0.06;        // how far links stick out from their joints, of the size of the box

// The circle of a crank.
void extend_by_circle(const RevoluteActuation& actuation, AlignedBox3d& box) {
  const Vector3d half =
      actuation.radius * (Vector3d::Ones() - actuation.axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  box.extend(Vector3d(actuation.center + half));
  box.extend(Vector3d(actuation.center - half));
}

// Where the platform may be, too, with the actuated joints where they are at home: all that may be offered to
// choose from.
void extend_by_assembly_modes(const Mechanism& mechanism, AlignedBox3d& box) {
  const Manipulator& robot = *mechanism.manipulator();
  if (robot.task_space() == TaskSpace::SO3) return;  // they are in one sphere
  for (const AssemblyMode& mode : direct(robot, mechanism.home().q).solutions)
    for (const Leg& leg : robot.legs()) box.extend(mode.pose.transform(leg.anchor));
}

// The base as it is drawn, but no hall or table around the robot.
void extend_by_base(const AlignedBox3d& still, AlignedBox3d& box) {
  if (!still.isEmpty() && still.diagonal().norm() < largest_base * box.diagonal().norm()) box.extend(still);
}

AlignedBox3d robot_box(const Manipulator& robot, const Pose& pose) {
  AlignedBox3d box;
  for (const Leg& leg : robot.legs()) {
    box.extend(pose.transform(leg.anchor));
    std::visit(Overloaded{[&box](const RevoluteActuation& crank) { extend_by_circle(crank, box); },
                          [](const PrismaticActuation&) {},  // its origin is anywhere on its line
                          [&box](const StrutActuation& strut) { box.extend(strut.base); },
                          [&box](const ElbowActuation& elbow) { box.extend(elbow.base); }},
               leg.actuation);
    for (const double limit : {leg.limits.lower, leg.limits.upper})
      if (std::isfinite(limit)) box.extend(leg.proximal_point(limit));
  }
  for (const InverseSolution& solution : inverse_in_all_modes(robot, pose)) {
    if (solution.status != InverseStatus::solved) continue;
    for (std::size_t j = 0; j < robot.leg_count(); ++j)
      box.extend(robot.leg(j).proximal_point(solution.q[static_cast<Eigen::Index>(j)]));
  }
  const Vector3d margin = Vector3d::Constant(links * box.diagonal().norm());
  return {box.min() - margin, box.max() + margin};
}

// Encloses every position that all legs with a bounded reach allow, far from tightly.
AlignedBox3d outer_reach_box(const Manipulator& robot) {
  AlignedBox3d reach(Vector3d::Constant(-1e9), Vector3d::Constant(1e9));
  for (const Leg& leg : robot.legs()) {
    const Vector3d radius = Vector3d::Constant(leg.longest_reach() + leg.anchor.norm());
    if (!radius.allFinite()) continue;
    reach = reach.intersection(
        AlignedBox3d(Vector3d(leg.base_point() - radius), Vector3d(leg.base_point() + radius)));
  }
  return reach;
}

// In one of the orientations that are examined.
bool is_reached(const Manipulator& robot, const Vector3d& position, const Eigen::Quaterniond& orientation) {
  constexpr int angles = 16;
  const int turns = robot.task_space() == TaskSpace::SE2 ? angles : 1;
  for (int k = 0; k < turns; ++k) {
    Pose pose;
    pose.position = position;
    pose.orientation = orientation * Eigen::AngleAxisd(2.0 * EIGEN_PI * k / turns, Vector3d::UnitZ());
    for (const InverseSolution& solution : inverse_in_all_modes(robot, pose))
      if (solution.status == InverseStatus::solved) return true;
  }
  return false;
}

// As the viewer sees it.
double height_of(const AlignedBox3d& box, bool planar) {
  const Vector3d size = box.sizes();
  return planar ? size.y() : size.z() * std::cos(view_pitch) + size.y() * std::sin(view_pitch);
}

AlignedBox3d turned(const AlignedBox3d& box, const Eigen::Matrix3d& axes) {
  AlignedBox3d result;
  for (int i = 0; i < 8; ++i)
    result.extend(Vector3d(axes * box.corner(static_cast<AlignedBox3d::CornerType>(i))));
  return result;
}

Eigen::Isometry3d gallery_frame(const Scene& scene, double height) {
  const AlignedBox3d& robot = scene.robot;
  const Vector3d center = robot.center();
  const double left = robot.max().x() + 0.12 * height;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  if (scene.planar) {
    frame.translation() = Vector3d(left, center.y() + 0.5 * height, robot.min().z());
    return frame;
  }
  frame.linear() = Eigen::AngleAxisd(0.5 * EIGEN_PI - view_pitch, Vector3d::UnitX()).toRotationMatrix();
  frame.translation() = Vector3d(left, center.y(), center.z()) + 0.5 * height * frame.linear().col(1);
  return frame;
}

}  // namespace

AlignedBox3d reach_box(const Manipulator& robot, const Pose& start) {
  const std::size_t free = directions(robot.task_space());
  AlignedBox3d outer = outer_reach_box(robot), reach;
  if (free == 0 || outer.isEmpty() || outer.sizes().maxCoeff() > 1e8) return reach;
  const int cells = free < 3 ? 32 : 12;
  for (Eigen::Index i = static_cast<Eigen::Index>(free); i < 3; ++i) outer.min()[i] = outer.max()[i] = 0.0;
  const Vector3d cell = outer.sizes() / cells, half = 0.5 * cell;
  for (int k = 0; k < (free < 3 ? 1 : cells); ++k)
    for (int j = 0; j < (free < 2 ? 1 : cells); ++j)
      for (int i = 0; i < cells; ++i) {
        const Vector3d middle = outer.min() + Vector3d(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(cell);
        if (!reach.contains(middle) && is_reached(robot, middle, start.orientation))
          reach.extend(AlignedBox3d(Vector3d(middle - half), Vector3d(middle + half)));
      }
  return reach;
}

TileLayout::TileLayout(std::size_t tiles, double height)
    : columns_(std::min<std::size_t>(4, tiles)), rows_((tiles + columns_ - 1) / columns_) {
  const double share = tiles == 1 ? 0.75 : rows_ == 1 ? 0.55 : 0.95 / static_cast<double>(rows_);
  side_ = share * height / 1.55;
  pitch_ = Eigen::Vector2d(1.18 * side_, height / static_cast<double>(rows_));
}

Eigen::Vector2d TileLayout::center(std::size_t tile) const {
  const auto column = static_cast<double>(tile % columns_), row = static_cast<double>(tile / columns_);
  // Above a tile is room for a title, below it for a legend.
  return {pitch_.x() * (column + 0.5), -pitch_.y() * (row + 0.5) + 0.1 * side_};
}

Pose start_pose(const Mechanism& mechanism, const StartOptions& start) {
  const Pose assembled = mechanism.assembled().pose;
  if (!start.pose) return assembled;
  const Eigen::Map<const Eigen::VectorXd> values(start.pose->data(),
                                                 static_cast<Eigen::Index>(start.pose->size()));
  return pose_from_coordinates(mechanism.manipulator()->motions(), values).value_or(assembled);
}

double seen_height(const Scene& scene) {
  constexpr double height_over_width = 0.8;  // of the window beside the panel
  AlignedBox3d seen = scene.robot;
  if (!scene.reach.isEmpty())
    seen.extend(scene.reach);
  else if (scene.radius > 0.0)
    seen.extend(Vector3d((1.0 + ball_distance) * scene.radius, 0.0, 0.0));
  return std::max(height_of(seen, scene.planar), height_over_width * seen.sizes().x());
}

Scene scene_of(const NodeSetup& setup) {
  return scene_of(*setup.mechanism, setup.options, RobotVisuals(setup.mechanism, setup.urdf, 1.0).still());
}

Scene scene_of(const Mechanism& mechanism, const NodeOptions& options, const AlignedBox3d& still) {
  const Manipulator& robot = *mechanism.manipulator();
  Scene scene;
  scene.planar = is_planar(robot.task_space());
  const Pose start = start_pose(mechanism, options.start);
  scene.robot = robot_box(robot, start);
  if (robot.task_space() == TaskSpace::SO3) {
    scene.radius = options.display.radius;
    scene.robot = {Vector3d::Constant(-scene.radius), Vector3d::Constant(scene.radius)};
  }
  extend_by_assembly_modes(mechanism, scene.robot);
  scene.robot = turned(scene.robot, drawing_axes(robot));
  extend_by_base(still, scene.robot);
  scene.reach = reach_box(robot, start);
  if (scene.planar) {
    scene.robot.extend(scene.reach);
    scene.robot.max().y() += words_room * scene.robot.sizes().y();
    scene.robot.min().z() = scene.robot.max().z() = -0.05 * robot.size();  // behind the robot
  }
  const double height = std::max(height_of(scene.robot, scene.planar), 0.6 * scene.robot.sizes().x());
  const bool drawn =
      degrees_of_freedom(robot.task_space()) == 2 || degrees_of_freedom(robot.task_space()) == 3;
  scene.tiles = TileLayout(drawn ? working_modes(robot).size() : 1, height);
  scene.gallery = gallery_frame(scene, height);
  return scene;
}

namespace {

// Lines of at most this many letters, broken at blanks.
void add_lines(const std::string& line, std::size_t longest, std::vector<std::string>& lines) {
  std::istringstream stream(line);
  std::string word, current;
  while (stream >> word) {
    if (!current.empty() && current.size() + 1 + word.size() > longest) {
      lines.push_back(current);
      current.clear();
    }
    current += (current.empty() ? "" : " ") + word;
  }
  lines.push_back(current);
}

std::vector<std::string> lines_of(const std::string& words, std::size_t longest) {
  std::vector<std::string> lines;
  std::istringstream stream(words);
  for (std::string line; std::getline(stream, line);) add_lines(line, longest, lines);
  if (lines.size() <= Caption::max_lines) return lines;
  lines.resize(Caption::max_lines);
  std::string& last = lines.back();
  if (last.size() + 4 > longest) last.erase(std::min(last.find_last_of(' ', longest - 4), longest - 4));
  last += " ...";
  return lines;
}

// Of a planar robot, below it; of any other, above it and the gallery, in the plane of the gallery.
struct Room {
  Eigen::Isometry3d frame;
  double left, right, first;  // where the lines begin [m]
  double text;                // height of letters [m]

  double height(std::size_t lines) const { return Caption::line_pitch * text * static_cast<double>(lines); }
};

Room room_of(const Scene& scene) {
  const Eigen::AlignedBox3d& robot = scene.robot;
  const double text = 0.04 * scene.tiles.height();
  if (scene.planar)
    return {Eigen::Isometry3d::Identity(), robot.min().x(), robot.max().x(), robot.min().y() - 0.8 * text,
            text};
  return {scene.gallery, robot.min().x() - scene.gallery.translation().x(), scene.tiles.width(), 2.0 * text,
          text};
}

}  // namespace

Caption caption_of(const Scene& scene, const std::string& words) {
  const Room room = room_of(scene);
  Caption caption;
  caption.text_height = room.text;
  const auto longest = static_cast<std::size_t>(
      std::max(12.0, (room.right - room.left) / (Caption::letter_width * room.text)));
  const std::vector<std::string> lines = lines_of(words, longest);
  for (const std::string& line : lines) caption.words += (caption.words.empty() ? "" : "\n") + line;
  const double half = 0.5 * room.height(lines.size());
  const double middle = 0.5 * (room.left + room.right);
  caption.at = room.frame * Eigen::Vector3d(middle, room.first + (scene.planar ? -half : half), 0.0);
  return caption;
}

std::vector<Eigen::Vector3d> caption_corners(const Scene& scene) {
  const Room room = room_of(scene);
  const double height = room.height(Caption::max_lines);
  const double last = room.first + (scene.planar ? -height : height);
  return {room.frame * Eigen::Vector3d(room.left, room.first, 0.0),
          room.frame * Eigen::Vector3d(room.right, last, 0.0)};
}

}  // namespace parallel_aspects
