// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/unresolved_text.h"

#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <memory>
#include <string>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

const WorkingMode mode = *WorkingMode::from_signs({1, -1, -1});

Pose pose_at(const Eigen::Vector3d& position) {
  Pose pose;
  pose.position = position;
  return pose;
}

double determinant_at(const Manipulator& robot, const Eigen::Vector3d& position) {
  const Pose pose = pose_at(position);
  return direct_determinant(robot, pose, inverse(robot, pose, mode).q);
}

/// Where det A and its slope vanish, and the directions along which it then grows and falls the most.
struct Saddle {
  Eigen::Vector3d position, rising, falling;
};

/// By differences, from a position near by.
Saddle saddle_near(const Manipulator& robot, const Eigen::Vector3d& start) {
  constexpr double step = 1e-4;
  Saddle saddle{start, {}, {}};
  for (int round = 0; round < 10; ++round) {
    const auto at = [&](int i, double a, int k, double b) {
      return determinant_at(
          robot, saddle.position + a * step * Eigen::Vector3d::Unit(i) + b * step * Eigen::Vector3d::Unit(k));
    };
    Eigen::Vector3d slope;
    Eigen::Matrix3d second;
    for (int i = 0; i < 3; ++i) {
      slope[i] = (at(i, 1, i, 0) - at(i, -1, i, 0)) / (2.0 * step);
      for (int k = 0; k < 3; ++k)
        second(i, k) =
            (at(i, 1, k, 1) - at(i, 1, k, -1) - at(i, -1, k, 1) + at(i, -1, k, -1)) / (4.0 * step * step);
    }
    // One of the three eigenvalues is nearly zero: det A vanishes all along a curve.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second);
    saddle.falling = solver.eigenvectors().col(0);
    saddle.rising = solver.eigenvectors().col(2);
    for (const int k : {0, 2}) {
      const Eigen::Vector3d direction = solver.eigenvectors().col(k);
      saddle.position -= slope.dot(direction) / solver.eigenvalues()[k] * direction;
    }
  }
  return saddle;
}

/// The Delta with the rod of one leg so much longer.
Robot with_longer_rod(const Robot& robot, std::size_t leg, double more) {
  ManipulatorDescription description = robot->description();
  description.legs[leg].rod_length += more;
  return std::make_shared<const Manipulator>(description);
}

// What docs/theory/maps.md says of the Delta: where the rods of legs 1 and 2 are parallel, poses of one sign
// of det A touch along a curve, and a rod that is longer or shorter by next to nothing joins them or parts
// them.
TEST(UnresolvedText, TheSmallestChangeJoinsOrPartsWhatTouchesInTheDelta) {
  const Robot delta = test::shipped("delta")->mapped_manipulator();
  const Saddle saddle = saddle_near(*delta, {0.218, -0.752, 0.341});
  ASSERT_LT(std::abs(determinant_at(*delta, saddle.position)), 1e-9);
  const Pose pose = pose_at(saddle.position);
  const TaskMatrix rows = homogenised_matrix(*delta, pose, inverse(*delta, pose, mode).q);
  EXPECT_LT((rows.row(0).normalized() - rows.row(1).normalized()).norm(), 1e-5);
  for (const Eigen::Vector3d& direction : {saddle.rising, saddle.falling}) {
    const Pose one = pose_at(saddle.position - 0.02 * direction),
               other = pose_at(saddle.position + 0.02 * direction);
    ASSERT_GT(determinant_at(*delta, one.position) * determinant_at(*delta, other.position), 0.0);
    for (const double change : {1e-3, 1e-5, 1e-7}) {
      int joined = 0;
      for (const double more : {change, -change}) {
        const SegmentProof proof =
            SegmentCertifier(with_longer_rod(delta, 0, more)).prove(one, other, mode, 20000);
        joined += proof.verdict == SegmentVerdict::free;
      }
      EXPECT_EQ(joined, 1) << "change by " << change;
    }
  }
}

// At whatever resolution, what meets there is named.
TEST(UnresolvedText, NamesAPlaceAndTheLegs) {
  const Robot delta = test::shipped("delta")->mapped_manipulator();
  MapOptions options;
  options.resolution = 0.06;
  options.modes = {mode};
  const auto map = compute_aspect_map(delta, options).map;
  ASSERT_FALSE(map->unresolved().empty());
  const auto [first, second] = map->unresolved().front();
  const std::string text = unresolved_text(*map, second, first);
  EXPECT_EQ(text.find("in (+,-,-) the map cannot decide whether aspects " + std::to_string(first) + " and " +
                      std::to_string(second) + " are one."),
            0U)
      << text;
  EXPECT_NE(text.find("undecided leaves, as about x "), std::string::npos) << text;
}

}  // namespace
}  // namespace parallel_aspects
