// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_DISTANCE_BAR_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_DISTANCE_BAR_H

#include "rviz/panel/panel_model.h"

#include <QWidget>

namespace parallel_aspects {

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_DISTANCE_BAR_H
