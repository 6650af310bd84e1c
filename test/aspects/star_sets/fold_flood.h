// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ASPECTS_STARS_FOLD_FLOOD_H
#define PARALLEL_ASPECTS_TEST_ASPECTS_STARS_FOLD_FLOOD_H

#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <set>
#include <vector>

namespace parallel_aspects::test {

/// A pose of SE2 by a leg: length and direction of the vector from its base point to its anchor [m, rad], and
/// phi [rad].
struct FoldPose {
  double length = 0.0, direction = 0.0, angle = 0.0;
};

inline Eigen::Vector3d fold_displacement(const Leg& leg, const Eigen::Vector3d& at) {
  const Eigen::Rotation2Dd turn(at[2]);
  return Eigen::Vector3d(at[0], at[1], 0.0) +
         (Eigen::Vector3d() << turn * leg.anchor.head<2>(), 0.0).finished() -
         std::get<RevoluteActuation>(leg.actuation).center;
}

/// `at`: x, y [m] and phi [rad].
inline FoldPose fold_pose(const Leg& leg, const Eigen::Vector3d& at) {
  const Eigen::Vector3d d = fold_displacement(leg, at);
  return {std::hypot(d.x(), d.y()), std::atan2(d.y(), d.x()), at[2]};
}

inline Eigen::Vector3d from_fold(const Leg& leg, const FoldPose& at) {
  const Eigen::Vector3d still = fold_displacement(leg, {0.0, 0.0, at.angle});
  return {at.length * std::cos(at.direction) - still.x(), at.length * std::sin(at.direction) - still.y(),
          at.angle};
}

/// Looks for a way between two poses of a set by flooding a grid of these coordinates, each edge of it
/// halved.
class FoldFlood {
 public:
  using Node = std::array<int, 3>;

  FoldFlood(const Leg& leg, std::function<bool(const Eigen::Vector3d&)> is_in_set)
      : leg_(leg), is_in_set_(std::move(is_in_set)) {}

  bool joins(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const FoldPose first = fold_pose(leg_, from), last = fold_pose(leg_, to);
    make_grid(first, last);
    const Node start = node(first), goal = node(last);
    std::set<Node> seen{start};
    std::queue<Node> open({start});
    while (!open.empty()) {
      const Node at = open.front();
      open.pop();
      if (at == goal) return true;
      for (std::size_t i = 0; i < 3; ++i)
        for (const int step : {-1, 1}) visit(at, i, step, seen, open);
    }
    return false;
  }

 private:
  static std::vector<double> levels(double a, double b, double more, int count) {
    const double lower = std::min(a, b) - more, upper = std::max(a, b) + more;
    std::vector<double> result{a, b};
    for (int i = 0; i <= count; ++i) result.push_back(lower + (upper - lower) * i / count);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  void make_grid(const FoldPose& first, const FoldPose& last) {
    const double longest = std::max(first.length, last.length);
    values_[0] = levels(first.length, last.length, 0.0, 6);
    values_[1] = levels(first.direction, last.direction, 0.0, 0);
    for (int i = 0; i < 96; ++i) values_[1].push_back(-M_PI + 2.0 * M_PI * i / 96);
    std::sort(values_[1].begin(), values_[1].end());
    values_[1].erase(std::unique(values_[1].begin(), values_[1].end()), values_[1].end());
    values_[2] = levels(first.angle, last.angle, longest / leg_.rod_length, 24);
  }

  Node node(const FoldPose& at) const {
    const std::array<double, 3> wanted{at.length, at.direction, at.angle};
    Node result{};
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = static_cast<int>(std::lower_bound(values_[i].begin(), values_[i].end(), wanted[i]) -
                                   values_[i].begin());
    return result;
  }

  FoldPose pose(const Node& node) const {
    const auto value = [&](std::size_t i) { return values_[i][static_cast<std::size_t>(node[i])]; };
    return {value(0), value(1), value(2)};
  }

  void visit(const Node& at, std::size_t i, int step, std::set<Node>& seen, std::queue<Node>& open) {
    Node next = at;
    const int count = static_cast<int>(values_[i].size());
    next[i] += step;
    if (i == 1) next[i] = (next[i] + count) % count;
    if (next[i] < 0 || next[i] >= count || seen.count(next) > 0) return;
    const FoldPose a = pose(at), b = pose(next);
    const double turn = std::remainder(b.direction - a.direction, 2.0 * M_PI);
    const FoldPose middle{0.5 * (a.length + b.length), a.direction + 0.5 * turn, 0.5 * (a.angle + b.angle)};
    if (!is_in_set_(from_fold(leg_, middle)) || !is_in_set_(from_fold(leg_, b))) return;
    seen.insert(next);
    open.push(next);
  }

  const Leg& leg_;
  std::function<bool(const Eigen::Vector3d&)> is_in_set_;
  std::array<std::vector<double>, 3> values_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ASPECTS_STARS_FOLD_FLOOD_H
