// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/domain_picture.h"

#include "draw/surface/aspect_surface.h"
#include "ros/pictures/marker_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

namespace parallel_aspects {
namespace {

using Eigen::AlignedBox2d;
using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double lean = 60.0 / 180.0 * EIGEN_PI;  // back from the plane that is seen from above [rad]
constexpr double gap = 0.15, legend_share = 0.2;  // beside and between boxes, of their width
constexpr std::size_t most_rows = 2;              // of boxes; others are in further columns
constexpr int cells = 48;                         // of the grid, along each axis

using Cell = std::array<int, 3>;

/// Poses in a grid over all aspects of a map, each with its basic region in a working mode.
class RegionGrid {
 public:
  RegionGrid(const Uniqueness& uniqueness, const WorkingMode& mode, const MapControl& control);

  const WorkingMode& mode() const noexcept { return mode_; }

  /// The middles of the cells of a region of which a neighbour is in no region, or in another [m, m, rad].
  std::vector<Vector3d> outermost(std::size_t region) const;

  Vector3d edges() const { return bounds_.sizes() / cells; }

 private:
  static std::size_t index(const Cell& cell) {
    return static_cast<std::size_t>((cell[2] * cells + cell[1]) * cells + cell[0]);
  }
  Vector3d middle(const Cell& cell) const {
    return bounds_.min() + (Vector3d(cell[0], cell[1], cell[2]).array() + 0.5).matrix().cwiseProduct(edges());
  }
  bool is_outermost(const Cell& cell) const;
  template <class Visit>
  static void visit(const Visit& visit_cell);

  WorkingMode mode_;
  AlignedBox3d bounds_;
  std::vector<std::int32_t> regions_;  // -1 for none
};

AlignedBox3d bounds_of(const AspectMap& map) {
  AlignedBox3d bounds;
  for (const Aspect& aspect : map.aspects()) {
    bounds.extend(Vector3d(aspect.bounds.lower[0], aspect.bounds.lower[1], -EIGEN_PI));
    bounds.extend(Vector3d(aspect.bounds.upper[0], aspect.bounds.upper[1], EIGEN_PI));
  }
  return bounds;
}

template <class Visit>
void RegionGrid::visit(const Visit& visit_cell) {
  Cell cell{};
  for (cell[2] = 0; cell[2] < cells; ++cell[2])
    for (cell[1] = 0; cell[1] < cells; ++cell[1])
      for (cell[0] = 0; cell[0] < cells; ++cell[0]) visit_cell(cell);
}

RegionGrid::RegionGrid(const Uniqueness& uniqueness, const WorkingMode& mode, const MapControl& control)
    : mode_(mode), bounds_(bounds_of(*uniqueness.map)), regions_(cells * cells * cells, -1) {
  visit([&](const Cell& cell) {
    if (is_cancelled(control)) return;
    const Vector3d at = middle(cell);
    if (const auto region = uniqueness.locate(Pose::planar(at.x(), at.y(), at.z()), mode))
      regions_[index(cell)] = static_cast<std::int32_t>(*region);
  });
}

// The ends of phi count as outermost, though they are one: there the picture is cut.
bool RegionGrid::is_outermost(const Cell& cell) const {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      Cell beside = cell;
      beside[axis] += step;
      if (beside[axis] < 0 || beside[axis] >= cells || regions_[index(beside)] != regions_[index(cell)])
        return true;
    }
  return false;
}

std::vector<Vector3d> RegionGrid::outermost(std::size_t region) const {
  std::vector<Vector3d> middles;
  visit([&](const Cell& cell) {
    if (regions_[index(cell)] == static_cast<std::int32_t>(region) && is_outermost(cell))
      middles.push_back(middle(cell));
  });
  return middles;
}

std::string numbered(const char* what, std::size_t number) {
  char text[48];
  std::snprintf(text, sizeof text, "%s %02zu", what, number);
  return text;
}

/// What is drawn of one aspect.
class AspectDrawing {
 public:
  AspectDrawing(const Uniqueness& uniqueness, const DomainLayout& layout, std::size_t box, int aspect,
                MarkerBatch& batch)
      : uniqueness_(uniqueness), layout_(layout), aspect_(aspect), batch_(batch) {
    const Manipulator& robot = *uniqueness.map->manipulator();
    box_ = {robot.base_frame(), robot.task_frame() * layout.frame(box)};
    flat_ = {robot.base_frame(), robot.task_frame()};
    top_ = layout.top(box);
    line_ =
        top_ - Vector2d((0.5 + 0.5 * legend_share) * layout.box().sizes().x(), 0.5 * layout.text_height());
  }

  void draw_frame() {
    const double text = layout_.text_height();
    batch_.segments(box_, group("frame"), edges(), 0.06 * text, color(0x808080));
    const Aspect& aspect = uniqueness_.map->aspects()[static_cast<std::size_t>(aspect_ - 1)];
    batch_.text(flat_, group("frame"), top_ + Vector2d(0.0, 0.9 * text), 0.0, text,
                "Basic regions of aspect " + std::to_string(aspect_) + ", " +
                    branch_text(aspect.mode, aspect.determinant_sign),
                color(ink_color));
    const AlignedBox3d& box = layout_.box();
    for (const double end : {-1.0, 1.0})
      batch_.text(box_, group("frame"), {box.max().x() + 1.5 * text, box.max().y()},
                  end * EIGEN_PI * layout_.radian(), 0.8 * text, end < 0.0 ? "phi = -pi" : "phi = pi",
                  color(ink_color));
  }

