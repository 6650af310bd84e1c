// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/panel.h"

#include <gtest/gtest.h>

namespace parallel_aspects {
namespace {

// The line to what has no room for its number ends before the number.
TEST(PanelLabels, ALeaderDoesNotRunIntoItsText) {
  PanelLabels labels(PagePoint(0.0, 0.0), PagePoint(200.0, 200.0));
  PagePicture picture;
  for (int i = 0; i < 8; ++i)
    labels.add(std::to_string(7 + 5 * i), {PagePoint(60.0 + 10.0 * i, 100.0), 0.5}, 0x332288, picture);
  int texts = 0;
  PageLine leader;
  for (const PageElement& element : picture.elements) {
    if (const auto* curves = std::get_if<PageCurves>(&element)) leader = curves->lines.front();
    const auto* text = std::get_if<PageText>(&element);
    if (text == nullptr) continue;
    ++texts;
    const PagePoint half(0.5 * text_width(text->text, text->size), 0.375 * text->size);
    const PagePoint middle = text->at - PagePoint(0.0, half.y());
    const Eigen::AlignedBox2d box(PagePoint(middle - half), PagePoint(middle + half));
    ASSERT_EQ(leader.size(), 2U);
    for (int k = 0; k <= 100; ++k)
      EXPECT_FALSE(box.contains(leader[0] + k / 100.0 * (leader[1] - leader[0]))) << text->text;
  }
  EXPECT_EQ(texts, 8);
}

}  // namespace
}  // namespace parallel_aspects
