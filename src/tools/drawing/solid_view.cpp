// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/solid_view.h"

#include "model/angles.h"
#include "model/number_text.h"
#include "tools/drawing/surface_image.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using Eigen::Vector3d;

constexpr double shortest_edge = 0.5;          // of the box, of its longest
constexpr std::size_t most_triangles = 40000;  // of a surface

/// The box that is drawn.
struct SolidBox {
  Vector3d lower, upper;
  std::array<std::string, 3> names, units;
};

SolidBox box_of(const AspectMap& map) {
  if (map.manipulator()->task_space() == TaskSpace::SO3)
    return {Vector3d::Constant(-pi),
            Vector3d::Constant(pi),
            {"about x", "about y", "about z"},
            {"rad", "rad", "rad"}};
  SolidBox box{Vector3d::Constant(std::numeric_limits<double>::infinity()),
               Vector3d::Constant(-std::numeric_limits<double>::infinity()),
               {},
               {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    box.names[i] = map.coordinates()[i];
    box.units[i] = box.names[i] == "phi" ? "rad" : "m";
    for (const Aspect& aspect : map.aspects()) {
      box.lower[k] = std::min(box.lower[k], aspect.bounds.lower[i]);
      box.upper[k] = std::max(box.upper[k], aspect.bounds.upper[i]);
    }
  }
  return box;
}

// Lengths keep their proportion unless one is far shorter; an angle is drawn as long as the longest of them.
Vector3d lengths_of(const SolidBox& box) {
  const Vector3d ranges = box.upper - box.lower;
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (box.units[i] == "m") longest = std::max(longest, ranges[static_cast<Eigen::Index>(i)]);
  Vector3d lengths = Vector3d::Ones();
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto k = static_cast<Eigen::Index>(i); box.units[i] == "m")
      lengths[k] = std::max(shortest_edge, ranges[k] / longest);
  return lengths;
}

// The edges of the box in front below, and at the left.
std::vector<ImageAxis> axes_of(const SolidBox& box, const Eye& eye) {
  const Vector3d& l = box.lower;
  const Vector3d& u = box.upper;
  const std::array<std::pair<Vector3d, Vector3d>, 3> edges{
      std::pair{l, Vector3d(u.x(), l.y(), l.z())},
      {Vector3d(u.x(), l.y(), l.z()), Vector3d(u.x(), u.y(), l.z())},
      {l, Vector3d(l.x(), l.y(), u.z())}};
  std::vector<ImageAxis> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    axes.push_back(
        {eye.seen(edges[i].first).head<2>(),
         eye.seen(edges[i].second).head<2>(),
         {box.names[i] + " [" + box.units[i] + "]", number_text(l[k], 3) + " to " + number_text(u[k], 3)}});
  }
  return axes;
}

std::set<int> aspects_of(const AspectMap& map, const WorkingMode& mode) {
  std::set<int> ids;
  for (const Aspect& aspect : map.aspects())
    if (aspect.mode == mode) ids.insert(aspect.id);
  return ids;
}

std::set<int> seen_in(const PanelContents& panel) {
  std::set<int> ids;
  for (const ImageLabel& label : panel.image_labels) ids.insert(std::stoi(label.text));
  return ids;
}

}  // namespace

void add_solids(const AspectMap& map, const std::vector<WorkingMode>& modes,
                const std::function<void()>& checkpoint, Page& page) {
  const SolidBox box = box_of(map);
  const Eye eye(box.lower, box.upper, lengths_of(box));
  const std::vector<Rgb> colors = aspect_colors(map.aspects());
  SurfaceOptions options;
  options.most_triangles = most_triangles;
  const HalfSpace behind{-Vector3d::UnitY(), -0.5 * (box.lower.y() + box.upper.y())};
  page.notes = {
      (map.slice() ? "Map of the slice " + to_string(*map.slice()) + "." : std::string("Map of all poses.")) +
      " The boxes that are proved to lie in each aspect, smoothed for the eye by no more than one of them; "
      "what is in front of the middle of " +
      box.names[1] + " is cut away."};
  if (map.manipulator()->task_space() == TaskSpace::SO3)
    page.notes.emplace_back(
        "Orientations as rotation vectors, in a ball of radius pi; opposite points of its surface are the "
        "same.");
  std::vector<int> hidden;
  for (const WorkingMode& mode : modes) {
    const std::set<int> ids = aspects_of(map, mode);
    SurfaceImage image(eye);
    for (const int id : ids) {
      checkpoint();
      image.add(section_of(surface_of(map, id, options), behind), colors[static_cast<std::size_t>(id - 1)]);
    }
    PanelContents panel;
    panel.image = image.image();
    panel.image_labels = image.labels();
    panel.image_axes = axes_of(box, eye);
    page.figures.push_back(
        {"working mode " + to_string(mode), aspect_entries(map, colors, ids), {std::move(panel)}});
    const std::set<int> seen = seen_in(page.figures.back().panels.front());
    std::set_difference(ids.begin(), ids.end(), seen.begin(), seen.end(), std::back_inserter(hidden));
  }
  if (!hidden.empty())
    page.notes.push_back(missing_aspects(
        hidden, "Cut away, behind others or smaller than a point of the picture, and not seen"));
  page.legend = {{aspect_color(1, 0), false, "light: det A > 0"},
                 {aspect_color(-1, 0), false, "dark: det A < 0"}};
}

}  // namespace parallel_aspects::tools
