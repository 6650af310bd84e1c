// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/uniqueness_drawing.h"

#include "model/angles.h"
#include "model/number_text.h"
#include "parallel_aspects/aspects/boundary_curves.h"
#include "parallel_aspects/aspects/joint_projection.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "tools/drawing/page.h"
#include "tools/drawing/plot_plane.h"
#include "tools/report/reports.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using Eigen::Vector2d;

constexpr double side_of_planes = 430.0;  // [px]

// Of the grid of numbers, about a point of the panel each, and of that of the curves.
constexpr int cells_of_numbers = 360, cells_of_curves = 240;

class UniquenessDrawing {
 public:
  explicit UniquenessDrawing(const Uniqueness& uniqueness)
      : uniqueness_(uniqueness),
        robot_(*uniqueness.map->manipulator()),
        mode_(uniqueness.map->working_modes().front()),
        plane_(plane_of(*uniqueness.map, std::optional<PlotSection>())),
        projection_(uniqueness.map),
        segments_(
            trace_slice(*uniqueness.map, mode_, plane_.slice, plane_.bounds, cells_of_curves).segments) {}

  Picture draw() const {
    Page page;
    page.side = side_of_planes;
    page.title =
        robot_.name() + ", " + to_string(*uniqueness_.map->slice()) + ": where direct solutions meet";
    page.notes = {
        "Colours: the number of direct solutions of the actuated values, each proved at the middle of a cell "
        "of "
        "a grid of " +
            std::to_string(cells_of_numbers) + " x " + std::to_string(cells_of_numbers) +
            ". On the left, edges between colours that are not singular are characteristic curves.",
        "Dots: cusps" +
            std::string(uniqueness_.cusps_complete ? ", proved to be all." : ", perhaps not all.") +
            " Curves are drawn for the eye."};
    page.figures = {{"", {}, {poses(), actuated_values()}}};
    page.legend = legend();
    return draw_page(page);
  }

 private:
  PanelContents poses() const {
    PanelContents panel;
    panel.caption = "poses";
    panel.axes = plane_.axes;
    panel.shapes = numbers(plane_.bounds, [this](const Vector2d& at) {
      return inverse(robot_, plane_.slice.pose(at), mode_).q;
    });
    panel.segments = segments_;
    const AnchorCircle circle = circle_of_anchor(robot_, *uniqueness_.map->slice()->joint);
    mark_cusps(panel, [&](const Cusp& cusp) {
      const Vector2d rod = circle.rod(cusp.pose);
      const auto& turn = cusp.pose.orientation;
      return Vector2d(std::atan2(rod.y(), rod.x()),
                      std::remainder(2.0 * std::atan2(turn.z(), turn.w()), 2.0 * pi));
    });
    return panel;
  }

  PanelContents actuated_values() const {
    PanelContents panel;
    panel.caption = "actuated values";
    const JointWindow& window = projection_.window();
    for (std::size_t i = 0; i < 2; ++i) {
      const Leg& leg = robot_.leg(projection_.legs()[i]);
      const auto k = static_cast<Eigen::Index>(i);
      panel.axes[i] = {leg.actuated_joint + " [" + joint_unit(leg) + "]", window.lower[k], window.upper[k],
                       false};
    }
    panel.shapes =
        numbers({window.lower, window.upper}, [this](const Vector2d& at) { return actuated_at(at); });
    panel.segments = projection_.images(segments_, mode_);
    mark_cusps(panel, [this](const Cusp& cusp) {
      return Vector2d(cusp.actuated[joint(0)], cusp.actuated[joint(1)]);
    });
    return panel;
  }

  Eigen::Index joint(std::size_t axis) const { return static_cast<Eigen::Index>(projection_.legs()[axis]); }

  JointVector actuated_at(const Vector2d& at) const {
    JointVector q(static_cast<Eigen::Index>(robot_.leg_count()));
    q.setConstant(uniqueness_.map->slice()->joint->value);
    for (std::size_t i = 0; i < 2; ++i) q[joint(i)] = at[static_cast<Eigen::Index>(i)];
    return q;
  }

  /// A shape for each number of solutions, of the cells of a grid.
  std::vector<PanelShape> numbers(const Eigen::AlignedBox2d& bounds,
                                  const std::function<JointVector(const Vector2d&)>& actuated) const {
    std::map<std::size_t, PanelShape> shapes;
    const Vector2d step = bounds.sizes() / cells_of_numbers;
    for (int row = 0; row < cells_of_numbers; ++row)
      for (int column = 0; column < cells_of_numbers; ++column) {
        const auto corner = [&](int x, int y) {
          return Vector2d(bounds.min() + step.cwiseProduct(Vector2d(column + x, row + y)));
        };
        const auto component = uniqueness_.component_of(actuated(0.5 * (corner(0, 0) + corner(1, 1))));
        if (!component) continue;
        const std::size_t solutions = uniqueness_.basic_components[*component].solutions.size();
        shapes[solutions].polygons.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
      }
    std::vector<PanelShape> result;
    for (auto& [solutions, shape] : shapes) {
      shape.color = solutions_color(solutions);
      shape.title = counted(solutions, "solution");
      result.push_back(std::move(shape));
    }
    return result;
  }

  void mark_cusps(PanelContents& panel, const std::function<Vector2d(const Cusp&)>& place) const {
    for (std::size_t i = 0; i < uniqueness_.cusps.size(); ++i)
      panel.marks.push_back({place(uniqueness_.cusps[i]), std::to_string(i + 1)});
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries;
    for (const SolutionRegion& region : uniqueness_.regions)
      entries.push_back(
          {solutions_color(region.solutions), false,
           counted(region.solutions, "solution") + ", " + number_text(region.measure, 4) + " m^2"});
    std::set<BoundaryKind> kinds;
    for (const BoundarySegment& segment : segments_) kinds.insert(segment.kind);
    for (const auto& [kind, words] : boundary_words())
      if (kinds.count(kind) > 0) entries.push_back({boundary_color(kind), true, words});
    return entries;
  }

  const Uniqueness& uniqueness_;
  const Manipulator& robot_;
  WorkingMode mode_;
  PlotPlane plane_;
  JointProjection projection_;
  std::vector<BoundarySegment> segments_;
};

}  // namespace

Picture draw_uniqueness(const Uniqueness& uniqueness) { return UniquenessDrawing(uniqueness).draw(); }

}  // namespace parallel_aspects::tools
