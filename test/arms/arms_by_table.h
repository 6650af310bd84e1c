// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ARMS_ARMS_BY_TABLE_H
#define PARALLEL_ASPECTS_TEST_ARMS_ARMS_BY_TABLE_H

#include "parallel_aspects/arms/serial_arm.h"

#include <Eigen/Geometry>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// A row of a table after Denavit and Hartenberg [m, rad].
struct Row {
  double d, a, alpha;
  bool turns = true;
};

inline constexpr double quarter = 1.57079632679489661923, degree = quarter / 90.0;

/// The arm with joints q1, q2, ... of the table, without limits of what turns; slides from 0 to 1 m.
inline ArmDescription described_by(const std::string& name, const std::vector<Row>& table) {
  ArmDescription description;
  description.name = name;
  description.base_link = "base";
  description.tip_link = "tip";
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (const Row& row : table) {
    JointLimits limits;
    if (!row.turns) limits.lower = 0.0, limits.upper = 1.0;
    description.axes.push_back({"q" + std::to_string(description.axes.size() + 1), row.turns,
                                frame.translation(), frame.linear().col(2), limits});
    frame = frame * Eigen::Translation3d(row.a, 0.0, row.d) *
            Eigen::AngleAxisd(row.alpha, Eigen::Vector3d::UnitX());
  }
  description.tip = frame;
  return description;
}

inline ArmDescription planar_2r() { return described_by("planar 2R", {{0, 1, 0}, {0, 0.7, 0}}); }
inline ArmDescription planar_3r() { return described_by("planar 3R", {{0, 1, 0}, {0, 0.7, 0}, {0, 0.3, 0}}); }
inline ArmDescription scara() {
  return described_by("scara", {{0.4, 0.35, 0}, {0, 0.3, 2 * quarter}, {0.1, 0, 0, false}, {0, 0, 0}});
}
inline ArmDescription orthogonal_3r(double d3 = 2.0, double d4 = 1.5, double r2 = 1.0) {
  return described_by("3R", {{0, 1, -quarter}, {r2, d3, quarter}, {0, d4, 0}});
}
inline ArmDescription puma_560() {
  return described_by("puma", {{0, 0, quarter},
                               {0, 0.4318, 0},
                               {0.15005, 0.0203, -quarter},
                               {0.4318, 0, quarter},
                               {0, 0, -quarter},
                               {0, 0, 0}});
}
inline ArmDescription ur5() {
  return described_by("ur5", {{0.089159, 0, quarter},
                              {0, -0.425, 0},
                              {0, -0.39225, 0},
                              {0.10915, 0, quarter},
                              {0.09465, 0, -quarter},
                              {0.0823, 0, 0}});
}
inline ArmDescription jaco() {
  return described_by("jaco", {{0.212, 0, quarter},
                               {0, 0.41, 2 * quarter},
                               {-0.012, 0, quarter},
                               {-0.2493, 0, 55 * degree},
                               {-0.0846, 0, 55 * degree},
                               {-0.22273, 0, 2 * quarter}});
}

/// Joint values of all turns, and of the first metre of slides.
inline Eigen::VectorXd random_joints(const SerialArm& arm, std::mt19937& random) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(arm.size()));
  for (std::size_t i = 0; i < arm.size(); ++i)
    q[static_cast<Eigen::Index>(i)] =
        arm.joints()[i].turns ? std::uniform_real_distribution<double>(-half_turn, half_turn)(random)
                              : std::uniform_real_distribution<double>(0.0, 1.0)(random);
  return q;
}

/// The largest difference of joint values, of angles modulo turns.
inline double apart(const SerialArm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const double difference = a[static_cast<Eigen::Index>(i)] - b[static_cast<Eigen::Index>(i)];
    largest = std::max(
        largest, std::abs(arm.joints()[i].turns ? std::remainder(difference, 2.0 * half_turn) : difference));
  }
  return largest;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ARMS_ARMS_BY_TABLE_H
