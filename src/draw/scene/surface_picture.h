// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SCENE_SURFACE_PICTURE_H
#define PARALLEL_ASPECTS_DRAW_SCENE_SURFACE_PICTURE_H

#include "draw/scene/bodies.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <Eigen/Geometry>

#include <atomic>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Which aspects are drawn.
enum class Shown {
  present_mode,    ///< those of the working mode that the robot is in
  present_aspect,  ///< the one that the robot is in
  chosen,          ///< those that `chosen` names
  all,             ///< all of them
};

/// Which part of the picture a section leaves.
enum class Section {
  none,       ///< all of it
  at_robot,   ///< what lies below the present value of the coordinate
  at_offset,  ///< what lies below a value of it
};

/// What is drawn of a map.
struct PictureChoice {
  Shown shown = Shown::present_mode;
  std::set<int> chosen;                ///< ids
  std::vector<WorkingMode> modes;      ///< the present one; while it is not known those of the candidates
  int aspect = 0;                      ///< id of the present one; 0 where it is not known
  std::set<int> candidates;            ///< ids of those that it may be in, while it is not known
  std::vector<Eigen::Vector3d> names;  ///< where those of candidates are written, in the task frame [m]
  Section section = Section::none;
  std::size_t axis = 2;          ///< coordinate that the section is across
  double offset = 0.0;           ///< of the section [m or rad]
  bool upper = false;            ///< leaves what lies above in place of what lies below
  bool tells_boundaries = true;  ///< colours what an aspect ends at
  double radian = 0.0;           ///< how long an angle of one rad is drawn [m]; 0 for what suits the robot
  bool joint_space = false;      ///< draws the joint space beside the workspace
  bool gallery = false;          ///< draws every working mode beside the robot
  Eigen::AlignedBox3d robot{};   ///< what the robot takes, in the task frame [m]; the rest stands beside it
  Eigen::AlignedBox3d reach{};   ///< what it reaches, likewise, below the legend; may be empty
  double seen = 0.0;             ///< `seen_height` of its scene [m]; 0 for that of what is drawn
};

/// A working mode in the gallery: what `drawn_point` says is drawn at `offset + scale * point`, in the task
/// frame.
struct PoseTile {
  WorkingMode mode;
  double scale = 1.0;
  Eigen::Vector3d offset;
};

/// Whether they differ in nothing but where the robot stands.
bool is_same(const PictureChoice& one, const PictureChoice& other);

/// What there is to draw, in metres.
struct SurfacePicture {
  PicturePart moving;                ///< in the task frame moved by `placement` of the present pose
  PicturePart standing;              ///< in the task frame
  std::vector<PoseTile> workspaces;  ///< of the gallery
  std::vector<JointTile> joint_spaces;
  Label legend;                 ///< where the robot is, in the task frame
  std::vector<Label> meanings;  ///< of the colours of boundaries, in these; below it, from the lowest line on
  bool is_cut = false;          ///< by a section, so that its inside shows
  double radian = 1.0;          ///< how long an angle of one rad is drawn [m]
  double size = 1.0;            ///< of the robot, or of the ball of rotations [m]
  double legend_size = 1.0;     ///< how high its letters are [m]
  std::size_t triangles = 0;
};

/// Draws the map of the store; stops early, with what there is, where `cancelled` is set.
SurfacePicture draw_surfaces(SurfaceStore& store, const PictureChoice& choice,
                             const std::optional<Pose>& present, const std::atomic<bool>& cancelled);

/// Its legend: where the robot is.
std::string where_words(const PictureChoice& choice, TaskSpace space);

/// Ids of the aspects that a choice shows.
std::vector<int> shown_aspects(const AspectMap& map, const PictureChoice& choice);

/// The ids and working modes that a person wrote, as "1 4 (+,-)"; what is neither is returned in `problem`.
std::set<int> chosen_aspects(const AspectMap& map, const std::string& text, std::string& problem);

/// Where the picture stands in the task frame: in SE2 the present angle is in the plane of the robot, and
/// SO3's ball of rotations is beside the robot.
Eigen::Vector3d placement(const Manipulator& manipulator, const std::optional<Pose>& present, double radian);

/// How far a section at the robot may be from it before it is drawn anew, in its own unit.
double section_step(const AspectMap& map, std::size_t axis);

/// How long one unit of a coordinate is drawn [m].
double section_unit(TaskSpace space, std::size_t axis, double radian) noexcept;

/// Coordinate `axis` of a pose, as sections have it [m or rad].
double section_value(TaskSpace space, const Pose& pose, std::size_t axis);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SCENE_SURFACE_PICTURE_H
