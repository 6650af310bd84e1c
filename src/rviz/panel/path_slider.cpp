// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/path_slider.h"

#include "rviz/panel/tone_colors.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <cmath>
#include <utility>

namespace parallel_aspects {
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
                     color_of(Tone::warn));
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
