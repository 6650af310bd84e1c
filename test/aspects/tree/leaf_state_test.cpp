// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/leaf_state.h"

#include <gtest/gtest.h>

namespace parallel_aspects {
namespace {

TEST(LeafState, ExchangesSigns) {
  for (const int sign : {1, -1})
    EXPECT_EQ(LeafState::inside(sign).with_signs_exchanged(), LeafState::inside(-sign));
  EXPECT_EQ(LeafState::outside().with_signs_exchanged(), LeafState::outside());
  EXPECT_EQ(LeafState::divided().with_signs_exchanged(), LeafState::divided());
  EXPECT_EQ(LeafState::inherited().with_signs_exchanged(), LeafState::inherited());
  const LeafState state = LeafState::undecided(true, false).with_whole(1).with_center(1);
  EXPECT_EQ(state.with_signs_exchanged(), LeafState::undecided(false, true).with_whole(-1).with_center(-1));
  EXPECT_EQ(state.with_signs_exchanged().with_signs_exchanged(), state);
}

}  // namespace
}  // namespace parallel_aspects
