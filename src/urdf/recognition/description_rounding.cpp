// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/description_rounding.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr int length_digits = 14, angle_decimals = 13, direction_decimals = 14;

// Powers of ten are exact up to there, and so are the integers that numbers of the model are multiplied to.
constexpr int max_decimals = 22;

/// To a number of decimals; the nearest double of the decimal number, and of its opposite the opposite.
class Decimals {
 public:
  explicit Decimals(int decimals) : scale_(std::pow(10.0, std::clamp(decimals, 0, max_decimals))) {}

  double operator()(double value) const {
    const double rounded = std::round(value * scale_) / scale_;
    return std::isfinite(rounded) ? rounded + 0.0 : value;
  }
  Vector3d operator()(const Vector3d& vector) const { return vector.unaryExpr(*this); }

 private:
  double scale_;
};

class Rounding {
 public:
  explicit Rounding(double size)
      : length_(length_digits - 1 - std::ilogb(size) * 3 / 10),
        angle_(angle_decimals),
        direction_(direction_decimals) {}

  double round(double length) const { return length_(length); }

  void round(Leg& leg) const {
    leg.anchor = length_(leg.anchor);
    leg.rod_length = length_(leg.rod_length);
    std::visit([this](auto& actuation) { round(actuation); }, leg.actuation);
  }

 private:
  void round(RevoluteActuation& actuation) const {
    actuation.center = length_(actuation.center);
    actuation.axis = direction_(actuation.axis).normalized();
    const Vector3d zero = direction_(actuation.zero_direction);
    actuation.zero_direction = (zero - actuation.axis * actuation.axis.dot(zero)).normalized();
    actuation.radius = length_(actuation.radius);
  }
  void round(PrismaticActuation& actuation) const {
    actuation.origin = length_(actuation.origin);
    actuation.direction = direction_(actuation.direction).normalized();
  }
  void round(StrutActuation& actuation) const {
    actuation.base = length_(actuation.base);
    actuation.length_at_zero = length_(actuation.length_at_zero);
  }
  void round(ElbowActuation& actuation) const {
    actuation.base = length_(actuation.base);
    actuation.inner_length = length_(actuation.inner_length);
    actuation.outer_length = length_(actuation.outer_length);
    actuation.angle_at_zero = angle_(actuation.angle_at_zero);
  }

  Decimals length_, angle_, direction_;
};

}  // namespace

Leg without_rounding_noise(Leg leg, double size) {
  Rounding(size).round(leg);
  return leg;
}

double without_rounding_noise(double length, double size) { return Rounding(size).round(length); }

}  // namespace parallel_aspects
