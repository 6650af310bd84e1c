// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "aspects/roadmap/pose_sampler.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/clearance_at.h"
#include "support/configuration_at.h"
#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <cmath>
#include <optional>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

using test::all_kinds;
using test::Robot;
using test::with;

Robot within(const Robot& robot, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  Constraints constraints;
  constraints.workspace = WorkspaceBox{lower, upper};
  return with(robot, constraints);
}

Robot stewart() { return test::shipped("stewart")->manipulator(); }

Robot stewart_in_a_box() { return within(stewart(), {-0.2, -0.1, 1.1}, {0.3, 0.2, 1.4}); }

bool is_in_the_box(const Pose& pose) {
  return (pose.position.array() > Eigen::Array3d(-0.2, -0.1, 1.1)).all() &&
         (pose.position.array() < Eigen::Array3d(0.3, 0.2, 1.4)).all();
}

// Poses are sampled in it, so that none is wasted on what lies outside.
TEST(ConstrainedRoadmap, StaysInTheWorkspace) {
  RoadmapOptions options;
  options.samples = 200;
  const RoadmapResult result = compute_pose_roadmap(stewart_in_a_box(), options);
  ASSERT_TRUE(result.roadmap) << result.message;
  std::size_t poses = 0;
  for (const RoadmapSide& side : result.roadmap->sides()) poses += side.poses.size();
  EXPECT_GT(poses, 190U);
  for (const Pose& pose : result.roadmap->poses()) EXPECT_TRUE(is_in_the_box(pose));
  options.region = Box{3, {0.0, -1.0, -1.0}, {1.0, 1.0, 2.0}};
  const RoadmapResult part = compute_pose_roadmap(stewart_in_a_box(), options);
  for (const Pose& pose : part.roadmap->poses()) EXPECT_TRUE(is_in_the_box(pose) && pose.position.x() >= 0.0);
}

// Struts without limits reach everywhere; the workspace bounds them.
TEST(ConstrainedRoadmap, TheWorkspaceBoundsWhatLegsDoNot) {
  EXPECT_EQ(compute_pose_roadmap(test::dietmaier()).status, MapStatus::refused);
  RoadmapOptions options;
  options.samples = 50;
  const Robot robot =
      within(test::dietmaier(), Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0));
  EXPECT_EQ(compute_pose_roadmap(robot, options).status, MapStatus::complete);
}

TEST(ConstrainedRoadmap, AnswersNameTheConstraintThatFails) {
  const SegmentCertifier certifier(stewart_in_a_box());
  const WorkingMode mode(6);
  PoseInMode inside{{}, mode}, outside{{}, mode};
  inside.pose.position = {0.0, 0.0, 1.3};
  outside.pose.position = {0.0, 0.0, 1.41};
  const AspectComparison answer = same_aspect(certifier, inside, outside);
  EXPECT_EQ(answer.answer, SameAspect::no);
  EXPECT_EQ(answer.message,
            "The second configuration lies in no aspect: the constraint workspace does not hold there.");
  EXPECT_EQ(answer.failing, ConstraintKind::workspace);
  outside.pose.position = {0.0, 0.0, 3.0};
  const AspectComparison far = same_aspect(certifier, outside, inside);
  EXPECT_EQ(far.failing, ConstraintKind::actuated_limits) << far.message;
  EXPECT_NE(far.message.find("the actuated joint of leg '"), std::string::npos) << far.message;
  outside.pose.position = {0.0, 0.0, 1.39};
  const AspectComparison same = same_aspect(certifier, inside, outside);
  EXPECT_EQ(same.answer, SameAspect::yes) << same.message;
  EXPECT_FALSE(same.failing);
}

// A segment is proved only where all of it is in the workspace, although its ends alone may be asked.
TEST(ConstrainedRoadmap, SegmentsThatLeaveTheWorkspaceAreNeverProved) {
  const SegmentCertifier bounded(stewart_in_a_box()), free(stewart());
  PoseSampler sampler(stewart(), 7, Box{3, {-0.3, -0.2, 1.0}, {0.4, 0.3, 1.5}}, 0.3);
  const WorkingMode mode(6);
  int proved = 0, refused = 0;
  for (int i = 0; i < test::thinned(300); ++i) {
    const auto from = sampler.draw(), to = sampler.draw();
    if (!from || !to || free.prove(*from, *to, mode).verdict != SegmentVerdict::free) continue;
    const bool inside = is_in_the_box(*from) && is_in_the_box(*to);
    EXPECT_EQ(bounded.prove(*from, *to, mode).verdict,
              inside ? SegmentVerdict::free : SegmentVerdict::blocked);
    ++(inside ? proved : refused);
  }
  if (test::is_sanitized) return;
  EXPECT_GT(proved, 5);
  EXPECT_GT(refused, 50);
}

