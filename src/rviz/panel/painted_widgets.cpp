// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/painted_widgets.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int bar_height = 8, gap = 2, mark_width = 2;  // [pixels]

double known(double share) { return std::isnan(share) ? 0.0 : share; }

void draw_mark(QPainter& painter, const QRectF& bar, double share, SafetyLevel safety) {
  if (!(share > 0.0)) return;
  const double x = bar.left() + share * bar.width();
  painter.fillRect(QRectF(x - mark_width / 2.0, bar.top() - gap, mark_width, bar.height() + 2 * gap),
                   color_of(safety));
}

QRectF part_of(const QRectF& bar, double from, double to) {
  return {bar.left() + from * bar.width(), bar.top(), (to - from) * bar.width(), bar.height()};
}

}  // namespace

DistanceBar::DistanceBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void DistanceBar::show_gauge(const DistanceGauge& gauge) {
  gauge_ = gauge;
  setToolTip(QString::fromStdString(gauge.tip));
  update();
}

QSize DistanceBar::sizeHint() const { return {200, fontMetrics().height() + bar_height + 4 * gap}; }

void DistanceBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRect text(0, 0, width(), fontMetrics().height());
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(gauge_.name));
  painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(gauge_.text));
  const QRectF bar(0.0, text.bottom() + 1.0 + gap, width(), bar_height);
  painter.fillRect(bar, palette().color(QPalette::Midlight));
  const QColor color = color_of(gauge_.safety);
  const double lower = known(gauge_.lower), upper = std::max(lower, known(gauge_.upper));
  painter.fillRect(part_of(bar, 0.0, lower), color);
  painter.fillRect(part_of(bar, lower, upper), QBrush(color, Qt::Dense6Pattern));
  draw_mark(painter, bar, gauge_.warn, SafetyLevel::warn);
  draw_mark(painter, bar, gauge_.stop, SafetyLevel::stop);
}

namespace {

constexpr int steps = 1000;
constexpr int slider_mark_width = 3;  // [pixels]

}  // namespace

PathSlider::PathSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, steps);
  setPageStep(steps / 20);
  setSingleStep(steps / 100);
  setFocusPolicy(Qt::StrongFocus);
}

void PathSlider::set_marks(std::vector<double> shares) {
  marks_ = std::move(shares);
  update();
}

double PathSlider::share() const { return static_cast<double>(value()) / steps; }

void PathSlider::set_share(double share) { setValue(static_cast<int>(std::lround(share * steps))); }

// Of the middle of the handle.
int PathSlider::x_of(double share) const {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
  return handle / 2 + static_cast<int>(std::lround(share * (width() - handle)));
}

void PathSlider::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  for (const double mark : marks_)
    painter.fillRect(x_of(mark) - slider_mark_width / 2, 0, slider_mark_width, height(),
                     color_of(SafetyLevel::warn));
  painter.end();
  QSlider::paintEvent(event);
}

void PathSlider::mousePressEvent(QMouseEvent* event) {
  const int left = x_of(0.0), right = x_of(1.0);
  if (event->button() == Qt::LeftButton && right > left)
    setValue(QStyle::sliderValueFromPosition(0, steps, event->x() - left, right - left));
  QSlider::mousePressEvent(event);
}

}  // namespace parallel_aspects
