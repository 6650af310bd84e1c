// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/plane_markers.h"

namespace parallel_aspects {
namespace {

Rgb shade_of(const PlaneArea& area, const Highlight& only) {
  return only && *only != area.aspect ? lightened(area.color, 0.65) : area.color;
}

}  // namespace

MarkerBatch::Points rectangle(const Eigen::Vector2d& center, const Eigen::Vector2d& size) {
  const Eigen::Vector2d half = 0.5 * size, across(half.x(), -half.y());
  const Eigen::Vector2d a = center - half, b = center + across, c = center + half, d = center - across;
  return {a, b, b, c, c, d, d, a};
}

MarkerBatch::Points PlanePainter::placed(MarkerBatch::Points points) const {
  for (Eigen::Vector2d& point : points) point = place_(point);
  return points;
}

void PlanePainter::area(const PlaneArea& area, const Highlight& only, float opacity, double height,
                        const std::string& name) const {
  batch_.triangles(plane_, group_ + name, placed(triangles_of(area)), height,
                   color(shade_of(area, only), opacity));
}

void PlanePainter::label(const PlaneArea& area, const Eigen::Vector2d& at, double size,
                         const Highlight& only) const {
  words("/labels", place_(at), size, area.label, readable_on(shade_of(area, only)));
}

void PlanePainter::boundaries(const PlaneScene& scene) const {
  for (const BoundaryCurves& curves : curves_of(scene.boundaries))
    batch_.lines(plane_, group_ + "/boundary", placed(curves.ends), height_of(Layer::boundary, text_), width_,
                 color(curves.style->color));
}

void PlanePainter::outline(const PlaneScene& scene, int aspect) const {
  batch_.lines(plane_, group_ + "/outline", placed(outline_of(scene.boundaries, aspect)),
               height_of(Layer::outline, text_), 2.2 * width_, color(ink_color));
}

void PlanePainter::dot(const Eigen::Vector2d& at) const {
  batch_.dots(plane_, group_, {place_(at)}, height_of(Layer::dot, text_), 0.55 * text_, color(0x000000));
  batch_.dots(plane_, group_, {place_(at)}, 0.3 * text_, 0.35 * text_, color(0xFFFFFF));
}

void PlanePainter::words(const std::string& name, const Eigen::Vector2d& at, double size,
                         const std::string& text, Rgb rgb) const {
  batch_.text(plane_, group_ + name, at, height_of(Layer::text, text_), size, text, color(rgb));
}

void PlanePainter::frame(const std::string& name, const Eigen::Vector2d& center, const Eigen::Vector2d& size,
                         Rgb rgb, double width, Layer layer) const {
  batch_.lines(plane_, group_ + name, rectangle(center, size), height_of(layer, text_), width, color(rgb));
}

}  // namespace parallel_aspects
