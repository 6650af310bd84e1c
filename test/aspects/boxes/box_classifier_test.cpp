// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"

#include "interval/interval.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
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
    space = make_pose_space(robot->motions(), positions, robot->characteristic_length());
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
                                         Case{"linear_delta", test::linear_delta}, Case{"ankle", test::ankle},
                                         Case{"four_bar", [] { return test::four_bar(); }},
                                         Case{"agile_eye", test::agile_eye},
                                         Case{"spherical", test::spherical_three_rrr}),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace parallel_aspects
