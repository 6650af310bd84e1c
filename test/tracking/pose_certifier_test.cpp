// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/pose_certifier.h"

#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "tracking/continuation.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <cmath>
#include <mpfr.h>
#include <optional>
#include <sstream>

namespace parallel_aspects {
namespace {

// A direct solution of a random robot with random actuated joints, and a change of the actuated joints.
struct TriedStep {
  std::shared_ptr<const Manipulator> robot;
  Pose pose;
  JointVector q;
  TaskVector direction;
};

std::string text(const TriedStep& tried) {
  std::ostringstream stream;
  stream.precision(17);
  stream << tried.robot->name() << " at " << to_string(tried.robot->task_space(), tried.pose) << ", q "
         << tried.q.transpose() << ", direction " << tried.direction.transpose();
  return stream.str();
}

std::optional<TriedStep> random_case(test::RandomRobots& random, TaskSpace space, test::ActuationKind kind) {
  const auto robot = random.robot(space, kind);
  TriedStep made{robot, random.pose(robot->motions()), {}, {}};
  const auto modes = working_modes(*made.robot);
  const auto pick = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(modes.size())));
  const InverseSolution solution = inverse(*made.robot, made.pose, modes[std::min(pick, modes.size() - 1)]);
  if (solution.status != InverseStatus::solved) return std::nullopt;
  made.q = solution.q;
  made.direction = solution.q;
  const double size = std::pow(10.0, random.uniform(-6.0, 0.0));
  for (double& entry : coefficients_of(made.direction)) entry = size * random.uniform(-1.0, 1.0);
  return made;
}

template <class Check>
int for_random_cases(unsigned seed, int tries, const Check& check) {
  test::RandomRobots random(seed);
  int made = 0;
  for (int i = 0; i < tries; ++i)
    for (const TaskSpace space : test::all_task_spaces)
      for (const test::ActuationKind kind : test::all_actuation_kinds)
        if (const auto tried = random_case(random, space, kind)) {
          check(*tried, random);
          ++made;
        }
  return made;
}

// A pose at this distance, in any direction.
Pose at_rim(const Manipulator& robot, const Pose& middle, double radius, test::RandomRobots& random) {
  TaskVector twist(static_cast<Eigen::Index>(robot.leg_count()));
  for (double& entry : coefficients_of(twist)) entry = random.uniform(-1.0, 1.0);
  twist *= radius / twist.norm();
  twist.head(static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot.task_space()))) /=
      robot.characteristic_length();
  return displaced(robot.motions(), middle, twist);
}

// A pose anywhere in the ball.
Pose within(const Manipulator& robot, const Pose& middle, double radius, test::RandomRobots& random) {
  return at_rim(robot, middle, radius * random.uniform(0.0, 1.0), random);
}

// Every claim of a certified ball, tried at random: the actuated joints anywhere on the path, the pose
// anywhere in the ball. det A keeps its sign; Newton's method, wherever it begins, ends at one and the same
// solution or leaves the ball.
TEST(PoseCertifier, WhatItCertifiesHoldsAtRandomPoints) {
  int certified = 0;
  const int made = for_random_cases(11, 150, [&](const TriedStep& tried, test::RandomRobots& random) {
    const PoseCertifier certifier(*tried.robot);
    CertifiedPoint point;
    if (!certify_solution(certifier, tried.pose, tried.q, point)) return;
    CertifiedBall ball;
    int sign = 0;
    {
      const RoundingUpward upward;
      const TaskVector allowance = TaskVector::Zero(tried.q.size());
      ball = certifier.ball(point, tried.direction, allowance, 1.0,
                            certifier.path_speed(point, tried.direction));
      sign = certifier.determinant_sign(point);
    }
    if (!ball.certified || sign == 0) return;
    ++certified;
    for (int i = 0; i < 10; ++i) {
      const JointVector q = tried.q + random.uniform(0.0, 1.0) * tried.direction;
      const Pose start = within(*tried.robot, point.pose, ball.radius, random);
      ASSERT_GT(sign * direct_determinant(*tried.robot, start, q), 0.0) << text(tried);
      CertifiedPoint one = point, other = point;
      one.q = other.q = q;
      other.pose = start;
      const RoundingUpward upward;
      ASSERT_TRUE(certifier.evaluate(one)) << text(tried);
      ASSERT_LE(certifier.distance(one.pose, point.pose), ball.radius * (1.0 + 1e-9) + 1e-12) << text(tried);
      if (!certifier.evaluate(other) || certifier.distance(other.pose, point.pose) > ball.radius) continue;
      ASSERT_LT(certifier.distance(one.pose, other.pose), 1e-9 * tried.robot->size()) << text(tried);
    }
  });
  EXPECT_GT(certified, made / 4);
}

/// The longest path along the direction that is certified, to a tenth; none where no part of it is.
std::optional<CertifiedBall> stretch_to_the_longest(const PoseCertifier& certifier,
                                                    const CertifiedPoint& point, TaskVector& direction) {
  const RoundingUpward upward;
  const TaskVector still = TaskVector::Zero(direction.size());
  const auto ball_of = [&](const TaskVector& path) {
    return certifier.ball(point, path, still, 1.0, certifier.path_speed(point, path));
  };
  std::optional<CertifiedBall> longest;
  TaskVector path = 1e-7 / direction.norm() * direction;
  for (CertifiedBall ball = ball_of(path); ball.certified; ball = ball_of(path)) {
    longest = ball;
    direction = path;
    path *= 1.1;
    if (!(path.norm() < 1e3)) break;
  }
  return longest;
}

