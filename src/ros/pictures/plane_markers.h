// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_PLANE_MARKERS_H
#define PARALLEL_ASPECTS_ROS_PICTURES_PLANE_MARKERS_H

#include "draw/scene/plane_scene.h"
#include "ros/pictures/marker_batch.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// What lies above what.
enum class Layer { fill, frame, outline, boundary, dot, text = 6 };

/// Height above the plane of a drawing [m].
inline double height_of(Layer layer, double text_height) {
  return 0.02 * text_height * static_cast<double>(layer);
}

/// The four sides, two ends each.
MarkerBatch::Points rectangle(const Eigen::Vector2d& center, const Eigen::Vector2d& size);

/// Which aspect is full while others are pale, by its id, 0 for none; nothing where all are full.
using Highlight = std::optional<int>;

/// Paints planes of scenes as markers whose names begin with that of a group.
class PlanePainter {
 public:
  /// Where a point of a scene is in the plane of the markers [m].
  using Placing = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

  /// Height of text and width of boundaries [m].
  PlanePainter(
      MarkerBatch& batch, MarkerBatch::Plane plane, std::string group, double text, double width,
      Placing place = [](const Eigen::Vector2d& point) { return point; })
      : batch_(batch),
        plane_(std::move(plane)),
        group_(std::move(group)),
        text_(text),
        width_(width),
        place_(std::move(place)) {}

  void area(const PlaneArea& area, const Highlight& only = {}, float opacity = 1.0F, double height = 0.0,
            const std::string& name = "/aspects") const;

  /// What is written on an area, at a point of the scene.
  void label(const PlaneArea& area, const Eigen::Vector2d& at, double size, const Highlight& only = {}) const;

  /// In the colours of their kinds.
  void boundaries(const PlaneScene& scene) const;

  /// A dark line around one aspect, wider than the boundaries.
  void outline(const PlaneScene& scene, int aspect) const;

  /// Of the point of a scene, in two colours, so that it is seen on all.
  void dot(const Eigen::Vector2d& at) const;

  /// These are placed in the plane of the markers.
  void words(const std::string& name, const Eigen::Vector2d& at, double size, const std::string& text,
             Rgb color = ink_color) const;
  void frame(const std::string& name, const Eigen::Vector2d& center, const Eigen::Vector2d& size, Rgb color,
             double width, Layer layer = Layer::frame) const;

 private:
  MarkerBatch::Points placed(MarkerBatch::Points points) const;

  MarkerBatch& batch_;
  MarkerBatch::Plane plane_;
  std::string group_;
  double text_, width_;
  Placing place_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_PLANE_MARKERS_H
