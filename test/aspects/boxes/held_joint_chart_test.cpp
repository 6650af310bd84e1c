// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/held_joint_chart.h"

#include "aspects/tree/slice_space.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <gtest/gtest.h>

#include "support/held_joint_at.h"
#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

using test::HeldJointAt;
using test::Robot;
using test::uniform;
using Number = long double;

constexpr Number pi = 3.14159265358979323846264338L;

MapSlice holding(const Manipulator& robot, std::size_t leg, double value) {
  Problems problems;
  MapSlice slice = make_slice(robot, {{robot.leg(leg).actuated_joint, value}}, problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
  return slice;
}

Robot with_serial_margin(const Robot& robot, double margin) {
  Margins margins;
  margins.serial = margin;
  return robot->with_margins(margins);
}

/// Random boxes of the torus and random poses in each.
class Comparison {
 public:
  Comparison(const Robot& robot, std::size_t leg, double value)
      : robot_(robot),
        modes_(working_modes(*robot)),
        classifier_(make_held_joint_classifier(*robot, modes_, holding(*robot, leg, value), {})),
        by_hand_(*robot, leg, value),
        name_(robot->name() + ", leg " + std::to_string(leg) + " at " + std::to_string(value)) {}

  /// How many decided poses agreed.
  int run(int boxes, unsigned seed) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < boxes; ++i) {
      Box box{2, {}, {}};
      const double width = std::pow(2.0, uniform(random, -11.0, -3.0));
      for (std::size_t k = 0; k < 2; ++k) {
        box.lower[k] = uniform(random, -1.0, 1.0 - width);
        box.upper[k] = box.lower[k] + width;
      }
      look_into(box, random);
      if (testing::Test::HasFatalFailure()) return agreed_;
    }
    return agreed_;
  }

 private:
  void look_into(const Box& box, std::mt19937_64& random) {
    std::vector<LeafState> states(modes_.size());
    {
      const RoundingUpward rounding;
      classifier_->classify(0, box, ~ModeSet{0}, Detail::parts, states.data());
    }
    for (int k = 0; k < 4; ++k) {
      const double direction = uniform(random, box.lower[0], box.upper[0]),
                   phi = uniform(random, box.lower[1], box.upper[1]);
      for (std::size_t mode = 0; mode < modes_.size(); ++mode)
        compare(states[mode], box, direction, phi, mode);
    }
  }

  void compare(const LeafState& state, const Box& box, double direction, double phi, std::size_t mode) {
    const auto value = by_hand_.determinant(pi * direction, pi * phi, modes_[mode]);
    if (!value) return;
    const int sign = *value > 0.0L ? 1 : *value < 0.0L ? -1 : 0;
    agreed_ += state.is_inside() ? 1 : 0;
    ASSERT_FALSE(state.is_inside() ? sign == 0 || !state.is_inside(sign) : sign != 0 && !state.may_be(sign))
        << name_ << ", mode " << to_string(modes_[mode]) << ", {" << direction << ", " << phi << "} in ["
        << box.lower[0] << ", " << box.upper[0] << "] x [" << box.lower[1] << ", " << box.upper[1]
        << "], sign " << sign;
  }

  Robot robot_;
  std::vector<WorkingMode> modes_;
  std::unique_ptr<const BoxClassifier> classifier_;
  HeldJointAt by_hand_;
  std::string name_;
  int agreed_ = 0;
};

TEST(HeldJointChart, NoPoseContradictsItsBox) {
  std::mt19937_64 random(20261123);
  for (const Robot& robot :
       {test::three_rpr(), test::three_rrr(), test::three_prr(), with_serial_margin(test::three_rrr(), 0.3),
        with_serial_margin(test::three_prr(), 0.2)})
    for (std::size_t leg = 0; leg < 3; ++leg) {
      const JointLimits& limits = robot->leg(leg).limits;
      const double value =
          limits.limited() ? uniform(random, limits.lower, limits.upper) : uniform(random, -0.3, 1.0);
      const int agreed =
          Comparison(robot, leg, value).run(test::thinned(8000), 7 + static_cast<unsigned>(leg));
      ASSERT_FALSE(HasFatalFailure());
      EXPECT_GT(agreed, test::thinned(100)) << robot->name() << ", leg " << leg << " at " << value;
    }
}

TEST(HeldJointChart, NoPoseOfRandomRobotsContradictsItsBox) {
  test::RandomRobots robots(20261123);
  int agreed = 0;
  for (int i = 0; i < test::thinned(60); ++i)
    for (const auto kind :
         {test::ActuationKind::revolute, test::ActuationKind::prismatic, test::ActuationKind::strut}) {
      const Robot robot = robots.robot(TaskSpace::SE2, kind);
      const auto leg = static_cast<std::size_t>(i % 3);
      double value = robots.uniform(-1.0, 1.0);
      if (const auto* strut = std::get_if<StrutActuation>(&robot->leg(leg).actuation))
        value = strut->sense * (robots.uniform(0.6, 2.0) - strut->length_at_zero);
      agreed += Comparison(robot, leg, value).run(300, 1);
      ASSERT_FALSE(HasFatalFailure());
    }
  EXPECT_GT(agreed, test::thinned(5000));
}

