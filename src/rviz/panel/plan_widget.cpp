// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/plan_widget.h"

#include "model/message_text.h"
#include "rviz/panel/aspect_rows.h"
#include "rviz/panel/painted_widgets.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int between_steps = 40;  // while it plays [ms]

template <typename Widget>
Widget* named(Widget* widget, const char* name) {
  widget->setObjectName(name);
  return widget;
}

void permit(QWidget& widget, const Permission& permission, const char* tip) {
  widget.setEnabled(static_cast<bool>(permission));
  widget.setToolTip(permission ? QString(tip) : QString::fromStdString(permission.refusal));
}

bool same(const PlanEnd& a, const PlanEnd& b) {
  return a.pose.pose == b.pose.pose && a.working_mode == b.working_mode;
}

}  // namespace

PlanWidget::PlanWidget(QWidget* parent)
    : QWidget(parent),
      start_(named(new QComboBox, "start")),
      goal_(named(new QComboBox, "goal")),
      store_(named(new QPushButton("Store probe"), "store")),
      policy_(named(new QComboBox, "policy")),
      margin_(named(new QDoubleSpinBox, "margin")),
      in_time_(named(new QCheckBox("in time"), "in_time")),
      plan_button_(named(new QPushButton("Plan"), "plan")),
      cancel_(named(new QPushButton("Cancel"), "cancel_plan")),
      progress_(named(new QProgressBar, "plan_progress")),
      answer_(named(new QLabel, "answer")),
      play_(named(new QPushButton("Play"), "play")),
      slider_(named(new PathSlider, "slider")),
      place_(named(new QLabel, "place")),
      topic_(named(new QLineEdit, "topic")),
      publish_(named(new QPushButton("Publish once"), "publish")),
      timer_(new QTimer(this)) {
  auto* const layout = new QVBoxLayout(this);
  add_question(*layout);
  add_answer(*layout);
  add_publication(*layout);
  layout->addStretch();
  timer_->setInterval(between_steps);
  connect(timer_, &QTimer::timeout, this, [this] { step(); });
}

void PlanWidget::add_question(QVBoxLayout& layout) {
  auto* const form = new QFormLayout;
  add_ends(*form);
  policy_->addItems({"stay in one aspect", "through serial gates"});
  policy_->setToolTip("At a serial gate a leg changes its posture; the platform is under control all along.");
  form->addRow("Policy", policy_);
  margin_->setRange(0.0, 0.95);
  margin_->setSingleStep(0.05);
  margin_->setSpecialValueText("none");
  margin_->setToolTip(
      "The parallel index, 0 at det A = 0 and 1 at best, that the whole path is proved to keep.");
  auto* const margins = new QHBoxLayout;
  margins->addWidget(margin_, 1);
  in_time_->setToolTip("Plans a trajectory as well, within the limits of velocity and acceleration.");
  margins->addWidget(in_time_);
  form->addRow("Margin", margins);
  layout.addLayout(form);
  auto* const buttons = new QHBoxLayout;
  buttons->addWidget(plan_button_, 1);
  buttons->addWidget(progress_, 2);
  buttons->addWidget(cancel_);
  layout.addLayout(buttons);
  progress_->setRange(0, 100);
  connect(plan_button_, &QPushButton::clicked, this, [this] { plan(); });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (link_ != nullptr) link_->cancel_plan();
  });
}

void PlanWidget::add_ends(QFormLayout& form) {
  auto* const start = new QHBoxLayout;
  start_->addItem("where the robot is");
  start->addWidget(start_, 1);
  start->addWidget(store_);
  form.addRow("From", start);
  goal_->addItem("the probe");
  form.addRow("To", goal_);
  connect(store_, &QPushButton::clicked, this, [this] {
    if (probe_.now) add_start(*probe_.now);
  });
}

void PlanWidget::add_answer(QVBoxLayout& layout) {
  answer_->setWordWrap(true);
  answer_->setTextFormat(Qt::PlainText);
  answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout.addWidget(answer_);
  auto* const scrubber = new QHBoxLayout;
  play_->setCheckable(true);
  scrubber->addWidget(play_);
  scrubber->addWidget(slider_, 1);
  layout.addLayout(scrubber);
  place_->setWordWrap(true);
  layout.addWidget(place_);
  connect(slider_, &QSlider::valueChanged, this, [this] { scrub(); });
  connect(play_, &QPushButton::toggled, this, [this](bool on) { play(on); });
}

void PlanWidget::add_publication(QVBoxLayout& layout) {
  auto* const row = new QHBoxLayout;
  topic_->setPlaceholderText("topic of a controller");
  topic_->setToolTip("Of trajectory_msgs/JointTrajectory. Empty: nothing is published.");
  row->addWidget(topic_, 1);
  row->addWidget(publish_);
  layout.addLayout(row);
  connect(publish_, &QPushButton::clicked, this, [this] { publish(); });
}

QString PlanWidget::topic() const { return topic_->text(); }

void PlanWidget::set_topic(const QString& topic) { topic_->setText(topic); }

void PlanWidget::set_link(PanelLink* link) {
  link_ = link;
  forget();
}

// Poses and paths of another robot.
void PlanWidget::forget() {
  stored_.clear();
  while (start_->count() > 1) start_->removeItem(start_->count() - 1);
  while (goal_->count() > 1) goal_->removeItem(goal_->count() - 1);
  offered_.clear();
  stored_goal_.reset();
  probe_ = ProbeView();
  plan_ = PlanView();
  motion_ = PlannedMotion();
  shown_number_ = 0;
  slider_->set_marks({});
  play_->setChecked(false);
}

