// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/surface_picture.h"

#include "draw/scene/robot_lines.h"
#include "draw/scene/workspace_bodies.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <regex>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr std::size_t most_triangles = 120000;  // of all surfaces, so that software renders them
constexpr int plane_cells = 300, tile_cells = 120;

// Of tiles, over their side.
constexpr double tile_width = 1.35, workspace_height = 1.35, joint_height = 1.6;
constexpr std::size_t most_columns = 4;

// Of robots that only turn, it is directions of axes that have the size.
double radian_of(const Manipulator& robot, const PictureChoice& choice) {
  const TaskSpace space = robot.task_space();
  if (space != TaskSpace::SE2 && space != TaskSpace::SO3 && !has_hinges(space)) return 1.0;
  if (choice.radian > 0.0) return choice.radian;
  if (has_hinges(space)) return sphere_radius(robot);
  return turn_length(robot) * (space == TaskSpace::SO3 ? 2.0 * ball_radius : 1.0) / (2.0 * pi);
}

std::string listed(const std::set<int>& ids) {
  std::string text;
  for (const int id : ids) text += (text.empty() ? "" : " or ") + std::to_string(id);
  return text;
}

// All aspects of a map as they are drawn, before `placement`.
AlignedBox3d workspace_box(const AspectMap& map, double radian) {
  const TaskSpace space = map.manipulator()->task_space();
  if (space == TaskSpace::SO3) return {Vector3d::Constant(-pi * radian), Vector3d::Constant(pi * radian)};
  if (has_hinges(space)) return {Vector3d::Constant(-1.1 * radian), Vector3d::Constant(1.1 * radian)};
  AlignedBox3d box;
  for (const Aspect& aspect : map.aspects())
    for (const auto& end : {aspect.bounds.lower, aspect.bounds.upper}) {
      Vector3d corner(end[0], end[1], aspect.bounds.dimension > 2 ? end[2] : 0.0);
      if (space == TaskSpace::SE2) corner.z() = corner.z() > 0.0 ? pi * radian : -pi * radian;
      box.extend(corner);
    }
  return box.isEmpty() ? AlignedBox3d(Vector3d::Zero(), Vector3d::Zero()) : box;
}

void extend(AlignedBox3d& box, const PicturePart& part, const Vector3d& offset) {
  for (const ColoredMesh& mesh : part.meshes)
    for (const Eigen::Vector3f& point : mesh.points) box.extend(Vector3d(point.cast<double>() + offset));
}

/// Puts the parts of one picture together.
class Composer {
 public:
  Composer(SurfaceStore& store, const PictureChoice& choice, const std::optional<Pose>& present)
      : store_(store),
        robot_(store.robot()),
        choice_(choice),
        present_(present),
        paint_(store.map(), choice.tells_boundaries ? Tint::boundaries : Tint::light) {
    const TaskSpace space = robot_.task_space();
    picture_.radian = radian_of(robot_, choice);
    picture_.size = space == TaskSpace::SO3 ? 2.0 * pi * picture_.radian : robot_.size();
    style_ = {picture_.radian, choice.aspect, choice.candidates, section(), std::nullopt, {}, choice.names};
    if (present) style_.robot = drawn_point(robot_, *present, picture_.radian);
    if (present) style_.platform = platform_corners(robot_, *present);
    picture_.is_cut = style_.section.has_value();
    box_ = choice.robot;
  }

  SurfacePicture draw(const std::atomic<bool>& cancelled) {
    const std::vector<int> ids = shown_aspects(store_.map(), choice_);
    picture_.moving = workspace_bodies(store_, paint_, style_, ids, most_triangles, plane_cells, cancelled);
    extend(box_, picture_.moving, placement(robot_, present_, picture_.radian));
    if (!box_.isEmpty()) {
      const AlignedBox3d here = box_;
      if (choice_.gallery || choice_.joint_space) add_tiles(ids, here, cancelled);
      add_legend(here);
    }
    for (const PicturePart* const part : {&picture_.moving, &picture_.standing})
      for (const ColoredMesh& mesh : part->meshes) picture_.triangles += mesh.triangles.size();
    return std::move(picture_);
  }

 private:
  std::optional<HalfSpace> section() const {
    const bool at_robot = choice_.section == Section::at_robot;
    if (choice_.section == Section::none || (at_robot && !present_) || !has_surfaces(store_.map()))
      return std::nullopt;
    const double value =
        at_robot ? section_value(robot_.task_space(), *present_, choice_.axis) : choice_.offset;
    const double sign = choice_.upper ? -1.0 : 1.0;
    return HalfSpace{sign * Vector3d::Unit(static_cast<Eigen::Index>(choice_.axis)), sign * value};
  }

