// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_CONSTRAINED_BOXES_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_CONSTRAINED_BOXES_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/roadmap/pose_sampler.h"
#include "aspects/tree/slice_space.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>

namespace parallel_aspects::test {

/// A robot, and what of it is mapped.
struct MappedRobot {
  const char* name;
  std::function<Robot()> make;
  Held held;  ///< of a slice; empty for a map
};

/// One of every kind of chart.
inline std::vector<MappedRobot> mapped_robots() {
  return {{"delta", delta, {}},
          {"linear_delta", linear_delta, {}},
          {"five_bar", five_bar, {}},
          {"ankle", ankle, {}},
          {"four_bar", [] { return four_bar(); }, {}},
          {"three_rrr", three_rrr, {}},
          {"three_rpr", three_rpr, {}},
          {"three_rrr_turning", three_rrr, {{"x", -4.0}}},
          {"three_rrr_holding", three_rrr, {{"leg_2_joint", 0.4}}},
          {"three_rpr_holding", three_rpr, {{"leg_1_joint", 14.98}}},
          {"hexa", [] { return shipped("hexa")->manipulator(); }, upright({{"z", -0.6}})},
          {"stewart", [] { return shipped("stewart")->manipulator(); }, upright({{"z", 1.3}})},
          {"stewart_turning",
           [] { return shipped("stewart")->manipulator(); },
           {{"z", 1.3}, {"roll", 0.1}, {"pitch", 0.0}}},
          {"stewart_tilting",
           [] { return shipped("stewart")->manipulator(); },
           {{"x", 0.0}, {"y", 0.1}, {"z", 1.3}}},
          {"six_pus", [] { return shipped("six_pus")->manipulator(); }, upright()}};
}

/// Boxes of a robot in one working mode that it can have, with constraints that each test chooses; what is
/// proved of them is compared with `clearance`, which is negative where a constraint is broken.
class ConstrainedBoxes : public testing::TestWithParam<MappedRobot> {
 protected:
  struct Start {
    Pose pose;
    WorkingMode mode;
    JointVector q;
  };

  /// Of the robot of the test, without constraints but for the limits of its actuated joints.
  virtual Constraints choose(const Manipulator& plain, const Start& start) = 0;
  virtual double clearance(const Pose& pose) const = 0;

  void SetUp() override {
    const Robot plain = with(GetParam().make(), {});
    if (!GetParam().held.empty()) slice = slice_of(plain, GetParam().held);
    space = make_space(*plain);
    const auto start = draw_start(*plain);
    ASSERT_TRUE(start);
    mode = start->mode;
    robot = with(plain, choose(*plain, *start));
    classifier = make_classifier(*robot);
  }

  double uniform(double lower, double upper) { return test::uniform(random, lower, upper); }

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

  LeafState state(RootIndex root, const Box& box) const {
    const RoundingUpward rounding;
    return classifier->state(root, box, 0);
  }

