// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_STATE_WIDGET_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_STATE_WIDGET_H

#include "rviz/panel/panel_model.h"

#include <QWidget>
#include <array>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace parallel_aspects {

class DistanceBar;

/// What is known of the robot now: its level, its place, distances, and candidates to choose from.
class StateWidget : public QWidget {
 public:
  using OnChoice = std::function<void(const SolvedConfiguration&)>;

  explicit StateWidget(OnChoice on_choice, QWidget* parent = nullptr);

  void show_view(const NodeView& view);

 private:
  QWidget* bar_page();
  QWidget* candidate_page();
  void show_banner(const Banner& banner);
  void show_domains(const DomainLine& line);
  void show_candidates(const NodeView& view);
  void resize_candidates(std::size_t count);

  OnChoice on_choice_;
  QLabel* title_;
  QLabel* text_;
  QLabel* domains_;
  std::array<DistanceBar*, 3> bars_{};
  QLabel* scale_;
  QStackedWidget* pages_;  // bars, or candidates
  QWidget* candidate_box_;
  QLabel* candidate_text_;
  QVBoxLayout* candidate_layout_;
  std::vector<QPushButton*> buttons_;
  std::vector<SolvedConfiguration> candidates_;  // of the buttons
  int safety_ = -1, domains_safety_ = -1;        // that the title and the line of domains have; none yet
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_STATE_WIDGET_H