// Anchors out of the plane of what the joints move: rods are shorter, seen in the plane. By the kinematics.
TEST(HeldJointChart, TakesHeightsIntoAccount) {
  for (const Robot& plane : {test::three_rrr(), test::three_prr(), test::three_rpr()}) {
    ManipulatorDescription description = plane->description();
    for (std::size_t j = 0; j < 3; ++j)
      description.legs[j].anchor.z() += 0.05 * (1.0 + static_cast<double>(j)) * plane->size();
    const Robot robot = std::make_shared<const Manipulator>(description);
    const double value =
        plane->leg(1).limits.limited()
            ? plane->leg(1).limits.lower + 0.3 * (plane->leg(1).limits.upper - plane->leg(1).limits.lower)
            : 0.4;
    const MapSlice slice = holding(*robot, 1, value);
    const auto modes = working_modes(*robot);
    const auto classifier = make_held_joint_classifier(*robot, modes, slice, {});
    const auto space = make_held_joint_space(*robot, slice);
    std::mt19937_64 random(4);
    int inside = 0;
    for (int i = 0; i < test::thinned(20000); ++i) {
      const MapPosition at = test::random_position(*space, random);
      const Pose pose = space->pose(at);
      const std::size_t mode = random() % modes.size();
      const auto sign = test::sign_at(*robot, pose, modes[mode]);
      if (!sign) continue;
      const Leg& leg = robot->leg(1);
      const double off =
          *sign == 0 ? 0.0 : joint_value(leg, pose.transform(leg.anchor), modes[mode].sign(1)) - value;
      const bool holds = std::abs(std::remainder(off, 2.0 * EIGEN_PI)) < 1e-7;
      Box box{2, at.point, at.point};
      for (std::size_t k = 0; k < 2; ++k) box.upper[k] = std::min(1.0, box.lower[k] + 1e-4);
      const RoundingUpward rounding;
      const LeafState state = classifier->state(0, box, mode);
      inside += state.is_inside() ? 1 : 0;
      ASSERT_FALSE(state.is_inside() ? !holds || !state.is_inside(*sign)
                                     : holds && *sign != 0 && !state.may_be(*sign))
          << robot->name() << ", trial " << i;
    }
    EXPECT_GT(inside, test::thinned(50)) << robot->name();
  }
}

// Both by formulas of the package, since the space only says which pose is meant.
TEST(HeldJointSpace, PosesHaveTheJointAtItsValueAndAreFoundAgain) {
  std::mt19937_64 random(3);
  for (const Robot& robot : {test::three_rpr(), test::three_rrr(), test::three_prr()}) {
    const double value = robot->leg(1).limits.limited()
                             ? 0.5 * (robot->leg(1).limits.lower + robot->leg(1).limits.upper)
                             : 0.4;
    const auto space = make_held_joint_space(*robot, holding(*robot, 1, value));
    for (int i = 0; i < 1000; ++i) {
      const MapPosition at = test::random_position(*space, random);
      const Pose pose = space->pose(at);
      EXPECT_NEAR(robot->leg(1).residual(pose, value), 0.0, 1e-10 * robot->size() * robot->size());
      const MapPosition again = space->position(pose);
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(std::remainder(again.point[k] - at.point[k], 2.0), 0.0, 1e-12);
    }
  }
}

TEST(HeldJointSpace, PosesNearbyAreTakenAsThoseOfTheSlice) {
  const Robot robot = test::three_rpr();
  const auto space = make_held_joint_space(*robot, holding(*robot, 0, 14.98));
  const Eigen::Vector2d along(std::cos(0.3), std::sin(0.3));
  for (const double off : {-2e-6, -0.9e-6, 0.9e-6, 2e-6}) {
    const Eigen::Vector2d at = (14.98 + off) * along;
    const MapPosition found = space->position(Pose::planar(at.x(), at.y(), 1.0));
    EXPECT_EQ(std::isnan(found.point[0]), std::abs(off) > held_joint_tolerance) << off;
    if (std::isnan(found.point[0])) continue;
    EXPECT_NEAR(found.point[0], 0.3 / EIGEN_PI, 1e-12);
    EXPECT_NEAR(found.point[1], 1.0 / EIGEN_PI, 1e-12);
  }
}

}  // namespace
}  // namespace parallel_aspects
