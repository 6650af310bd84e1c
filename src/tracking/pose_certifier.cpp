// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/pose_certifier.h"

#include "model/angles.h"
#include "model/linear_algebra.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr int max_newton_steps = 20;

// Over the robot's size. With C that is right to the second of these, a step of the first leaves rounding.
constexpr double converged = 1e-10;
constexpr double outdated = 1e-5;

// The smallest radius tried where actuated joints move, over the robot's size: far above what is left around
// a point where they stay, far below everything else.
constexpr double least_radius = 1e-9;

// Rotations in a ball stay below half a turn, where exponential coordinates are one to one.
constexpr double largest_turn = 3.0;

// What `Eigen::Quaternion::normalize` leaves of a length other than 1, with room.
constexpr double unit_error = few_units;

template <int n>
void invert(const SquareArray<double>& matrix, SquareArray<double>& inverse) {
  Eigen::Matrix<double, n, n> fixed;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      fixed(i, k) = matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  Eigen::Matrix<double, n, n> result;
  if constexpr (n <= 4)
    result = fixed.inverse();
  else
    result = parallel_aspects::inverse(fixed);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = result(i, k);
}

void invert(std::size_t size, const SquareArray<double>& matrix, SquareArray<double>& inverse) {
  switch (size) {
    case 1:
      return invert<1>(matrix, inverse);
    case 2:
      return invert<2>(matrix, inverse);
    case 3:
      return invert<3>(matrix, inverse);
    default:
      return invert<6>(matrix, inverse);
  }
}

}  // namespace

PoseCertifier::PoseCertifier(const Manipulator& manipulator) noexcept
    : motions_(manipulator.motions()),
      size_(manipulator.leg_count()),
      rotational_(rotational_degrees_of_freedom(motions_.space)),
      length_(manipulator.characteristic_length()),
      scale_(manipulator.size()) {
  const RoundingUpward upward;
  bounds_ = anchor_bounds(manipulator);
  for (std::size_t j = 0; j < size_; ++j) legs_[j] = LegForm(manipulator.leg(j));
}

void PoseCertifier::approximate(const Pose& pose, const JointVector& q, LegBounds& residual,
                                Rows* matrix) const noexcept {
  const Eigen::Matrix3d turn =
      rotational_ == 0 ? Eigen::Matrix3d::Identity() : pose.orientation.toRotationMatrix();
  for (std::size_t j = 0; j < size_; ++j) {
    const double actuation = q[static_cast<Eigen::Index>(j)];
    const Eigen::Vector3d b = turn * legs_[j].anchor();
    const Eigen::Vector3d u = pose.position + b - legs_[j].proximal_point(actuation);
    residual[j] = 0.5 * (u.squaredNorm() - legs_[j].squared_distance(actuation));
    const Lever<Eigen::Vector3d> lever{b, pose.position + b, turn.col(2)};
    if (matrix != nullptr) write_homogenised_row(motions_.space, lever, u, 1.0 / length_, (*matrix)[j]);
  }
}

Pose PoseCertifier::stepped(const Pose& pose, const Rows& inverse, const LegBounds& residual,
                            double& size) const noexcept {
  TaskVector step(static_cast<Eigen::Index>(size_));
  for (std::size_t i = 0; i < size_; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < size_; ++j) sum -= inverse[i][j] * residual[j];
    step[static_cast<Eigen::Index>(i)] = sum;
  }
  size = step.norm();
  step.head(static_cast<Eigen::Index>(rotational_)) /= length_;
  return displaced(motions_, pose, step);
}

Pose PoseCertifier::predicted(const CertifiedPoint& point, const JointVector& q) const noexcept {
  LegBounds residual;
  double size = 0.0;
  approximate(point.pose, q, residual, nullptr);
  return stepped(point.pose, point.inverse, residual, size);
}

// With an inverse that is a little old Newton's method still contracts, and each step is far cheaper.
bool PoseCertifier::refine(CertifiedPoint& point) const noexcept {
  LegBounds residual;
  Rows matrix;
  bool fresh = false;
  for (int i = 0; i < max_newton_steps; ++i) {
    approximate(point.pose, point.q, residual, fresh ? nullptr : &matrix);
    if (!fresh) invert(size_, matrix, point.inverse);
    double size = 0.0;
    point.pose = stepped(point.pose, point.inverse, residual, size);
    if (!std::isfinite(size)) return false;
    if (size <= converged * scale_) return true;
    fresh = size <= outdated * scale_;
  }
  return false;
}

SquareArray<Interval> PoseCertifier::enclosed_matrix(
    const CertifiedPoint& point, std::array<LegEnclosure, max_legs>& legs) const noexcept {
  SquareArray<Interval> matrix;
  const EnclosedPose pose = enclosed_pose(motions_, point.pose);
  const Interval over_length = reciprocal(Interval(length_));
  for (std::size_t j = 0; j < size_; ++j) {
    legs[j] = legs_[j].enclose(pose, point.q[static_cast<Eigen::Index>(j)]);
    write_homogenised_row(motions_.space, legs[j].lever, legs[j].u, over_length, matrix[j]);
  }
  return matrix;
}

