// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/fold.h"

#include "interval/path_form.h"
#include "legs/spatial_leg.h"
#include "model/linear_algebra.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Coefficients = std::array<Interval, 6>;

Interval times(double factor, const Interval& a) { return Interval(factor) * a; }

// With velocities and accelerations over s, that is times T and T^2.
Coefficients quintic(const Interval& q0, const Interval& q1, const Interval& v0, const Interval& v1,
                     const Interval& a0, const Interval& a1) {
  const Interval rise = q1 - q0;
  return {q0,
          v0,
          times(0.5, a0),
          times(10.0, rise) - times(6.0, v0) - times(4.0, v1) - times(1.5, a0) + times(0.5, a1),
          times(-15.0, rise) + times(8.0, v0) + times(7.0, v1) + times(1.5, a0) - a1,
          times(6.0, rise) - times(3.0, v0) - times(3.0, v1) - times(0.5, a0) + times(0.5, a1)};
}

Coefficients cubic(const Interval& q0, const Interval& q1, const Interval& v0, const Interval& v1) {
  const Interval rise = q1 - q0;
  return {q0,           v0, times(3.0, rise) - times(2.0, v0) - v1, v0 + v1 - times(2.0, rise), Interval(0.0),
          Interval(0.0)};
}

Coefficients straight(const Interval& q0, const Interval& q1) {
  return {q0, q1 - q0, Interval(0.0), Interval(0.0), Interval(0.0), Interval(0.0)};
}

}  // namespace

JointPath::JointPath(const JointWaypoint& from, const JointWaypoint& to) noexcept {
  assert_rounding_upward();
  const Interval duration = Interval(to.time) - Interval(from.time);
  const bool has_velocities = from.velocity.size() > 0 && to.velocity.size() > 0;
  const bool has_accelerations = has_velocities && from.acceleration.size() > 0 && to.acceleration.size() > 0;
  for (Eigen::Index j = 0; j < from.q.size(); ++j) {
    const Interval q0(from.q[j]), q1(to.q[j]);
    Coefficients& coefficients = coefficients_[static_cast<std::size_t>(j)];
    coefficients = straight(q0, q1);
    if (!has_velocities) continue;
    const Interval v0 = duration * Interval(from.velocity[j]), v1 = duration * Interval(to.velocity[j]);
    coefficients = cubic(q0, q1, v0, v1);
    if (has_accelerations)
      coefficients = quintic(q0, q1, v0, v1, square(duration) * Interval(from.acceleration[j]),
                             square(duration) * Interval(to.acceleration[j]));
  }
}

Interval JointPath::value(std::size_t leg, double s) const noexcept {
  Interval sum(0.0);
  for (std::size_t k = 6; k-- > 0;) sum = sum * Interval(s) + coefficients_[leg][k];
  return sum;
}

// Expanded about the middle of the range, so that it is tight to the second order.
Interval JointPath::slope(std::size_t leg, const Interval& s) const noexcept {
  const Interval middle(0.5 * (s.lower() + s.upper()));
  Interval sum(0.0);
  for (std::size_t k = 6; k-- > 1;) sum = sum * middle + times(static_cast<double>(k), coefficients_[leg][k]);
  return sum + second(leg, s) * (s - middle);
}

Interval JointPath::second(std::size_t leg, const Interval& s) const noexcept {
  Interval sum(0.0);
  for (std::size_t k = 6; k-- > 2;)
    sum = sum * s + times(static_cast<double>(k * (k - 1)), coefficients_[leg][k]);
  return sum;
}

// The chord of a function whose second derivative is at most m is off by at most m h^2 / 8.
double JointPath::bend(std::size_t leg, double begin, double end) const noexcept {
  const Interval length = Interval(end) - Interval(begin);
  return (Interval(0.125 * magnitude(second(leg, Interval(begin, end)))) * square(length)).upper();
}

namespace {

constexpr int most_arcs = 2000;
constexpr int most_halvings = 12;

// Length of the first arc, over the size of the robot; arcs grow as far as they can be proved.
constexpr double first_length = 0x1p-24;

// How far along an arc the next one starts: distances are rounded up.
constexpr double taken = 0.9;

constexpr double largest_turn = 3.0;  // where exponential coordinates are one to one
constexpr double down = 1.0 - few_units;

// Newton's steps across the curve, from a point near it.
constexpr int newton_steps = 4;

double norm_of(const double* bounds, std::size_t count) {
  double squared = 0.0;
  for (std::size_t i = 0; i < count; ++i) squared += bounds[i] * bounds[i];
  return std::sqrt(squared);
}

}  // namespace

