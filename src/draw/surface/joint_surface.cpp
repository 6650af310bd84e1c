// SPDX-License-Identifier: BSD-3-Clause
#include "draw/surface/joint_surface.h"

#include "model/angles.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using Corners = std::vector<Vector3d>;

constexpr double widest = 0.25;  // of a turn, that a triangle takes: wider ones cannot be unwrapped

/// Carries one surface to joint space.
class Carrier {
 public:
  Carrier(const AspectMap& map, const AspectSurface& surface, const JointBlock& block)
      : surface_(surface), block_(block) {
    const WorkingMode& mode = map.aspects()[static_cast<std::size_t>(surface.aspect - 1)].mode;
    for (const Vector3d& point : surface.mesh.points)
      images_.push_back(values_in(block, *map.manipulator(), surface_pose(map, point), mode));
    result_.aspect = surface.aspect;
  }

  JointSurface carry() {
    for (std::size_t t = 0; t < surface_.mesh.triangles.size(); ++t)
      if (surface_.mesh.kinds[t] == FaceKind::inner) carry(t);
    return std::move(result_);
  }

 private:
  bool is_narrow(const Corners& corners) const {
    for (Eigen::Index i = 0; i < 3; ++i)
      if (block_.turns[static_cast<std::size_t>(i)])
        for (const Vector3d& corner : corners)
          if (!(std::abs(corner[i] - corners.front()[i]) < widest * full_turn)) return false;
    return true;
  }

  void carry(std::size_t t) {
    const auto& triangle = surface_.mesh.triangles[t];
    Corners corners;
    for (const std::uint32_t corner : triangle)
      corners.push_back(corners.empty() ? images_[corner] : block_.near(corners.front(), images_[corner]));
    if (!corners[0].allFinite() || !corners[1].allFinite() || !corners[2].allFinite()) return;
    if (!is_narrow(corners)) return;
    const auto bound = bound_of(surface_, t);
    if (is_within(corners)) {
      add({shared(triangle[0]), shared(triangle[1]), shared(triangle[2])}, bound);
      return;
    }
    for (const Corners& copy : block_.copies_of(corners, false)) add_fan(copy, bound);
  }

  bool is_within(const Corners& corners) const {
    for (Eigen::Index i = 0; i < 3; ++i)
      for (const Vector3d& corner : corners)
        if (block_.turns[static_cast<std::size_t>(i)] &&
            (corner[i] < block_.lower[i] || corner[i] > block_.upper[i]))
          return false;
    return true;
  }

  std::uint32_t append(const Vector3d& point) {
    result_.points.push_back(point);
    return static_cast<std::uint32_t>(result_.points.size() - 1);
  }

  std::uint32_t shared(std::uint32_t corner) {
    const auto [found, is_new] = shared_.try_emplace(corner, 0U);
    if (is_new) found->second = append(images_[corner]);
    return found->second;
  }

  void add(const std::array<std::uint32_t, 3>& triangle, const std::optional<BoundaryKind>& bound) {
    result_.triangles.push_back(triangle);
    result_.bounds.push_back(bound);
  }

  void add_fan(const Corners& polygon, const std::optional<BoundaryKind>& bound) {
    std::vector<std::uint32_t> indices;
    for (const Vector3d& corner : polygon) indices.push_back(append(corner));
    for (std::size_t i = 2; i < indices.size(); ++i) add({indices[0], indices[i - 1], indices[i]}, bound);
  }

  const AspectSurface& surface_;
  const JointBlock& block_;
  std::vector<Vector3d> images_;
  std::map<std::uint32_t, std::uint32_t> shared_;
  JointSurface result_;
};

}  // namespace

Vector3d values_in(const JointBlock& block, const Manipulator& robot, const Pose& pose,
                   const WorkingMode& mode) {
  Vector3d q;
  for (std::size_t j = 0; j < 3; ++j) {
    const Leg& leg = robot.leg(j);
    q[static_cast<Eigen::Index>(j)] = joint_value(leg, pose.transform(leg.anchor), mode.sign(j));
  }
  return block.wrapped(q);
}

bool has_joint_surfaces(const AspectMap& map) noexcept {
  return has_surfaces(map) && map.manipulator()->leg_count() == 3;
}

JointBlock joint_block(const AspectMap& map) {
  const Manipulator& robot = *map.manipulator();
  JointBlock block;
  block.lower.setConstant(std::numeric_limits<double>::infinity());
  block.upper = -block.lower;
  for (const Aspect& aspect : map.aspects())
    map.visit_inside_poses(aspect.id, [&](const Pose& pose, double) {
      const Vector3d q = values_in(block, robot, pose, aspect.mode);
      block.lower = block.lower.cwiseMin(q);
      block.upper = block.upper.cwiseMax(q);
    });
  for (std::size_t j = 0; j < 3; ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const JointLimits& limits = robot.leg(j).limits;
    block.turns[j] = robot.leg(j).actuated_by_angle() && !limits.limited();
    if (block.turns[j]) block.lower[i] = -0.5 * full_turn;
    if (block.turns[j]) block.upper[i] = 0.5 * full_turn;
    if (std::isfinite(limits.lower)) block.lower[i] = limits.lower;
    if (std::isfinite(limits.upper)) block.upper[i] = limits.upper;
  }
  return block;
}

JointSurface joint_surface_of(const AspectMap& map, const AspectSurface& surface, const JointBlock& block) {
  return Carrier(map, surface, block).carry();
}

std::optional<BoundaryKind> bound_of(const AspectSurface& surface, std::size_t triangle) {
  std::map<BoundaryKind, int> votes;
  for (const std::uint32_t corner : surface.mesh.triangles[triangle])
    if (const auto bound = surface.bounds[corner]) ++votes[*bound];
  const auto most = std::max_element(votes.begin(), votes.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == votes.end() ? std::nullopt : std::make_optional(most->first);
}

}  // namespace parallel_aspects
