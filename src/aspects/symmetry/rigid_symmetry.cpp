// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/rigid_symmetry.h"

#include "model/message_text.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr Eigen::Index dimensions = 3;

/// All 48 matrices that permute the axes and change their directions.
std::vector<Eigen::Matrix3d> signed_permutations() {
  std::vector<Eigen::Matrix3d> result;
  std::array<Eigen::Index, dimensions> target{0, 1, 2};
  do {
    for (unsigned negative = 0; negative < 8U; ++negative) {
      Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
      for (Eigen::Index i = 0; i < dimensions; ++i)
        matrix(target[static_cast<std::size_t>(i)], i) = (negative >> i & 1U) != 0 ? -1.0 : 1.0;
      result.push_back(matrix);
    }
  } while (std::next_permutation(target.begin(), target.end()));
  return result;
}

bool keeps_axis(const Eigen::Matrix3d& matrix, Eigen::Index axis) { return matrix(axis, axis) != 0.0; }

/// Planar robots stay in their plane and what is above it stays above; platforms of T1 stay on their line.
bool fits(TaskSpace space, const Eigen::Matrix3d& base) {
  if (is_planar(space) && base(2, 2) != 1.0) return false;
  return space != TaskSpace::T1 || keeps_axis(base, 0);
}

/// The shift that brings the image of an interval onto another; nothing where none does so exactly.
std::optional<double> find_shift(double sign, double lower, double upper, double image_lower,
                                 double image_upper) {
  const double first = sign > 0.0 ? lower : -upper, last = sign > 0.0 ? upper : -lower;
  const double shift = image_lower - first;
  const bool exact = is_exact_sum(first, shift, image_lower) && is_exact_sum(last, shift, image_upper);
  return exact ? std::optional<double>(shift) : std::nullopt;
}

bool set_shift(const Box& region, std::size_t positions, RigidSymmetry& symmetry) {
  for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(positions); ++k) {
    Eigen::Index i = 0;
    symmetry.base.col(k).cwiseAbs().maxCoeff(&i);
    const auto from = static_cast<std::size_t>(k), to = static_cast<std::size_t>(i);
    const auto shift = find_shift(symmetry.base(i, k), region.lower[from], region.upper[from],
                                  region.lower[to], region.upper[to]);
    if (!shift) return false;
    symmetry.shift[i] = *shift;
  }
  return true;
}

/// About the same axes the platform may make a half turn besides.
std::vector<RigidSymmetry> symmetries_of_rotations(const Eigen::Matrix3d& base) {
  std::vector<RigidSymmetry> result{{base, base}};
  for (Eigen::Index axis = 0; axis < dimensions; ++axis) {
    Eigen::Vector3d half_turn = Eigen::Vector3d::Constant(-1.0);
    half_turn[axis] = 1.0;
    result.push_back({base, base * half_turn.asDiagonal()});
  }
  return result;
}

}  // namespace

// Knuth's two-sum: where numbers round to nearest, `error` is exactly what the rounded sum is off by.
bool is_exact_sum(double one, double other, double sum) noexcept {
  const double rounded = one + other, other_part = rounded - one;
  const double error = (one - (rounded - other_part)) + (other - other_part);
  return rounded == sum && error == 0.0;
}

std::vector<RigidSymmetry> rigid_symmetries_without_shift(TaskSpace space) {
  std::vector<RigidSymmetry> result;
  if (space == TaskSpace::SE3 || has_hinges(space)) return result;
  for (const Eigen::Matrix3d& base : signed_permutations()) {
    if (!fits(space, base)) continue;
    if (space == TaskSpace::SO3) {
      const auto more = symmetries_of_rotations(base);
      result.insert(result.end(), more.begin(), more.end());
    } else {
      result.push_back({base, base});
    }
  }
  return result;
}

std::vector<RigidSymmetry> find_rigid_symmetries(TaskSpace space, const Box& region) {
  std::vector<RigidSymmetry> result;
  for (RigidSymmetry& symmetry : rigid_symmetries_without_shift(space))
    if (space == TaskSpace::SO3 || set_shift(region, directions(space), symmetry)) result.push_back(symmetry);
  return result;
}

std::string to_string(const RigidSymmetry& symmetry, TaskSpace space) {
  const std::size_t count = is_planar(space) ? 2 : 3;
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    Eigen::Index from = 0;
    symmetry.base.row(row).cwiseAbs().maxCoeff(&from);
    text += (i == 0 ? "(" : ", ");
    if (symmetry.shift[row] != 0.0) text += number_text(symmetry.shift[row]);
    if (symmetry.base(row, from) < 0.0)
      text += "-";
    else if (symmetry.shift[row] != 0.0)
      text += "+";
    text += "xyz"[from];
  }
  return text + ")";
}

