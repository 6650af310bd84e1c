// SPDX-License-Identifier: BSD-3-Clause
//
// From motors to joints of an ankle and back: the Jacobian against differences of formulas of the test's own.
#include "parallel_aspects/ask/jacobian.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/ankle_formulas.h"
#include "support/robots/robots.h"
#include <array>
#include <cmath>
#include <random>

namespace parallel_aspects::ask {
namespace {

namespace formulas = test::ankle_formulas;
using formulas::Vector2d;
using Matrix2d = Eigen::Matrix2d;

/// Central differences of two lengths, so that the third derivatives drop out.
template <class Function>
Matrix2d differences(const Vector2d& at, const Function& function) {
  constexpr double step = 1e-4;
  const auto by = [&](double length) {
    Matrix2d result;
    for (Eigen::Index i = 0; i < 2; ++i) {
      Vector2d moved = function(at + length * Vector2d::Unit(i)) - function(at - length * Vector2d::Unit(i));
      for (double& each : moved) each = std::remainder(each, 2.0 * EIGEN_PI);
      result.col(i) = moved / (2.0 * length);
    }
    return result;
  };
  return (4.0 * by(0.5 * step) - by(step)) / 3.0;
}

double relative_error(const Matrix2d& matrix, const Matrix2d& expected) {
  return (matrix - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// Far enough from singularities for differences to be of use: the cranks from the rods, and the rates of the
/// angles from being without bound.
bool is_regular(const Vector2d& angles, const Matrix2d& rates) {
  for (const formulas::Rod& rod : formulas::rods())
    if (std::abs(formulas::crank_cosine(rod, angles)) > 0.97) return false;
  return std::abs(rates.determinant()) > 0.02 * rates.squaredNorm();
}

TEST(AnkleJacobian, IsThatOfDifferencesOfItsDrawing) {
  const auto robot = test::ankle();
  std::mt19937 random(20261129);
  std::uniform_real_distribution<double> angle(-EIGEN_PI, EIGEN_PI);
  int compared = 0;
  for (int i = 0; i < 200000 && compared < 1000; ++i) {
    const Vector2d angles(angle(random), angle(random));
    const std::array<int, 2> signs{(i & 1) != 0 ? -1 : 1, (i & 2) != 0 ? -1 : 1};
    const auto q = formulas::cranks(angles, signs);
    if (!q || std::abs(formulas::crank_cosine(formulas::rods()[0], angles)) > 0.97 ||
        std::abs(formulas::crank_cosine(formulas::rods()[1], angles)) > 0.97)
      continue;
    const Matrix2d to_motors =
        differences(angles, [&](const Vector2d& at) { return *formulas::cranks(at, signs); });
    if (!is_regular(angles, to_motors)) continue;
    const Matrix2d to_joints =
        differences(*q, [&](const Vector2d& at) { return formulas::angles_at(angles, at); });
    const JacobianAt found = jacobian_at(*robot, *pose_from_coordinates(robot->motions(), angles), *q);
    ASSERT_TRUE(found.jacobian && found.inverse_jacobian) << angles.transpose();
    ASSERT_EQ(*found.mode, *WorkingMode::from_signs({signs[0], signs[1]})) << angles.transpose();
    EXPECT_LT(relative_error(*found.jacobian, to_joints), 1e-6)
        << angles.transpose() << ", cranks " << q->transpose();
    EXPECT_LT(relative_error(*found.inverse_jacobian, to_motors), 1e-6) << angles.transpose();
    EXPECT_LT(relative_error(*found.force_transmission, to_motors.transpose()), 1e-6) << angles.transpose();
    ++compared;
  }
  EXPECT_EQ(compared, 1000);
}

TEST(AnkleJacobian, NamesTheRatesOfBothHinges) {
  const JacobianAnswer units = jacobian_units(*test::ankle());
  EXPECT_EQ(units.twist.size(), 2U);
  EXPECT_EQ(units.twist_units, (std::vector<std::string>{"rad/s", "rad/s"}));
  EXPECT_EQ(units.wrench_units, (std::vector<std::string>{"N m", "N m"}));
}

}  // namespace
}  // namespace parallel_aspects::ask
