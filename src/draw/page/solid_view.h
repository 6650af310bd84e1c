// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_SOLID_VIEW_H
#define PARALLEL_ASPECTS_DRAW_PAGE_SOLID_VIEW_H

#include "parallel_aspects/aspects/aspect_map.h"

#include <Eigen/Core>

#include "draw/page/page.h"
#include "draw/page/panel.h"
#include "draw/surface/aspect_surface.h"
#include <cstddef>
#include <functional>
#include <vector>

namespace parallel_aspects {

/// A parallel projection of a box of three coordinates, from the front, a little right and above.
class Eye {
 public:
  /// The ends of the box, and how long its edges are drawn.
  Eye(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper, const Eigen::Vector3d& lengths);

  /// Where a point is seen, 0 to 1 to the right and down, and how near to the eye.
  Eigen::Vector3d seen(const Eigen::Vector3d& point) const;

  /// Where a point is in the box as it is drawn.
  Eigen::Vector3d drawn(const Eigen::Vector3d& point) const;

  /// Brightness of a surface with this normal in the box as it is drawn, on either side; 0 to 1.
  double light(const Eigen::Vector3d& normal) const;

 private:
  Eigen::Vector3d middle_, scale_, towards_, right_, up_;
  double extent_ = 1.0;
};

/// Shaded surfaces; what is in front hides what is behind.
class SurfaceImage {
 public:
  explicit SurfaceImage(const Eye& eye);

  void add(const AspectSurface& surface, Rgb color);

  PageImage image() const;

  /// Each id where most of its aspect is seen around it.
  std::vector<ImageLabel> labels() const;

 private:
  struct Corner {
    Eigen::Vector3d seen, normal;
  };
  void fill(const Corner& a, const Corner& b, const Corner& c, int aspect, Rgb color);

  const Eye& eye_;
  std::vector<Rgb> points_;
  std::vector<double> depths_;  // how near
  std::vector<int> ids_;
  std::vector<Rgb> colors_;  // by id
};

/// Adds the aspects of working modes of a map that has surfaces to a page, as shaded bodies of which the half
/// in front is cut away. `checkpoint` is called now and then; it may throw.
void add_solids(const AspectMap& map, const std::vector<WorkingMode>& modes,
                const std::function<void()>& checkpoint, Page& page);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_SOLID_VIEW_H
