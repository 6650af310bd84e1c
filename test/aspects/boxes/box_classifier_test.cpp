// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"

#include "interval/half_turns.h"
#include "interval/interval.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"

#include <gtest/gtest.h>

#include "support/robots.h"
#include "support/sign_at.h"
#include "support/thoroughness.h"
#include <cmath>
#include <functional>
#include <random>

namespace parallel_aspects {
namespace {

struct Case {
  const char* name;
  std::function<std::shared_ptr<const Manipulator>()> make;
};

bool contradicts(LeafState state, int sign) {
  if (state.is_inside()) return !state.is_inside(sign);
  return sign != 0 && !state.may_be(sign);
}

class BoxClassifierTest : public testing::TestWithParam<Case> {
 protected:
  BoxClassifierTest() {
    Box positions{2, {-3.0, -3.0, -3.0}, {3.0, 3.0, 3.0}};
    if (const auto reachable = classifier->reachable_positions(); reachable && reachable->dimension > 0)
      positions = *reachable;
    else
      positions.dimension = robot->task_space() == TaskSpace::T3 ? 3 : 2;
    space = make_pose_space(robot->task_space(), positions, robot->characteristic_length());
  }

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random);
  }

  Box random_box() {
    const Box& region = space->region();
    const double share = std::pow(2.0, uniform(-9.0, -2.0));
    Box box = region;
    for (std::size_t i = 0; i < region.dimension; ++i) {
      const double width = share * region.width(i);
      box.lower[i] = uniform(region.lower[i], region.upper[i] - width);
      box.upper[i] = box.lower[i] + width;
    }
    return box;
  }

  // Inside, or on the corners, where enclosures are tightest.
  MapPoint random_point(const Box& box) {
    MapPoint point{};
    const bool corner = uniform(0.0, 1.0) < 0.3;
    for (std::size_t i = 0; i < box.dimension; ++i) {
      const double share = uniform(0.0, 1.0);
      point[i] = corner ? (share < 0.5 ? box.lower[i] : box.upper[i])
                        : box.lower[i] + share * (box.upper[i] - box.lower[i]);
    }
    return point;
  }

  std::shared_ptr<const Manipulator> robot = GetParam().make();
  std::vector<WorkingMode> modes = working_modes(*robot);
  std::unique_ptr<const BoxClassifier> classifier = make_box_classifier(*robot, modes);
  std::shared_ptr<const PoseSpace> space;
  std::mt19937_64 random{20261121};
};

TEST_P(BoxClassifierTest, NoPoseContradictsItsBox) {
  std::vector<LeafState> states(modes.size());
  std::size_t inside = 0, checked = 0;
  for (int i = 0; i < test::thinned(20000); ++i) {
    const auto root = static_cast<RootIndex>(random() % space->root_count());
    const Box box = random_box();
    {
      const RoundingUpward rounding;
      classifier->classify(root, box, ~ModeSet{0}, Detail::parts, states.data());
    }
    for (int k = 0; k < 3; ++k) {
      const MapPoint point = random_point(box);
      const Pose pose = space->pose({root, point});
      for (std::size_t m = 0; m < modes.size(); ++m) {
        inside += states[m].is_inside();
        const auto sign = test::sign_at(*robot, pose, modes[m]);
        if (!sign) continue;
        ++checked;
        ASSERT_FALSE(contradicts(states[m], *sign))
            << "root " << root << ", box " << box.lower[0] << ' ' << box.lower[1] << ' ' << box.lower[2]
            << " to " << box.upper[0] << ' ' << box.upper[1] << ' ' << box.upper[2] << ", mode "
            << to_string(modes[m]) << ", pose " << to_string(robot->task_space(), pose) << ", sign " << *sign;
      }
    }
  }
  EXPECT_TRUE(test::is_sanitized || inside > 100U) << inside;
  EXPECT_GT(checked, test::thinned(20000U));
}

// Small boxes around poses that are clear of singularities must be decided: bounds that are never tight are
// no use.
TEST_P(BoxClassifierTest, SmallBoxesAreDecided) {
  std::vector<LeafState> states(modes.size());
  int decided = 0, clear = 0;
  for (int i = 0; i < test::thinned(3000); ++i) {
    const MapPosition position = [this] {
      const Box box = random_box();
      return MapPosition{static_cast<RootIndex>(random() % space->root_count()), random_point(box)};
    }();
    Box box{space->dimension(), position.point, position.point};
    for (std::size_t k = 0; k < box.dimension; ++k) box.upper[k] += 1e-9 * space->region().width(k);
    const RoundingUpward rounding;
    classifier->classify(position.root, box, ~ModeSet{0}, Detail::parts, states.data());
    for (std::size_t m = 0; m < modes.size(); ++m) {
      if (!test::sign_at(*robot, space->pose(position), modes[m])) continue;
      ++clear;
      decided += !states[m].is_undecided();
    }
  }
  EXPECT_GE(decided, clear * 0.999) << decided << " of " << clear;
}

