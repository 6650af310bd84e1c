// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/ompl/aspect_space_information.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <string>

namespace parallel_aspects {
namespace {

namespace ob = ompl::base;
using RealVectorState = ob::RealVectorStateSpace::StateType;
using SE2State = ob::SE2StateSpace::StateType;
using SO3State = ob::SO3StateSpace::StateType;
using SE3State = ob::SE3StateSpace::StateType;

/// One of OMPL's spaces, with the motions that certified segments have.
template <TaskSpace space, class Base>
class PoseStateSpace final : public Base {
 public:
  using Base::Base;
  using Base::sanityChecks;

  void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override {
    set_pose(space, pose_between(pose_of(space, *from), pose_of(space, *to), t), *state);
  }

  /// Half of half a motion is not a quarter of it, as in other spaces of OMPL's.
  void sanityChecks() const override {
    constexpr double zero = std::numeric_limits<double>::epsilon(),
                     nearly_zero = std::numeric_limits<float>::epsilon();
    Base::sanityChecks(zero, nearly_zero, ~static_cast<unsigned>(ob::StateSpace::STATESPACE_INTERPOLATION));
  }
};

Eigen::Quaterniond quaternion(const SO3State& state) {
  return Eigen::Quaterniond(state.w, state.x, state.y, state.z).normalized();
}

void set_quaternion(const Eigen::Quaterniond& orientation, SO3State& state) {
  state.x = orientation.x();
  state.y = orientation.y();
  state.z = orientation.z();
  state.w = orientation.w();
}

/// Encloses the points where the anchor of the leg can be.
Eigen::AlignedBox3d anchors_of(const Leg& leg) {
  Eigen::AlignedBox3d box(leg.base_point());
  double reach = leg.longest_reach();
  if (!std::isfinite(reach) && std::isfinite(leg.limits.lower) && std::isfinite(leg.limits.upper)) {
    box = Eigen::AlignedBox3d(leg.proximal_point(leg.limits.lower));
    box.extend(leg.proximal_point(leg.limits.upper));
    reach = leg.rod_length;
  }
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(reach);
  return {box.min() - margin, box.max() + margin};
}

/// Encloses the positions of the operational point that the leg reaches, whatever the orientation.
Eigen::AlignedBox3d positions_of(const Leg& leg, TaskSpace space) {
  const Eigen::AlignedBox3d box = anchors_of(leg);
  if (!has_rotation(space)) return {box.min() - leg.anchor, box.max() - leg.anchor};
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(leg.anchor.norm());
  return {box.min() - margin, box.max() + margin};
}

Eigen::AlignedBox3d positions_in(const Manipulator& manipulator, const std::optional<Box>& region) {
  const double infinity = std::numeric_limits<double>::infinity();
  Eigen::AlignedBox3d box(Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity));
  for (const Leg& leg : manipulator.legs())
    box = box.intersection(positions_of(leg, manipulator.task_space()));
  if (const auto& workspace = manipulator.constraints().workspace)
    box = box.intersection(Eigen::AlignedBox3d(workspace->lower, workspace->upper));
  if (region)
    for (std::size_t i = 0; i < region->dimension; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      box.min()[k] = std::max(box.min()[k], region->lower[i]);
      box.max()[k] = std::min(box.max()[k], region->upper[i]);
    }
  return box;
}

ob::RealVectorBounds bounds_of(const Manipulator& manipulator, const std::optional<Box>& region) {
  const std::size_t moved = directions(manipulator.task_space());
  if (region && region->dimension != moved)
    throw InvalidDescription({"The region has " + std::to_string(region->dimension) +
                              " coordinates; give one for each position of the task space, which are " +
                              std::to_string(moved) + "."});
  const Eigen::AlignedBox3d box = positions_in(manipulator, region);
  ob::RealVectorBounds bounds(static_cast<unsigned>(moved));
  for (std::size_t i = 0; i < moved; ++i) {
    bounds.low[i] = box.min()[static_cast<Eigen::Index>(i)];
    bounds.high[i] = box.max()[static_cast<Eigen::Index>(i)];
    if (!std::isfinite(bounds.high[i] - bounds.low[i]))
      throw InvalidDescription({"The legs of '" + manipulator.name() +
                                "' have no limits that bound the workspace; limit the actuated joints in the "
                                "URDF or give a region."});
    if (!(bounds.low[i] < bounds.high[i]))
      throw InvalidDescription({"The region, the workspace and the reach of the legs of '" +
                                manipulator.name() + "' have no position in common; give another region."});
  }
  return bounds;
}

/// In T1, T2 and T3.
template <TaskSpace space>
ob::StateSpacePtr made_of_positions(const Manipulator& manipulator, const std::optional<Box>& region) {
  auto made = std::make_shared<PoseStateSpace<space, ob::RealVectorStateSpace>>(
      static_cast<unsigned>(directions(space)));
  made->setBounds(bounds_of(manipulator, region));
  return made;
}

/// In SE2 and SE3; `radius` makes OMPL's distance of rotations metres.
template <TaskSpace space, class Base>
ob::StateSpacePtr made_of_motions(const Manipulator& manipulator, const std::optional<Box>& region,
                                  double radius) {
  auto made = std::make_shared<PoseStateSpace<space, Base>>();
  made->setBounds(bounds_of(manipulator, region));
  made->setSubspaceWeight(1, radius);
  return made;
}

ob::StateSpacePtr made(const Manipulator& manipulator, const std::optional<Box>& region) {
  const double length = manipulator.characteristic_length();
  switch (manipulator.task_space()) {
    case TaskSpace::T1:
      return made_of_positions<TaskSpace::T1>(manipulator, region);
    case TaskSpace::T2:
      return made_of_positions<TaskSpace::T2>(manipulator, region);
    case TaskSpace::SE2:
      return made_of_motions<TaskSpace::SE2, ob::SE2StateSpace>(manipulator, region, length);
    case TaskSpace::T3:
      return made_of_positions<TaskSpace::T3>(manipulator, region);
    case TaskSpace::SO3:
      return std::make_shared<PoseStateSpace<TaskSpace::SO3, ob::SO3StateSpace>>();
    case TaskSpace::R1:
    case TaskSpace::R2:
      throw InvalidDescription(
          {"OMPL's state spaces are not available for '" + manipulator.name() +
           "' yet, whose poses are angles of passive joints; plan with `aspects plan` or "
           "plan_path."});
    case TaskSpace::SE3:
      break;
  }
  // OMPL takes half the angle between two rotations.
  return made_of_motions<TaskSpace::SE3, ob::SE3StateSpace>(manipulator, region, 2.0 * length);
}

}  // namespace

