// SPDX-License-Identifier: BSD-3-Clause
// The stages of a box are made one from the other: the wrong order does not compile.
#include "aspects/boxes/box_slopes.h"
#include "aspects/boxes/charts.h"
#include "interval/interval.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <algorithm>
#include <type_traits>

namespace parallel_aspects {
namespace {

using Chart = SE2Chart;
using At = ChartBox<Chart>;
using Intervals = BoxIntervals<Chart>;
using Forms = BoxForms<Chart>;
using Slopes = BoxSlopes<Chart>;

static_assert(std::is_constructible_v<Intervals, const At&>);
static_assert(std::is_constructible_v<Forms, const Intervals&>);
static_assert(std::is_constructible_v<Slopes, const Forms&>);

static_assert(!std::is_constructible_v<Forms, const At&>);
static_assert(!std::is_constructible_v<Slopes, const At&>);
static_assert(!std::is_constructible_v<Slopes, const Intervals&>);

// Each refers to the one before, which has to stay.
static_assert(!std::is_constructible_v<Forms, Intervals&&>);
static_assert(!std::is_constructible_v<Slopes, Forms&&>);
static_assert(!std::is_copy_constructible_v<Intervals> && !std::is_copy_constructible_v<Forms>);

TEST(BoxStages, EachIsAtLeastAsTightAsTheOneBefore) {
  const RoundingUpward rounding;
  const auto robot = test::three_rrr();
  const Chart chart(*robot);
  const ConstraintTests<2> tests(*robot);
  const Box box{3, {-0.05, -0.05, -0.01}, {0.05, 0.06, 0.01}};
  const Intervals intervals({chart, tests, 0, box});
  const Forms forms(intervals);
  ASSERT_FALSE(forms.reachable_nowhere());
  const Slopes slopes(forms);
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_GE(forms.entries().square(j).lower(), intervals.entries().square(j).lower());
    EXPECT_LE(forms.entries().square(j).upper(), intervals.entries().square(j).upper());
    // By the mean value theorem the slopes bound how far B_jj^2 strays from its value at the center.
    double spread = 0.0;
    const Slopes::Gradient gradient = slopes.squared_b_entry_gradient(j);
    for (std::size_t i = 0; i < 3; ++i)
      spread += 0.5 * box.width(i) * std::max(-gradient[i].lower(), gradient[i].upper());
    const Interval center = forms.squared_b_entry_at_center(j);
    EXPECT_LE(center.lower() - spread, forms.entries().square(j).upper());
    EXPECT_GE(center.upper() + spread, forms.entries().square(j).lower());
  }
  for (const int sign : {1, -1}) {
    const Interval by_intervals = intervals.determinant({1, sign, 1}),
                   by_forms = forms.determinant({1, sign, 1});
    EXPECT_GE(by_forms.lower(), by_intervals.lower());
    EXPECT_LE(by_forms.upper(), by_intervals.upper());
  }
}

}  // namespace
}  // namespace parallel_aspects