FoldProof::FoldProof(const Manipulator& manipulator, const PoseCertifier& poses,
                     const JointPath& path) noexcept
    : motions_(manipulator.motions()),
      poses_(poses),
      path_(path),
      size_(manipulator.leg_count()),
      rotational_(rotational_degrees_of_freedom(motions_.space)),
      length_(manipulator.characteristic_length()),
      robot_size_(manipulator.size()),
      bounds_(anchor_bounds(manipulator)) {
  assert_rounding_upward();
  for (std::size_t j = 0; j < size_; ++j) legs_[j] = LegForm(manipulator.leg(j));
}

// Chosen so that the column of z is about as long as those of xi.
double FoldProof::find_scale(const CertifiedPoint& at, double share) const noexcept {
  double scale = 0.0;
  for (std::size_t j = 0; j < size_; ++j)
    scale = std::max(
        scale, magnitude(at.inverse_diagonal[j]) * magnitude(path_.slope(j, Interval(share))) / at.rod[j]);
  return scale;
}

/// The difference of q_j and `q`, a number in the middle of its range.
Interval FoldProof::middle_of(std::size_t leg, double share, double& q) const noexcept {
  const Interval value = path_.value(leg, share);
  q = 0.5 * (value.lower() + value.upper());
  return value - Interval(q);
}

// The deviation of q_j from its middle counts to the first order in the rows, and to the second in F.
FoldProof::System FoldProof::enclose(Point& point) const noexcept {
  System system;
  const EnclosedPose pose = enclosed_pose(motions_, point.pose);
  const Interval over_length = reciprocal(Interval(length_)), over_scale = reciprocal(Interval(scale_));
  for (std::size_t j = 0; j < size_; ++j) {
    double q = 0.0;
    const Interval change = middle_of(j, point.share, q);
    const LegEnclosure leg = legs_[j].enclose(pose, q);
    const double off = magnitude(change), moved = legs_[j].point_speed() * off;
    point.rod[j] = square_root(squared_norm(leg.u)).upper() + moved;
    const double curved = legs_[j].joint_curvature(point.rod[j]) * off, tilted = bounds_.lever[j] * moved;
    const Interval entry = leg.inverse_diagonal + Interval(-curved, curved);
    point.entry[j] = magnitude(entry);
    std::array<Interval, max_legs> row;
    write_homogenised_row(motions_.space, leg.lever, leg.u, over_length, row);
    for (std::size_t k = 0; k < size_; ++k) system.matrix[j][k] = row[k] + Interval(-tilted, tilted);
    system.matrix[j][size_] = -(entry * path_.slope(j, Interval(point.share)) * over_scale);
    system.residual[j] = leg.half_residual - entry * change;
  }
  for (std::size_t k = 0; k <= size_; ++k)
    system.matrix[size_][k] = Interval(point.tangent[static_cast<Eigen::Index>(k)]);
  system.residual[size_] = Interval(0.0);
  return system;
}

// g by the Frobenius norm.
bool FoldProof::evaluate(Point& point) const noexcept {
  const System system = enclose(point);
  const auto n = static_cast<Eigen::Index>(size_ + 1);
  Matrix middle(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const Interval& entry = system.matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      middle(i, k) = 0.5 * (entry.lower() + entry.upper());
    }
  if (!middle.allFinite()) return false;
  point.inverse = inverse(middle);
  if (!point.inverse.allFinite()) return false;
  double squared_defect = 0.0, squared_residual = 0.0;
  for (std::size_t i = 0; i <= size_; ++i) {
    Interval corrected(0.0);
    for (std::size_t k = 0; k <= size_; ++k) {
      Interval entry(i == k ? -1.0 : 0.0);
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = 0; j <= size_; ++j)
        entry += system.matrix[j][k] * Interval(point.inverse(row, static_cast<Eigen::Index>(j)));
      squared_defect += magnitude(entry) * magnitude(entry);
      corrected += system.residual[k] * Interval(point.inverse(row, static_cast<Eigen::Index>(k)));
    }
    squared_residual += magnitude(corrected) * magnitude(corrected);
  }
  point.defect = std::sqrt(squared_defect);
  point.residual = std::sqrt(squared_residual);
  return std::isfinite(point.defect) && std::isfinite(point.residual);
}

