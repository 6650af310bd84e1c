// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/distance_bar.h"

#include "rviz/panel/tone_colors.h"

#include <QPainter>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int bar_height = 8, gap = 2, mark_width = 2;  // [pixels]

double known(double share) { return std::isnan(share) ? 0.0 : share; }

void draw_mark(QPainter& painter, const QRectF& bar, double share, Tone tone) {
  if (!(share > 0.0)) return;
  const double x = bar.left() + share * bar.width();
  painter.fillRect(QRectF(x - mark_width / 2.0, bar.top() - gap, mark_width, bar.height() + 2 * gap),
                   color_of(tone));
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
  const QColor color = color_of(gauge_.tone);
  const double lower = known(gauge_.lower), upper = std::max(lower, known(gauge_.upper));
  painter.fillRect(part_of(bar, 0.0, lower), color);
  painter.fillRect(part_of(bar, lower, upper), QBrush(color, Qt::Dense6Pattern));
  draw_mark(painter, bar, gauge_.warn, Tone::warn);
  draw_mark(painter, bar, gauge_.stop, Tone::stop);
}

}  // namespace parallel_aspects
