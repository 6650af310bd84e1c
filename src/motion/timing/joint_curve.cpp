// SPDX-License-Identifier: BSD-3-Clause
#include "motion/timing/joint_curve.h"

namespace parallel_aspects {
namespace {

constexpr double shortest_chord = 0.02;  // of their mean; values nearer than that tell no direction

double length_of(const std::vector<JointVector>& values, const JointVector& limits) {
  double length = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) length += chord(values[i - 1], values[i], limits);
  return length;
}

JointCurve knots_of(const std::vector<JointVector>& values, const JointVector& limits) {
  JointCurve curve{{0.0}, {values.front()}, {}, {}};
  const double shortest = shortest_chord * length_of(values, limits) / static_cast<double>(values.size());
  for (std::size_t i = 1; i < values.size(); ++i) {
    const bool is_last = i + 1 == values.size();
    if (chord(curve.value.back(), values[i], limits) <= shortest) {
      if (!is_last) continue;
      if (curve.size() > 1) {
        curve.value.pop_back();
        curve.parameter.pop_back();
      }
    }
    const double length = chord(curve.value.back(), values[i], limits);
    if (!(length > 0.0)) continue;
    curve.parameter.push_back(curve.parameter.back() + length);
    curve.value.push_back(values[i]);
  }
  return curve;
}

/// Second derivatives at the knots by the usual tridiagonal system; constant in the first and last interval.
std::vector<JointVector> second_derivatives(const JointCurve& curve) {
  const std::size_t knots = curve.size();
  std::vector<JointVector> second(knots, JointVector::Zero(curve.value.front().size()));
  if (knots < 3) return second;
  std::vector<double> factor(knots, 0.0);
  factor[0] = 1.0;  // that of the first is that of the second, plus nothing
  for (std::size_t i = 1; i + 1 < knots; ++i) {
    const double before = curve.parameter[i] - curve.parameter[i - 1],
                 after = curve.parameter[i + 1] - curve.parameter[i];
    const JointVector bend = 6.0 * ((curve.value[i + 1] - curve.value[i]) / after -
                                    (curve.value[i] - curve.value[i - 1]) / before);
    const double pivot = 2.0 * (before + after) + before * factor[i - 1];
    // second[i] = held[i] + factor[i] second[i + 1]; held is kept in `second`.
    const JointVector held = (bend - before * second[i - 1]) / pivot;
    second[i] = held;
    factor[i] = -after / pivot;
  }
  second[knots - 1] = second[knots - 2] / (1.0 - factor[knots - 2]);
  for (std::size_t i = knots - 1; i-- > 0;) second[i] += factor[i] * second[i + 1];
  return second;
}

std::vector<JointVector> slopes(const JointCurve& curve) {
  const std::size_t knots = curve.size();
  std::vector<JointVector> slope(knots, JointVector::Zero(curve.value.front().size()));
  for (std::size_t i = 0; i + 1 < knots; ++i) {
    const double length = curve.parameter[i + 1] - curve.parameter[i];
    const JointVector rise = (curve.value[i + 1] - curve.value[i]) / length;
    slope[i] = rise - length / 6.0 * (2.0 * curve.second[i] + curve.second[i + 1]);
    slope[i + 1] = rise + length / 6.0 * (curve.second[i] + 2.0 * curve.second[i + 1]);
  }
  return slope;
}

}  // namespace

double chord(const JointVector& from, const JointVector& to, const JointVector& velocity_limits) {
  return (to - from).cwiseQuotient(velocity_limits).norm();
}

JointCurve spline_through(const std::vector<JointVector>& values, const JointVector& velocity_limits) {
  JointCurve curve = knots_of(values, velocity_limits);
  curve.second = second_derivatives(curve);
  curve.slope = slopes(curve);
  return curve;
}

}  // namespace parallel_aspects
