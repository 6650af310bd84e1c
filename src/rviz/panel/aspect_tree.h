// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_ASPECT_TREE_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_ASPECT_TREE_H

#include "rviz/panel/aspect_rows.h"

#include <QTreeWidget>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Working modes and their aspects as a table, each with a box to tick where it is to be drawn.
class AspectTree : public QTreeWidget {
 public:
  using OnShown = std::function<void(const std::set<std::uint32_t>&)>;

  explicit AspectTree(OnShown on_shown, QWidget* parent = nullptr);

  void show_rows(const std::vector<ModeRows>& modes, const std::string& unit);  ///< `unit`: of the sizes
  void select(std::uint32_t aspect);  ///< scrolls to its row; where there is none, no row is selected
  std::set<std::uint32_t> ticked() const;

 private:
  void make_items(const std::vector<ModeRows>& modes);
  void fill(QTreeWidgetItem& item, const AspectRow& row);
  void mark(QTreeWidgetItem& item, bool present);
  void follow(QTreeWidgetItem* present);

  OnShown on_shown_;
  std::vector<std::vector<std::uint32_t>> ids_;  // of the items
  std::uint32_t present_ = 0;                    // id that was marked last
  bool filling_ = false;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_ASPECT_TREE_H
