// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"
#include "draw/plane/map_pictures.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/clearance_at.h"
#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include "support/sign_at.h"
#include "support/thoroughness.h"
#include <functional>
#include <random>
#include <set>

namespace parallel_aspects {
namespace {

using test::all_kinds;
using test::Robot;
using test::with;

// A small robot between long rails, around the poses that it reaches.
Robot narrow_three_prr() {
  Constraints constraints = all_kinds(test::three_prr(), 0.005);
  constraints.workspace = WorkspaceBox{Eigen::Vector3d::Constant(-0.4), Eigen::Vector3d::Constant(0.35)};
  constraints.passive_limits.pop_back();
  return with(test::three_prr(), constraints);
}

struct Case {
  const char* name;
  std::function<Robot()> make;
};

const Case cases[] = {
    {"five_bar", [] { return with(test::five_bar(), all_kinds(test::five_bar(), 0.01)); }},
    {"five_bar_of_segments", [] { return with(test::five_bar(), all_kinds(test::five_bar(), 0.0)); }},
    {"three_rrr", [] { return with(test::three_rrr(), all_kinds(test::three_rrr(), 0.01)); }},
    {"three_rpr", [] { return with(test::three_rpr(), all_kinds(test::three_rpr(), 0.01)); }},
    {"three_prr", narrow_three_prr},
    {"delta", [] { return with(test::delta(), all_kinds(test::delta(), 0.02)); }},
    {"linear_delta", [] { return with(test::linear_delta(), all_kinds(test::linear_delta(), 0.02)); }},
};

class ConstraintsTest : public testing::TestWithParam<Case> {
 protected:
  // Somewhat beyond the workspace, and within reach where that is bounded.
  Box positions() const {
    const WorkspaceBox& workspace = *robot->constraints().workspace;
    const auto reachable = classifier->reachable_positions();
    Box box{directions(robot->task_space()), {}, {}};
    for (std::size_t i = 0; i < box.dimension; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      box.lower[i] = 1.2 * workspace.lower[row];
      box.upper[i] = 1.2 * workspace.upper[row];
      if (!reachable) continue;
      box.lower[i] = std::max(box.lower[i], reachable->lower[i]);
      box.upper[i] = std::min(box.upper[i], reachable->upper[i]);
    }
    return box;
  }

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random);
  }

  Box random_box(double largest_share) {
    Box box = space->region();
    const double share = largest_share * std::pow(2.0, uniform(-8.0, 0.0));
    for (std::size_t i = 0; i < box.dimension; ++i) {
      const double width = share * space->region().width(i);
      box.lower[i] = uniform(space->region().lower[i], space->region().upper[i] - width);
      box.upper[i] = box.lower[i] + width;
    }
    return box;
  }

  // The sign of det A where every constraint holds, 0 where one does not; nothing where rounding may matter.
  std::optional<int> sign_at(const MapPoint& point, const WorkingMode& mode) const {
    const Pose pose = space->pose({0, point});
    const auto sign = test::sign_at(*robot, pose, mode);
    if (!sign || *sign == 0) return sign;
    const InverseSolution solution = inverse(*robot, pose, mode);
    const double clearance = test::ClearanceAt(*robot, pose, solution.q).of_all();
    // Boxes are sampled with a step of a 400th of a link.
    if (std::abs(clearance) < 1e-3 * robot->size()) return std::nullopt;
    return clearance > 0.0 ? *sign : 0;
  }

  MapPoint random_point(const Box& box) {
    MapPoint point{};
    for (std::size_t i = 0; i < box.dimension; ++i) point[i] = uniform(box.lower[i], box.upper[i]);
    return point;
  }

  Robot robot = GetParam().make();
  std::vector<WorkingMode> modes = working_modes(*robot);
  std::unique_ptr<const BoxClassifier> classifier = make_box_classifier(*robot, modes);
  std::shared_ptr<const PoseSpace> space =
      make_pose_space(robot->task_space(), positions(), robot->characteristic_length());
  std::mt19937_64 random{20261121};
};

TEST_P(ConstraintsTest, NoPoseContradictsItsBox) {
  std::vector<LeafState> states(modes.size());
  std::size_t inside = 0, shut_out = 0;
  for (int i = 0; i < test::thinned(4000); ++i) {
    const Box box = random_box(0.05);
    {
      const RoundingUpward rounding;
      classifier->classify(0, box, ~ModeSet{0}, Detail::parts, states.data());
    }
    const MapPoint point = random_point(box);
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const auto sign = sign_at(point, modes[m]);
      if (!sign) continue;
      inside += states[m].is_inside();
      shut_out += *sign == 0 && states[m].is_outside();
      ASSERT_FALSE(states[m].is_inside() ? !states[m].is_inside(*sign)
                                         : *sign != 0 && !states[m].may_be(*sign))
          << "box " << box.lower[0] << ' ' << box.lower[1] << ' ' << box.lower[2] << " to " << box.upper[0]
          << ' ' << box.upper[1] << ' ' << box.upper[2] << ", mode " << to_string(modes[m]) << ", pose "
          << to_string(robot->task_space(), space->pose({0, point})) << ", sign " << *sign;
    }
  }
  EXPECT_TRUE(test::is_sanitized || inside > 15U) << inside;
  EXPECT_TRUE(test::is_sanitized || shut_out > 100U) << shut_out;
}

