// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PLANE_SINGULAR_CURVES_H
#define PARALLEL_ASPECTS_DRAW_PLANE_SINGULAR_CURVES_H

#include "draw/plane/map_pictures.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace parallel_aspects {

/// A short straight piece of a curve of singular configurations.
struct SingularPiece {
  BoundaryKind kind = BoundaryKind::parallel;  ///< parallel or serial
  std::size_t leg = 0;                         ///< whose B_jj vanishes; unused for others
  WorkingMode mode;  ///< of its middle; where it is serial, the sign of that leg says nothing
  std::array<Eigen::Vector2d, 2> poses;     ///< its ends, in the slice [rad]; the second may be beyond pi
  std::array<Eigen::Vector2d, 2> actuated;  ///< both joint values that move, likewise [m or rad]

  /// Whether it bounds aspects of this working mode.
  bool is_of(const WorkingMode& other) const noexcept;
};

/// The singular curves of a slice with an actuated joint held, for drawing. Each is followed in the space of
/// the pose and the joint values, where it is smooth at B_jj = 0 too: there det A = 0 touches the boundary of
/// the working mode and goes on in another one, and as a function of the pose the joint value changes like a
/// root. What breaks limits or constraints is left out. Not certified.
class SingularCurves {
 public:
  /// `projection` is of the same map, and must outlive the object as the map must.
  SingularCurves(const AspectMap& map, const JointProjection& projection);

  /// Follows the curve that a traced piece of this mode is near to, unless it is there already.
  void follow(const BoundarySegment& near, const WorkingMode& mode);

  /// Follows serial singularities of single poses: where an anchor is on the axis of a crank as long as the
  /// rod, every value of the crank is one.
  void follow_free_cranks();

  const std::vector<SingularPiece>& pieces() const noexcept { return pieces_; }

 private:
  // direction, phi, and both joint values, lengths so that the whole range of each counts like a turn.
  using Coordinates = Eigen::Vector4d;
  struct Condition {
    BoundaryKind kind;
    std::size_t leg;
  };
  struct Point {
    Coordinates at, tangent;
  };
  using Key = std::tuple<BoundaryKind, std::size_t, int, int>;

  JointVector actuated(const Coordinates& at) const;
  Coordinates coordinates(const Eigen::Vector2d& point, const WorkingMode& mode) const;
  Eigen::Vector3d residual(const Condition& condition, const Coordinates& at) const;
  Eigen::Matrix<double, 4, 3> gradients(const Condition& condition, const Coordinates& at) const;
  std::optional<Point> corrected(const Condition& condition, Coordinates at) const;
  void follow(const Condition& condition, const Eigen::Vector2d& point, const WorkingMode& mode);
  bool walk(const Condition& condition, const Point& start, double sense);
  void add(const Condition& condition, const Coordinates& from, const Coordinates& to);
  bool fits(const Pose& pose, JointVector& q) const;
  Coordinates way(const Coordinates& from, const Coordinates& to) const;
  Key key(const Condition& condition, const Coordinates& at, int right, int up) const;
  bool is_known(const Condition& condition, const Coordinates& at) const;

  const Manipulator& robot_;
  const JointProjection& projection_;
  PoseSlice slice_;
  HeldJoint held_;
  std::array<double, 2> units_{};  // of the last coordinates [m or rad]
  std::map<Key, std::vector<Coordinates>> known_;
  std::vector<SingularPiece> pieces_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PLANE_SINGULAR_CURVES_H
