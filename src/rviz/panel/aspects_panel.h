// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_ASPECTS_PANEL_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_ASPECTS_PANEL_H

#include "rviz/panel/node_finder.h"
#include "rviz/panel/panel_link.h"

#include <memory>
#include <rviz/panel.h>
#include <set>

class QComboBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace parallel_aspects {

class AspectTree;
class PlanWidget;
class StateWidget;

/// The panel for rviz: what one aspect_node knows, as text and bars, with its aspects to tick, candidates to
/// choose and paths to plan. Redraws ten times a second, and never waits for the network.
class AspectsPanel : public rviz::Panel {
 public:
  explicit AspectsPanel(QWidget* parent = nullptr);
  ~AspectsPanel() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;
  QSize sizeHint() const override;  ///< room for all of it
  bool eventFilter(QObject* watched, QEvent* event) override;

  /// Full name of the node to look at; empty for the first that is found.
  void set_node(const QString& name);

 private:
  void add_scroll_area();
  void leave_wheel_to_area();
  void add_node_row(QVBoxLayout& layout);
  void add_tabs(QVBoxLayout& layout);
  void add_map_row(QVBoxLayout& layout);
  void refresh();
  void update_nodes();
  void update_events(const NodeView& view);
  void update_map(const NodeView& view);
  void choose_shown(const std::set<std::uint32_t>& aspects);

  NodeFinder finder_;
  std::unique_ptr<PanelLink> link_;
  bool shown_was_chosen_ = false;    // whether a box was clicked
  std::set<std::uint32_t> aspects_;  // of the map that is shown
  std::uint64_t clicks_ = 0;         // in the display, that were followed
  std::size_t events_ = 0;
  bool fresh_link_ = true;

  QComboBox* nodes_;
  StateWidget* state_;
  AspectTree* tree_;
  QLabel* count_;
  PlanWidget* plan_;
  QListWidget* event_list_;
  QLabel* map_text_;
  QProgressBar* map_progress_;
  QPushButton* map_button_;
  bool map_button_cancels_ = false;
  QLabel* last_answer_;
  QTimer* timer_;
  QWidget* content_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_ASPECTS_PANEL_H
