// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/singular_curves.h"

#include "draw/plane/map_pictures.h"
#include "model/angles.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

struct CurveCase {
  std::string robot, joint;
  double value;
  bool has_limits;
};

void PrintTo(const CurveCase& which, std::ostream* stream) { *stream << which.robot; }

const Eigen::AlignedBox2d turns(Vector2d(-pi, -pi), Vector2d(pi, pi));

class SingularCurvesOf : public testing::TestWithParam<CurveCase> {
 protected:
  struct Followed {
    std::shared_ptr<const AspectMap> map;
    std::unique_ptr<JointProjection> projection;
    std::unique_ptr<SingularCurves> curves;
    std::map<std::size_t, std::vector<BoundarySegment>> traced;  // by working mode
  };

  /// Computed by the first test that asks for it.
  static const Followed& followed() {
    static std::map<std::string, Followed> all;
    Followed& result = all[GetParam().robot];
    if (result.map) return result;
    auto robot = test::shipped(GetParam().robot)->mapped_manipulator();
    if (!GetParam().has_limits) robot = robot->with_constraints(ConstraintKinds());
    const MapSlice slice = test::slice_of(robot, {{GetParam().joint, GetParam().value}});
    result.map = test::map_of(robot, test::options_of(slice, 0.1));
    result.projection = std::make_unique<JointProjection>(result.map);
    result.curves = std::make_unique<SingularCurves>(*result.map, *result.projection);
    const PoseSlice plane(*robot, slice);
    for (std::size_t i = 0; i < result.map->working_modes().size(); ++i) {
      const WorkingMode& mode = result.map->working_modes()[i];
      result.traced[i] = trace_slice(*result.map, mode, plane, turns, 120).segments;
      for (const BoundarySegment& segment : result.traced[i]) result.curves->follow(segment, mode);
    }
    result.curves->follow_free_cranks();
    return result;
  }

  static const Manipulator& robot() { return *followed().map->manipulator(); }
  static const HeldJoint& held() { return *followed().map->slice()->joint; }
  static Pose pose(const Vector2d& at) { return PoseSlice(robot(), *followed().map->slice()).pose(at); }

  static JointVector actuated(const Vector2d& values) {
    JointVector q(static_cast<Eigen::Index>(robot().leg_count()));
    q[static_cast<Eigen::Index>(held().leg)] = held().value;
    for (std::size_t i = 0; i < 2; ++i)
      q[static_cast<Eigen::Index>(followed().projection->legs()[i])] = values[static_cast<Eigen::Index>(i)];
    return q;
  }
};

// Both ends of each piece are configurations of the slice, and singular.
TEST_P(SingularCurvesOf, EndsAreSingularConfigurations) {
  const double size = robot().size();
  std::size_t serial = 0, parallel = 0;
  for (const SingularPiece& piece : followed().curves->pieces())
    for (const std::size_t end : {0U, 1U}) {
      const Pose at = pose(piece.poses[end]);
      const JointVector q = actuated(piece.actuated[end]);
      ASSERT_LT(residuals(robot(), at, q).cwiseAbs().maxCoeff(), 1e-6 * size * size);
      if (piece.kind == BoundaryKind::serial) {
        const double entry = inverse_diagonal(robot(), at, q)[static_cast<Eigen::Index>(piece.leg)];
        ASSERT_LT(std::abs(entry), 1e-6 * size * size);
      } else {
        ASSERT_LT(std::abs(direct_determinant(robot(), at, q)), 1e-6 * std::pow(size, 4.0));
      }
      ++(piece.kind == BoundaryKind::serial ? serial : parallel);
    }
  EXPECT_GT(parallel, 100U);
  const bool has_branches = robot().leg(0).has_branch(1) && robot().leg(0).has_branch(-1);
  EXPECT_EQ(serial > 100U, has_branches);
}

TEST_P(SingularCurvesOf, PiecesAreShort) {
  const JointWindow& window = followed().projection->window();
  for (const SingularPiece& piece : followed().curves->pieces()) {
    ASSERT_LT((piece.poses[1] - piece.poses[0]).norm(), 0.04);
    const Vector2d change = piece.actuated[1] - piece.actuated[0];
    ASSERT_LT(change.cwiseQuotient(window.upper - window.lower).norm(), 0.04 / full_turn);
  }
}