TEST_P(ConstraintsTest, SmallBoxesAreDecided) {
  std::vector<LeafState> states(modes.size());
  int decided = 0, clear = 0;
  for (int i = 0; i < test::thinned(1000); ++i) {
    Box box = random_box(0.0);
    for (std::size_t k = 0; k < box.dimension; ++k) box.upper[k] += 1e-9 * space->region().width(k);
    const RoundingUpward rounding;
    classifier->classify(0, box, ~ModeSet{0}, Detail::parts, states.data());
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (!sign_at(box.lower, modes[m])) continue;
      ++clear;
      decided += !states[m].is_undecided();
    }
  }
  EXPECT_TRUE(test::is_sanitized || clear > 100) << clear;
  EXPECT_GE(decided, clear * 0.999) << decided << " of " << clear;
}

// What is whole has no two poses of the set that no part of the box joins: both must be proved to lie in one
// set by monotonicity alone, so the corner that the set grows to is in it wherever anything is.
TEST_P(ConstraintsTest, SetsThatGrowHoldTheirHighestCorner) {
  std::size_t grown = 0;
  for (int i = 0; i < 4000; ++i) {
    const Box box = random_box(0.02);
    const MapPoint point = random_point(box);
    for (std::size_t m = 0; m < modes.size(); ++m)
      for (const int sign : {1, -1}) {
        const Examined found = [&] {
          const RoundingUpward rounding;
          return classifier->examine(0, box, m, sign);
        }();
        if (!found.state.is_undecided() || !found.monotonicity.along_all(box) ||
            sign_at(point, modes[m]) != sign)
          continue;
        ++grown;
        const auto corner = sign_at(found.monotonicity.highest(box), modes[m]);
        ASSERT_TRUE(!corner || *corner == sign)
            << "box " << box.lower[0] << ' ' << box.lower[1] << ' ' << box.lower[2] << " to " << box.upper[0]
            << ' ' << box.upper[1] << ' ' << box.upper[2] << ", mode " << to_string(modes[m]) << ", pose "
            << to_string(robot->task_space(), space->pose({0, point}));
      }
  }
  EXPECT_GT(grown, 0U);
}

TEST_P(ConstraintsTest, FreeSegmentsKeepEveryConstraint) {
  const SegmentCertifier certifier(robot);
  int free = 0, blocked = 0;
  for (int i = 0; i < 400; ++i) {
    const Box box = random_box(0.1);
    const Pose from = space->pose({0, random_point(box)}), to = space->pose({0, random_point(box)});
    const WorkingMode& mode = modes[random() % modes.size()];
    const SegmentProof proof = certifier.prove(from, to, mode);
    free += proof.verdict == SegmentVerdict::free;
    blocked += proof.verdict == SegmentVerdict::blocked;
    if (proof.verdict != SegmentVerdict::free) continue;
    for (int k = 0; k <= 10; ++k) {
      const Pose pose = pose_between(from, to, 0.1 * k);
      const InverseSolution solution = inverse(*robot, pose, mode);
      ASSERT_EQ(solution.status, InverseStatus::solved);
      ASSERT_GT(test::ClearanceAt(*robot, pose, solution.q).of_all(), -1e-9)
          << to_string(mode) << " from " << to_string(robot->task_space(), from) << " to "
          << to_string(robot->task_space(), to) << " at " << 0.1 * k;
    }
  }
  EXPECT_GT(free, 2);
  EXPECT_GT(blocked, 50);
}

INSTANTIATE_TEST_SUITE_P(Robots, ConstraintsTest, testing::ValuesIn(cases),
                         [](const auto& each) { return std::string(each.param.name); });

// Caro et al. (Artificial Intelligence 211, 2014) remove the poses where links collide as segments, and still
// find ten aspects.
TEST(SelfCollision, LeavesTenAspectsOfTheFiveBar) {
  Constraints segments;
  segments.self_collision.emplace();
  MapOptions options;
  for (const double resolution : {0.2, 0.1}) {
    options.resolution = resolution;
    const MapResult found = compute_aspect_map(with(test::five_bar(), segments), options);
    ASSERT_TRUE(found.map) << found.message;
    EXPECT_EQ(found.map->proved_count(), 10U) << resolution;
    EXPECT_TRUE(found.map->unresolved().empty()) << resolution;
    const MapResult whole = compute_aspect_map(test::five_bar(), options);
    double with_collisions = 0.0, without = 0.0;
    for (const Aspect& aspect : found.map->aspects()) with_collisions += aspect.measure_upper;
    for (const Aspect& aspect : whole.map->aspects()) without += aspect.measure_lower;
    EXPECT_LT(with_collisions, without);
  }
}

