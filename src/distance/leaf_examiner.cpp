// SPDX-License-Identifier: BSD-3-Clause
#include "distance/leaf_examiner.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

// Takes rounding errors of some dozens of operations along.
constexpr double widened = 1.0 + 0x1p-40;

float nearest_float(double value) noexcept { return static_cast<float>(value); }

}  // namespace

template <TaskSpace space>
void LeafExaminer<space>::look_at(RootIndex root, const Box& box) noexcept {
  assert_rounding_upward();
  edges_ = {};
  if constexpr (turns == 0) enclose_positions(box);
  if constexpr (space == TaskSpace::SE2) enclose_motions(box);
  if constexpr (space == TaskSpace::SO3) enclose_rotations(root, box);
  std::array<typename ModeDeterminant<space>::CellForm, size> y;
  double squares = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    using Form = typename ModeDeterminant<space>::CellForm;
    double farthest = 0.0;
    for (std::size_t k = 0; k < size; ++k) {
      if (edges_[i][k] == 0.0) continue;
      y[i] += Form::coordinate(0.0, edges_[i][k], k);
      farthest += std::abs(edges_[i][k]);
    }
    squares += farthest * farthest;
  }
  radius_ = static_cast<float>(std::sqrt(squares) * widened);
  reached_ = determinant_.find_legs(y, unit_cell_, everywhere, legs_, over_);
  static_cast<void>(root);
}

template <TaskSpace space>
double LeafExaminer<space>::half_width_about(const Box& box, std::size_t i) const noexcept {
  const double middle = chart_.pose().position[static_cast<Eigen::Index>(i)];
  return std::max(box.upper[i] - middle, middle - box.lower[i]);
}

template <TaskSpace space>
void LeafExaminer<space>::enclose_positions(const Box& box) noexcept {
  for (std::size_t i = 0; i < size; ++i)
    center_[i] = nearest_float(box.center(i) + chart_.metric().center[static_cast<Eigen::Index>(i)]);
  chart_.move_to(pose_of<space>(center_, chart_.metric()));
  for (std::size_t i = 0; i < size; ++i) edges_[i][i] = half_width_about(box, i) * widened;
}

// With m the vector from the operational point to the centroid and v the sine of half the angle, the centroid
// moves by as much as the operational point and (-2 v^2 m_x - 2 v w m_y, 2 v w m_x - 2 v^2 m_y): by
// 2 v (-m_y, m_x), but for 2 v^2 |m| + |v|^3 |m|.
template <TaskSpace space>
void LeafExaminer<space>::enclose_motions(const Box& box) noexcept {
  const double half_angle = 0.5 * EIGEN_PI * box.center(2);
  center_[2] = nearest_float(std::sin(half_angle));
  center_[3] = nearest_float(std::cos(half_angle));
  Pose turned;
  turned.orientation = Eigen::Quaterniond(center_[3], 0.0, 0.0, center_[2]).normalized();
  const Eigen::Vector3d at_center = turned.orientation * chart_.metric().center;
  for (std::size_t i = 0; i < 2; ++i)
    center_[i] = nearest_float(box.center(i) + at_center[static_cast<Eigen::Index>(i)]);
  chart_.move_to(pose_of<space>(center_, chart_.metric()));
  const double at = std::atan2(static_cast<double>(center_[2]), static_cast<double>(center_[3]));
  // An arc tangent of the C library is off by a few units in the last place, which here is at most 2^-52,
  // also where rounding is upward. This is 256 of them, and nothing beside the size of a leaf.
  const Interval half_pi = Interval(0.5) * pi_enclosure();
  const Interval turn = half_pi * Interval(box.lower[2], box.upper[2]) - Interval(at) +
                        Interval(-16.0 * few_units, 16.0 * few_units);
  const double v = std::min(1.0, std::max(-turn.lower(), turn.upper())) * widened;
  const Eigen::Vector3d& m = chart_.center_at_pose();
  const double beside = (2.0 * v * v + v * v * v) * m.norm() + 0x1p-40 * m.norm();
  for (std::size_t i = 0; i < 2; ++i) edges_[i][i] = (half_width_about(box, i) + beside) * widened;
  edges_[0][size - 1] = -2.0 * v * m.y();
  edges_[1][size - 1] = 2.0 * v * m.x();
  edges_[size - 1][size - 1] = 2.0 * v / chart_.metric().half_turns(2, 2) * widened;
}

// The vector part of the unit quaternion from the center, by affine arithmetic; what is not linear in it is
// made up for by longer edges.
template <TaskSpace space>
void LeafExaminer<space>::enclose_rotations(RootIndex root, const Box& box) noexcept {
  using Form = Affine<3>;
  std::array<Form, 4> q;
  Eigen::Vector4d middle;
  for (std::size_t component = 0, i = 0; component < 4; ++component) {
    const bool is_root = component == root;
    q[component] = is_root ? Form(1.0) : Form::coordinate(Interval(box.lower[i], box.upper[i]), i);
    middle[static_cast<Eigen::Index>(component)] = is_root ? 1.0 : box.center(i);
    if (!is_root) ++i;
  }
  middle.normalize();
  for (std::size_t i = 0; i < 4; ++i) center_[i] = nearest_float(middle[static_cast<Eigen::Index>(i)]);
  const Pose pose = pose_of<space>(center_, chart_.metric());
  chart_.move_to(pose);
  const auto& c = pose.orientation;
  const Form x(c.x()), y(c.y()), z(c.z()), w(c.w());
  const Form squared = square(q[0]) + square(q[1]) + square(q[2]) + square(q[3]);
  const Form share = reciprocal(square_root(squared, 1.0), 1.0);
  const std::array<Form, 3> v{share * (w * q[0] - x * q[3] - (y * q[2] - z * q[1])),
                              share * (w * q[1] - y * q[3] - (z * q[0] - x * q[2])),
                              share * (w * q[2] - z * q[3] - (x * q[1] - y * q[0]))};
  Eigen::Matrix3d slopes;
  Eigen::Vector3d rest;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < 3; ++k) slopes(row, static_cast<Eigen::Index>(k)) = v[i].slope(k);
    // The center was divided by its length: it is a unit quaternion to 2^-50, and with it v. This is 2^-42.
    rest[row] = std::abs(v[i].center()) + v[i].error() + 64.0 * few_units;
  }
  const Eigen::Matrix3d edges = 2.0 * chart_.metric().half_turns.inverse() * slopes;
  const Eigen::Vector3d longer = lengthening(edges, slopes, rest);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      edges_[i][k] = edges(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) *
                     (1.0 + longer[static_cast<Eigen::Index>(k)]) * widened;
}

