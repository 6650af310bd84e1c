// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"
#include "aspects/roadmap/pose_sampler.h"
#include "aspects/tree/slice_space.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/same_aspect.h"
#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "support/clearance_at.h"
#include "support/constrained_robots.h"
#include "support/robots.h"
#include "support/shipped.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <cmath>
#include <functional>
#include <optional>
#include <random>

namespace parallel_aspects {
namespace {

using test::Robot;
using test::with;

struct Case {
  const char* name;
  std::function<Robot()> make;
  test::Held held;  // of a slice; empty for a map
};

const Case cases[] = {
    {"delta", test::delta, {}},
    {"linear_delta", test::linear_delta, {}},
    {"five_bar", test::five_bar, {}},
    {"three_rrr", test::three_rrr, {}},
    {"three_rpr", test::three_rpr, {}},
    {"three_rrr_turning", test::three_rrr, {{"x", -4.0}}},
    {"hexa", [] { return test::shipped("hexa")->manipulator(); }, test::upright({{"z", -0.6}})},
    {"stewart", [] { return test::shipped("stewart")->manipulator(); }, test::upright({{"z", 1.3}})},
    {"stewart_turning",
     [] { return test::shipped("stewart")->manipulator(); },
     {{"z", 1.3}, {"roll", 0.1}, {"pitch", 0.0}}},
    {"stewart_tilting",
     [] { return test::shipped("stewart")->manipulator(); },
     {{"x", 0.0}, {"y", 0.1}, {"z", 1.3}}},
    {"six_pus", [] { return test::shipped("six_pus")->manipulator(); }, test::upright()}};

/// Cones about where the rods are at some pose, of every kind and size: narrow, of half a turn and wider.
class ConesTest : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    const Robot plain = GetParam().make();
    std::optional<MapSlice> slice;
    if (!GetParam().held.empty()) slice = test::slice_of(plain, GetParam().held);
    space = make_space(*plain, slice);
    const auto start = draw_start(*plain);
    ASSERT_TRUE(start);
    mode = start->mode;
    Constraints constraints;
    constraints.cones = draw_cones(*plain, *start);
    robot = with(plain, constraints);
    classifier = make_classifier(*robot, slice);
  }

  double uniform(double lower, double upper) { return test::uniform(random, lower, upper); }

  std::unique_ptr<const BoxClassifier> make_classifier(const Manipulator& of,
                                                       const std::optional<MapSlice>& slice) {
    return slice ? make_slice_classifier(of, {mode}, *slice) : make_box_classifier(of, {mode});
  }

  std::shared_ptr<const PoseSpace> make_space(const Manipulator& of, const std::optional<MapSlice>& slice) {
    mode = WorkingMode(of.leg_count());
    const double size = of.size();  // rails without ends reach everywhere
    const Box around{3, {-size, -size, -size}, {size, size, size}};
    const Box reachable = make_classifier(of, slice)->reachable_positions().value_or(around);
    return slice ? make_slice_space(*slice, reachable, of.characteristic_length())
                 : make_pose_space(of.task_space(), reachable, of.characteristic_length());
  }

  struct Start {
    Pose pose;
    WorkingMode mode;
    JointVector q;
  };

  std::optional<Start> draw_start(const Manipulator& of) {
    for (int i = 0; i < 100000; ++i) {
      const Pose pose = space->pose(test::random_position(*space, random));
      for (const InverseSolution& solution : inverse_in_all_modes(of, pose))
        if (solution.status == InverseStatus::solved &&
            test::sign_at(of, pose, solution.mode).value_or(0) != 0)
          return Start{pose, solution.mode, solution.q};
    }
    return std::nullopt;
  }

  std::vector<BallJointCone> draw_cones(const Manipulator& of, const Start& start) {
    const test::ClearanceAt at(of, start.pose, start.q);
    const double angles[] = {0.9, 0.5 * EIGEN_PI, 2.3};
    std::vector<BallJointCone> cones;
    for (std::size_t k = 0; k < 4; ++k) {
      BallJointCone cone{k % of.leg_count(), k % 2 == 0 ? LegEnd::platform : LegEnd::base, {}, angles[k % 3]};
      Eigen::Vector3d about =
          is_planar(of.task_space())
              ? Eigen::Vector3d::UnitZ()
              : Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
      cone.axis = Eigen::AngleAxisd(0.8 * cone.angle, about) * at.seen_rod(cone.leg, cone.end).normalized();
      cones.push_back(cone);
    }
    return cones;
  }