  // Of a column and a height above the robot's box, to the right of it.
  Eigen::Index up() const { return is_planar(robot_.task_space()) ? 1 : 2; }

  std::vector<WorkingMode> tile_modes(const std::vector<int>& ids) const {
    if (choice_.gallery && choice_.shown != Shown::chosen) return store_.map().working_modes();
    std::vector<WorkingMode> modes;
    for (const int id : ids) {
      const WorkingMode& mode = store_.map().aspects()[static_cast<std::size_t>(id - 1)].mode;
      if (std::find(modes.begin(), modes.end(), mode) == modes.end()) modes.push_back(mode);
    }
    return modes;
  }

  void add_tiles(const std::vector<int>& ids, const AlignedBox3d& here, const std::atomic<bool>& cancelled) {
    const std::vector<WorkingMode> modes = tile_modes(ids);
    if (modes.empty()) return;
    const bool joints = choice_.joint_space && has_joint_space(store_.map());
    const std::size_t columns = std::min(most_columns, modes.size()),
                      rows = (modes.size() + columns - 1) / columns;
    const double pitch = (choice_.gallery ? workspace_height : 0.0) + (joints ? joint_height : 0.0);
    if (!(pitch > 0.0)) return;
    const double height = std::max(here.sizes()[up()], 0.6 * picture_.size);
    const double side = std::min(0.8 * height, height / (pitch * static_cast<double>(rows)));
    for (std::size_t i = 0; i < modes.size() && !cancelled; ++i) {
      Vector3d at = here.center();
      if (is_planar(robot_.task_space())) at.z() = 0.0;
      at.x() =
          here.max().x() + 0.1 * picture_.size + side * tile_width * (static_cast<double>(i % columns) + 0.5);
      at[up()] = here.max()[up()] - side * pitch * static_cast<double>(i / columns);
      if (choice_.gallery) add_workspace(modes[i], at, side, modes.size(), cancelled);
      if (choice_.gallery) at[up()] -= side * workspace_height;
      if (joints) add_joint_space(modes[i], ids, at, side, modes.size());
    }
  }

  std::vector<int> ids_of(const WorkingMode& mode) const {
    std::vector<int> ids;
    for (const Aspect& aspect : store_.map().aspects())
      if (aspect.mode == mode && (choice_.shown != Shown::chosen || choice_.chosen.count(aspect.id) != 0))
        ids.push_back(aspect.id);
    return ids;
  }

  // Below `top`, which is the middle of its upper end.
  void add_workspace(const WorkingMode& mode, const Vector3d& top, double side, std::size_t tiles,
                     const std::atomic<bool>& cancelled) {
    const AlignedBox3d box = workspace_box(store_.map(), picture_.radian);
    const double scale = side / std::max(1e-9, box.sizes().maxCoeff());
    Vector3d center = top;
    center[up()] -= 0.62 * side;
    PoseTile tile{mode, scale, center - scale * box.center()};
    WorkspaceStyle style = style_;
    style.platform.clear();  // it is not drawn there
    PicturePart part =
        workspace_bodies(store_, paint_, style, ids_of(mode), most_triangles / tiles, tile_cells, cancelled);
    move(part, scale, tile.offset);
    for (Label& label : part.labels) label.share = 0.6;
    Vector3d title = top;
    title[up()] -= 0.04 * side;
    part.labels.push_back({"working mode " + to_string(mode), ink_color, title.cast<float>(), 0.7});
    append(std::move(part), picture_.standing);
    picture_.workspaces.push_back(std::move(tile));
  }

  void add_joint_space(const WorkingMode& mode, const std::vector<int>& ids, const Vector3d& top, double side,
                       std::size_t tiles) {
    Vector3d center = top;
    center[up()] -= 0.65 * side;
    const JointTile tile = joint_tile(store_, mode, center, side);
    append(joint_bodies(store_, paint_, choice_.gallery ? ids_of(mode) : ids, tile, most_triangles / tiles,
                        tile_cells),
           picture_.standing);
    picture_.joint_spaces.push_back(tile);
  }

  // Above the picture and the robot, as they are usually seen.
  void add_legend(const AlignedBox3d& here) {
    const AlignedBox3d below = choice_.reach.isEmpty() ? here : here.merged(choice_.reach);
    picture_.legend_size = legend_height * (choice_.seen > 0.0 ? choice_.seen : here.sizes().maxCoeff());
    Eigen::Vector3f at = below.center().cast<float>();
    at[up()] = static_cast<float>(below.max()[up()] + picture_.legend_size);
    double raised = 0.0;
    const auto line = [&](const std::string& words, Rgb color) {
      const Label result{words, color, at, 1.0, 0, raised};
      raised += legend_pitch;
      return result;
    };
    if (choice_.tells_boundaries || !has_surfaces(store_.map()))
      for (const BoundaryStyle& style : boundary_styles())
        if (paint_.kinds().count(style.kind) != 0)
          picture_.meanings.push_back(line(style.color_word + std::string(": ") + style.words, style.color));
    picture_.legend = line(where_words(choice_, robot_.task_space()), ink_color);
  }