  void expect_no_contradiction() {
    std::size_t samples = 0, inside = 0, shut_out = 0;
    for (int i = 0; samples < thinned<std::size_t>(100000) && i < 400000; ++i) {
      Box box;
      const RootIndex root = random_box(0.05, box).root;
      const LeafState found = state(root, box);
      for (int k = 0; k < 4; ++k, ++samples) {
        const Pose pose = space->pose({root, random_point(box)});
        const auto sign = sign_within(*robot, pose, mode);
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
    EXPECT_TRUE(is_sanitized || inside > 100U) << inside;
    EXPECT_TRUE(is_sanitized || shut_out > 20U) << shut_out;
  }

  void expect_small_boxes_decided() {
    int allowed = 0, decided_inside = 0, beyond = 0, decided_outside = 0;
    for (int i = 0; i < thinned(20000); ++i) {
      Box box;
      const RootIndex root = random_box(0.0, box).root;
      for (std::size_t k = 0; k < box.dimension; ++k) box.upper[k] += 1e-9 * space->region().width(k);
      const Pose pose = space->pose({root, box.lower});
      if (sign_within(*robot, pose, mode).value_or(0) == 0) continue;
      const double margin = clearance(pose);
      if (std::abs(margin) < 1e-4) continue;
      const LeafState found = state(root, box);
      ++(margin > 0.0 ? allowed : beyond);
      decided_inside += margin > 0.0 && found.is_inside();
      decided_outside += margin < 0.0 && found.is_outside();
    }
    EXPECT_TRUE(is_sanitized || allowed > 10) << allowed;
    EXPECT_TRUE(is_sanitized || beyond > 10) << beyond;
    EXPECT_GE(decided_inside, 0.999 * allowed) << allowed;
    EXPECT_GE(decided_outside, 0.999 * beyond) << beyond;
  }

  /// Slopes of all conditions against finite differences; there are at least `least_count` of them.
  void expect_slopes_of_finite_differences(std::size_t least_count) {
    const auto conditions = [this](const MapPosition& position) {
      const RoundingUpward rounding;
      return classifier->conditions(position, 0, 1);
    };
    int compared = 0;
    for (int i = 0; i < 20000 && compared < 500; ++i) {
      const MapPosition position = random_position(*space, random);
      if (sign_within(*robot, space->pose(position), mode).value_or(0) == 0) continue;
      const Conditions here = conditions(position);
      ASSERT_GE(here.count, least_count);
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

  /// Free segments stay where all constraints hold, and what is blocked by this kind is.
  void expect_free_segments_stay(ConstraintKind kind) {
    const SegmentCertifier certifier(robot);
    int free = 0, blocked = 0;
    for (int i = 0; i < thinned(2000); ++i) {
      Box box;
      const RootIndex root = random_box(0.1, box).root;
      const Pose from = space->pose({root, random_point(box)}), to = space->pose({root, random_point(box)});
      const ConfigurationProof start = certifier.prove(from, mode);
      if (start.failing == kind) {
        ++blocked;
        ASSERT_LT(clearance(from), 1e-9);
      }
      if (certifier.prove(from, to, mode).verdict != SegmentVerdict::free) continue;
      ++free;
      for (int k = 0; k <= 10; ++k) ASSERT_GT(clearance(pose_between(from, to, 0.1 * k)), -1e-9);
    }
    EXPECT_GT(free, is_sanitized ? -1 : 5);
    EXPECT_GT(blocked, is_sanitized ? -1 : 0);
  }

  std::mt19937_64 random{20261122};
  Robot robot;
  WorkingMode mode{1};
  std::shared_ptr<const PoseSpace> space;
  std::unique_ptr<const BoxClassifier> classifier;
  std::optional<MapSlice> slice;

  /// See `sign_at`; a joint that is held has its value in one of two working modes.
  std::optional<int> sign_within(const Manipulator& of, const Pose& pose, const WorkingMode& in) const {
    const std::optional<int> sign = sign_at(of, pose, in);
    if (!slice || !slice->joint || sign.value_or(0) == 0) return sign;
    const Leg& leg = of.leg(slice->joint->leg);
    const double off =
        joint_value(leg, pose.transform(leg.anchor), in.sign(slice->joint->leg)) - slice->joint->value;
    return std::abs(std::remainder(off, 2.0 * EIGEN_PI)) < 1e-6 ? sign : 0;
  }

 private:
  std::unique_ptr<const BoxClassifier> make_classifier(const Manipulator& of) {
    return slice ? make_slice_classifier(of, {mode}, *slice) : make_box_classifier(of, {mode});
  }

  std::shared_ptr<const PoseSpace> make_space(const Manipulator& of) {
    mode = WorkingMode(of.leg_count());
    const double size = of.size();  // rails without ends reach everywhere
    const Box around{3, {-size, -size, -size}, {size, size, size}};
    const Box reachable = make_classifier(of)->reachable_positions().value_or(around);
    if (slice && slice->joint) return make_held_joint_space(of, *slice);
    return slice ? make_slice_space(*slice, reachable, of.characteristic_length())
                 : make_pose_space(of.motions(), reachable, of.characteristic_length());
  }

  std::optional<Start> draw_start(const Manipulator& of) {
    for (int i = 0; i < 100000; ++i) {
      const Pose pose = space->pose(random_position(*space, random));
      for (const InverseSolution& solution : inverse_in_all_modes(of, pose))
        if (solution.status == InverseStatus::solved && sign_within(of, pose, solution.mode).value_or(0) != 0)
          return Start{pose, solution.mode, solution.q};
    }
    return std::nullopt;
  }
};

inline std::string name_of(const testing::TestParamInfo<MappedRobot>& each) { return each.param.name; }

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_CONSTRAINED_BOXES_H
