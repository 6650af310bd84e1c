// SPDX-License-Identifier: BSD-3-Clause
#include "ros/programs/rviz_view.h"

#include "draw/plane/map_pictures.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "ros/pictures/domain_picture.h"
#include "ros/pictures/map_picture.h"
#include "ros/pictures/scene.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double field_of_view = 0.3;  // narrow, so that it looks nearly orthographic [rad]
constexpr double margin = 1.06;

// What is left of the window for the scene.
struct Screen {
  double width, height;  // [pixels]
};

Screen screen_of(const YAML::Node& config) {
  const YAML::Node window = config["Window Geometry"];
  const double dock = window["Hide Left Dock"].as<bool>(true) ? 0.0 : 380.0;
  return {window["Width"].as<double>(1280.0) - 40.0 - dock, window["Height"].as<double>(800.0) - 95.0};
}

// Rviz's own display of the map draws none beside the robot.
bool shows_gallery(const YAML::Node& config) {
  const YAML::Node displays = config["Visualization Manager"]["Displays"];
  return std::none_of(displays.begin(), displays.end(), [](const YAML::Node& display) {
    return display["Class"].as<std::string>("") == "parallel_aspects/Aspects";
  });
}

// The gallery of a robot of two degrees of freedom takes its size from the map, which takes no time to
// compute.
AlignedBox2d map_gallery(const NodeSetup& setup) {
  const auto map = compute_aspect_map(setup.mechanism->mapped_manipulator(), setup.options.map).map;
  AlignedBox2d box;
  if (!map || map->aspects().empty() || !setup.options.display.gallery) return box;
  const GalleryLayout layout(*map, JointProjection(map).window(), setup.options.display.gallery_scale);
  const double text = layout.text_height();
  const Vector2d half_tile = 0.5 * layout.workspace_tile_size();
  const Vector2d last = layout.workspace_tile_center(map->working_modes().size() - 1);
  box.extend(Vector2d(layout.aspects_origin() - half_tile));
  box.extend(Vector2d(layout.aspects_origin() + last + half_tile + Vector2d(text, 2.0 * text)));
  box.extend(
      Vector2d(layout.joint_space_origin() - 0.5 * layout.joint_tile_size() - Vector2d(0.0, 6.0 * text)));
  box.extend(Vector2d(box.min().x() + 9.0 * text, box.min().y()));  // the lines of the legend are wide
  return box;
}

AlignedBox2d tile_gallery(const Scene& scene) {
  const double text = scene.tiles.text_height();
  return {Vector2d(0.0, -scene.tiles.height() - 3.5 * text), Vector2d(scene.tiles.width(), 2.0 * text)};
}

