// SPDX-License-Identifier: BSD-3-Clause
//
// What is proved with a tolerance, of boxes and segments of every kind of chart, against robots that are
// built within it: points moved in all directions of space, lengths changed, each by up to the whole
// tolerance.
#include "support/constrained_boxes.h"
#include "support/robots/robots_within.h"

namespace parallel_aspects {
namespace {

constexpr double share = 0.001;

class Tolerance : public test::ConstrainedBoxes {
 protected:
  Constraints choose(const Manipulator&, const Start&) override { return {}; }
  double clearance(const Pose&) const override { return 1.0; }

  void SetUp() override {
    test::ConstrainedBoxes::SetUp();
    ASSERT_TRUE(robot);
    robot = robot->with_tolerance(share);
    if (GetParam().held.empty())
      classifier = make_box_classifier(*robot, {mode});
    else
      classifier = make_slice_classifier(*robot, {mode}, test::slice_of(robot, GetParam().held));
  }

  test::Robot built() { return test::RobotsWithin(robot->tolerance(), random).draw(*robot); }
};

TEST_P(Tolerance, NoRobotWithinContradictsABox) {
  int inside = 0, outside = 0;
  for (int i = 0; i < test::thinned(20000); ++i) {
    Box box;
    const RootIndex root = random_box(0.005, box).root;
    const LeafState found = state(root, box);
    for (int k = 0; k < 4; ++k) {
      const test::Robot other = built();
      const Pose pose = space->pose({root, random_point(box)});
      const auto sign = test::sign_at(*other, pose, mode);
      if (!sign) continue;
      inside += found.is_inside();
      outside += found.is_outside();
      if (*sign == 0)
        ASSERT_FALSE(found.is_inside()) << to_string(robot->task_space(), pose);
      else
        ASSERT_TRUE(found.may_be(*sign)) << to_string(robot->task_space(), pose);
    }
  }
  EXPECT_GT(inside, test::is_sanitized ? -1 : 100);
  // The rod of the four-bar reaches all poses, as those of the spherical robots.
  const bool reaches_all = robot->task_space() == TaskSpace::SO3 || robot->task_space() == TaskSpace::R1;
  EXPECT_TRUE(test::is_sanitized || outside > 100 || reaches_all) << outside;
}

TEST_P(Tolerance, EveryRobotWithinTakesAFreeSegment) {
  const SegmentCertifier certifier(robot);
  int free = 0;
  for (int i = 0; i < test::thinned(2000); ++i) {
    Box box;
    const RootIndex root = random_box(0.1, box).root;
    const Pose from = space->pose({root, random_point(box)}), to = space->pose({root, random_point(box)});
    if (certifier.prove(from, to, mode).verdict != SegmentVerdict::free) continue;
    ++free;
    const test::Robot other = built();
    const auto first = test::sign_at(*other, from, mode);
    for (int k = 0; k <= 10; ++k) {
      const auto sign = test::sign_at(*other, pose_between(from, to, 0.1 * k), mode);
      ASSERT_TRUE(!sign || *sign != 0);
      ASSERT_TRUE(!sign || !first || *sign == *first);
    }
  }
  EXPECT_GT(free, test::is_sanitized ? -1 : 5);
}

// And the chart of rotations, which is not among them. A slice that holds a joint refuses tolerances.
std::vector<test::MappedRobot> robots() {
  std::vector<test::MappedRobot> result;
  for (const test::MappedRobot& each : test::mapped_robots())
    if (std::string(each.name).find("holding") == std::string::npos) result.push_back(each);
  result.push_back({"agile_eye", test::agile_eye, {}});
  result.push_back({"three_rrr_actuated_elbow", test::three_rrr_actuated_elbow, {}});
  return result;
}

INSTANTIATE_TEST_SUITE_P(Robots, Tolerance, testing::ValuesIn(robots()), test::name_of);

}  // namespace
}  // namespace parallel_aspects