// |C F|, and |C A - I| by its Frobenius norm, which is no smaller than that of the theorem.
bool PoseCertifier::enclose(CertifiedPoint& point) const noexcept {
  assert_rounding_upward();
  std::array<LegEnclosure, max_legs> legs;
  const SquareArray<Interval> matrix = enclosed_matrix(point, legs);
  double squared_defect = 0.0, squared_residual = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    Interval corrected = 0.0;
    for (std::size_t k = 0; k < size_; ++k) {
      Interval entry = i == k ? -1.0 : 0.0;
      for (std::size_t j = 0; j < size_; ++j) entry += matrix[j][k] * point.inverse[i][j];
      squared_defect += magnitude(entry) * magnitude(entry);
      corrected += legs[k].half_residual * point.inverse[i][k];
    }
    squared_residual += magnitude(corrected) * magnitude(corrected);
  }
  point.defect = std::sqrt(squared_defect);
  point.residual = std::sqrt(squared_residual);
  for (std::size_t j = 0; j < size_; ++j) {
    point.inverse_diagonal[j] = legs[j].inverse_diagonal;
    const IntervalVector& u = legs[j].u;
    point.rod[j] = square_root(square(u[0]) + square(u[1]) + square(u[2])).upper();
  }
  return std::isfinite(point.defect) && std::isfinite(point.residual);
}

bool PoseCertifier::evaluate(CertifiedPoint& point) const noexcept {
  if (rotational_ == 0) point.pose.orientation.setIdentity();
  return refine(point) && enclose(point) && std::abs(point.pose.orientation.squaredNorm() - 1.0) < unit_error;
}

// At least |C v| for every v that is at most `entries`, leg by leg.
double PoseCertifier::spread(const CertifiedPoint& point, const LegBounds& entries) const noexcept {
  double squared = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < size_; ++j) sum += std::abs(point.inverse[i][j]) * entries[j];
    squared += sum * sum;
  }
  return std::sqrt(squared);
}

double PoseCertifier::path_speed(const CertifiedPoint& point, const TaskVector& direction) const noexcept {
  std::array<Interval, max_legs> change;
  for (std::size_t j = 0; j < size_; ++j)
    change[j] = point.inverse_diagonal[j] * direction[static_cast<Eigen::Index>(j)];
  double squared = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    Interval sum = 0.0;
    for (std::size_t j = 0; j < size_; ++j) sum += change[j] * point.inverse[i][j];
    squared += magnitude(sum) * magnitude(sum);
  }
  return std::sqrt(squared);
}

Eigen::Index PoseCertifier::widest(const CertifiedPoint& point, const TaskVector& allowance) const noexcept {
  TaskVector motion(allowance.size());
  for (std::size_t j = 0; j < size_; ++j) {
    LegBounds entry{};
    entry[j] =
        magnitude(point.inverse_diagonal[j]) + bounds_.lever[j] * point.rod[j] * legs_[j].point_speed();
    motion[static_cast<Eigen::Index>(j)] = spread(point, entry) * allowance[static_cast<Eigen::Index>(j)];
  }
  Eigen::Index widest = 0;
  motion.maxCoeff(&widest);
  return widest;
}

CertifiedBall PoseCertifier::ball(const CertifiedPoint& point) const noexcept {
  const TaskVector still = TaskVector::Zero(static_cast<Eigen::Index>(size_));
  return ball(point, still, still, 0.0, 0.0, 0.0);
}

CertifiedBall PoseCertifier::ball(const CertifiedPoint& point, const TaskVector& direction,
                                  const TaskVector& allowance, double share, double speed) const noexcept {
  return ball(point, direction, allowance, share, speed, least_radius * scale_);
}

CertifiedBall PoseCertifier::ball(const CertifiedPoint& point, const TaskVector& direction,
                                  const TaskVector& allowance, double share, double speed,
                                  double least) const noexcept {
  // The theorem of docs/theory/tracking.md, by its bounds for each leg: `row` of the change of A, `bend` of
  // what F is off its linear part in q, `curvature` of D^2 F in the ball. Then g is `contraction`, eta
  // `moved` and k r `bent`.
  LegBounds rod{}, row{}, bend{}, curvature{};
  for (std::size_t j = 0; j < size_; ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const double change = share * std::abs(direction[i]) + allowance[i];
    const double motion = legs_[j].point_speed() * change;
    rod[j] = point.rod[j] + motion;
    row[j] = bounds_.lever[j] * motion;
    bend[j] = 0.5 * legs_[j].joint_curvature(rod[j]) * change * change +
              magnitude(point.inverse_diagonal[j]) * allowance[i];
  }
  const double contraction = point.defect + spread(point, row);
  const double gain = -(contraction - 1.0);  // rounded down: 1 - g
  const double moved = point.residual + share * speed + spread(point, bend);
  if (!(gain > 0.0)) return {};
  // Twice what eta / (1 - g) would do without k, so that half of it is left for k.
  const double radius = std::max(2.0 * moved / gain, least);
  for (std::size_t j = 0; j < size_; ++j)
    curvature[j] =
        bounds_.lever[j] * bounds_.lever[j] + (rod[j] + bounds_.lever[j] * radius) * bounds_.bend[j];
  const double bent = spread(point, curvature) * radius;
  const double kept = -(-gain * radius);  // rounded down
  const bool turns_little = rotational_ == 0 || radius <= largest_turn * length_;
  return {turns_little && bent < gain && moved + 0.5 * bent * radius <= kept, radius};
}