// Every position has a pose with that position, across all root boxes.
TEST_P(BoxClassifierTest, PositionsAndPosesAgree) {
  for (int i = 0; i < test::thinned(1000); ++i) {
    const MapPosition position{static_cast<RootIndex>(random() % space->root_count()),
                               random_point(space->region())};
    const Pose pose = space->pose(position), again = space->pose(space->position(pose));
    EXPECT_LT((pose.position - again.position).norm(), 1e-12);
    EXPECT_LT(pose.orientation.angularDistance(again.orientation), 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, BoxClassifierTest,
                         testing::Values(Case{"five_bar", test::five_bar}, Case{"bipod", test::bipod},
                                         Case{"three_rpr", test::three_rpr},
                                         Case{"three_rrr", test::three_rrr},
                                         Case{"actuated_elbow", test::three_rrr_actuated_elbow},
                                         Case{"three_prr", test::three_prr}, Case{"delta", test::delta},
                                         Case{"linear_delta", test::linear_delta},
                                         Case{"agile_eye", test::agile_eye},
                                         Case{"spherical", test::spherical_three_rrr}),
                         [](const auto& robot) { return std::string(robot.param.name); });

// Glued faces are the same poses: a point of the first face and its image on the second.
TEST(PoseSpace, GluedFacesHoldTheSamePoses) {
  const Box square{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const TaskSpace task_space : {TaskSpace::SE2, TaskSpace::SO3}) {
    const auto space = make_pose_space(task_space, square, 1.0);
    EXPECT_EQ(space->gluings().size(), task_space == TaskSpace::SE2 ? 1U : 12U);
    for (const Gluing& gluing : space->gluings()) {
      for (int i = 0; i < 20; ++i) {
        MapPosition first{gluing.first.root, {}}, second{gluing.second.root, {}};
        for (std::size_t k = 0; k < 3; ++k) first.point[k] = coordinate(random);
        first.point[gluing.first.axis] = gluing.first.upper ? 1.0 : -1.0;
        second.point[gluing.second.axis] = gluing.second.upper ? 1.0 : -1.0;
        for (std::size_t k = 0; k < 3; ++k)
          if (k != gluing.first.axis)
            second.point[gluing.axis_of[k]] = gluing.flipped[k] ? -first.point[k] : first.point[k];
        const Pose a = space->pose(first), b = space->pose(second);
        EXPECT_LT((a.position - b.position).norm(), 1e-12);
        EXPECT_LT(a.orientation.angularDistance(b.orientation), 1e-7);
      }
    }
  }
}

// Inside the root box of the other side, and as close to the pose on the face as the depth says.
TEST(PoseSpace, PositionsBeyondAGluedFaceAreCloseToIt) {
  const Box square{2, {-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const TaskSpace task_space : {TaskSpace::SE2, TaskSpace::SO3}) {
    const auto space = make_pose_space(task_space, square, 1.0);
    for (int i = 0; i < 200; ++i) {
      MapPosition face{static_cast<RootIndex>(random() % space->root_count()), {}};
      for (double& each : face.point) each = coordinate(random);
      const std::size_t axis = task_space == TaskSpace::SE2 ? 2 : random() % 3;
      face.point[axis] = random() % 2 == 0 ? 1.0 : -1.0;
      const auto beyond = space->beyond(face, axis, 0.01);
      ASSERT_TRUE(beyond);
      EXPECT_TRUE(space->region().contains(beyond->point));
      const double angle = space->pose(face).orientation.angularDistance(space->pose(*beyond).orientation);
      EXPECT_GT(angle, 1e-3);
      EXPECT_LT(angle, 0.05);
      MapPosition inside = face;
      inside.point[axis] *= 0.99;
      EXPECT_GT(space->pose(inside).orientation.angularDistance(space->pose(*beyond).orientation),
                1.2 * angle);
    }
    EXPECT_FALSE(make_pose_space(TaskSpace::T2, square, 1.0)->beyond({0, {1.0, 0.0, 0.0}}, 0, 0.01));
  }
}

TEST(HalfTurns, EnclosuresHoldTheCosineAndSineOfEveryPoint) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> end(-1.0, 1.0), share(0.0, 1.0);
  for (int i = 0; i < 100000; ++i) {
    double lower = end(random), upper = end(random);
    if (lower > upper) std::swap(lower, upper);
    const long double at = lower + share(random) * (upper - lower);
    const long double angle = 3.14159265358979323846264338327950288L * at;
    const RoundingUpward rounding;
    const Interval cosine = cosine_of_half_turns({lower, upper}), sine = sine_of_half_turns({lower, upper});
    ASSERT_TRUE(cosine.lower() <= std::cos(angle) && std::cos(angle) <= cosine.upper())
        << lower << ' ' << upper;
    ASSERT_TRUE(sine.lower() <= std::sin(angle) && std::sin(angle) <= sine.upper()) << lower << ' ' << upper;
  }
}

}  // namespace
}  // namespace parallel_aspects
