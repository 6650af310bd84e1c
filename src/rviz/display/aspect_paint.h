// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_ASPECT_PAINT_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_ASPECT_PAINT_H

#include "aspects/pictures/palette.h"
#include "parallel_aspects/model/task_space.h"
#include "rviz/display/colored_parts.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What the sets of a picture are called: with six degrees of freedom they are of the positions at one
/// orientation.
inline std::string set_word(TaskSpace space) { return space == TaskSpace::SE3 ? "part" : "aspect"; }

/// The colours of one picture.
class AspectPaint {
 public:
  AspectPaint(const AspectMap& map, bool tells_boundaries)
      : colors_(aspect_colors(map.aspects())), tells_boundaries_(tells_boundaries) {}

  Rgb color(int id) const { return colors_[static_cast<std::size_t>(id - 1)]; }

  /// Of a surface, tinted by what the aspect ends at there. Surfaces have shadows, so that they are lighter
  /// than what lies in a plane.
  Rgb color(int id, const std::optional<BoundaryKind>& kind) {
    const Rgb body = lightened(color(id), 0.25);
    if (!kind) return body;
    kinds_.insert(*kind);
    return tells_boundaries_ ? mixed(body, lightened(boundary_color(*kind), 0.35), 0.55) : body;
  }

  void meet(BoundaryKind kind) { kinds_.insert(kind); }
  const std::set<BoundaryKind>& kinds() const noexcept { return kinds_; }  ///< that were met

 private:
  std::vector<Rgb> colors_;  // by id - 1
  bool tells_boundaries_;
  std::set<BoundaryKind> kinds_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_ASPECT_PAINT_H
