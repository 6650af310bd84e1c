// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_PATH_SLIDER_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_PATH_SLIDER_H

#include <QSlider>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_PATH_SLIDER_H