double PoseCertifier::anchor_spread(const CertifiedPoint& point, const TaskVector& allowance) const noexcept {
  const TaskVector still = TaskVector::Zero(static_cast<Eigen::Index>(size_));
  const CertifiedBall around = ball(point, still, allowance, 0.0, 0.0);
  if (!around.certified) return std::numeric_limits<double>::infinity();
  double squared = 0.0;
  for (std::size_t j = 0; j < size_; ++j) squared += bounds_.lever[j] * bounds_.lever[j];
  return around.radius * std::sqrt(squared / static_cast<double>(size_));
}

// The angles of a pose are those that `enclosed_pose` takes.
double PoseCertifier::angle_distance(const Pose& a, const Pose& b) const noexcept {
  const PoseCoordinates first = pose_coordinates(motions_.space, a),
                        last = pose_coordinates(motions_.space, b);
  double squared = 0.0;
  for (int k = 0; k < 2; ++k) {
    const double way = std::abs(std::remainder(last[k] - first[k], full_turn)) + few_units;
    squared += way * way;
  }
  return length_ * std::sqrt(squared);
}

double PoseCertifier::distance(const Pose& a, const Pose& b) const noexcept {
  if (motions_.space == TaskSpace::R2) return angle_distance(a, b);
  double squared = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double up = a.position[k] - b.position[k], down = b.position[k] - a.position[k];
    squared += std::max(up * up, down * down);
  }
  if (rotational_ == 0) return std::sqrt(squared);
  // Half the chord of two unit quaternions is the sine of a quarter of the angle between the rotations, and
  // asin x <= x + x^3 for 0 <= x <= 1/2.
  double chord = 0.0;
  for (int k = 0; k < 4; ++k) {
    const double up = a.orientation.coeffs()[k] - b.orientation.coeffs()[k];
    const double down = b.orientation.coeffs()[k] - a.orientation.coeffs()[k];
    chord += std::max(up * up, down * down);
  }
  const double half = 0.5 * std::sqrt(chord) + 2.0 * unit_error;
  if (!(half <= 0.5)) return std::numeric_limits<double>::infinity();
  const double arc = length_ * 4.0 * (half + half * half * half);
  return std::sqrt(squared + arc * arc);
}

TaskVector PoseCertifier::entry_sines(const CertifiedPoint& point) const noexcept {
  TaskVector sines(static_cast<Eigen::Index>(size_));
  for (std::size_t j = 0; j < size_; ++j) {
    const Interval& entry = point.inverse_diagonal[j];
    sines[static_cast<Eigen::Index>(j)] =
        0.5 * (entry.lower() + entry.upper()) / legs_[j].largest_inverse_entry(point.rod[j]);
  }
  return sines;
}

// Along a straight way |u| stays below what it is at most, and B_jj changes by c'.Dp for the pose and by the
// second derivative of F for the joint value.
int PoseCertifier::entry_sign(const CertifiedPoint& point, std::size_t leg, double radius,
                              double change) const noexcept {
  assert_rounding_upward();
  const double rod = point.rod[leg] + bounds_.lever[leg] * radius + legs_[leg].point_speed() * change;
  const double off =
      legs_[leg].point_speed() * bounds_.lever[leg] * radius + legs_[leg].joint_curvature(rod) * change;
  const Interval entry = point.inverse_diagonal[leg] + Interval(-off, off);
  return entry.positive() ? 1 : entry.negative() ? -1 : 0;
}

// F changes its sign between the joint values on both sides.
bool PoseCertifier::assembles_within(const CertifiedPoint& point,
                                     const TaskVector& allowance) const noexcept {
  assert_rounding_upward();
  const EnclosedPose pose = enclosed_pose(motions_, point.pose);
  const auto half_residual = [&](std::size_t leg, double q) {
    return legs_[leg].enclose(pose, q).half_residual;
  };
  for (std::size_t j = 0; j < size_; ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    // Half of it, so that what the sums are rounded by does not lead out of it.
    const double below = point.q[i] - 0.5 * allowance[i], above = point.q[i] + 0.5 * allowance[i];
    if (!(point.q[i] - below <= allowance[i] && above - point.q[i] <= allowance[i])) return false;
    const Interval first = half_residual(j, below), last = half_residual(j, above);
    if (!(first.positive() && last.negative()) && !(first.negative() && last.positive())) return false;
  }
  return true;
}

int PoseCertifier::determinant_sign(const CertifiedPoint& point) const noexcept {
  std::array<LegEnclosure, max_legs> legs;
  return proved_determinant_sign(size_, enclosed_matrix(point, legs));
}

}  // namespace parallel_aspects
