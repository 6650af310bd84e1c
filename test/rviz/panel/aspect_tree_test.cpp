// SPDX-License-Identifier: BSD-3-Clause
// The table of many aspects, without a screen.
#include "rviz/panel/aspect_tree.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QScrollBar>
#include <cstdlib>
#include <set>
#include <vector>

namespace parallel_aspects {
namespace {

// Four working modes of fifteen aspects each, ids from 1.
std::vector<ModeRows> sixty_rows(std::uint32_t present) {
  std::vector<ModeRows> modes;
  std::uint32_t id = 0;
  for (const char* const mode : {"(+,+)", "(-,+)", "(+,-)", "(-,-)"}) {
    modes.push_back({mode, false, {}});
    for (int i = 0; i < 15; ++i) {
      AspectRow row;
      row.id = ++id;
      row.name = std::to_string(id);
      row.present = id == present;
      modes.back().present = modes.back().present || row.present;
      modes.back().aspects.push_back(row);
    }
  }
  return modes;
}

QTreeWidgetItem* row_of(const AspectTree& tree, std::uint32_t id) {
  return tree.topLevelItem(static_cast<int>((id - 1) / 15))->child(static_cast<int>((id - 1) % 15));
}

bool is_seen(const AspectTree& tree, std::uint32_t id) {
  return tree.viewport()->rect().contains(tree.visualItemRect(row_of(tree, id)).center());
}

TEST(AspectTree, GoesToThePresentAspectWhenItChangesAndNotElse) {
  AspectTree tree([](const auto&) {});
  tree.resize(340, 200);  // as in the panel
  tree.show();
  tree.show_rows(sixty_rows(0), "m^2");
  EXPECT_TRUE(is_seen(tree, 1));
  for (const std::uint32_t id : {52U, 3U, 60U, 31U}) {
    tree.show_rows(sixty_rows(id), "m^2");
    EXPECT_TRUE(is_seen(tree, id)) << id;
    EXPECT_TRUE(row_of(tree, id)->text(0).contains(QString("\u25C0"))) << id;
  }
  tree.verticalScrollBar()->setValue(0);  // somebody looks elsewhere
  tree.show_rows(sixty_rows(31), "m^2");
  EXPECT_TRUE(is_seen(tree, 1));
  EXPECT_FALSE(is_seen(tree, 31));
}

// So that the others fit, as with the components of a roadmap.
TEST(AspectTree, HidesColumnsWithoutValues) {
  std::vector<ModeRows> modes = sixty_rows(1);
  AspectTree tree([](const auto&) {});
  tree.show_rows(modes, "");
  EXPECT_TRUE(tree.isColumnHidden(3));
  EXPECT_TRUE(tree.isColumnHidden(4));
  modes.back().aspects.back().clearance = "0.0089";
  modes.front().aspects.front().index = "0.081";
  tree.show_rows(modes, "m^2");
  EXPECT_FALSE(tree.isColumnHidden(3));
  EXPECT_FALSE(tree.isColumnHidden(4));
}

TEST(AspectTree, ABoxOfAModeTicksItsAspects) {
  std::set<std::uint32_t> shown;
  AspectTree tree([&shown](const std::set<std::uint32_t>& ids) { shown = ids; });
  tree.show_rows(sixty_rows(1), "m^2");
  EXPECT_EQ(tree.ticked().size(), 60U);
  for (const int mode : {0, 1, 3}) tree.topLevelItem(mode)->setCheckState(0, Qt::Unchecked);
  EXPECT_EQ(shown, (std::set<std::uint32_t>{31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45}));
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
