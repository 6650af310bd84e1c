// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_PLAN_WIDGET_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_PLAN_WIDGET_H

#include "rviz/panel/panel_link.h"
#include "rviz/panel/plan_model.h"

#include <QElapsedTimer>
#include <QWidget>
#include <optional>
#include <set>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace parallel_aspects {

class PathSlider;

/// Plans a path by hand, and shows it on the probe. Nothing is carried out.
class PlanWidget : public QWidget {
 public:
  explicit PlanWidget(QWidget* parent = nullptr);

  void set_link(PanelLink* link);  ///< may be null; outlives its use here
  void show_view(const NodeView& view);

  QString topic() const;
  void set_topic(const QString& topic);

 private:
  void add_question(QVBoxLayout& layout);
  void add_ends(QFormLayout& form);
  void add_answer(QVBoxLayout& layout);
  void add_publication(QVBoxLayout& layout);
  void forget();
  void update_ends(const NodeView& view);
  void update_goals(const NodeView& view);
  void add_start(const PlanEnd& start);
  void update_plan(const NodeView& view);
  void update_publication();
  void take_result();
  void plan();
  void publish();
  void scrub();
  void play(bool on);
  void step();
  PlanChoice choice() const;

  PanelLink* link_ = nullptr;
  NodeView view_;
  PlanView plan_;
  PlannedMotion motion_;
  std::uint64_t shown_number_ = 0;  // of the result that the slider is of
  std::uint64_t shown_start_ = 0;   // of the node
  std::vector<PlanEnd> stored_;
  ProbeView probe_;
  std::set<std::uint32_t> offered_;     // aspects in the list of goals
  std::optional<PlanEnd> stored_goal_;  // in that list before these

  QComboBox* start_;
  QComboBox* goal_;
  QPushButton* store_;
  QComboBox* policy_;
  QDoubleSpinBox* margin_;
  QCheckBox* in_time_;
  QPushButton* plan_button_;
  QPushButton* cancel_;
  QProgressBar* progress_;
  QLabel* answer_;
  QPushButton* play_;
  PathSlider* slider_;
  QLabel* place_;
  QLineEdit* topic_;
  QPushButton* publish_;
  QTimer* timer_;
  QElapsedTimer since_step_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_PLAN_WIDGET_H