/// With the tangent of the curve at the point, on the side of `onward`; not longer than 1.
bool FoldProof::prepare(Point& point, const Vector& onward) const noexcept {
  point.tangent = onward;
  const System system = enclose(point);
  const auto n = static_cast<Eigen::Index>(size_);
  TallMatrix columns(n + 1, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k <= n; ++k) {
      const Interval& entry = system.matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      columns(k, i) = 0.5 * (entry.lower() + entry.upper());
    }
  if (!columns.allFinite()) return false;
  const Vector along = line_of_solutions(columns, TaskVector::Zero(n)).along;
  point.tangent = (along.dot(onward) < 0.0 ? -down : down) / along.norm() * along;
  return evaluate(point);
}

FoldProof::Point FoldProof::moved(const Point& point, const Vector& step) const noexcept {
  Point result = point;
  TaskVector twist = step.head(static_cast<Eigen::Index>(size_));
  twist.head(static_cast<Eigen::Index>(rotational_)) /= length_;
  result.pose = displaced(motions_, point.pose, twist);
  result.share = point.share + step[static_cast<Eigen::Index>(size_)] / scale_;
  return result;
}

// D^2 H in unit vectors (xi, z): D^2 F in the pose, twice the mixed part with 2 |xi| |z| <= 1, and the second
// derivative along the path.
double FoldProof::lipschitz(const Point& point, double radius) const noexcept {
  const double reach = radius / scale_;
  const Interval shares = Interval(point.share) + Interval(-reach, reach);
  LegBounds second{};
  for (std::size_t j = 0; j < size_; ++j) {
    const double slope = magnitude(path_.slope(j, shares)), curvature = magnitude(path_.second(j, shares));
    const double change = slope * reach, speed = legs_[j].point_speed();
    const double rod = point.rod[j] + bounds_.lever[j] * radius + speed * change;
    const double joint = legs_[j].joint_curvature(rod);
    const double entry = point.entry[j] + speed * bounds_.lever[j] * radius + joint * change;
    second[j] = bounds_.lever[j] * bounds_.lever[j] + rod * bounds_.bend[j] +
                speed * bounds_.lever[j] * slope / scale_ +
                (joint * slope * slope + entry * curvature) / scale_ / scale_;
  }
  std::array<double, most> bounds{};
  for (std::size_t i = 0; i <= size_; ++i)
    for (std::size_t j = 0; j < size_; ++j)
      bounds[i] +=
          std::abs(point.inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))) * second[j];
  return norm_of(bounds.data(), size_ + 1);
}

// On the arc dzeta/dtau = (C DH)^-1 C e, which is C e up to the share lost / (1 - lost) of its length.
std::optional<FoldProof::Arc> FoldProof::arc(const Point& point, double length) const noexcept {
  const auto last = static_cast<Eigen::Index>(size_);
  const double gain = -(point.defect - 1.0);  // rounded down: 1 - g
  if (!(gain > 0.0)) return std::nullopt;
  const Vector onward = point.inverse.col(last);
  std::array<double, most> entries{};
  for (std::size_t i = 0; i <= size_; ++i) entries[i] = std::abs(onward[static_cast<Eigen::Index>(i)]);
  const double speed = norm_of(entries.data(), size_ + 1);
  const double moved = point.residual + speed * length;
  const double radius = 2.0 * moved / gain;
  const double k = lipschitz(point, radius), bent = k * radius;
  const double kept = -(-gain * radius);  // rounded down
  if (!(bent < gain && moved + 0.5 * bent * radius <= kept)) return std::nullopt;
  if (rotational_ > 0 && radius > largest_turn * length_) return std::nullopt;
  const double lost = point.defect + bent;
  const double left = -(lost - 1.0);
  const double still = 2.0 * point.residual / gain;
  return Arc{radius, (still + (entries[size_] + speed * (lost / left)) * length) / scale_};
}

