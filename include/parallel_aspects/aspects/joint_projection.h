// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_JOINT_PROJECTION_H
#define PARALLEL_ASPECTS_ASPECTS_JOINT_PROJECTION_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/boundary_curves.h"
#include "parallel_aspects/aspects/pose_slice.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// The rectangle of joint values that is drawn: one turn, -pi to pi, for an angle without limits, the range
/// that the aspects take otherwise. Opposite edges of a full turn are the same.
struct JointWindow {
  Eigen::Vector2d lower;        ///< least values [rad or m]
  Eigen::Vector2d upper;        ///< greatest values [rad or m]
  std::array<bool, 2> turns{};  ///< whether the actuated joint is an angle that wraps

  /// Joint values brought into the window where they wrap.
  Eigen::Vector2d wrapped(const Eigen::Vector2d& q) const noexcept;

  /// A short straight line as it is seen in the window: where it leaves by one edge of a full turn, the rest
  /// comes in by the opposite one.
  std::vector<std::array<Eigen::Vector2d, 2>> pieces(const Eigen::Vector2d& from,
                                                     const Eigen::Vector2d& to) const;
};

/// Corners of triangles, three each, counter-clockwise.
using TriangleCorners = std::vector<Eigen::Vector2d>;

/// Pictures of a two-dimensional map in joint space: of T2, or of a slice of SE2 with an actuated joint held,
/// in the plane of the other two. Not certified: images of pieces are drawn as polygons with edges of about a
/// quarter of a radian, or of a 25th of the range of a length, or a little more.
class JointProjection {
 public:
  /// `map` must have such a plane.
  explicit JointProjection(std::shared_ptr<const AspectMap> map);

  /// Whether it has.
  static bool is_possible(const AspectMap& map) noexcept;

  /// The legs whose joints are drawn, to the right and up.
  const std::array<std::size_t, 2>& legs() const noexcept { return legs_; }

  /// What is drawn.
  const JointWindow& window() const noexcept { return window_; }

  /// QA_ij, the joint projection of an aspect: its pieces among `slivers` under q_s, cut at the edges of the
  /// window.
  TriangleCorners triangles(int aspect, const std::vector<BoundarySliver>& slivers) const;

  /// The same pieces as they are, convex and cut at the edges of the window.
  std::vector<BoundarySliver> images(int aspect, const std::vector<BoundarySliver>& slivers) const;

  /// Images of boundary pieces of one working mode, cut at the edges of the window.
  std::vector<BoundarySegment> images(const std::vector<BoundarySegment>& segments,
                                      const WorkingMode& mode) const;

  /// Likewise of lines of equal index.
  std::vector<LevelSegment> images(const std::vector<LevelSegment>& segments, const WorkingMode& mode) const;

  /// The joint values at a point of the map that is reached in this mode, within the window [rad or m].
  Eigen::Vector2d image(const Eigen::Vector2d& point, const WorkingMode& mode) const;

 private:
  Eigen::Vector2d joint_values(const Eigen::Vector2d& point, const WorkingMode& mode,
                               std::optional<std::size_t> singular = std::nullopt) const;
  double span(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  Eigen::Vector2d near(const Eigen::Vector2d& reference, Eigen::Vector2d q) const;
  void visit_images(const std::vector<Eigen::Vector2d>& polygon, const WorkingMode& mode, int splits_left,
                    const std::function<void(const std::vector<Eigen::Vector2d>&)>& visit) const;
  template <class Segment>
  std::vector<Segment> images_of(const std::vector<Segment>& segments, const WorkingMode& mode) const;
  void find_window();

  std::shared_ptr<const AspectMap> map_;
  PoseSlice slice_;
  std::array<std::size_t, 2> legs_{0, 1};
  JointWindow window_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_JOINT_PROJECTION_H
