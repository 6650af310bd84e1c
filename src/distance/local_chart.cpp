// SPDX-License-Identifier: BSD-3-Clause
#include "distance/local_chart.h"

#include "interval/rotation_rows.h"

#include <cmath>

namespace parallel_aspects {

template <TaskSpace space>
LocalChart<space>::LocalChart(const Manipulator& manipulator) : metric_(manipulator) {
  const RoundingUpward rounding;
  for (std::size_t j = 0; j < size; ++j) {
    Leg leg = manipulator.leg(j);
    leg.tolerance = 0.0;  // distances are those of the robot that is described
    legs_.emplace_back(leg);
    const Vector<Interval> anchor = interval_vector(leg.anchor), center = interval_vector(metric_.center);
    base_points_[j] = interval_vector(leg.base_point());
    for (std::size_t i = 0; i < dimension; ++i) {
      platform_arms_[j][i] = anchor[i] - center[i];
      squared_arms_[j] += square(platform_arms_[j][i]);
    }
    turning_[j] = metric_.turning(leg.anchor);
  }
}

template <TaskSpace space>
typename LocalChart<space>::template Vector<Interval> LocalChart<space>::interval_vector(
    const Eigen::Vector3d& vector) noexcept {
  Vector<Interval> result;
  for (std::size_t i = 0; i < dimension; ++i) result[i] = Interval(vector[static_cast<Eigen::Index>(i)]);
  return result;
}

template <TaskSpace space>
void LocalChart<space>::move_to(const Pose& pose) noexcept {
  assert_rounding_upward();
  pose_ = pose;
  const RotationRows<Interval> rows = enclosed_rotation(pose.orientation);
  for (std::size_t i = 0; i < dimension; ++i)
    for (std::size_t k = 0; k < dimension; ++k) rotation_[i][k] = rows[i][k];
  const auto turned = [this](const Vector<Interval>& vector) {
    Vector<Interval> result;
    for (std::size_t i = 0; i < dimension; ++i)
      for (std::size_t k = 0; k < dimension; ++k) result[i] += rotation_[i][k] * vector[k];
    return result;
  };
  center_at_pose_ = pose.orientation.normalized() * metric_.center;
  const Vector<Interval> position = interval_vector(pose.position);
  const Vector<Interval> center = turned(interval_vector(metric_.center));
  center_ = center;
  for (std::size_t j = 0; j < size; ++j) {
    arms_[j] = turned(platform_arms_[j]);
    squared_offsets_[j] = Interval(0.0);
    for (std::size_t i = 0; i < dimension; ++i) {
      offsets_[j][i] = position[i] + center[i] - base_points_[j][i];
      squared_offsets_[j] += square(offsets_[j][i]);
      displacements_[j][i] = offsets_[j][i] + arms_[j][i];
    }
  }
  turn_half_turns();
}

template <TaskSpace space>
void LocalChart<space>::turn_half_turns() noexcept {
  half_turns_at_pose_ = 0.5 * (pose_.orientation.normalized().toRotationMatrix() * metric_.half_turns);
  const Interval half(0.5);
  if constexpr (dimension == 2) half_turns_[2][2] = half * Interval(metric_.half_turns(2, 2));
  if constexpr (dimension == 3) {
    const Interval root_of_two = square_root(Interval(2.0));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        half_turns_[i][k] = Interval(0.0);
        for (std::size_t a = 0; a < 3; ++a)
          half_turns_[i][k] +=
              half * rotation_[i][a] *
              Interval(metric_.half_turns(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(k)));
        longer_half_turns_[i][k] = root_of_two * half_turns_[i][k];
      }
  }
}

