// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/joint_path.h"

#include "interval/path_form.h"

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

// About the middle of the range, so that it is tight to the second order.
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

}  // namespace parallel_aspects