  void draw_region(std::size_t region, std::size_t hue, const RegionGrid& grid) {
    const double text = layout_.text_height();
    const auto shade = color(aspect_color(1, hue));  // the light ones, in every aspect
    const std::string name = group(numbered("basic region", region + 1));
    const Vector3d scale(1.0, 1.0, layout_.radian());
    std::vector<Vector3d> middles = grid.outermost(region);
    for (Vector3d& middle : middles) middle = middle.cwiseProduct(scale);
    batch_.cubes(box_, name, middles, grid.edges().cwiseProduct(scale), shade);
    batch_.dots(flat_, name, {line_}, 0.0, 0.7 * text, shade);
    batch_.text(flat_, name, line_ + Vector2d(1.2 * text, 0.0), 0.0, text, std::to_string(region + 1),
                color(ink_color));
    line_.y() -= 1.2 * text;
  }

  void draw_cusps(const CuspCurves& cusps) {
    for (const CuspCurve& curve : cusps.curves)
      batch_.segments(box_, group("cusps"), pieces_of(curve), 0.2 * layout_.text_height(),
                      color(boundary_color(BoundaryKind::parallel)));
  }

 private:
  std::string group(const std::string& what) const {
    return "aspect " + std::to_string(aspect_) + "/" + what;
  }

  std::vector<Vector3d> edges() const {
    std::vector<Vector3d> ends;
    for (int corner = 0; corner < 8; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        if ((corner >> axis & 1) == 0)
          for (const int end : {corner, corner | 1 << axis})
            ends.push_back(layout_.box().corner(static_cast<AlignedBox3d::CornerType>(end)));
    return ends;
  }

  // Without those that go around through phi = pi.
  std::vector<Vector3d> pieces_of(const CuspCurve& curve) const {
    std::vector<Vector3d> ends;
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
      const Vector3d from = surface_point(TaskSpace::SE2, curve.points[i].pose),
                     to = surface_point(TaskSpace::SE2, curve.points[i + 1].pose);
      if (std::abs(from.z() - to.z()) > EIGEN_PI) continue;
      for (const Vector3d& end : {from, to}) ends.emplace_back(end.x(), end.y(), layout_.radian() * end.z());
    }
    return ends;
  }

  const Uniqueness& uniqueness_;
  const DomainLayout& layout_;
  const int aspect_;
  MarkerBatch& batch_;
  MarkerBatch::Plane box_, flat_;
  Vector2d top_, line_;  // of the box, and where the next line of the legend begins
};

}  // namespace

DomainLayout::DomainLayout(const Manipulator& manipulator, const Scene& scene, const AlignedBox2d& positions,
                           std::size_t aspects)
    : radian_(turn_length(manipulator) / (2.0 * EIGEN_PI)),
      rows_(std::clamp<std::size_t>(aspects, 1, most_rows)),
      columns_((aspects + rows_ - 1) / rows_) {
  const double half_turn = EIGEN_PI * radian_;
  box_ = {Vector3d(positions.min().x(), positions.min().y(), -half_turn),
          Vector3d(positions.max().x(), positions.max().y(), half_turn)};
  height_ = std::cos(lean) * box_.sizes().y() + std::sin(lean) * box_.sizes().z();
  middle_ = {scene.robot.min().x() - (gap + 0.5) * box_.sizes().x(), scene.robot.center().y()};
}

Vector2d DomainLayout::pitch() const {
  const double width = box_.sizes().x();
  return {(1.0 + gap + legend_share) * width, height_ + gap * width};
}

Isometry3d DomainLayout::frame(std::size_t box) const {
  const double above = 0.5 * (static_cast<double>(rows_) - 1.0) - static_cast<double>(box % rows_);
  const auto before = static_cast<double>(columns_ - 1 - box / rows_);
  return Eigen::Translation3d(middle_.x() - before * pitch().x(), middle_.y() + above * pitch().y(), 0.0) *
         Eigen::AngleAxisd(-lean, Vector3d::UnitX()) * Eigen::Translation3d(-box_.center());
}

Vector2d DomainLayout::top(std::size_t box) const {
  return Vector3d(frame(box) * box_.center()).head<2>() + Vector2d(0.0, 0.5 * height_);
}

AlignedBox2d DomainLayout::seen() const {
  const double width = box_.sizes().x(), half = 0.5 * static_cast<double>(rows_) * pitch().y();
  const double before = static_cast<double>(columns_ - 1) * pitch().x();
  return {middle_ - Vector2d(before + (0.5 + legend_share) * width, half),
          middle_ + Vector2d(0.5 * width, half)};
}

visualization_msgs::MarkerArray domain_markers(const Uniqueness& uniqueness, const CuspCurves& cusps,
                                               const Scene& scene, const MapControl& control) {
  const auto& aspects = uniqueness.map->aspects();
  const AlignedBox3d bounds = bounds_of(*uniqueness.map);
  const AlignedBox2d positions(bounds.min().head<2>(), bounds.max().head<2>());
  const DomainLayout layout(*uniqueness.map->manipulator(), scene, positions, aspects.size());
  std::optional<RegionGrid> grid;
  MarkerBatch batch;
  for (std::size_t box = 0; box < aspects.size() && !is_cancelled(control); ++box) {
    if (!grid || grid->mode() != aspects[box].mode) grid.emplace(uniqueness, aspects[box].mode, control);
    AspectDrawing drawing(uniqueness, layout, box, aspects[box].id, batch);
    drawing.draw_frame();
    std::size_t hue = 0;
    for (std::size_t region = 0; region < uniqueness.basic_regions.size(); ++region)
      if (uniqueness.basic_regions[region].aspect == aspects[box].id)
        drawing.draw_region(region, hue++, *grid);
    drawing.draw_cusps(cusps);
  }
  return batch.take();
}

}  // namespace parallel_aspects
