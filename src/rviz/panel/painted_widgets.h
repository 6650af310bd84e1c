// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_PAINTED_WIDGETS_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_PAINTED_WIDGETS_H

#include "rviz/panel/panel_model.h"

#include <QColor>
#include <QSlider>
#include <QWidget>
#include <vector>

namespace parallel_aspects {

/// Colours that people with any colour vision can distinguish (after Paul Tol's "high contrast" scheme).
inline QColor color_of(SafetyLevel safety) {
  switch (safety) {
    case SafetyLevel::clear:
      return QColor(0x00, 0x44, 0x88);
    case SafetyLevel::warn:
      return QColor(0xDD, 0xAA, 0x33);
    case SafetyLevel::stop:
      return QColor(0xBB, 0x55, 0x66);
    case SafetyLevel::unknown:
      break;
  }
  return QColor(0x77, 0x77, 0x77);
}

/// A distance as a bar: dark what is proved, light up to the witness, marks at the thresholds.
class DistanceBar : public QWidget {
 public:
  explicit DistanceBar(QWidget* parent = nullptr);

  void show_gauge(const DistanceGauge& gauge);
  const DistanceGauge& gauge() const { return gauge_; }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  DistanceGauge gauge_;
};

/// A slider along a path, with a mark at each change of posture.
class PathSlider : public QSlider {
 public:
  explicit PathSlider(QWidget* parent = nullptr);

  void set_marks(std::vector<double> shares);  ///< 0 to 1
  const std::vector<double>& marks() const { return marks_; }

  double share() const;  ///< where the handle is, 0 to 1
  void set_share(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;  // jumps to the place that is clicked

 private:
  int x_of(double share) const;

  std::vector<double> marks_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_PAINTED_WIDGETS_H