// Along every segment of a roadmap with six degrees of freedom, by formulas of the test, at poses that the
// proof did not choose.
TEST(ConstrainedRoadmap, SegmentsKeepTheMargins) {
  const Margins margins{0.02, 0.0, 0.0};
  const Robot robot = stewart()->with_margins(margins);
  RoadmapOptions options;
  options.samples = test::is_sanitized ? 60 : 400;
  options.largest_rotation = 0.6;
  const RoadmapResult result = compute_pose_roadmap(robot, options);
  ASSERT_TRUE(result.roadmap) << result.message;
  std::mt19937_64 random{31};
  int segments = 0, near = 0;
  for (const RoadmapSide& side : result.roadmap->sides())
    for (std::size_t a = 0; a < side.poses.size(); ++a)
      for (const std::uint32_t b : side.links[a]) {
        if (b < a) continue;
        ++segments;
        const Pose &from = result.roadmap->poses()[side.poses[a]],
                   &to = result.roadmap->poses()[side.poses[b]];
        for (int n = 0; n < 30; ++n) {
          const Pose pose = pose_between(from, to, test::uniform(random, 0.0, 1.0));
          const auto index =
              static_cast<double>(test::ConfigurationAt<long double>(*robot, pose, side.mode).parallel());
          EXPECT_GE(index * side.determinant_sign, margins.parallel - 1e-12)
              << to_string(TaskSpace::SE3, from) << " to " << to_string(TaskSpace::SE3, to);
          near += std::abs(index) < 2.0 * margins.parallel;
        }
      }
  EXPECT_GT(segments, test::is_sanitized ? 10 : 100);
  if (test::is_sanitized) return;
  EXPECT_GT(near, 10);
}

/// How far a configuration is from breaking each constraint, by a second way.
double clearance(const test::ClearanceAt& at, ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::passive_limits:
      return at.of_passive_joints();
    case ConstraintKind::cones:
      return at.of_cones();
    case ConstraintKind::self_collision:
      return at.of_self_collision();
    case ConstraintKind::obstacles:
      return at.of_obstacles();
    case ConstraintKind::margins:
      return at.of_margins();
    case ConstraintKind::workspace:
    case ConstraintKind::actuated_limits:
      break;
  }
  return at.of_workspace();
}

TEST(ConstrainedRoadmap, TheConstraintThatIsNamedFails) {
  ConstraintKinds named;
  for (const Robot& plain : {test::five_bar(), test::three_rrr(), test::delta()}) {
    const Robot robot = with(plain, all_kinds(plain, 0.02));
    const SegmentCertifier certifier(robot);
    PoseSampler sampler(plain, 3, std::nullopt, EIGEN_PI);
    for (int i = 0; i < test::thinned(2000); ++i) {
      const auto pose = sampler.draw();
      if (!pose) continue;
      for (const WorkingMode& mode : working_modes(*robot)) {
        const ConfigurationProof proof = certifier.prove(*pose, mode);
        if (proof.proved_violation != Violation::constraint) continue;
        ASSERT_TRUE(proof.failing);
        named[index_of(*proof.failing)] = true;
        const InverseSolution solution = inverse(*robot, *pose, mode);
        EXPECT_LT(clearance(test::ClearanceAt(*robot, *pose, solution.q), *proof.failing),
                  1e-3 * robot->size())
            << name(*proof.failing) << " at " << to_string(robot->task_space(), *pose);
      }
    }
  }
  // Limits of actuated joints are another violation.
  if (test::is_sanitized) return;
  EXPECT_EQ(named.count(), all_constraint_kinds.size() - 1);
}

