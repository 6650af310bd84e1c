// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/solid_view.h"

#include "model/number_text.h"
#include "tools/drawing/solid_grid.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using Eigen::Vector3d;

constexpr std::size_t points_across = 416;         // of the image
constexpr double azimuth = -0.9, elevation = 0.5;  // of the eye, seen from the middle [rad]
constexpr double step = 0.6;                       // along a line of sight, in points of the grid
constexpr double ambient = 0.58;
constexpr double least_proportion = 0.5;
constexpr Rgb background = 0xFFFFFF;

/// A parallel projection of the cube [0, count]^3, with a quarter of it cut away towards the eye.
class Eye {
 public:
  explicit Eye(const Vector3d& proportions) : proportions_(proportions) {
    backward_ = Vector3d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
    right_ = Vector3d::UnitZ().cross(backward_).normalized();
    up_ = backward_.cross(right_);
    for (int corner = 0; corner < 8; ++corner)
      extent_ = std::max(extent_, seen(corner_at(corner)).cwiseAbs().maxCoeff());
    extent_ *= 1.12;  // room for the axes
  }

  /// Where a place of the cube is in the image: 0 to 1, to the right and down.
  PagePoint in_image(const Vector3d& place) const {
    const Eigen::Vector2d at = seen(place) / extent_;
    return {0.5 + 0.5 * at.x(), 0.5 - 0.5 * at.y()};
  }

  /// The place on the line of sight of a point of the image that is `depth` behind the middle.
  Vector3d place(const PagePoint& point, double depth) const {
    const Vector3d from =
        extent_ * ((2.0 * point.x() - 1.0) * right_ + (1.0 - 2.0 * point.y()) * up_) - depth * backward_;
    return from.cwiseQuotient(proportions_) + Vector3d::Constant(0.5 * SolidGrid::count);
  }

  double reach() const { return 1.8 * extent_; }
  const Vector3d& proportions() const { return proportions_; }

  /// Brightness of a surface with this outward normal in the proportions that are seen.
  double light(const Vector3d& normal) const {
    const Vector3d lamp = (backward_ + 0.45 * up_ - 0.35 * right_).normalized();
    return ambient + (1.0 - ambient) * std::max(0.0, normal.dot(lamp));
  }

  static Vector3d corner_at(int corner) {
    return SolidGrid::count * Vector3d(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
  }

 private:
  Eigen::Vector2d seen(const Vector3d& place) const {
    const Vector3d from = (place - Vector3d::Constant(0.5 * SolidGrid::count)).cwiseProduct(proportions_);
    return {from.dot(right_), from.dot(up_)};
  }

  Vector3d proportions_, backward_, right_, up_;
  double extent_ = 0.0;
};

// The quarter towards the eye.
bool is_cut_away(const Vector3d& place) {
  const double middle = 0.5 * SolidGrid::count;
  return place.x() > middle && place.y() < middle;
}

struct Hit {
  Vector3d place;
  bool on_cut = false;
};

class SolidImage {
 public:
  SolidImage(const SolidGrid& grid, const Eye& eye, const std::vector<Rgb>& colors)
      : grid_(grid), eye_(eye), colors_(colors) {}

  PanelContents draw() const {
    PageImage image;
    image.width = points_across;
    image.points.assign(points_across * points_across, background);
    std::vector<int> ids(image.points.size(), 0);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (const auto found = hit(middle_of(i)); found && (ids[i] = grid_.aspect(found->place)) != 0)
        image.points[i] = shaded(color_of_aspect(ids[i]), eye_.light(normal(*found)));
    PanelContents panel;
    panel.image = std::move(image);
    panel.image_labels = labels(ids);
    return panel;
  }

 private:
  bool is_solid(const Vector3d& place) const { return !is_cut_away(place) && grid_.density(place) > 0.5; }

  std::optional<Hit> hit(const PagePoint& point) const {
    for (double depth = -eye_.reach(); depth < eye_.reach(); depth += step) {
      if (!is_solid(eye_.place(point, depth))) continue;
      double outside = depth - step, inside = depth;
      for (int k = 0; k < 6; ++k) {
        const double middle = 0.5 * (outside + inside);
        (is_solid(eye_.place(point, middle)) ? inside : outside) = middle;
      }
      return Hit{eye_.place(point, inside), is_cut_away(eye_.place(point, outside - 0.01))};
    }
    return std::nullopt;
  }

  Vector3d normal(const Hit& hit) const {
    if (hit.on_cut) {
      const Vector3d from = hit.place - Vector3d::Constant(0.5 * SolidGrid::count);
      return std::abs(from.x()) < std::abs(from.y()) ? Vector3d::UnitX() : Vector3d(-Vector3d::UnitY());
    }
    Vector3d slope;
    for (int i = 0; i < 3; ++i) {
      const Vector3d along = 1.2 * Vector3d::Unit(i);
      slope[i] = grid_.density(hit.place - along) - grid_.density(hit.place + along);
    }
    return slope.cwiseQuotient(eye_.proportions()).normalized();
  }

