// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/report.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

TEST(Report, LongListsOfNamesAreShortened) {
  EXPECT_EQ(shortened("Joints " + listed_names({"a", "b", "c", "d", "e"}) + " of 'x.urdf' have no limits."),
            "Joints 'a', 'b', 'c' and 2 more of 'x.urdf' have no limits.");
  EXPECT_EQ(shortened(listed_names({"a", "b", "c", "d"})), "'a', 'b', 'c', 'd'");
  EXPECT_EQ(shortened("none"), "none");
  EXPECT_EQ(shortened(listed_names({"1", "2", "3", "4", "5", "6"}) + "; " +
                      listed_names({"7", "8", "9", "10", "11"})),
            "'1', '2', '3' and 3 more; '7', '8', '9' and 2 more");
}

TEST(Report, NotesSayHowTheyAreListed) {
  const Notes notes{"one", listed_names({"a", "b", "c", "d", "e"})};
  EXPECT_EQ(notes_text(notes, true), "note: one\nnote: 'a', 'b', 'c', 'd', 'e'\n");
  EXPECT_EQ(notes_text(notes, false),
            "note: one\nnote: 'a', 'b', 'c' and 2 more\n--verbose lists all names of these notes.\n");
  EXPECT_EQ(notes_text(Notes{"one"}, false), "note: one\n");
}

// What is shown of a proved bound is proved, too.
TEST(Report, BoundsAreRoundedOutward) {
  EXPECT_EQ(shown_bound(9846.118, Side::below), "9846");
  EXPECT_EQ(shown_bound(9846.118, Side::above), "9847");
  EXPECT_EQ(shown_bound(2.0 / 3.0, Side::below), "0.6666");
  EXPECT_EQ(shown_bound(2.0 / 3.0, Side::above), "0.6667");
  EXPECT_EQ(shown_bound(-2.0 / 3.0, Side::below), "-0.6667");
  EXPECT_EQ(shown_bound(0.99999, Side::above), "1");
  EXPECT_EQ(shown_bound(0.99999, Side::below), "0.9999");
  EXPECT_EQ(shown_bound(0.0, Side::above), "0");
}

TEST(Report, AnglesComeInDegreesAndRadians) { EXPECT_EQ(shown_angle(0.5 * EIGEN_PI), "90 deg (1.5708 rad)"); }

}  // namespace
}  // namespace parallel_aspects::tools