// What is traced on a grid is near to what is followed, in the same mode.
TEST_P(SingularCurvesOf, NoneThatIsTracedIsMissed) {
  for (const auto& [index, segments] : followed().traced) {
    const WorkingMode& mode = followed().map->working_modes()[index];
    for (std::size_t i = 0; i < segments.size(); i += 11) {
      const BoundarySegment& segment = segments[i];
      if (segment.kind != BoundaryKind::parallel && segment.kind != BoundaryKind::serial) continue;
      double nearest = HUGE_VAL;
      for (const SingularPiece& piece : followed().curves->pieces())
        if (piece.kind == segment.kind && piece.is_of(mode)) {
          Vector2d apart = piece.poses[0] - segment.from;
          for (Eigen::Index k = 0; k < 2; ++k) apart[k] = std::remainder(apart[k], full_turn);
          nearest = std::min(nearest, apart.norm());
        }
      ASSERT_LT(nearest, 0.1) << to_string(mode) << ' ' << segment.from.transpose();
    }
  }
}

// The pose decides the sign of B_jj of the joint that is held.
TEST_P(SingularCurvesOf, TracedBoundariesAreInTheirMode) {
  const auto row = static_cast<Eigen::Index>(held().leg);
  const double largest = robot().leg(held().leg).largest_entry();
  for (const auto& [index, segments] : followed().traced)
    for (const BoundarySegment& segment : segments) {
      JointVector q = actuated(Vector2d::Zero());
      const double entry = inverse_diagonal(robot(), pose(0.5 * (segment.from + segment.to)), q)[row];
      ASSERT_GT(followed().map->working_modes()[index].sign(held().leg) * entry, -0.01 * largest);
    }
}

INSTANTIATE_TEST_SUITE_P(Robots, SingularCurvesOf,
                         testing::Values(CurveCase{"three_rrr", "crank_1_joint", 0.3, false},
                                         CurveCase{"three_prr", "slider_1_joint", 0.3, true},
                                         CurveCase{"three_rpr", "strut_1_joint", 14.98, true}),
                         [](const auto& which) { return which.param.robot; });

// Each value of crank 2 is singular where anchor 2 is on its axis, whatever the mode of the rest.
TEST(SingularCurves, OfCranksThatAreFreeGoAllAround) {
  const auto robot = test::shipped("three_rrr")->mapped_manipulator();
  const MapSlice slice = test::slice_of(robot, {{"crank_1_joint", 0.3}});
  const auto map = test::map_of(robot, test::options_of(slice, 0.2));
  const JointProjection projection(map);
  SingularCurves curves(*map, projection);
  curves.follow_free_cranks();
  double way = 0.0;
  for (const SingularPiece& piece : curves.pieces())
    if (piece.leg == 1 && (piece.poses[1] - piece.poses[0]).norm() < 1e-9) {
      way += (piece.actuated[1] - piece.actuated[0]).norm();
      EXPECT_NEAR(piece.actuated[1].y(), piece.actuated[0].y(), 1e-9);
    }
  EXPECT_GT(way, 1.9 * full_turn);
}

// From either working mode a serial curve has the image on which both meet.
TEST(SerialCurves, HaveOneImage) {
  const auto map = compute_aspect_map(test::shipped("five_bar")->mapped_manipulator(), {}).map;
  const JointProjection projection(map);
  const WorkingMode mode = *WorkingMode::from_signs({1, 1}), other = *WorkingMode::from_signs({-1, 1});
  std::vector<BoundarySegment> serial;
  for (const BoundarySegment& segment :
       trace_slice(*map, mode, PoseSlice(TaskSpace::T2, 0.0), slice_bounds(*map), 60).segments)
    if (segment.kind == BoundaryKind::serial && segment.leg == 0) serial.push_back(segment);
  const auto images = projection.images(serial, mode), others = projection.images(serial, other);
  ASSERT_GT(images.size(), 20U);
  ASSERT_EQ(images.size(), others.size());
  for (std::size_t i = 0; i < images.size(); ++i)
    EXPECT_LT((images[i].from - others[i].from).norm(), 1e-9) << images[i].from.transpose();
}

}  // namespace
}  // namespace parallel_aspects
