// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/state_widget.h"

#include "model/message_text.h"
#include "rviz/panel/painted_widgets.h"

#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int lines_of_text = 2;      // that the banner has room for, whatever it says
constexpr int candidate_lines = 7;    // that are seen at once
constexpr int candidate_swatch = 12;  // [pixels]

QLabel* wrapped_label(const char* name) {
  auto* const label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

StateWidget::StateWidget(OnChoice on_choice, QWidget* parent)
    : QWidget(parent),
      on_choice_(std::move(on_choice)),
      title_(wrapped_label("state_title")),
      text_(wrapped_label("state_text")),
      domains_(wrapped_label("domains")),
      scale_(new QLabel),
      pages_(new QStackedWidget),
      candidate_box_(new QWidget),
      candidate_text_(wrapped_label("candidate_text")),
      candidate_layout_(new QVBoxLayout(candidate_box_)) {
  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(title_);
  layout->addWidget(text_);
  layout->addWidget(domains_);
  candidate_layout_->setContentsMargins(0, 0, 0, 0);
  candidate_layout_->addWidget(candidate_text_);
  text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  text_->setMinimumHeight(lines_of_text * fontMetrics().lineSpacing());
  layout->addWidget(pages_);
  pages_->addWidget(bar_page());
  pages_->addWidget(candidate_page());
}

QWidget* StateWidget::bar_page() {
  auto* const page = new QWidget;
  auto* const layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < bars_.size(); ++i) {
    bars_[i] = new DistanceBar;
    bars_[i]->setObjectName(QString("distance_%1").arg(i));
    layout->addWidget(bars_[i]);
  }
  scale_->setAlignment(Qt::AlignRight);
  scale_->setStyleSheet("color: #666666");  // as the axis of a diagram
  layout->addWidget(scale_);
  return page;
}

// In place of the bars, which say nothing while the state is not known: so nothing below them moves.
QWidget* StateWidget::candidate_page() {
  auto* const page = new QScrollArea;
  page->setFrameShape(QFrame::NoFrame);
  page->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  page->setWidgetResizable(true);
  page->setWidget(candidate_box_);
  page->setMinimumHeight(candidate_lines * fontMetrics().lineSpacing());
  return page;
}

void StateWidget::show_view(const NodeView& view) {
  show_banner(banner_of(view));
  show_domains(domain_line_of(view));
  const auto gauges = gauges_of(view);
  for (std::size_t i = 0; i < bars_.size(); ++i) bars_[i]->show_gauge(gauges[i]);
  scale_->setText(QString::fromStdString("bars: proved distance, full at " + number_text(scale_of(view)) +
                                         " " + view.unit.name()));
  show_candidates(view);
}

void StateWidget::show_banner(const Banner& banner) {
  title_->setText(QString::fromStdString(banner.title));
  text_->setText(QString::fromStdString(banner.text));
  if (safety_ == static_cast<int>(banner.safety)) return;
  safety_ = static_cast<int>(banner.safety);
  const char* const ink = banner.safety == SafetyLevel::warn ? "black" : "white";
  title_->setStyleSheet(
      QString("background: %1; color: %2; font-weight: bold; padding: 3px 6px; border-radius: 3px")
          .arg(color_of(banner.safety).name(), ink));
}

void StateWidget::show_domains(const DomainLine& line) {
  domains_->setVisible(!line.text.empty());
  domains_->setText(QString::fromStdString(line.text));
  domains_->setToolTip(QString::fromStdString(line.tip));
  if (domains_safety_ == static_cast<int>(line.safety)) return;
  domains_safety_ = static_cast<int>(line.safety);
  domains_->setStyleSheet(line.safety == SafetyLevel::warn
                              ? QString("background: %1; color: black").arg(color_of(line.safety).name())
                              : QString());
}

void StateWidget::show_candidates(const NodeView& view) {
  const std::vector<CandidateLine> lines = candidates_of(view);
  pages_->setCurrentIndex(lines.empty() ? 0 : 1);
  candidates_ = lines.empty() ? std::vector<SolvedConfiguration>() : view.candidates.candidates;
  resize_candidates(lines.size());
  const Permission permission = may_choose(view);
  const std::string which =
      view.candidates.complete ? "It is in one of these. " : "It may be in one of these, or in another. ";
  candidate_text_->setText(
      QString::fromStdString(which + (permission ? "Click the one that you see:" : permission.refusal)));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    buttons_[i]->setText(
        QString::fromStdString(lines[i].name + ":  " + lines[i].branch + "\n" + lines[i].text));
    QPixmap swatch(candidate_swatch, candidate_swatch);
    swatch.fill(QColor(static_cast<QRgb>(lines[i].color)));
    buttons_[i]->setIcon(swatch);
    buttons_[i]->setMinimumHeight(buttons_[i]->sizeHint().height());
    buttons_[i]->setEnabled(static_cast<bool>(permission));
    buttons_[i]->setToolTip(QString::fromStdString(
        permission ? "States to the node that the robot is in this assembly mode." : permission.refusal));
  }
}

void StateWidget::resize_candidates(std::size_t count) {
  while (buttons_.size() > count) {
    buttons_.back()->deleteLater();
    buttons_.pop_back();
  }
  while (buttons_.size() < count) {
    auto* const button = new QPushButton;
    const std::size_t number = buttons_.size();
    button->setObjectName(QString("candidate_%1").arg(number));
    connect(button, &QPushButton::clicked, this, [this, number] {
      if (number < candidates_.size()) on_choice_(candidates_[number]);
    });
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    button->setStyleSheet("text-align: left; padding: 3px 6px");
    candidate_layout_->addWidget(button);
    buttons_.push_back(button);
  }
}

}  // namespace parallel_aspects