  static PagePoint middle_of(std::size_t i) {
    return {(static_cast<double>(i % points_across) + 0.5) / points_across,
            (static_cast<double>(i / points_across) + 0.5) / points_across};
  }

  Rgb color_of_aspect(int id) const { return colors_[static_cast<std::size_t>(id - 1)]; }

  static Rgb shaded(Rgb color, double light) {
    Rgb result = 0;
    for (const unsigned shift : {16U, 8U, 0U})
      result |= static_cast<Rgb>(light * (color >> shift & 0xFFU)) << shift;
    return result;
  }

  // Each id where it is farthest from what is not of its aspect, by steps from point to point.
  std::vector<ImageLabel> labels(const std::vector<int>& ids) const {
    std::vector<int> room(ids.size(), 0);
    const auto widen = [&](std::size_t i, std::size_t before, std::size_t above) {
      const auto beside = [&](std::size_t other) { return ids[other] == ids[i] ? room[other] : 0; };
      return std::min(beside(before), beside(above)) + 1;
    };
    for (std::size_t i = points_across; i < ids.size(); ++i) room[i] = widen(i, i - 1, i - points_across);
    for (std::size_t i = ids.size() - points_across; i-- > 0;)
      room[i] = std::min(room[i], widen(i, i + 1, i + points_across));
    std::map<int, std::size_t> widest;
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (ids[i] != 0 && room[i] > room[widest.emplace(ids[i], i).first->second]) widest[ids[i]] = i;
    std::vector<ImageLabel> result;
    for (const auto& [id, i] : widest)
      result.push_back({std::to_string(id),
                        {middle_of(i), 0.7 * room[i] / static_cast<double>(points_across)},
                        color_of_aspect(id)});
    return result;
  }

  const SolidGrid& grid_;
  const Eye& eye_;
  const std::vector<Rgb>& colors_;
};

// Lengths keep their proportion unless one is far shorter; an angle is drawn as long as the longest of them.
Vector3d proportions_of(const std::array<SolidAxis, 3>& axes) {
  double longest = 0.0;
  for (const SolidAxis& axis : axes)
    if (axis.unit == "m") longest = std::max(longest, axis.upper - axis.lower);
  Vector3d result = Vector3d::Ones();
  for (std::size_t i = 0; i < 3; ++i)
    if (axes[i].unit == "m")
      result[static_cast<Eigen::Index>(i)] =
          std::max(least_proportion, (axes[i].upper - axes[i].lower) / longest);
  return result;
}

// The edges of the cube along which the axes are seen: two in front below, one at the right.
std::vector<ImageAxis> image_axes(const std::array<SolidAxis, 3>& axes, const Eye& eye) {
  constexpr double end = SolidGrid::count;
  const std::array<std::pair<Vector3d, Vector3d>, 3> edges{std::pair{Vector3d(0, 0, 0), Vector3d(end, 0, 0)},
                                                           {Vector3d(end, 0, 0), Vector3d(end, end, 0)},
                                                           {Vector3d(0, 0, 0), Vector3d(0, 0, end)}};
  std::vector<ImageAxis> result;
  for (std::size_t i = 0; i < 3; ++i)
    result.push_back({eye.in_image(edges[i].first), eye.in_image(edges[i].second),
                      axes[i].name + ": " + number_text(axes[i].lower, 3) + " to " +
                          number_text(axes[i].upper, 3) + " " + axes[i].unit});
  return result;
}

std::set<int> aspects_of(const AspectMap& map, const WorkingMode& mode) {
  std::set<int> ids;
  for (const Aspect& aspect : map.aspects())
    if (aspect.mode == mode) ids.insert(aspect.id);
  return ids;
}

}  // namespace

void add_solids(const AspectMap& map, const std::vector<WorkingMode>& modes,
                const std::function<void()>& checkpoint, Page& page) {
  const std::array<SolidAxis, 3> axes = solid_axes(map);
  const Eye eye(proportions_of(axes));
  const std::vector<Rgb> colors = aspect_colors(map.aspects());
  page.notes = {
      std::string(map.slice() ? "Map of the slice " + to_string(*map.slice()) + "." : "Map of all poses.") +
      " The boxes that are proved to lie in each aspect, rounded for the eye on a grid of " +
      std::to_string(SolidGrid::count) + " points a side; a quarter is cut away."};
  if (map.coordinates().empty())
    page.notes.emplace_back(
        "Orientations as rotation vectors, in a ball of radius pi; opposite points of its surface are the "
        "same.");
  for (const WorkingMode& mode : modes) {
    checkpoint();
    const SolidGrid grid(map, axes, mode, checkpoint);
    PanelContents panel = SolidImage(grid, eye, colors).draw();
    panel.image_axes = image_axes(axes, eye);
    page.figures.push_back({"working mode " + to_string(mode),
                            aspect_entries(map, colors, aspects_of(map, mode)),
                            {std::move(panel)}});
  }
  page.legend = {{aspect_color(1, 0), false, "light: det A > 0"},
                 {aspect_color(-1, 0), false, "dark: det A < 0"}};
}

}  // namespace parallel_aspects::tools