// With H half the matrix `half_turns`, v = slopes e + rest = H edges e' for
// e' = e + (slopes + error)^-1 (rest - error e), where error = H edges - slopes comes from rounding.
template <TaskSpace space>
Eigen::Vector3d LeafExaminer<space>::lengthening(const Eigen::Matrix3d& edges, const Eigen::Matrix3d& slopes,
                                                 const Eigen::Vector3d& rest) const noexcept {
  Eigen::Matrix3d error;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k) {
      Interval entry = -Interval(slopes(i, k));
      for (Eigen::Index a = 0; a < 3; ++a)
        entry += Interval(0.5) * Interval(chart_.metric().half_turns(i, a)) * Interval(edges(a, k));
      error(i, k) = absolute(entry).upper();
    }
  const Eigen::Matrix3d inverse = slopes.inverse().cwiseAbs() * widened;
  const double share = (inverse * error).rowwise().sum().maxCoeff();
  const Eigen::Vector3d longer = inverse * (rest + error.rowwise().sum());
  return share < 0.5 ? Eigen::Vector3d(longer * (1.0 + 2.0 * share)) : Eigen::Vector3d::Constant(1e9);
}

template <TaskSpace space>
std::optional<SingularLeaf> LeafExaminer<space>::leaf(const WorkingMode& mode) noexcept {
  if (!reached_) return std::nullopt;
  determinant_.set_mode(mode);
  determinant_.find_determinant(legs_, over_);
  if (over_.is_free_by_norm(unit_cell_, everywhere)) return std::nullopt;
  const Affine<size>& value = over_.determinant;
  const Interval range = value.range();
  if (range.positive() || range.negative()) return std::nullopt;
  for (const Affine<size>& signed_value : {value, -value})
    if (over_.is_positive_where_reached(signed_value, unit_cell_, everywhere)) return std::nullopt;
  SingularLeaf leaf;
  leaf.center = center_;
  leaf.radius = radius_;
  set_plane(value, leaf);
  if (over_.has_norm) set_plane(over_.norm, leaf);
  if (std::abs(leaf.offset) - leaf.thickness > radius_) return std::nullopt;
  return leaf;
}

// With value = a + g . e within an error and y = L e, zeros have n . y = -a within it for n = L^-T g. Keeps
// the thinner of the present plane and this.
template <TaskSpace space>
void LeafExaminer<space>::set_plane(const Affine<size>& value, SingularLeaf& leaf) const noexcept {
  constexpr int order = static_cast<int>(size);
  Eigen::Matrix<double, order, order> edges;
  Eigen::Matrix<double, order, 1> slopes;
  for (std::size_t i = 0; i < size; ++i) {
    slopes[static_cast<Eigen::Index>(i)] = value.slope(i);
    for (std::size_t k = 0; k < size; ++k)
      edges(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = edges_[i][k];
  }
  const Eigen::Matrix<double, order, 1> normal = edges.inverse().transpose() * slopes;
  const double steepness = normal.norm();
  if (!(steepness > 0.0) || !std::isfinite(steepness)) return;
  SingularLeaf plane = leaf;
  const double scale = 1.0 / steepness;
  std::array<Interval, size> unit;  // as it is kept
  for (std::size_t i = 0; i < size; ++i) {
    plane.normal[i] = static_cast<float>(scale * normal[static_cast<Eigen::Index>(i)]);
    unit[i] = Interval(static_cast<double>(plane.normal[i]));
  }
  plane.offset = static_cast<float>(-scale * value.center());
  // scale value = (scale a + offset) + (scale g - L^T unit) . e + (unit . y - offset) within scale error.
  Interval rest =
      absolute(Interval(scale) * Interval(value.center()) + Interval(static_cast<double>(plane.offset))) +
      Interval(scale) * Interval(value.error());
  for (std::size_t k = 0; k < size; ++k) {
    Interval slope = Interval(scale) * Interval(value.slope(k));
    for (std::size_t i = 0; i < size; ++i) slope += -(Interval(edges_[i][k]) * unit[i]);
    rest += absolute(slope);
  }
  plane.thickness = static_cast<float>(rest.upper());
  if (plane.thickness < (leaf.has_plane() ? leaf.thickness : radius_)) leaf = plane;
}

template class LeafExaminer<TaskSpace::T1>;
template class LeafExaminer<TaskSpace::T2>;
template class LeafExaminer<TaskSpace::SE2>;
template class LeafExaminer<TaskSpace::T3>;
template class LeafExaminer<TaskSpace::SO3>;

}  // namespace parallel_aspects
