// SPDX-License-Identifier: BSD-3-Clause
// So that what is inline here has its assertions, however the library is built.
#undef NDEBUG
#include "aspects/boxes/box_classifier.h"
#include "distance/leg_boundary.h"
#include "interval/interval.h"
#include "interval/nonsingular.h"
#include "tracking/leg_enclosure.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "support/robots/robots.h"
#include "support/thoroughness.h"
#include <atomic>
#include <cfenv>

namespace parallel_aspects {
namespace {

TEST(Rounding, IsUpwardWhileAGuardLives) {
  EXPECT_FALSE(rounds_upward());
  {
    const RoundingUpward rounding;
    EXPECT_TRUE(rounds_upward());
  }
  EXPECT_FALSE(rounds_upward());
}

TEST(Rounding, EveryOtherDirectionIsNoticed) {
  for (const int direction : {FE_TONEAREST, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(direction);
    const bool upward = rounds_upward();
    std::fesetround(FE_TONEAREST);
    EXPECT_FALSE(upward) << direction;
  }
}

// A guard is of its thread: tasks on other threads need their own.
TEST(Rounding, IsUpwardInEveryTaskThatHoldsAGuard) {
  std::atomic<int> wrong{0};
  tbb::parallel_for(0, 1000, [&wrong](int) {
    const RoundingUpward rounding;
    if (!rounds_upward()) ++wrong;
  });
  EXPECT_EQ(wrong, 0);
}

void prove_a_sign() { proved_determinant_sign(1, SquareArray<Interval>{}); }

void enclose_a_rotation() { enclosed_rotation(Eigen::Quaterniond::Identity()); }

void enclose_a_leg() { const LegForm form(test::five_bar()->leg(0)); }

void collect_boundaries() { leg_boundaries<2>(*test::five_bar()); }

void classify_a_box() {
  const auto robot = test::five_bar();
  const std::vector<WorkingMode> modes{WorkingMode(2)};
  const auto classifier = make_box_classifier(*robot, modes);
  std::vector<LeafState> states(modes.size());
  classifier->classify(0, Box{2, {4.0, 8.0}, {4.1, 8.1}}, 1, Detail::states, states.data());
}

// What proves must not run without a guard: the assertion is there to be hit. This test is built with
// assertions.
TEST(RoundingDeathTest, ProofsInHeadersWithoutAGuardEndTheProgram) {
  EXPECT_DEATH(enclose_a_rotation(), "rounds_upward");
}

TEST(RoundingDeathTest, ProofsWithoutAGuardEndTheProgram) {
  if (!test::is_sanitized) GTEST_SKIP() << "the library has assertions where it has sanitizers";
  EXPECT_DEATH(prove_a_sign(), "rounds_upward");
  EXPECT_DEATH(enclose_a_leg(), "rounds_upward");
  EXPECT_DEATH(collect_boundaries(), "rounds_upward");
  EXPECT_DEATH(classify_a_box(), "rounds_upward");
}

}  // namespace
}  // namespace parallel_aspects