double FoldProof::distance(const Point& a, const Point& b) const noexcept {
  const double apart = poses_.distance(a.pose, b.pose);
  const double along = scale_ * std::max(a.share - b.share, b.share - a.share);
  return std::sqrt(apart * apart + along * along);
}

/// A point of the curve on the arc of this length from another one, proved to be on it.
std::optional<FoldProof::Point> FoldProof::next(const Point& point, double length,
                                                double radius) const noexcept {
  const auto n = static_cast<Eigen::Index>(size_);
  Point there = moved(point, taken * length * point.tangent);
  for (int i = 0; i < newton_steps; ++i) {
    const System system = enclose(there);
    Vector off(n + 1);
    for (Eigen::Index k = 0; k <= n; ++k) {
      const Interval& entry = system.residual[static_cast<std::size_t>(k)];
      off[k] = 0.5 * (entry.lower() + entry.upper());
    }
    there = moved(there, -(point.inverse * off));
    if (!std::isfinite(there.share) || !there.pose.position.allFinite()) return std::nullopt;
  }
  if (!(std::abs(there.pose.orientation.squaredNorm() - 1.0) < few_units)) return std::nullopt;
  if (!prepare(there, point.tangent)) return std::nullopt;
  const std::optional<Arc> still = arc(there, 0.0);
  if (!still || !(distance(point, there) + still->radius <= std::min(length, radius))) return std::nullopt;
  return there;
}

/// Of the solution of the curve at the point; 0 where it is not proved. D exp has a positive determinant, so
/// that of DF has the sign of det A; the rows of DF change with the pose by D^2 F, and with the joints.
int FoldProof::determinant_sign(Point point) const noexcept {
  const std::optional<Arc> still = arc(point, 0.0);
  if (!still) return 0;
  const System system = enclose(point);
  const Interval shares = Interval(point.share) + Interval(-still->drift, still->drift);
  SquareArray<Interval> matrix;
  for (std::size_t j = 0; j < size_; ++j) {
    const double moved = legs_[j].point_speed() * magnitude(path_.slope(j, shares)) * still->drift;
    const double rod = point.rod[j] + bounds_.lever[j] * still->radius + moved;
    const double off = (bounds_.lever[j] * bounds_.lever[j] + rod * bounds_.bend[j]) * still->radius +
                       bounds_.lever[j] * moved;
    for (std::size_t k = 0; k < size_; ++k) matrix[j][k] = system.matrix[j][k] + Interval(-off, off);
  }
  return proved_determinant_sign(size_, matrix);
}

/// The longest arc that can be proved, of the length at most, and becomes that long; it stays behind
/// `earliest`. Also where it leads.
std::optional<FoldProof::Onward> FoldProof::go_on(const Point& point, double earliest,
                                                  double& length) const noexcept {
  for (int i = 0; i < most_halvings; ++i, length *= 0.5) {
    const std::optional<Arc> here = arc(point, length);
    if (!here || !(point.share - here->drift > earliest)) continue;
    const std::optional<Point> there = next(point, length, here->radius);
    if (there) return Onward{*here, *there};
  }
  return std::nullopt;
}

std::optional<double> FoldProof::latest(const CertifiedPoint& at, double off, double earliest, double share,
                                        double until) noexcept {
  const int start = poses_.determinant_sign(at);
  scale_ = find_scale(at, share);
  if (start == 0 || !(scale_ > 0.0) || !std::isfinite(scale_)) return std::nullopt;
  Point point;
  point.pose = at.pose;
  point.share = share;
  if (!prepare(point, Vector::Unit(static_cast<Eigen::Index>(size_ + 1), static_cast<Eigen::Index>(size_))))
    return std::nullopt;
  double length = std::max(2.0 * off, first_length * robot_size_), latest = share;
  for (int arcs = 0; arcs < most_arcs; ++arcs, length *= 2.0) {
    const std::optional<Onward> onward = go_on(point, earliest, length);
    if (!onward || (arcs == 0 && !(off <= std::min(length, onward->arc.radius)))) return std::nullopt;
    latest = std::max(latest, point.share + onward->arc.drift);
    if (!(latest <= until)) return std::nullopt;
    point = onward->end;
    if (determinant_sign(point) == -start) return latest;
  }
  return std::nullopt;
}

}  // namespace parallel_aspects