namespace {

constexpr RootIndex quaternion_components = 4;

/// A map of quaternions that takes component c to `sign[c]` times component `to[c]`.
struct QuaternionSymmetry {
  std::array<RootIndex, quaternion_components> to{};
  std::array<bool, quaternion_components> negative{};
};

// The map multiplies by a quaternion from each side, and takes the units 1, i, j, k to units or their
// negatives since both matrices permute the axes alike. So one quaternion whose components all differ shows
// it.
QuaternionSymmetry quaternion_symmetry(const RigidSymmetry& symmetry) {
  const Eigen::Quaterniond shown = Eigen::Quaterniond(0.8, 0.1, 0.3, 0.5).normalized();
  const Eigen::Quaterniond image(
      Eigen::Matrix3d(symmetry.base * shown.toRotationMatrix() * symmetry.platform.transpose()));
  QuaternionSymmetry result;
  for (RootIndex c = 0; c < quaternion_components; ++c) {
    Eigen::Index nearest = 0;
    (image.coeffs().cwiseAbs().array() - shown.coeffs()[c]).abs().minCoeff(&nearest);
    result.to[c] = static_cast<RootIndex>(nearest);
    result.negative[c] = image.coeffs()[nearest] < 0.0;
  }
  return result;
}

}  // namespace

PoseSymmetry::PoseSymmetry(TaskSpace space, const Box& region, const RigidSymmetry& symmetry)
    : dimension_(region.dimension), region_(region) {
  if (space == TaskSpace::SO3) {
    for (RootIndex root = 0; root < quaternion_components; ++root) add(of_cube(root, symmetry));
    return;
  }
  OfRoot of_root;
  for (std::size_t i = 0; i < directions(space); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    Eigen::Index from = 0;
    symmetry.base.row(row).cwiseAbs().maxCoeff(&from);
    of_root.from[i] = static_cast<std::uint8_t>(from);
    of_root.reversed[i] = symmetry.base(row, from) < 0.0;
  }
  // A reflection of the plane turns angles around.
  if (space == TaskSpace::SE2) of_root.reversed[2] = symmetry.handedness() < 0.0;
  add(of_root);
}

// Coordinates of a cube are the components of the quaternion but that of the root, divided by it.
PoseSymmetry::OfRoot PoseSymmetry::of_cube(RootIndex root, const RigidSymmetry& symmetry) {
  const QuaternionSymmetry quaternions = quaternion_symmetry(symmetry);
  OfRoot result;
  result.root = quaternions.to[root];
  for (RootIndex c = 0; c < quaternion_components; ++c) {
    if (c == root) continue;
    const RootIndex to = quaternions.to[c];
    const std::size_t i = to < result.root ? to : to - 1;
    result.from[i] = static_cast<std::uint8_t>(c < root ? c : c - 1);
    result.reversed[i] = quaternions.negative[c] != quaternions.negative[root];
  }
  return result;
}

void PoseSymmetry::add(const OfRoot& of_root) {
  roots_.push_back(of_root);
  for (std::size_t rank = 0; rank < std::size_t{1} << dimension_; ++rank) {
    std::size_t image = 0;
    for (std::size_t i = 0; i < dimension_; ++i)
      if (((rank >> of_root.from[i] & 1U) != 0) != of_root.reversed[i]) image |= std::size_t{1} << i;
    roots_.back().ranks[rank] = static_cast<std::uint8_t>(image);
  }
}

// The region is taken onto itself exactly, so that this rounds no more than the result needs.
MapPosition PoseSymmetry::image(const MapPosition& position) const noexcept {
  const OfRoot& of_root = roots_[position.root];
  MapPosition result{of_root.root, {}};
  for (std::size_t i = 0; i < dimension_; ++i) {
    const std::size_t from = of_root.from[i];
    const double value = position.point[from];
    result.point[i] = of_root.reversed[i] ? (region_.lower[i] + region_.upper[from]) - value
                                          : value + (region_.lower[i] - region_.lower[from]);
  }
  return result;
}

Box PoseSymmetry::image(RootIndex root, const Box& box) const noexcept {
  const MapPosition first = image(MapPosition{root, box.lower}), last = image(MapPosition{root, box.upper});
  Box result = box;
  for (std::size_t i = 0; i < box.dimension; ++i) {
    result.lower[i] = std::min(first.point[i], last.point[i]);
    result.upper[i] = std::max(first.point[i], last.point[i]);
  }
  return result;
}

// Of a group only the identity is its own square.
bool PoseSymmetry::is_identity() const { return after(*this) == *this; }

PoseSymmetry PoseSymmetry::after(const PoseSymmetry& first) const {
  PoseSymmetry result = first;
  result.roots_.clear();
  for (const OfRoot& before : first.roots_) {
    const OfRoot& next = roots_[before.root];
    OfRoot both;
    both.root = next.root;
    for (std::size_t i = 0; i < dimension_; ++i) {
      both.from[i] = before.from[next.from[i]];
      both.reversed[i] = before.reversed[next.from[i]] != next.reversed[i];
    }
    result.add(both);
  }
  return result;
}

bool operator==(const PoseSymmetry& a, const PoseSymmetry& b) noexcept {
  return std::equal(a.roots_.begin(), a.roots_.end(), b.roots_.begin(), b.roots_.end(),
                    [](const auto& one, const auto& other) {
                      return one.root == other.root && one.from == other.from &&
                             one.reversed == other.reversed;
                    });
}

}  // namespace parallel_aspects
