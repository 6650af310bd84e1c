// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PLANE_MAP_PICTURES_H
#define PARALLEL_ASPECTS_DRAW_PLANE_MAP_PICTURES_H

#include "draw/plane/joint_range.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A two-dimensional slice through the poses of a task space, for drawing:
///  - SE2: x, y [m] at one phi [rad];
///  - T3: x, y [m] at one z [m];
///  - SO3: the tilt (theta cos(azimuth), theta sin(azimuth)) [rad] of the platform's z axis, within the disc
///  of
///    radius pi, at one torsion [rad] (the tilt and torsion of Bonev, Zlatanov and Gosselin, 2002);
///  - T2: x, y [m], and R2: both angles [rad], all there is;
///  - every task space: the free coordinates of a `MapSlice` that leaves two of them.
class PoseSlice {
 public:
  /// `level`: phi, z or torsion; unused in T2 and R2. Not for SE3.
  PoseSlice(const Motions& motions, double level) noexcept : motions_(motions), level_(level) {}

  /// The free coordinates of `slice`, which are two.
  PoseSlice(const Manipulator& manipulator, const MapSlice& slice);

  /// The slice that holds a pose.
  static PoseSlice through(const Motions& motions, const Pose& pose) noexcept;

  /// phi or torsion [rad], or z [m].
  double level() const noexcept { return level_; }

  /// The pose at this point of the slice [m or rad].
  Pose pose(const Eigen::Vector2d& point) const noexcept;

  /// Where in its own slice a pose lies.
  static Eigen::Vector2d point(TaskSpace space, const Pose& pose) noexcept;

  /// Whether the slice reaches this far: angles to half a turn, SO3 over its disc, else everywhere.
  bool holds(const Eigen::Vector2d& point) const noexcept;

  /// The joint that is held, where one is.
  std::optional<HeldJoint> held_joint() const noexcept { return slice_ ? slice_->joint : std::nullopt; }

  /// "phi = 0.3 rad", for people; empty in T2 and R2.
  std::string text() const;

 private:
  bool turns(std::size_t coordinate) const noexcept;

  Motions motions_;
  double level_ = 0.0;
  std::optional<MapSlice> slice_{};
  std::optional<AnchorCircle> circle_{};  // where a joint is held
};

/// What slices of the map can show: bounds in the coordinates of `PoseSlice` [m or rad], of all aspects.
Eigen::AlignedBox2d slice_bounds(const AspectMap& map);

/// The same of the free coordinates of `slice`, which are two, through a map that has them.
Eigen::AlignedBox2d slice_bounds(const AspectMap& map, const MapSlice& slice);

/// How far apart two slices are, the short way round where the level is an angle [m or rad].
double level_difference(TaskSpace space, double a, double b) noexcept;

/// What bounds an aspect.
enum class BoundaryKind {
  parallel,        ///< det A = 0
  serial,          ///< B_jj = 0
  limit,           ///< an actuated joint at one of its joint limits
  passive_limit,   ///< another joint at one of its limits
  cone,            ///< a rod as far from its axis as its ball joint lets it lean
  self_collision,  ///< links of two legs touch
  obstacle,        ///< a link or the platform touches an obstacle
  workspace,       ///< the operational point on the side of its box
  margin,          ///< an index of singularities as small as its margin lets it be
};

/// A short straight piece of the boundary of the aspects of one working mode, for drawing: approximated
/// in one cell of a grid, not certified.
struct BoundarySegment {
  BoundaryKind kind = BoundaryKind::parallel;  ///< what ends there
  std::size_t leg = 0;                         ///< whose B_jj or limit it is; unused for others
  Eigen::Vector2d from;                        ///< first end, in the slice [m or rad]
  Eigen::Vector2d to;                          ///< other end, in the slice [m or rad]
  std::array<int, 2> aspects{};  ///< ids on its left and right side; 0 for none, or too close to decide
};

/// A piece of one aspect, for drawing: its curved sides are straightened, while a point in it was located in
/// the aspect by proof.
struct BoundarySliver {
  int aspect = 0;                        ///< id
  std::vector<Eigen::Vector2d> corners;  ///< convex, counter-clockwise [m or rad]
};

/// An index of which lines of equal value are drawn; 0 at parallel singularities.
enum class DrawnIndex {
  parallel,      ///< `parallel_index`
  conditioning,  ///< `SingularityIndices::inverse_condition_number`: isoconditioning lines
};

/// Which lines of equal index are drawn.
struct IndexLevels {
  DrawnIndex index = DrawnIndex::parallel;  ///< of what
  std::vector<double> levels;               ///< its values, above 0
};

/// A short straight piece of a line of equal index, for drawing: approximated in one cell of a grid.
struct LevelSegment {
  double level = 0.0;    ///< of the index
  int aspect = 0;        ///< id of the aspect that it runs through
  Eigen::Vector2d from;  ///< first end, in the slice [m or rad]
  Eigen::Vector2d to;    ///< other end, in the slice [m or rad]
};

/// The aspects of one working mode in a slice, as they are drawn; each list in no order.
struct BoundaryPicture {
  std::vector<BoundarySegment> segments;  ///< the boundaries
  std::vector<BoundarySliver> slivers;    ///< what they bound
  std::vector<LevelSegment> levels;       ///< lines of equal index, where they were asked for
};

/// Whether neighbouring cells that lie wholly in one aspect become one sliver.
enum class Cells { merged, single };

/// The aspects of one working mode in a slice, and their boundaries, traced on a grid of `cells` x `cells`
/// over `bounds`, and lines of equal index; in no order.
BoundaryPicture trace_slice(const AspectMap& map, const WorkingMode& mode, const PoseSlice& slice,
                            const Eigen::AlignedBox2d& bounds, int cells, Cells merging = Cells::merged,
                            const IndexLevels& levels = {});

using JointWindow = JointRange<2>;

/// Corners of triangles, three each, counter-clockwise.
using TriangleCorners = std::vector<Eigen::Vector2d>;

/// Pictures of a two-dimensional map in joint space: of T2 or R2, or of a slice of SE2 with an actuated joint
/// held, in the plane of the other two. Not certified: images of pieces are drawn as polygons with edges of
/// about a quarter of a radian, or of a 25th of the range of a length, or a little more.
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

#endif  // PARALLEL_ASPECTS_DRAW_PLANE_MAP_PICTURES_H
