// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/aspects_panel.h"

#include "rviz/panel/aspect_rows.h"
#include "rviz/panel/aspect_tree.h"
#include "rviz/panel/plan_widget.h"
#include "rviz/panel/state_widget.h"

#include <ros/names.h>

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>

namespace parallel_aspects {
namespace {

constexpr int between_refreshes = 100;                  // [ms]
constexpr int content_width = 356, least_height = 150;  // for all columns of the table, and the banner [px]

// As other nodes would find it; empty where it is no name.
std::string full_name(const QString& typed) {
  std::string fault;
  const std::string name = typed.trimmed().toStdString();
  if (name.empty() || !ros::names::validate(name, fault)) return {};
  return ros::names::clean(name.front() == '/' ? name : "/" + name);
}

}  // namespace

AspectsPanel::AspectsPanel(QWidget* parent)
    : rviz::Panel(parent),
      nodes_(new QComboBox),
      state_(new StateWidget([this](const SolvedConfiguration& candidate) {
        if (link_) link_->choose(candidate);
      })),
      tree_(new AspectTree([this](const std::set<std::uint32_t>& aspects) { choose_shown(aspects); })),
      count_(new QLabel),
      plan_(new PlanWidget),
      event_list_(new QListWidget),
      map_text_(new QLabel),
      map_progress_(new QProgressBar),
      map_button_(new QPushButton),
      last_answer_(new QLabel),
      timer_(new QTimer(this)),
      content_(new QWidget) {
  add_scroll_area();
  auto* const layout = new QVBoxLayout(content_);
  layout->setContentsMargins(6, 6, 6, 6);
  add_node_row(*layout);
  layout->addWidget(state_);
  add_tabs(*layout);
  add_map_row(*layout);
  leave_wheel_to_area();
  connect(timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_->start(between_refreshes);
  refresh();
}

// A line that loses the focus because its window closes says that it was edited.
AspectsPanel::~AspectsPanel() {
  for (QObject* const child : findChildren<QObject*>()) child->disconnect(this);
  timer_->stop();
  plan_->set_link(nullptr);
}

// Scrolls where there is no room, so that panels of several robots fit below each other.
void AspectsPanel::add_scroll_area() {
  auto* const area = new QScrollArea;
  area->setWidget(content_);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setMinimumWidth(content_width + area->verticalScrollBar()->sizeHint().width());
  area->setMinimumHeight(least_height);
  auto* const all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(area);
}

// Who scrolls the panel does not mean to choose another node, goal or tab on the way.
void AspectsPanel::leave_wheel_to_area() {
  for (QWidget* const each : content_->findChildren<QWidget*>())
    if (qobject_cast<QComboBox*>(each) != nullptr || qobject_cast<QAbstractSpinBox*>(each) != nullptr ||
        qobject_cast<QTabBar*>(each) != nullptr)
      each->installEventFilter(this);
}

bool AspectsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel) return rviz::Panel::eventFilter(watched, event);
  event->ignore();
  return true;
}

QSize AspectsPanel::sizeHint() const { return content_->sizeHint(); }

void AspectsPanel::add_node_row(QVBoxLayout& layout) {
  nodes_->setObjectName("node");
  nodes_->setEditable(true);
  nodes_->setInsertPolicy(QComboBox::NoInsert);
  nodes_->lineEdit()->setPlaceholderText("the first aspect_node that is found");
  nodes_->setToolTip("The node to look at, such as /left/aspect_node.");
  auto* const row = new QHBoxLayout;
  row->addWidget(new QLabel("Node"));
  row->addWidget(nodes_, 1);
  layout.addLayout(row);
  connect(nodes_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { set_node(nodes_->currentText()); });
  connect(nodes_->lineEdit(), &QLineEdit::editingFinished, this, [this] { set_node(nodes_->currentText()); });
}

void AspectsPanel::add_tabs(QVBoxLayout& layout) {
  auto* const tabs = new QTabWidget;
  tabs->setObjectName("tabs");
  auto* const page = new QWidget;
  auto* const aspects = new QVBoxLayout(page);
  aspects->setContentsMargins(0, 0, 0, 0);
  aspects->addWidget(tree_, 1);
  count_->setObjectName("count");
  count_->setWordWrap(true);
  aspects->addWidget(count_);
  event_list_->setObjectName("events");
  event_list_->setWordWrap(true);
  event_list_->setAlternatingRowColors(true);
  tabs->addTab(page, "Aspects");
  tabs->addTab(plan_, "Plan");
  tabs->addTab(event_list_, "Transitions");
  layout.addWidget(tabs, 1);
}