ob::StateSpacePtr make_pose_state_space(const Manipulator& manipulator, const std::optional<Box>& region) {
  ob::StateSpacePtr space = made(manipulator, region);
  space->setName(manipulator.name() + " " + std::string(name(manipulator.task_space())));
  return space;
}

Pose pose_of(TaskSpace space, const ob::State& state) noexcept {
  Pose pose;
  switch (space) {
    case TaskSpace::T1:
    case TaskSpace::T2:
    case TaskSpace::T3:
      for (std::size_t i = 0; i < directions(space); ++i)
        pose.position[static_cast<Eigen::Index>(i)] = state.as<RealVectorState>()->values[i];
      return pose;
    case TaskSpace::SE2: {
      const auto& planar = *state.as<SE2State>();
      return Pose::planar(planar.getX(), planar.getY(), planar.getYaw());
    }
    case TaskSpace::SO3:
      pose.orientation = quaternion(*state.as<SO3State>());
      return pose;
    case TaskSpace::R1:
    case TaskSpace::R2:
      return pose;  // no such state is made
    case TaskSpace::SE3:
      break;
  }
  const auto& spatial = *state.as<SE3State>();
  pose.position << spatial.getX(), spatial.getY(), spatial.getZ();
  pose.orientation = quaternion(spatial.rotation());
  return pose;
}

void set_pose(TaskSpace space, const Pose& pose, ob::State& state) noexcept {
  switch (space) {
    case TaskSpace::T1:
    case TaskSpace::T2:
    case TaskSpace::T3:
      for (std::size_t i = 0; i < directions(space); ++i)
        state.as<RealVectorState>()->values[i] = pose.position[static_cast<Eigen::Index>(i)];
      return;
    case TaskSpace::SE2: {
      auto& planar = *state.as<SE2State>();
      planar.setXY(pose.position.x(), pose.position.y());
      planar.setYaw(pose_coordinates(space, pose)[2]);
      return;
    }
    case TaskSpace::SO3:
      set_quaternion(pose.orientation, *state.as<SO3State>());
      return;
    case TaskSpace::R1:
    case TaskSpace::R2:
      return;  // no such state is made
    case TaskSpace::SE3:
      break;
  }
  auto& spatial = *state.as<SE3State>();
  spatial.setXYZ(pose.position.x(), pose.position.y(), pose.position.z());
  set_quaternion(pose.orientation, spatial.rotation());
}

}  // namespace parallel_aspects