TEST(Constraints, ThatAreSwitchedOffDoNotBoundTheMap) {
  const Robot robot = with(test::five_bar(), all_kinds(test::five_bar(), 0.01));
  MapOptions options;
  options.resolution = 0.8;
  options.extra_levels = 2;
  const auto measure = [&](ConstraintKinds kinds) {
    const MapResult found = compute_aspect_map(robot->with_constraints(kinds), options);
    double sum = 0.0;
    for (const Aspect& aspect : found.map->aspects()) sum += aspect.measure;
    return sum;
  };
  const double without = measure({});
  EXPECT_DOUBLE_EQ(without, [&] {
    const MapResult found = compute_aspect_map(test::five_bar(), options);
    double sum = 0.0;
    for (const Aspect& aspect : found.map->aspects()) sum += aspect.measure;
    return sum;
  }());
  for (const ConstraintKind kind : all_constraint_kinds) {
    ConstraintKinds one;
    one[index_of(kind)] = true;
    EXPECT_EQ(robot->with_constraints(one)->constraint_kinds(),
              kind == ConstraintKind::actuated_limits ? ConstraintKinds() : one);
    if (kind == ConstraintKind::actuated_limits) continue;
    EXPECT_LT(measure(one), 0.98 * without) << name(kind);
  }
}

TEST(Constraints, AreEachReportedWithTheirBoundary) {
  MapOptions options;
  options.resolution = 0.4;
  Constraints only_workspace;
  only_workspace.workspace = WorkspaceBox{{-1.0, 2.0, 0.0}, {5.0, 6.0, 0.0}};
  const auto boundaries =
      constraint_boundaries(*compute_aspect_map(with(test::five_bar(), only_workspace), options).map);
  ASSERT_EQ(boundaries.size(), 1U);
  EXPECT_EQ(boundaries[0].kind, ConstraintKind::workspace);
  EXPECT_TRUE(constraint_boundaries(*compute_aspect_map(test::five_bar(), options).map).empty());
  const auto of_struts = constraint_boundaries(*compute_aspect_map(test::bipod(), options).map);
  ASSERT_EQ(of_struts.size(), 1U);
  EXPECT_EQ(of_struts[0].kind, ConstraintKind::actuated_limits);
  EXPECT_GT(of_struts[0].leaves, 10U);
  EXPECT_GT(of_struts[0].measure, 0.0);
}

/// The kinds of boundaries in all pictures of a map.
std::set<BoundaryKind> drawn_kinds(const Robot& robot) {
  MapOptions options;
  options.resolution = 0.4;
  options.extra_levels = 2;
  const MapResult found = compute_aspect_map(robot, options);
  std::set<BoundaryKind> kinds;
  for (const WorkingMode& mode : found.map->working_modes()) {
    const BoundaryPicture picture =
        trace_slice(*found.map, mode, PoseSlice(TaskSpace::T2, 0.0), slice_bounds(*found.map), 60);
    for (const BoundarySegment& segment : picture.segments) kinds.insert(segment.kind);
  }
  return kinds;
}

TEST(Constraints, AreDrawnAsBoundariesOfTheirOwn) {
  const Robot robot = with(test::five_bar(), all_kinds(test::five_bar(), 0.01));
  const std::set<BoundaryKind> with_margins = drawn_kinds(robot),
                               without = drawn_kinds(robot->with_margins({}));
  for (const BoundaryKind kind :
       {BoundaryKind::passive_limit, BoundaryKind::cone, BoundaryKind::self_collision, BoundaryKind::obstacle,
        BoundaryKind::workspace}) {
    EXPECT_EQ(with_margins.count(kind), 1U) << static_cast<int>(kind);
    EXPECT_EQ(without.count(kind), 1U) << static_cast<int>(kind);
  }
  EXPECT_EQ(without.count(BoundaryKind::serial), 1U);
  EXPECT_EQ(without.count(BoundaryKind::parallel), 1U);
  EXPECT_EQ(without.count(BoundaryKind::margin), 0U);
  EXPECT_EQ(with_margins.count(BoundaryKind::margin), 1U);
}

// Leg 1 of the five-bar may bend one way only.
TEST(Constraints, CanLeaveWorkingModesEmpty) {
  Constraints one_way;
  one_way.passive_limits.push_back({"elbow", 0, PassiveAngle::crank_to_rod, 0.0, 1.0, JointLimits{0.1, 3.0}});
  MapOptions options;
  options.resolution = 0.4;
  const MapResult found = compute_aspect_map(with(test::five_bar(), one_way), options);
  const MissingModes missing = missing_modes(*found.map);
  EXPECT_EQ(found.map->working_modes().size(), 2U);
  EXPECT_EQ(missing.empty.size(), 2U);
  EXPECT_TRUE(missing.unknown.empty());
  for (const WorkingMode& mode : missing.empty) EXPECT_EQ(mode.sign(0), missing.empty.front().sign(0));
}

}  // namespace
}  // namespace parallel_aspects
