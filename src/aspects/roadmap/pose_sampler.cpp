// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/pose_sampler.h"

#include "model/overloaded.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

Eigen::AlignedBox3d around(const Eigen::Vector3d& center, double reach) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach);
  return {center - half, center + half};
}

// Proximal points on a line, and the rod beyond. A direction that does not move a coordinate leaves it.
Eigen::AlignedBox3d around(const PrismaticActuation& actuation, const Leg& leg) {
  Eigen::AlignedBox3d box = around(actuation.origin, leg.rod_length);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double direction = actuation.direction[i];
    if (direction == 0.0) continue;
    const double one_end = direction * leg.limits.lower, other_end = direction * leg.limits.upper;
    box.min()[i] += std::min(one_end, other_end);
    box.max()[i] += std::max(one_end, other_end);
  }
  return box;
}

Eigen::AlignedBox3d anchor_box(const Leg& leg) {
  const Eigen::AlignedBox3d ball = around(leg.base_point(), leg.longest_reach());
  return std::visit(Overloaded{[&ball](const RevoluteActuation&) { return ball; },
                               [&leg](const PrismaticActuation& rail) { return around(rail, leg); },
                               [&ball](const StrutActuation&) { return ball; },
                               [&ball](const ElbowActuation&) { return ball; }},
                    leg.actuation);
}

}  // namespace

PoseSampler::PoseSampler(std::shared_ptr<const Manipulator> manipulator, std::uint64_t seed,
                         const std::optional<Box>& region, double largest_rotation)
    : manipulator_(std::move(manipulator)), largest_rotation_(largest_rotation), engine_(seed) {
  for (const Leg& leg : manipulator_->legs()) anchor_boxes_.push_back(anchor_box(leg));
  region_.min().setConstant(-std::numeric_limits<double>::infinity());
  region_.max().setConstant(std::numeric_limits<double>::infinity());
  const auto& workspace = manipulator_->constraints().workspace;
  if (workspace) region_ = Positions(workspace->lower, workspace->upper);
  const auto moved = static_cast<Eigen::Index>(directions(manipulator_->task_space()));
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i >= moved)
      region_.min()[i] = region_.max()[i] = 0.0;
    else if (region) {
      region_.min()[i] = std::max(region_.min()[i], region->lower[static_cast<std::size_t>(i)]);
      region_.max()[i] = std::min(region_.max()[i], region->upper[static_cast<std::size_t>(i)]);
    }
  }
}

// Turning the platform moves the box, but does not open it.
bool PoseSampler::is_bounded() const {
  const Positions box = positions(Eigen::Quaterniond::Identity());
  return box.min().allFinite() && box.max().allFinite();
}

double PoseSampler::uniform(double lower, double upper) {
  // 53 bits, the same on every platform.
  return lower + (upper - lower) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
}

Eigen::Quaterniond PoseSampler::orientation() {
  const TaskSpace space = manipulator_->task_space();
  if (!has_rotation(space)) return Eigen::Quaterniond::Identity();
  const double largest = std::min(largest_rotation_, static_cast<double>(EIGEN_PI));
  if (space == TaskSpace::SE2)
    return Eigen::Quaterniond(Eigen::AngleAxisd(largest * uniform(-1.0, 1.0), Eigen::Vector3d::UnitZ()));
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle(largest), axis()));
}

// Uniform orientations have angles with a density that goes with the squared sine of their half.
double PoseSampler::angle(double largest) {
  const auto density = [](double angle) { return std::pow(std::sin(0.5 * angle), 2); };
  while (true) {
    const double angle = largest * uniform(0.0, 1.0);
    if (uniform(0.0, 1.0) * density(largest) <= density(angle)) return angle;
  }
}

Eigen::Vector3d PoseSampler::axis() {
  while (true) {
    const Eigen::Vector3d point(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
    const double length = point.norm();
    if (length <= 1.0 && length > 0.1) return point / length;
  }
}

PoseSampler::Positions PoseSampler::positions(const Eigen::Quaterniond& orientation) const {
  Positions box = region_;
  for (std::size_t j = 0; j < anchor_boxes_.size(); ++j) {
    const Eigen::Vector3d anchor = orientation * manipulator_->leg(j).anchor;
    box = box.intersection(Positions(anchor_boxes_[j]).translate(-anchor));
  }
  return box;
}

std::optional<Pose> PoseSampler::at_random_angles() {
  const double largest = std::min(largest_rotation_, static_cast<double>(EIGEN_PI));
  PoseCoordinates angles(static_cast<Eigen::Index>(manipulator_->leg_count()));
  for (Eigen::Index i = 0; i < angles.size(); ++i) angles[i] = largest * uniform(-1.0, 1.0);
  return pose_from_coordinates(manipulator_->motions(), angles);
}

std::optional<Pose> PoseSampler::draw() {
  if (has_hinges(manipulator_->task_space())) return at_random_angles();
  Pose pose;
  pose.orientation = orientation();
  if (!has_translation(manipulator_->task_space())) return pose;
  const Positions box = positions(pose.orientation);
  if (!(box.min().array() <= box.max().array()).all()) return std::nullopt;
  for (Eigen::Index i = 0; i < 3; ++i) pose.position[i] = uniform(box.min()[i], box.max()[i]);
  return pose;
}

}  // namespace parallel_aspects