  SurfaceStore& store_;
  const Manipulator& robot_;
  const PictureChoice& choice_;
  const std::optional<Pose>& present_;
  AspectPaint paint_;
  WorkspaceStyle style_;
  AlignedBox3d box_;  // of what stands at the robot, in the task frame
  SurfacePicture picture_;
};

auto parts(const PictureChoice& choice) {
  return std::tie(choice.shown, choice.chosen, choice.aspect, choice.candidates, choice.modes, choice.section,
                  choice.axis, choice.offset, choice.upper, choice.tells_boundaries, choice.radian,
                  choice.joint_space, choice.gallery, choice.names);
}

}  // namespace

bool is_same(const PictureChoice& one, const PictureChoice& other) { return parts(one) == parts(other); }

SurfacePicture draw_surfaces(SurfaceStore& store, const PictureChoice& choice,
                             const std::optional<Pose>& present, const std::atomic<bool>& cancelled) {
  return Composer(store, choice, present).draw(cancelled);
}

std::string where_words(const PictureChoice& choice, TaskSpace space) {
  const std::string set = set_word(space), where = space == TaskSpace::SE3 ? " at this orientation" : "";
  if (choice.aspect != 0) return "The robot is in " + set + " " + std::to_string(choice.aspect) + where;
  if (!choice.candidates.empty())
    return "The robot may be in " + set + " " + listed(choice.candidates) + where;
  return "It is not known in which " + set + " the robot is" + where;
}

std::vector<int> shown_aspects(const AspectMap& map, const PictureChoice& choice) {
  std::vector<int> ids;
  for (const Aspect& aspect : map.aspects()) {
    const auto is_of_mode = [&] {
      return std::find(choice.modes.begin(), choice.modes.end(), aspect.mode) != choice.modes.end();
    };
    const bool is_present = aspect.id == choice.aspect || choice.candidates.count(aspect.id) != 0;
    const bool is_shown = choice.shown == Shown::all ||
                          (choice.shown == Shown::chosen && choice.chosen.count(aspect.id) != 0) ||
                          (choice.shown == Shown::present_mode && is_of_mode()) ||
                          (choice.shown == Shown::present_aspect && is_present);
    if (is_shown) ids.push_back(aspect.id);
  }
  return ids;
}

std::set<int> chosen_aspects(const AspectMap& map, const std::string& text, std::string& problem) {
  static const std::regex word(R"([^\s,]*\([^)]*\)|[^\s,]+)");
  std::set<int> ids;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
    const std::string name = it->str();
    bool is_known = false;
    for (const Aspect& aspect : map.aspects())
      if (name == std::to_string(aspect.id) || name == to_string(aspect.mode)) {
        ids.insert(aspect.id);
        is_known = true;
      }
    if (!is_known && problem.empty())
      problem = "'" + name + "' is no aspect of this map; give ids from 1 to " +
                std::to_string(map.aspects().size()) + ", or working modes as " +
                (map.working_modes().empty() ? "(+,-)" : to_string(map.working_modes().front())) + ".";
  }
  return ids;
}

Vector3d placement(const Manipulator& manipulator, const std::optional<Pose>& present, double radian) {
  const TaskSpace space = manipulator.task_space();
  const double size = manipulator.size();
  if (space == TaskSpace::SO3) return {ball_distance * pi * radian, 0.0, 0.0};
  if (space == TaskSpace::SE2) {
    const double here = present ? radian * surface_point(space, *present).z() : 0.0;
    return {0.0, 0.0, -here - plane_below * size};
  }
  return Vector3d::Zero();
}

double section_step(const AspectMap& map, std::size_t axis) {
  const Box region = map.region();
  return region.dimension == 3 ? region.width(axis) / 128.0 : 2.0 * pi / 128.0;
}

double section_unit(TaskSpace space, std::size_t axis, double radian) noexcept {
  return space == TaskSpace::SO3 || (space == TaskSpace::SE2 && axis == 2) ? radian : 1.0;
}

double section_value(TaskSpace space, const Pose& pose, std::size_t axis) {
  return surface_point(space, pose)[static_cast<Eigen::Index>(axis)];
}

}  // namespace parallel_aspects
