// SPDX-License-Identifier: BSD-3-Clause
//
// How the stand-off grows with noise at a fold and at a cusp of the 3-RPR of Innocenti and Parenti-Castelli:
// the least that any monitor needs, by the distance of the actuated joints from the image of det A = 0, and
// what StandOff says.
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace parallel_aspects {
namespace {

/// The least norm of `function` near `start`, by Levenberg's and Marquardt's method.
double least_norm(const std::function<Eigen::Vector3d(const Eigen::Vector2d&)>& function, Eigen::Vector2d at,
                  double step) {
  Eigen::Vector3d value = function(at);
  double damping = 1e-3;
  for (int i = 0; i < 200 && damping < 1e12; ++i) {
    Eigen::Matrix<double, 3, 2> slope;
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Eigen::Vector2d path = step * Eigen::Vector2d::Unit(k);
      slope.col(k) = (function(at + path) - function(at - path)) / (2.0 * step);
    }
    Eigen::Matrix2d normal = slope.transpose() * slope;
    normal.diagonal() *= 1.0 + damping;
    const Eigen::Vector2d next = at - normal.inverse() * (slope.transpose() * value);
    const Eigen::Vector3d next_value = function(next);
    const bool better = next_value.norm() < value.norm();
    damping *= better ? 0.2 : 5.0;
    if (better) at = next, value = next_value;
  }
  return value.norm();
}

/// How a path leaves a pose with det A = 0, in coordinates (w, v) over the robot's size: along the direction
/// in which the platform is loose there, which at a cusp is tangent to the surface det A = 0; bent towards
/// the normal of that surface by a multiple of the square; and along the normal.
struct WayOut {
  double loose = 0.0, bend = 0.0, normal = 0.0;
};
constexpr WayOut along_fold{1.0, 0.0, 0.0}, bent{1.0, 3.0, 0.0}, across{0.0, 0.0, 1.0};

/// The poses next to one with det A = 0.
class LocalChart {
 public:
  LocalChart(double x, double y, double phi) : singular_(polished(pose(x, y, phi))) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix(singular_), Eigen::ComputeFullV);
    loose_ = svd.matrixV().col(2);
    normal_ = gradient(singular_).normalized();
    along_ = loose_.cross(normal_);
  }

  Pose at(const WayOut& path, double share) const {
    const Eigen::Vector3d step =
        share * path.loose * loose_ + share * (path.normal + share * path.bend) * normal_;
    return moved(singular_, step);
  }

  double distance_at(const WayOut& path, double share) const {
    return anchor_distance(*robot_, at(path, share), singular_);
  }

  /// How far the actuated joints at this pose are from those of the nearest pose with det A = 0, over the
  /// robot's size: noise of that much hides on which side of the singularity the robot is, from any monitor.
  double hiding_noise(const WayOut& path, double share) const {
    const JointVector here = joint_values(at(path, share));
    const auto away = [&](const Eigen::Vector2d& plane) {
      const Pose near = on_surface(moved(singular_, plane[0] * loose_ + plane[1] * along_));
      return Eigen::Vector3d((joint_values(near) - here) / robot_->size());
    };
    double best = std::numeric_limits<double>::infinity();
    for (const double start : {-1.0, -0.3, 0.1, 0.3, 1.0})
      best = std::min(best, least_norm(away, {start * share, 0.0}, 1e-3 * std::abs(share)));
    return best;
  }

  /// The power of the distance that the noise grows with.
  double power(const WayOut& path, double share) const {
    return std::log2(hiding_noise(path, 2.0 * share) / hiding_noise(path, share));
  }

  StandOff with_noise(double noise) const {
    SampleOptions options;
    options.encoder_noise = noise;
    return {robot_, options};
  }

  /// What StandOff says of the path from there to det A = 0 [m].
  double stand_off(const WayOut& path, double share, double noise) const {
    return with_noise(noise).along_path(at(path, share), singular_, working_modes(*robot_).front());
  }

  bool can_distinguish(const WayOut& path, double share, double noise) const {
    return with_noise(noise).can_distinguish(at(path, share), working_modes(*robot_).front());
  }

 private:
  static Pose pose(double x, double y, double phi) {
    return *pose_from_coordinates(TaskSpace::SE2, Eigen::Vector3d(x, y, phi));
  }
  JointVector joint_values(const Pose& pose) const {
    return inverse(*robot_, pose, working_modes(*robot_).front()).q;
  }
  // A of motions as `moved` takes them.
  Eigen::Matrix3d matrix(const Pose& pose) const {
    Eigen::Matrix3d result = direct_matrix(*robot_, pose, joint_values(pose)) / std::pow(robot_->size(), 2);
    result.rightCols<2>() *= robot_->size();
    return result;
  }
  double determinant_of(const Pose& pose) const { return matrix(pose).determinant(); }

  Pose moved(const Pose& from, const Eigen::Vector3d& step) const {
    Eigen::Vector3d twist = step;
    twist.tail<2>() *= robot_->size();
    return displaced(TaskSpace::SE2, from, TaskVector(twist));
  }

  Eigen::Vector3d gradient(const Pose& pose) const {
    constexpr double step = 1e-6;
    Eigen::Vector3d result;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Vector3d path = step * Eigen::Vector3d::Unit(i);
      result[i] = (determinant_of(moved(pose, path)) - determinant_of(moved(pose, -path))) / (2.0 * step);
    }
    return result;
  }

  // Newton's method along the gradient at the pose.
  Pose on_surface(Pose pose) const {
    const Eigen::Vector3d normal = gradient(pose);
    for (int i = 0; i < 6; ++i) pose = moved(pose, -determinant_of(pose) / normal.squaredNorm() * normal);
    return pose;
  }
  Pose polished(Pose pose) const {
    for (int i = 0; i < 20; ++i) pose = on_surface(pose);
    return pose;
  }

  std::shared_ptr<const Manipulator> robot_ = unlimited();
  Pose singular_;
  Eigen::Vector3d loose_, normal_, along_;

  static std::shared_ptr<const Manipulator> unlimited() {
    ManipulatorDescription description = test::three_rpr()->description();
    for (Leg& leg : description.legs) leg.limits = {};
    return std::make_shared<const Manipulator>(description);
  }
};

