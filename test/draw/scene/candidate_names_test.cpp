// SPDX-License-Identifier: BSD-3-Clause
//
// Each candidate has a name of its own, and no name covers another.
#include "draw/scene/placed_labels.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <set>

namespace parallel_aspects {
namespace {

TEST(CandidateNames, AreLettersAndDiffer) {
  EXPECT_EQ(candidate_name(0), "A");
  EXPECT_EQ(candidate_name(25), "Z");
  EXPECT_EQ(candidate_name(26), "AA");
  EXPECT_EQ(candidate_name(53), "BB");
  std::set<std::string> names;
  for (std::size_t i = 0; i < 1000; ++i) names.insert(candidate_name(i));
  EXPECT_EQ(names.size(), 1000U);
}

class CandidatePlaces : public testing::TestWithParam<const char*> {};

TEST_P(CandidatePlaces, AreApart) {
  const auto mechanism = test::shipped(GetParam());
  const Manipulator& robot = *mechanism->manipulator();
  constexpr double radius = 0.2;
  std::vector<Pose> poses;
  for (const AssemblyMode& mode : direct(robot, mechanism->home().q).solutions) poses.push_back(mode.pose);
  poses.push_back(poses.front());  // at one place
  const auto places = candidate_places(robot, poses, radius);
  ASSERT_EQ(places.size(), poses.size());
  const double height = candidate_name_height * drawn_size(robot, radius);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE((places[i] - places[j]).cwiseAbs().maxCoeff(), 0.99 * height) << i << " upon " << j;
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, CandidatePlaces,
                         testing::Values("five_bar", "three_rpr", "three_prr", "delta", "stewart", "hexa",
                                         "agile_eye", "spherical_3rrr"),
                         [](const auto& robot) { return std::string(robot.param); });

TEST(LabelRoom, LongerWordsNeedMoreRoom) {
  for (const auto& [letters, moved] : {std::pair<std::size_t, bool>{1, false}, {8, true}}) {
    std::vector<PlacedLabel> labels{{{0.0, 0.0, 0.0}, letters}, {{1.5, 0.0, 0.0}, letters}};
    keep_apart(labels, 1.0, true);
    EXPECT_EQ(labels[1].at.y() < -1.0, moved) << letters;
    EXPECT_EQ(labels[0].at.y(), 0.0);
  }
}

}  // namespace
}  // namespace parallel_aspects
