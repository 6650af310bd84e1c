// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_COLORED_PARTS_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_COLORED_PARTS_H

#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace parallel_aspects {

/// One colour of a surface, or of a part of a plane.
struct ColoredMesh {
  int aspect = 0;           ///< id
  std::uint32_t color = 0;  ///< 0xRRGGBB
  bool is_flat = false;     ///< in a plane: the face of a section, or all of a picture of two coordinates
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Segments of one colour, two points each.
struct ColoredLines {
  std::uint32_t color = 0;  ///< 0xRRGGBB
  bool is_outline = false;  ///< around the present aspect, wider than the others
  std::vector<Eigen::Vector3f> ends;
};

/// How high a label is, over the size of the robot.
inline constexpr double id_height = 0.045;

/// Words, as the viewer sees them.
struct Label {
  std::string text;
  std::uint32_t color = 0;
  Eigen::Vector3f at = Eigen::Vector3f::Zero();
  double share = 1.0;   ///< of `id_height`
  int aspect = 0;       ///< id of the aspect that it names; 0 for other words
  double raised = 0.0;  ///< above its place as the viewer sees it, over its height
};

/// What is drawn together.
struct PicturePart {
  std::vector<ColoredMesh> meshes;
  std::vector<ColoredLines> lines;
  std::vector<Label> labels;
};

/// A picture of the joint space of a working mode: joint values q are drawn at `at + scale * (q - middle)`,
/// in the task frame.
struct JointTile {
  WorkingMode mode;
  Eigen::Vector3d at, scale, middle;
  std::array<bool, 3> turns{};  ///< whether a joint is an angle that wraps into (-pi, pi]

  /// Where joint values are drawn [m].
  Eigen::Vector3d drawn(const JointVector& q) const;
};

/// Points moved by `offset` after they were drawn `scale` times as large.
void move(PicturePart& part, double scale, const Eigen::Vector3d& offset);

void append(PicturePart&& part, PicturePart& to);

/// `share` of the way from one colour to the other.
std::uint32_t mixed(std::uint32_t one, std::uint32_t other, double share);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_COLORED_PARTS_H