// The cusp at the strut lengths (14.98, 17.98855, 26.44618), and a fold near by.
LocalChart cusp() { return {14.72185682124062, -2.76899471557658, 2.97363879604975}; }
LocalChart fold() { return {14.4, -3.0, 2.6}; }

TEST(StandOffFromNoise, IsASquareRootAtAFoldAndACubeRootAtACusp) {
  for (const double share : {0.005, 0.01, 0.02}) {
    EXPECT_NEAR(fold().power(along_fold, share), 2.0, 0.05) << share;
    EXPECT_NEAR(fold().power(along_fold, -share), 2.0, 0.05) << share;
    EXPECT_NEAR(cusp().power(bent, share), 3.0, 0.05) << share;
  }
}

// Proofs go by bounds of the second derivative, which vanishes at a cusp: so it is a square root of how far
// det A is from 0 there too, and that grows with the square of the path along the surface.
TEST(StandOffThatIsSaid, IsASquareRootOfTheNoiseTowardsTheSurface) {
  for (const double far : {-0.1, 0.1}) {
    EXPECT_NEAR(fold().stand_off(along_fold, far, 1e-10) / fold().stand_off(along_fold, far, 1e-12), 10.0,
                0.5);
    EXPECT_NEAR(cusp().stand_off(across, far, 1e-10) / cusp().stand_off(across, far, 1e-12), 10.0, 0.5);
    EXPECT_NEAR(cusp().stand_off(along_fold, far, 1e-10) / cusp().stand_off(along_fold, far, 1e-12),
                std::sqrt(10.0), 0.3);
  }
}

TEST(StandOffThatIsSaid, IsNoLessThanNoiseHides) {
  for (const double share : {0.005, 0.01, 0.02, 0.04}) {
    const double at_fold = fold().hiding_noise(along_fold, share), at_cusp = cusp().hiding_noise(bent, share);
    EXPECT_FALSE(fold().can_distinguish(along_fold, share, at_fold)) << share;
    EXPECT_FALSE(cusp().can_distinguish(bent, share, at_cusp)) << share;
    EXPECT_GE(fold().stand_off(along_fold, 0.1, at_fold), fold().distance_at(along_fold, share)) << share;
    EXPECT_GE(cusp().stand_off(along_fold, 0.1, at_cusp), cusp().distance_at(bent, share)) << share;
  }
}

}  // namespace
}  // namespace parallel_aspects
