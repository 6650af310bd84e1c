// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/cusp_aspect.h"

#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

constexpr double gradient_step = 1e-5;                     // [rad]
constexpr double first_distance = 1e-5, farthest = 0.3;    // of the pose between both solutions [rad]
constexpr double next_distance = 2.0;                      // as a share of the last one
constexpr double first_reach = 0.1, farthest_reach = 1.0;  // of the solutions, that goes with its root [rad]
constexpr double most_growth = 2.0;                        // of the reach from one distance to the next

/// Two solutions of the same actuated values.
struct SolutionPair {
  std::array<Pose, 2> poses;
  double reach = 0.0;  // of the farther one from the cusp [rad]
};

class CuspSurroundings {
 public:
  CuspSurroundings(const AspectMap& map, const Cusp& cusp)
      : map_(map),
        robot_(*map.manipulator()),
        mode_(cusp.mode),
        circle_(circle_of_anchor(robot_, *map.slice()->joint)),
        origin_(coordinates(cusp.pose)),
        across_(gradient().normalized()) {}

  /// With the pose between both solutions on one side of det A = 0, ever farther away.
  BesideCusp look(double side) const {
    BesideCusp result;
    double reach = first_reach / most_growth;
    for (double distance = first_distance; distance < farthest; distance *= next_distance) {
      const auto pair = pair_of(side * distance * across_);
      if (!pair || pair->reach > std::min(most_growth * reach, farthest_reach)) break;
      reach = pair->reach;
      const Location first = map_.locate(pair->poses[0], mode_), second = map_.locate(pair->poses[1], mode_);
      if (is_excluded(first) || is_excluded(second)) break;
      if (!first || !second) continue;
      if (first.aspect != second.aspect || (result.aspect != 0 && first.aspect != result.aspect)) break;
      result.aspect = first.aspect;
      result.poses.push_back(pair->poses[0]);
    }
    return result;
  }

 private:
  static bool is_excluded(const Location& at) {
    return at.status == LocationStatus::outside || at.status == LocationStatus::not_mapped;
  }

  Vector2d coordinates(const Pose& pose) const {
    const Vector2d rod = circle_.rod(pose);
    return {std::atan2(rod.y(), rod.x()), 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w())};
  }

  Pose pose_at(const Vector2d& off) const {
    return circle_.pose(origin_.x() + off.x(), origin_.y() + off.y());
  }

  Vector2d off_of(const Pose& pose) const {
    const Vector2d off = coordinates(pose) - origin_;
    return {std::remainder(off.x(), 2.0 * pi), std::remainder(off.y(), 2.0 * pi)};
  }

  /// Not a number where a leg does not reach.
  double determinant(const Vector2d& off) const {
    const Pose pose = pose_at(off);
    const InverseSolution found = inverse(robot_, pose, mode_);
    if (found.status == InverseStatus::out_of_reach) return std::nan("");
    return direct_determinant(robot_, pose, found.q);
  }

  Vector2d gradient() const {
    const auto slope = [&](const Vector2d& step) { return determinant(step) - determinant(-step); };
    return {slope({gradient_step, 0.0}), slope({0.0, gradient_step})};
  }

  /// The solutions of the actuated values there that lie on the other side of det A = 0, next to the cusp and
  /// in opposite directions from it.
  std::optional<SolutionPair> pair_of(const Vector2d& between) const {
    const Pose pose = pose_at(between);
    const InverseSolution reached = inverse(robot_, pose, mode_);
    if (reached.status == InverseStatus::out_of_reach || !reached.q.allFinite()) return std::nullopt;
    const JointVector& q = reached.q;
    const bool is_positive = direct_determinant(robot_, pose, q) > 0.0;
    std::vector<Vector2d> found;
    for (const AssemblyMode& each : direct(robot_, q).solutions)
      if ((each.determinant > 0.0) != is_positive && working_mode(robot_, each.pose, q) == mode_)
        found.push_back(off_of(each.pose));
    if (found.size() < 2) return std::nullopt;
    std::sort(found.begin(), found.end(),
              [](const Vector2d& a, const Vector2d& b) { return a.squaredNorm() < b.squaredNorm(); });
    const Vector2d along(-across_.y(), across_.x());
    if (found[0].dot(along) * found[1].dot(along) >= 0.0) return std::nullopt;
    return SolutionPair{{pose_at(found[0]), pose_at(found[1])}, found[1].norm()};
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  WorkingMode mode_;
  AnchorCircle circle_;
  Vector2d origin_;  // direction and phi of the cusp
  Vector2d across_;  // towards rising det A
};

}  // namespace

BesideCusp look_beside(const AspectMap& map, const Cusp& cusp) {
  const CuspSurroundings around(map, cusp);
  BesideCusp below = around.look(-1.0), above = around.look(1.0);
  if (below.aspect != 0 && above.aspect != 0) return {};
  return below.aspect != 0 ? std::move(below) : std::move(above);
}

}  // namespace parallel_aspects