template <TaskSpace space>
typename LocalChart<space>::template Vector<Interval> LocalChart<space>::operational_point(
    const std::array<Interval, size>& y) const noexcept {
  Vector<Interval> point = interval_vector(pose_.position);
  for (std::size_t i = 0; i < moves; ++i) point[i] += y[i];
  if constexpr (turns > 0) {
    const Rotation<Interval> turned = rotation(y.data() + moves);
    for (std::size_t i = 0; i < dimension; ++i) {
      point[i] += center_[i];
      for (std::size_t k = 0; k < dimension; ++k) point[i] += -(turned[i][k] * center_[k]);
    }
  }
  return point;
}

template <TaskSpace space>
Pose LocalChart<space>::pose_at(const Coordinates<size>& y) const noexcept {
  Pose pose = pose_;
  if constexpr (turns > 0) {
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < turns; ++i) turn[static_cast<Eigen::Index>(3 - turns + i)] = y[moves + i];
    const Eigen::Vector3d v = half_turns_at_pose_ * turn;
    const Eigen::Quaterniond by(std::sqrt(std::max(0.0, 1.0 - v.squaredNorm())), v.x(), v.y(), v.z());
    pose.orientation = (by.normalized() * pose_.orientation).normalized();
  }
  if constexpr (moves > 0) {
    Eigen::Vector3d move = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < moves; ++i) move[static_cast<Eigen::Index>(i)] = y[i];
    const Eigen::Vector3d center = pose.orientation * metric_.center;
    pose.position = pose_.position + move + (center_at_pose_ - center);
  }
  return pose;
}

template <TaskSpace space>
TaskVector LocalChart<space>::direction_to(const Coordinates<size>& y) const noexcept {
  const double length = std::sqrt(dot<size>(y, y));
  Eigen::Vector3d move = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
  if (length > 0.0) {
    for (std::size_t i = 0; i < moves; ++i) move[static_cast<Eigen::Index>(i)] = y[i] / length;
    for (std::size_t i = 0; i < turns; ++i)
      turn[static_cast<Eigen::Index>(3 - turns + i)] = y[moves + i] / length;
  }
  const Eigen::Vector3d rate = 2.0 * (half_turns_at_pose_ * turn);
  const Eigen::Vector3d velocity = move - rate.cross(center_at_pose_);
  TaskVector twist(static_cast<Eigen::Index>(size));
  if constexpr (turns == 1) twist[0] = rate.z();
  if constexpr (turns == 3) twist.head<3>() = rate;
  for (std::size_t i = 0; i < moves; ++i)
    twist[static_cast<Eigen::Index>(turns + i)] = velocity[static_cast<Eigen::Index>(i)];
  return twist;
}

template <TaskSpace space>
Coordinates<LocalChart<space>::size> LocalChart<space>::rate_of(const TaskVector& twist) const noexcept {
  Eigen::Vector3d rate = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
  if constexpr (turns == 1) rate.z() = twist[0];
  if constexpr (turns == 3) rate = twist.head<3>();
  for (std::size_t i = 0; i < moves; ++i)
    velocity[static_cast<Eigen::Index>(i)] = twist[static_cast<Eigen::Index>(turns + i)];
  const Eigen::Vector3d move = velocity + rate.cross(center_at_pose_);
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  if constexpr (turns == 1) turn.z() = rate.z() / (2.0 * half_turns_at_pose_(2, 2));
  if constexpr (turns == 3) turn = half_turns_at_pose_.inverse() * (0.5 * rate);
  Coordinates<size> result{};
  for (std::size_t i = 0; i < moves; ++i) result[i] = move[static_cast<Eigen::Index>(i)];
  for (std::size_t i = 0; i < turns; ++i) result[moves + i] = turn[static_cast<Eigen::Index>(3 - turns + i)];
  return result;
}

template class LocalChart<TaskSpace::T1>;
template class LocalChart<TaskSpace::T2>;
template class LocalChart<TaskSpace::SE2>;
template class LocalChart<TaskSpace::T3>;
template class LocalChart<TaskSpace::SO3>;
template class LocalChart<TaskSpace::SE3>;

}  // namespace parallel_aspects