TEST(ConstrainedSlice, IsMappedInTheWorkspaceOnly) {
  const Robot robot = stewart_in_a_box();
  const auto map =
      test::map_of(robot, test::options_of(test::slice_of(robot, test::upright({{"z", 1.3}})), 0.05));
  ASSERT_TRUE(map);
  EXPECT_NEAR(map->region().lower[0], -0.2, 1e-3);
  EXPECT_NEAR(map->region().upper[1], 0.2, 1e-3);
  for (const Aspect& aspect : map->aspects())
    map->visit_inside_poses(aspect.id, [](const Pose& pose, double) { EXPECT_TRUE(is_in_the_box(pose)); });
  MapOptions beyond = test::options_of(test::slice_of(robot, test::upright({{"z", 1.5}})), 0.05);
  EXPECT_EQ(compute_aspect_map(robot, beyond).message,
            "The slice holds a position outside of the workspace that the constraints of 'stewart' name; "
            "hold it inside, or leave the constraint out.");
}

struct PlanarSlice {
  Robot plain;
  test::Held held;
};

// Every kind of constraint, against a second way to all of them at random poses of slices of planar robots.
TEST(ConstrainedSlice, OfPlanarRobotsKnowsAllConstraints) {
  std::mt19937_64 random(8);
  for (const auto& [plain, held] :
       {PlanarSlice{test::three_rrr(), {{"phi", 0.4}}}, PlanarSlice{test::three_rrr(), {{"y", -2.0}}},
        PlanarSlice{test::three_rpr(), {{"phi", 2.1}}}, PlanarSlice{test::five_bar(), {{"x", 5.0}}}}) {
    const Robot robot = with(plain, all_kinds(plain, 0.01));
    MapOptions options = test::options_of(test::slice_of(robot, held), 0.4);
    options.extra_levels = 1;
    const auto map = test::map_of(robot, options);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->manipulator()->constraint_kinds(), robot->constraint_kinds());
    int inside = 0, outside = 0;
    for (int i = 0; i < test::thinned(4000); ++i) {
      const PoseSpace& space = map->contents().tree.space();
      const Pose pose = space.pose(test::random_position(space, random));
      for (const WorkingMode& mode : working_modes(*robot)) {
        const Location found = map->locate(pose, mode);
        const auto sign = test::sign_at(*robot, pose, mode);
        if (!sign || found.status == LocationStatus::undecided) continue;
        double clearance = -1.0;
        if (*sign != 0)
          clearance = test::ClearanceAt(*robot, pose, inverse(*robot, pose, mode).q).of_all() / robot->size();
        const std::string where = to_string(mode) + " at " + to_string(robot->task_space(), pose);
        if (found.status == LocationStatus::inside) {
          EXPECT_EQ(map->aspects()[static_cast<std::size_t>(found.aspect - 1)].determinant_sign, *sign)
              << where;
          EXPECT_GT(clearance, -1e-3) << where;
        } else {
          EXPECT_LT(clearance, 1e-3) << where;
        }
        ++(found.status == LocationStatus::inside ? inside : outside);
      }
    }
    if (test::is_sanitized) return;
    EXPECT_GT(inside, 20) << robot->name();
    EXPECT_GT(outside, 100) << robot->name();
  }
}

TEST(ConstrainedMap, RegionsAreClippedToTheWorkspace) {
  const Robot robot = within(test::five_bar(), {-1.0, 2.0, 0.0}, {5.0, 6.0, 0.0});
  MapOptions options;
  options.region = Box{2, {0.0, 0.0, 0.0}, {9.0, 9.0, 0.0}};
  const auto map = test::map_of(robot, options);
  EXPECT_EQ(map->region().lower, (MapPoint{0.0, 2.0, 0.0}));
  EXPECT_EQ(map->region().upper, (MapPoint{5.0, 6.0, 0.0}));
  options.region = Box{2, {6.0, 0.0, 0.0}, {9.0, 9.0, 0.0}};
  EXPECT_EQ(compute_aspect_map(robot, options).message,
            "The workspace that the constraints of 'five_bar' name holds no position of the region, or is "
            "too thin for a map; correct constraints.workspace, or leave it out.");
  options.region = Box{3, {0.0, 0.0, 0.0}, {9.0, 9.0, 9.0}};
  EXPECT_EQ(compute_aspect_map(robot, options).message,
            "The region of the map has 3 coordinates; give one for each position that is free, which are 2.");
}

}  // namespace
}  // namespace parallel_aspects