  MapPosition random_box(double largest_share, Box& box) {
    box = space->region();
    const double share = largest_share * std::pow(2.0, uniform(-8.0, 0.0));
    for (std::size_t i = 0; i < box.dimension; ++i) {
      const double width = share * space->region().width(i);
      box.lower[i] = uniform(space->region().lower[i], space->region().upper[i] - width);
      box.upper[i] = box.lower[i] + width;
    }
    return {static_cast<RootIndex>(random() % space->root_count()), box.lower};
  }

  MapPoint random_point(const Box& box) {
    MapPoint point{};
    for (std::size_t i = 0; i < box.dimension; ++i) point[i] = uniform(box.lower[i], box.upper[i]);
    return point;
  }

  double clearance(const Pose& pose) const {
    return test::ClearanceAt(*robot, pose, inverse(*robot, pose, mode).q).of_cones();
  }

  LeafState state(RootIndex root, const Box& box) const {
    const RoundingUpward rounding;
    return classifier->state(root, box, 0);
  }

  std::mt19937_64 random{20261122};
  Robot robot;
  WorkingMode mode{1};
  std::shared_ptr<const PoseSpace> space;
  std::unique_ptr<const BoxClassifier> classifier;
};

TEST_P(ConesTest, NoPoseContradictsItsBox) {
  std::size_t samples = 0, inside = 0, shut_out = 0;
  for (int i = 0; samples < test::thinned<std::size_t>(100000) && i < 400000; ++i) {
    Box box;
    const RootIndex root = random_box(0.05, box).root;
    const LeafState found = state(root, box);
    for (int k = 0; k < 4; ++k, ++samples) {
      const Pose pose = space->pose({root, random_point(box)});
      const auto sign = test::sign_at(*robot, pose, mode);
      if (!sign) continue;
      const double margin = *sign == 0 ? -1.0 : clearance(pose);
      if (found.is_inside()) {
        ++inside;
        ASSERT_TRUE(found.is_inside(*sign) && margin > -1e-9)
            << to_string(robot->task_space(), pose) << ' ' << margin;
      } else if (*sign != 0 && margin > 1e-9) {
        ASSERT_TRUE(found.may_be(*sign)) << to_string(robot->task_space(), pose) << ' ' << margin;
      } else if (*sign != 0) {
        shut_out += found.is_outside();
      }
    }
  }
  EXPECT_TRUE(test::is_sanitized || inside > 100U) << inside;
  EXPECT_TRUE(test::is_sanitized || shut_out > 20U) << shut_out;
}

TEST_P(ConesTest, SmallBoxesAreDecidedOnEitherSide) {
  int in_cones = 0, decided_inside = 0, beyond = 0, decided_outside = 0;
  for (int i = 0; i < test::thinned(20000); ++i) {
    Box box;
    const RootIndex root = random_box(0.0, box).root;
    for (std::size_t k = 0; k < box.dimension; ++k) box.upper[k] += 1e-9 * space->region().width(k);
    const Pose pose = space->pose({root, box.lower});
    if (test::sign_at(*robot, pose, mode).value_or(0) == 0) continue;
    const double margin = clearance(pose);
    if (std::abs(margin) < 1e-4) continue;
    const LeafState found = state(root, box);
    ++(margin > 0.0 ? in_cones : beyond);
    decided_inside += margin > 0.0 && found.is_inside();
    decided_outside += margin < 0.0 && found.is_outside();
  }
  EXPECT_TRUE(test::is_sanitized || in_cones > 10) << in_cones;
  EXPECT_TRUE(test::is_sanitized || beyond > 10) << beyond;
  EXPECT_GE(decided_inside, 0.999 * in_cones) << in_cones;
  EXPECT_GE(decided_outside, 0.999 * beyond) << beyond;
}