void PlanWidget::show_view(const NodeView& view) {
  if (view.start != shown_start_) forget();
  shown_start_ = view.start;
  view_ = view;
  if (link_ != nullptr) plan_ = link_->plan();
  update_ends(view);
  update_plan(view);
  update_publication();
  if (plan_.number != shown_number_) take_result();
  const bool walkable = !motion_.empty();
  slider_->setEnabled(walkable);
  play_->setEnabled(walkable);
}

void PlanWidget::update_ends(const NodeView& view) {
  const ProbeView probe = link_ != nullptr ? link_->probe() : ProbeView();
  const bool stored = probe.stored != probe_.stored;
  const bool other_start = stored && probe.start && !(probe_.start && same(*probe.start, *probe_.start));
  const bool other_goal = stored && probe.goal && !(probe_.goal && same(*probe.goal, *probe_.goal));
  probe_ = probe;
  store_->setEnabled(probe.now.has_value());
  store_->setToolTip(probe.now ? "Keeps the pose of the probe, to start from." : "There is no probe yet.");
  if (other_start) add_start(*probe.start);
  if (other_goal) stored_goal_ = probe.goal;
  if (other_goal || offered_ != ids_of(view)) update_goals(view);
  if (other_goal) goal_->setCurrentIndex(1);
}

// The probe, what was stored by its menu, and every aspect. What was chosen stays so.
void PlanWidget::update_goals(const NodeView& view) {
  const unsigned chosen = goal_->currentData().toUInt();
  offered_ = ids_of(view);
  while (goal_->count() > 1) goal_->removeItem(goal_->count() - 1);
  if (stored_goal_) goal_->addItem(QString::fromStdString("stored: " + pose_of(stored_goal_->pose.pose)));
  for (const ModeRows& mode : rows_of(view))
    for (const AspectRow& row : mode.aspects)
      if (row.id > 0)
        goal_->addItem(QString::fromStdString("aspect " + std::to_string(row.id) + "  " + mode.mode), row.id);
  if (chosen > 0) goal_->setCurrentIndex(std::max(0, goal_->findData(chosen)));
}

void PlanWidget::add_start(const PlanEnd& start) {
  stored_.push_back(start);
  start_->addItem(QString::fromStdString(std::to_string(stored_.size()) + ": " + pose_of(start.pose.pose)));
  start_->setCurrentIndex(start_->count() - 1);
}

PlanChoice PlanWidget::choice() const {
  PlanChoice choice;
  const int start = start_->currentIndex();
  if (start > 0 && start <= static_cast<int>(stored_.size()))
    choice.start = stored_[static_cast<std::size_t>(start - 1)];
  if (goal_->currentIndex() <= 0)
    choice.goal = probe_.now;
  else if (const unsigned aspect = goal_->currentData().toUInt(); aspect > 0)
    choice.goal = end_in_aspect(view_, aspect);
  else
    choice.goal = stored_goal_;
  choice.through_gates = policy_->currentIndex() == 1;
  choice.in_time = in_time_->isChecked();
  choice.parallel_margin = margin_->value();
  return choice;
}

void PlanWidget::update_plan(const NodeView& view) {
  permit(*plan_button_, may_plan(view, choice(), plan_),
         "Plans a path that is proved, or proves that there is none.");
  cancel_->setEnabled(plan_.runs);
  progress_->setValue(plan_.runs ? static_cast<int>(std::lround(100.0 * plan_.progress)) : 0);
  progress_->setVisible(plan_.runs);
  answer_->setText(QString::fromStdString(plan_.message));
}

void PlanWidget::update_publication() {
  permit(*publish_, may_publish(plan_, topic_->text().toStdString()), "Publishes the trajectory, once.");
}

void PlanWidget::take_result() {
  shown_number_ = plan_.number;
  play_->setChecked(false);
  motion_ = plan_.result ? PlannedMotion(*plan_.result) : PlannedMotion();
  slider_->set_marks(motion_.crossings());
  slider_->setValue(0);
  scrub();
}

void PlanWidget::plan() {
  if (link_ != nullptr && may_plan(view_, choice(), plan_)) link_->plan_path(goal_of(choice()));
}

void PlanWidget::publish() {
  const std::string topic = topic_->text().toStdString();
  if (link_ != nullptr && may_publish(plan_, topic)) link_->publish_once(plan_.result->trajectory, topic);
}

void PlanWidget::scrub() {
  if (motion_.empty() || link_ == nullptr) {
    place_->clear();
    return;
  }
  const geometry_msgs::Pose pose = motion_.pose_at(slider_->share());
  const std::vector<std::int8_t> mode = motion_.mode_at(slider_->share());
  place_->setText(QString::fromStdString(mode_of(mode) + "  " + pose_of(pose)));
  link_->move_probe(pose, mode);
}

void PlanWidget::play(bool on) {
  play_->setText(on ? "Pause" : "Play");
  if (!on) return timer_->stop();
  if (slider_->value() == slider_->maximum()) slider_->setValue(0);
  since_step_.start();
  timer_->start();
}

// Evenly along the path, in the time that it takes.
void PlanWidget::step() {
  const double passed = 0.001 * static_cast<double>(since_step_.restart());
  slider_->set_share(slider_->share() + passed / motion_.seconds());
  if (slider_->value() == slider_->maximum()) play_->setChecked(false);
}

}  // namespace parallel_aspects