void AspectsPanel::add_map_row(QVBoxLayout& layout) {
  map_text_->setObjectName("map_text");
  map_text_->setWordWrap(true);
  map_progress_->setObjectName("map_progress");
  map_progress_->setRange(0, 100);
  map_button_->setObjectName("map_button");
  last_answer_->setObjectName("last_answer");
  last_answer_->setWordWrap(true);
  auto* const row = new QHBoxLayout;
  row->addWidget(map_progress_, 1);
  row->addWidget(map_button_);
  layout.addWidget(map_text_);
  layout.addLayout(row);
  layout.addWidget(last_answer_);
  connect(map_button_, &QPushButton::clicked, this, [this] {
    if (!link_) return;
    if (map_button_cancels_)  // what it says, also where the map has ended since it was drawn
      link_->cancel_map();
    else
      link_->compute_map();
  });
}

void AspectsPanel::set_node(const QString& typed) {
  const std::string name = full_name(typed);
  if ((link_ ? link_->view().node : std::string()) == name) return;
  plan_->set_link(nullptr);
  link_.reset();
  if (!name.empty()) link_ = std::make_unique<PanelLink>(name);
  plan_->set_link(link_.get());
  nodes_->setEditText(QString::fromStdString(name));
  aspects_.clear();
  shown_was_chosen_ = false;
  clicks_ = 0;
  fresh_link_ = true;
  Q_EMIT configChanged();
}

void AspectsPanel::update_nodes() {
  QStringList names;
  for (const std::string& name : finder_.nodes()) names << QString::fromStdString(name);
  QStringList listed;
  for (int i = 0; i < nodes_->count(); ++i) listed << nodes_->itemText(i);
  if (names != listed && !nodes_->view()->isVisible()) {
    const QString typed = nodes_->currentText();
    nodes_->clear();
    nodes_->addItems(names);
    nodes_->setEditText(typed);
  }
  if (!link_ && !names.empty() && !nodes_->lineEdit()->hasFocus()) set_node(names.front());
}

void AspectsPanel::refresh() {
  update_nodes();
  NodeView view = link_ ? link_->view() : NodeView();
  view.master_answers = finder_.master_answers();
  state_->show_view(view);
  tree_->show_rows(rows_of(view), unit_of(view));
  if (view.clicks != clicks_) {
    clicks_ = view.clicks;
    tree_->select(view.selected);
  }
  count_->setText(QString::fromStdString(count_text(view)));
  if (aspects_ != ids_of(view)) {
    aspects_ = ids_of(view);
    if (shown_was_chosen_) choose_shown(tree_->ticked());
  }
  plan_->show_view(view);
  update_events(view);
  update_map(view);
}

void AspectsPanel::update_events(const NodeView& view) {
  const std::vector<EventLine> lines = events_of(view);
  const QString newest =
      lines.empty() ? QString() : QString::fromStdString(lines.front().time + "  " + lines.front().text);
  const bool same =
      !fresh_link_ && lines.size() == events_ && (lines.empty() || event_list_->item(0)->text() == newest);
  if (same) return;
  fresh_link_ = false;
  events_ = lines.size();
  event_list_->clear();
  for (const EventLine& line : lines)
    event_list_->addItem(QString::fromStdString(line.time + "  " + line.text));
}

void AspectsPanel::update_map(const NodeView& view) {
  const MapLine line = map_line_of(view);
  map_text_->setText(QString::fromStdString(line.text));
  map_progress_->setVisible(line.runs);
  map_progress_->setValue(static_cast<int>(std::lround(100.0 * line.share)));
  const Permission permission = line.runs ? may_cancel_map(view) : may_compute_map(view);
  map_button_cancels_ = line.runs;
  map_button_->setText(line.runs ? "Cancel" : "Compute map anew");
  map_button_->setEnabled(static_cast<bool>(permission));
  map_button_->setToolTip(QString::fromStdString(
      permission ? "The map in use stays until another is complete." : permission.refusal));
  last_answer_->setText(QString::fromStdString(view.last_answer));
  last_answer_->setVisible(!view.last_answer.empty());
}

void AspectsPanel::choose_shown(const std::set<std::uint32_t>& aspects) {
  shown_was_chosen_ = true;
  if (link_) link_->show(aspects);
}

void AspectsPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString text;
  if (config.mapGetString("Node", &text)) set_node(text);
  if (config.mapGetString("Trajectory Topic", &text)) plan_->set_topic(text);
}

void AspectsPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", link_ ? QString::fromStdString(link_->view().node) : QString());
  config.mapSetValue("Trajectory Topic", plan_->topic());
}

}  // namespace parallel_aspects

PLUGINLIB_EXPORT_CLASS(parallel_aspects::AspectsPanel, rviz::Panel)