// Of all conditions, the cones among them.
TEST_P(ConesTest, SlopesAreThoseOfFiniteDifferences) {
  const auto conditions = [this](const MapPosition& position) {
    const RoundingUpward rounding;
    return classifier->conditions(position, 0, 1);
  };
  int compared = 0;
  for (int i = 0; i < 20000 && compared < 500; ++i) {
    const MapPosition position = test::random_position(*space, random);
    if (test::sign_at(*robot, space->pose(position), mode).value_or(0) == 0) continue;
    const Conditions here = conditions(position);
    ASSERT_GE(here.count, robot->leg_count() + 1 + robot->constraints().cones.size());
    for (std::size_t k = 0; k < space->dimension(); ++k) {
      const double step = 1e-6 * space->region().width(k);
      MapPosition before = position, after = position;
      before.point[k] -= step;
      after.point[k] += step;
      const Conditions low = conditions(before), high = conditions(after);
      if (low.count != here.count || high.count != here.count) continue;
      for (std::size_t c = 0; c < here.count; ++c) {
        const double one = (here.items[c].value - low.items[c].value) / step,
                     other = (high.items[c].value - here.items[c].value) / step;
        // Where B_jj is nearly 0, its slope is too steep for differences.
        const double bend = std::abs(one - other);
        ASSERT_NEAR(here.items[c].slope[k], 0.5 * (one + other),
                    bend + 1e-5 * (std::abs(one) + std::pow(robot->size(), 3)))
            << "condition " << c << " at " << to_string(robot->task_space(), space->pose(position));
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 500);
}

TEST_P(ConesTest, FreeSegmentsStayInTheCones) {
  const SegmentCertifier certifier(robot);
  int free = 0, blocked = 0;
  for (int i = 0; i < test::thinned(2000); ++i) {
    Box box;
    const RootIndex root = random_box(0.1, box).root;
    const Pose from = space->pose({root, random_point(box)}), to = space->pose({root, random_point(box)});
    const ConfigurationProof start = certifier.prove(from, mode);
    if (start.failing == ConstraintKind::cones) {
      ++blocked;
      ASSERT_LT(clearance(from), 1e-9);
    }
    if (certifier.prove(from, to, mode).verdict != SegmentVerdict::free) continue;
    ++free;
    for (int k = 0; k <= 10; ++k) ASSERT_GT(clearance(pose_between(from, to, 0.1 * k)), -1e-9);
  }
  EXPECT_GT(free, test::is_sanitized ? -1 : 5);
  EXPECT_GT(blocked, test::is_sanitized ? -1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, ConesTest, testing::ValuesIn(cases),
                         [](const auto& each) { return std::string(each.param.name); });

Robot delta_with_cones(double at_crank, double at_platform) {
  const Robot plain = test::delta();
  Constraints constraints;
  for (std::size_t j = 0; j < 3; ++j) {
    constraints.cones.push_back({j, LegEnd::base, Eigen::Vector3d::UnitY(), at_crank});
    constraints.cones.push_back({j, LegEnd::platform, -Eigen::Vector3d::UnitZ(), at_platform});
  }
  return with(plain, constraints);
}

// Rods that hang down at the platform and to the side of the crank that its angle grows to: of the eight
// working modes one is left, and of that one aspect.
TEST(Cones, LeaveTheDeltaTheAspectThatItWorksIn) {
  MapOptions options;
  options.resolution = test::is_sanitized ? 0.2 : 0.08;
  options.extra_levels = 4;
  const MapResult found = compute_aspect_map(delta_with_cones(1.4, 0.8), options);
  ASSERT_TRUE(found.map) << found.message;
  if (test::is_sanitized) return;
  EXPECT_EQ(found.map->proved_count(), 1U);
  EXPECT_TRUE(found.map->unresolved().empty());
  ASSERT_EQ(found.map->aspects().size(), 1U);
  EXPECT_EQ(to_string(found.map->aspects()[0].mode), "(+,+,+)");
  Pose below;
  below.position = {0.0, 0.0, -0.8};
  EXPECT_EQ(found.map->locate(below, found.map->aspects()[0].mode).status, LocationStatus::inside);
}

Robot stewart_with_cones(double angle) {
  const Robot plain = test::shipped("stewart")->manipulator();
  Constraints constraints;
  const Pose home{{0.0, 0.0, 1.3}, Eigen::Quaterniond::Identity()};
  const JointVector q = inverse(*plain, home, WorkingMode(6)).q;
  const test::ClearanceAt at(*plain, home, q);
  for (std::size_t j = 0; j < 6; ++j)
    for (const LegEnd end : {LegEnd::base, LegEnd::platform})
      constraints.cones.push_back({j, end, at.seen_rod(j, end).normalized(), angle});
  return with(plain, constraints);
}

TEST(Cones, BoundTheRoadmapOfAStewartPlatform) {
  RoadmapOptions options;
  options.samples = test::thinned(400);
  options.largest_rotation = 0.7;
  const Robot robot = stewart_with_cones(0.6);
  const RoadmapResult result = compute_pose_roadmap(robot, options);
  ASSERT_TRUE(result.roadmap) << result.message;
  std::size_t poses = 0;
  for (const RoadmapSide& side : result.roadmap->sides())
    for (const std::uint32_t index : side.poses) {
      const Pose& pose = result.roadmap->poses()[index];
      EXPECT_GT(test::ClearanceAt(*robot, pose, inverse(*robot, pose, side.mode).q).of_cones(), -1e-9);
      ++poses;
    }
  EXPECT_GT(poses, test::is_sanitized ? 0U : 10U);
  EXPECT_LT(poses, result.roadmap->poses().size());
}

TEST(Cones, AreNamedWhereTheyFail) {
  const SegmentCertifier certifier(stewart_with_cones(0.35));
  const WorkingMode mode(6);
  PoseInMode inside{{{0.0, 0.0, 1.3}, Eigen::Quaterniond::Identity()}, mode}, outside = inside;
  outside.pose.position.x() = 0.5;
  const AspectComparison answer = same_aspect(certifier, inside, outside);
  EXPECT_EQ(answer.answer, SameAspect::no);
  EXPECT_EQ(answer.message,
            "The second configuration lies in no aspect: the constraint cones does not hold there.");
  outside.pose.position.x() = 0.05;
  EXPECT_EQ(same_aspect(certifier, inside, outside).answer, SameAspect::yes);
}

std::string problem_with(const Robot& plain, const BallJointCone& cone) {
  Constraints constraints;
  constraints.cones.push_back(cone);
  try {
    with(plain, constraints);
  } catch (const InvalidDescription& invalid) {
    return invalid.problems().size() == 1 ? invalid.problems().front() : "several problems";
  }
  return "";
}

TEST(Cones, ThatDoNotFitTheLegsAreRefused) {
  const auto says = [](const std::string& problem, const std::string& part) {
    return problem.find(part) != std::string::npos;
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  EXPECT_EQ(problem_with(test::delta(), {2, LegEnd::base, x, 3.0}), "");
  EXPECT_TRUE(
      says(problem_with(test::delta(), {3, LegEnd::base, x, 3.0}), "names leg 4, but the robot has 3"));
  EXPECT_TRUE(says(problem_with(test::delta(), {0, LegEnd::base, 2.0 * x, 1.0}), "not a unit vector"));
  EXPECT_TRUE(
      says(problem_with(test::delta(), {0, LegEnd::base, x * std::nan(""), 1.0}), "not a unit vector"));
  EXPECT_TRUE(
      says(problem_with(test::five_bar(), {0, LegEnd::base, Eigen::Vector3d::UnitZ(), 1.0}), "of the plane"));
  for (const double angle : {0.0, -1.0, static_cast<double>(EIGEN_PI), 4.0, std::nan("")})
    EXPECT_TRUE(says(problem_with(test::delta(), {1, LegEnd::platform, x, angle}),
                     "The cone at the platform end of leg 2 has an angle of"))
        << angle;
  EXPECT_TRUE(says(problem_with(test::agile_eye(), {0, LegEnd::base, x, 1.0}), "SO3"));
  EXPECT_TRUE(says(problem_with(test::three_rrr_actuated_elbow(), {0, LegEnd::base, x, 1.0}), "elbow"));
}

}  // namespace
}  // namespace parallel_aspects