// What the display has at the robot and beside it: aspects as bodies, or a ball of rotations, and a legend
// above them.
void add_display(const NodeSetup& setup, const Scene& scene, std::vector<Vector3d>& corners) {
  const Manipulator& robot = *setup.mechanism->manipulator();
  Eigen::AlignedBox3d here = scene.robot;
  if (!scene.reach.isEmpty()) here.extend(scene.reach);
  if (robot.task_space() == TaskSpace::R2)
    for (const double side : {-1.0, 1.0})
      here.extend(Vector3d::Constant(side * (1.0 + between_sheets) * sphere_radius(robot)));
  for (int i = 0; i < 8; ++i) corners.push_back(here.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  Vector3d above = here.center();
  const Eigen::Index up = scene.planar ? 1 : 2;
  above[up] = here.max()[up];
  if (robot.task_space() == TaskSpace::SO3) {
    const Vector3d radius = Vector3d::Constant(scene.radius);
    const Vector3d middle = ball_distance * radius.x() * Vector3d::UnitX();
    corners.insert(corners.end(), {middle - radius, middle + radius});
  }
  above[up] += (1.0 + legend_pitch * legend_lines) * legend_height * seen_height(scene);
  corners.push_back(above);
}

// Of aspects that there may be, one of each sign in each working mode, four at most: so that the robot is not
// lost among many. In robots of other task spaces nothing is drawn of their domains.
void add_domains(const NodeSetup& setup, const Scene& scene, std::vector<Vector3d>& corners) {
  const Manipulator& robot = *setup.mechanism->manipulator();
  if (!setup.options.uniqueness.enabled || robot.task_space() != TaskSpace::SE2) return;
  if (!find_uniqueness_problem(robot, {}).empty()) return;
  const AlignedBox2d positions(scene.robot.min().head<2>(), scene.robot.max().head<2>());
  const std::size_t aspects = std::min<std::size_t>(4, 2 * working_modes(robot).size());
  const AlignedBox2d seen = DomainLayout(robot, scene, positions, aspects).seen();
  for (const Vector2d& corner : {seen.min(), seen.max()}) corners.emplace_back(corner.x(), corner.y(), 0.0);
}

// Corners of all there is to see, in the task frame.
std::vector<Vector3d> corners_of(const NodeSetup& setup, const Scene& scene, bool with_gallery) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(scene.robot.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  if (with_gallery)
    for (const Vector3d& corner : caption_corners(scene)) corners.push_back(corner);
  add_domains(setup, scene, corners);
  if (!with_gallery) add_display(setup, scene, corners);
  if (!with_gallery || !setup.options.display.gallery) return corners;
  const bool plane = setup.mechanism->manipulator()->task_space() == TaskSpace::T2;
  const AlignedBox2d gallery = plane ? map_gallery(setup) : tile_gallery(scene);
  const Isometry3d frame = plane ? Isometry3d::Identity() : scene.gallery;
  if (!gallery.isEmpty())
    for (const Vector2d& corner : {gallery.min(), gallery.max()})
      corners.push_back(frame * Vector3d(corner.x(), corner.y(), 0.0));
  return corners;
}

// The viewer's axes in the base frame: right, up, and from the scene to the viewer.
Eigen::Matrix3d viewer_axes(const Manipulator& robot, bool planar) {
  const Eigen::Matrix3d drawn = drawing_frame(robot).linear();
  if (planar) return drawn;
  return drawn * Eigen::AngleAxisd(0.5 * EIGEN_PI - view_pitch, Vector3d::UnitX()).toRotationMatrix();
}

YAML::Node from_above(const Vector3d& center, const Vector3d& size, const Screen& screen) {
  YAML::Node view;
  view["Class"] = "rviz/TopDownOrtho";
  view["Name"] = "Current View";
  view["Angle"] = 0;
  view["Near Clip Distance"] = 0.01;
  view["Scale"] = std::min(screen.width / size.x(), screen.height / size.y()) / margin;
  view["X"] = center.x();
  view["Y"] = center.y();
  return view;
}

// How far the viewer is from the center so that all corners are seen, each at its own depth.
double distance_to(const std::vector<Vector3d>& corners, const Vector3d& center, const Screen& screen) {
  const double up = std::tan(0.5 * field_of_view), across = up * screen.width / screen.height;
  double distance = 0.0;
  for (const Vector3d& corner : corners) {
    const Vector3d from = (corner - center).cwiseAbs();
    const double needed = margin * std::max(from.x() / across, from.y() / up);
    distance = std::max(distance, needed + corner.z() - center.z());
  }
  return distance;
}

// `to_viewer`: in the base frame, as `center`.
YAML::Node from_the_front(const Vector3d& center, double distance, const Vector3d& to_viewer) {
  YAML::Node view;
  view["Class"] = "rviz/Orbit";
  view["Name"] = "Current View";
  view["Distance"] = distance;
  view["Field of View"] = field_of_view;
  view["Focal Point"]["X"] = center.x();
  view["Focal Point"]["Y"] = center.y();
  view["Focal Point"]["Z"] = center.z();
  view["Focal Shape Fixed Size"] = true;
  view["Near Clip Distance"] = 0.01;
  view["Pitch"] = std::asin(std::clamp(to_viewer.z(), -1.0, 1.0));
  view["Yaw"] = std::remainder(std::atan2(to_viewer.y(), to_viewer.x()), 2.0 * EIGEN_PI);
  return view;
}

// `corners`: of all there is to see, in the drawing frame.
YAML::Node view_of(const Manipulator& robot, bool planar, std::vector<Vector3d> corners,
                   const Screen& screen) {
  const Eigen::Matrix3d axes = viewer_axes(robot, planar);
  Eigen::AlignedBox3d seen;
  for (Vector3d& corner : corners) {
    corner = axes.transpose() * (drawing_frame(robot) * corner);  // as the viewer has them
    seen.extend(corner);
  }
  const Vector3d center = axes * seen.center();
  if (axes.isApprox(Eigen::Matrix3d::Identity(), 1e-6)) return from_above(center, seen.sizes(), screen);
  return from_the_front(center, distance_to(corners, seen.center(), screen), axes.col(2));
}

// Of the links in tf: what the name of the base frame begins with.
std::string link_prefix(const NodeSetup& setup) {
  const std::string& prefix = setup.options.frame_prefix;
  return setup.mechanism->manipulator()->base_frame().rfind(prefix + "/", 0) == 0 ? prefix : "";
}

}  // namespace

std::string with_view_of(const std::string& config, const NodeSetup& setup) {
  YAML::Node document = YAML::Load(config);
  const Manipulator& robot = *setup.mechanism->manipulator();
  const bool with_gallery = shows_gallery(document);
  NodeSetup drawn = setup;
  if (!with_gallery) drawn.options.display.radius = ball_radius * robot.size();
  const Scene scene = scene_of(drawn);
  YAML::Node view = view_of(robot, scene.planar, corners_of(setup, scene, with_gallery), screen_of(document));
  view["Target Frame"] = robot.base_frame();
  document["Visualization Manager"]["Views"]["Current"] = view;
  document["Visualization Manager"]["Global Options"]["Fixed Frame"] = robot.base_frame();
  for (YAML::Node display : document["Visualization Manager"]["Displays"])
    if (display["Class"].as<std::string>("") == "rviz/RobotModel") display["TF Prefix"] = link_prefix(setup);
  YAML::Emitter out;
  out << document;
  return std::string(out.c_str()) + "\n";
}

}  // namespace parallel_aspects