// Where it is all but too much: at the end of the longest path, at the rim of its ball.
TEST(PoseCertifier, WhatItCertifiesHoldsAtTheRim) {
  int certified = 0;
  const int made = for_random_cases(15, 60, [&](TriedStep tried, test::RandomRobots& random) {
    const PoseCertifier certifier(*tried.robot);
    CertifiedPoint point;
    if (!certify_solution(certifier, tried.pose, tried.q, point)) return;
    const auto ball = stretch_to_the_longest(certifier, point, tried.direction);
    const double center = direct_determinant(*tried.robot, point.pose, tried.q);
    if (!ball) return;
    ++certified;
    for (int i = 0; i < 10; ++i) {
      const Pose pose = at_rim(*tried.robot, point.pose, ball->radius * (1.0 - 1e-9), random);
      ASSERT_GT(center * direct_determinant(*tried.robot, pose, tried.q + tried.direction), 0.0)
          << text(tried);
    }
  });
  EXPECT_GT(certified, made / 2);
}

// What the enclosures say of F and B holds for the values in doubles, to their rounding.
TEST(PoseCertifier, EnclosuresHoldTheValuesInDoubles) {
  for_random_cases(12, 100, [&](const TriedStep& tried, test::RandomRobots&) {
    const TaskVector f = residuals(*tried.robot, tried.pose, tried.q);
    const TaskVector b = inverse_diagonal(*tried.robot, tried.pose, tried.q);
    const double rounding = 1e-13 * tried.robot->size() * tried.robot->size();
    const RoundingUpward upward;
    const EnclosedPose pose = enclosed_pose(tried.robot->motions(), tried.pose);
    for (std::size_t j = 0; j < tried.robot->leg_count(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      const LegEnclosure leg = LegForm(tried.robot->leg(j)).enclose(pose, tried.q[i]);
      EXPECT_LE(leg.half_residual.lower(), 0.5 * f[i] + rounding) << text(tried);
      EXPECT_GE(leg.half_residual.upper(), 0.5 * f[i] - rounding) << text(tried);
      EXPECT_LT(leg.half_residual.upper() - leg.half_residual.lower(), 100.0 * rounding) << text(tried);
      EXPECT_LE(leg.inverse_diagonal.lower(), b[i] + rounding) << text(tried);
      EXPECT_GE(leg.inverse_diagonal.upper(), b[i] - rounding) << text(tried);
    }
  });
}

// What proofs trust the C library to do, with upward rounding too: sine and cosine to within 2^-52.
TEST(PoseCertifier, TheLibraryKnowsSineAndCosine) {
  test::RandomRobots random(14);
  mpfr_t exact;
  mpfr_init2(exact, 200);
  const auto error = [&](double value, double angle, int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t)) {
    mpfr_set_d(exact, angle, MPFR_RNDN);
    function(exact, exact, MPFR_RNDN);
    mpfr_sub_d(exact, exact, value, MPFR_RNDN);
    return std::abs(mpfr_get_d(exact, MPFR_RNDA));
  };
  for (int i = 0; i < 30000; ++i) {
    const double angle = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-8.0, 6.0));
    double sine = 0.0, cosine = 0.0;
    {
      const RoundingUpward upward;
      sine = std::sin(angle);
      cosine = std::cos(angle);
    }
    ASSERT_LE(error(sine, angle, mpfr_sin), 0x1p-52) << angle;
    ASSERT_LE(error(cosine, angle, mpfr_cos), 0x1p-52) << angle;
  }
  mpfr_clear(exact);
}

// The distance is never less than that of the exponential coordinates.
TEST(PoseCertifier, DistanceBoundsTheLengthOfTheTwist) {
  for_random_cases(13, 40, [&](const TriedStep& tried, test::RandomRobots& random) {
    const PoseCertifier certifier(*tried.robot);
    const double radius = std::pow(10.0, random.uniform(-8.0, -0.5));
    TaskVector twist(tried.q.size());
    for (double& entry : coefficients_of(twist)) entry = random.uniform(-1.0, 1.0);
    twist *= radius / twist.norm();
    TaskVector scaled = twist;
    scaled.head(static_cast<Eigen::Index>(rotational_degrees_of_freedom(tried.robot->task_space()))) /=
        tried.robot->characteristic_length();
    const Pose moved = displaced(tried.robot->motions(), tried.pose, scaled);
    const RoundingUpward upward;
    const double distance = certifier.distance(tried.pose, moved);
    EXPECT_GE(distance, radius * (1.0 - 1e-12) - 1e-15) << text(tried);
    if (radius < 1e-3 * tried.robot->characteristic_length()) {
      EXPECT_LT(distance, radius * 1.01 + 1e-12) << text(tried);
    }
  });
}

}  // namespace
}  // namespace parallel_aspects
