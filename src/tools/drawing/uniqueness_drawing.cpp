// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/uniqueness_drawing.h"

#include "draw/page/page.h"
#include "draw/plane/map_pictures.h"
#include "draw/plane/singular_curves.h"
#include "model/angles.h"
#include "model/message_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "tools/report/reports.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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

// A cell is examined in its middle, and where nothing is proved there in so many points a side.
constexpr int points_of_cell = 3;

constexpr Rgb no_color = 0xFFFFFF;

/// That of which the components are the largest together; the first where there are none.
WorkingMode largest_mode(const AspectMap& map) {
  WorkingMode largest = working_modes(*map.manipulator()).front();
  double most = -1.0;
  for (const WorkingMode& mode : map.working_modes()) {
    double measure = 0.0;
    for (const Aspect& aspect : map.aspects())
      if (aspect.mode == mode) measure += aspect.measure;
    if (measure > most) largest = mode;
    most = std::max(most, measure);
  }
  return largest;
}

class UniquenessDrawing {
 public:
  UniquenessDrawing(const Uniqueness& uniqueness, const std::optional<WorkingMode>& mode)
      : uniqueness_(uniqueness),
        robot_(*uniqueness.map->manipulator()),
        held_(*uniqueness.map->slice()->joint),
        mode_(mode ? *mode : largest_mode(*uniqueness.map)),
        plane_(plane_of(*uniqueness.map)),
        projection_(uniqueness.map),
        curves_(*uniqueness.map, projection_) {
    for (const WorkingMode& each : uniqueness.map->working_modes()) trace(each);
    curves_.follow_free_cranks();
    add_curves();
  }

  PagePicture draw() const {
    Page page;
    page.side = side_of_planes;
    page.title =
        robot_.name() + ", " + to_string(*uniqueness_.map->slice()) + ": where direct solutions meet";
    page.notes = {
        "Colours: the number of direct solutions of the actuated values, each proved at the middle of a cell "
        "of a grid of " +
            std::to_string(cells_of_numbers) + " x " + std::to_string(cells_of_numbers) +
            ", or else at most of its points where one is proved. On the left, edges between colours that "
            "are "
            "not singular are characteristic curves.",
        "Dots: cusps" + words_for(uniqueness_.cusps_complete) +
            (uniqueness_.has_nodes
                 ? " Circles: nodes, with the two poses of each" + words_for(uniqueness_.nodes_complete)
                 : "") +
            " Curves are drawn for the eye."};
    page.figures = {{"", {}, {{poses()}, {actuated_values()}}}};
    page.legend = legend();
    return draw_page(page);
  }

 private:
  static std::string words_for(bool complete) {
    return complete ? ", proved to be all." : ", perhaps not all.";
  }

  PlaneScene poses() const {
    PlaneScene panel;
    panel.caption = has_modes() ? "poses in working mode " + to_string(mode_) : "poses";
    panel.axes = plane_.axes;
    panel.areas = numbers(plane_.bounds, [this](const Vector2d& at) { return actuated_of(at); });
    panel.boundaries = of_poses_;
    const AnchorCircle circle = circle_of_anchor(robot_, *uniqueness_.map->slice()->joint);
    const auto place = [&](const Pose& pose) {
      const Vector2d rod = circle.rod(pose);
      const auto& turn = pose.orientation;
      return Vector2d(std::atan2(rod.y(), rod.x()),
                      std::remainder(2.0 * std::atan2(turn.z(), turn.w()), 2.0 * pi));
    };
    for (std::size_t i = 0; i < uniqueness_.cusps.size(); ++i)
      if (uniqueness_.cusps[i].mode == mode_)
        panel.marks.push_back({place(uniqueness_.cusps[i].pose), std::to_string(i + 1)});
    for (std::size_t i = 0; i < uniqueness_.nodes.size(); ++i)
      for (const Pose& pose : uniqueness_.nodes[i].poses) panel.marks.push_back(node_mark(place(pose), i));
    return panel;
  }

  PlaneScene actuated_values() const {
    PlaneScene panel;
    panel.caption = "actuated values";
    const JointWindow& window = projection_.window();
    panel.axes = joint_axes(robot_, projection_, 0.0);
    for (PlaneAxis& axis : panel.axes) axis.is_turn = false;
    panel.areas =
        numbers({window.lower, window.upper}, [this](const Vector2d& at) { return actuated_at(at); });
    panel.boundaries = of_values_;
    const auto place = [this](const JointVector& q) { return Vector2d(q[joint(0)], q[joint(1)]); };
    for (std::size_t i = 0; i < uniqueness_.cusps.size(); ++i)
      panel.marks.push_back(
          {projection_.window().wrapped(place(uniqueness_.cusps[i].actuated)), std::to_string(i + 1)});
    for (std::size_t i = 0; i < uniqueness_.nodes.size(); ++i)
      panel.marks.push_back(node_mark(place(uniqueness_.nodes[i].actuated), i));
    return panel;
  }

  bool has_modes() const { return uniqueness_.map->working_modes().size() > 1; }

  /// Traced singular curves are where others begin, which are followed; limits and constraints are drawn.
  void trace(const WorkingMode& mode) {
    std::vector<BoundarySegment> others;
    for (const BoundarySegment& segment :
         trace_slice(*uniqueness_.map, mode, plane_.slice, plane_.bounds, cells_of_curves).segments)
      if (segment.kind == BoundaryKind::parallel || segment.kind == BoundaryKind::serial)
        curves_.follow(segment, mode);
      else
        others.push_back(segment);
    const auto images = projection_.images(others, mode);
    of_values_.insert(of_values_.end(), images.begin(), images.end());
    if (mode == mode_) of_poses_ = std::move(others);
  }

  /// Those of all working modes in the plane of values, and of one in that of poses.
  void add_curves() {
    const JointWindow turns{Vector2d::Constant(-pi), Vector2d::Constant(pi), {true, true}};
    const auto add = [](const SingularPiece& piece, const auto& parts, std::vector<BoundarySegment>& to) {
      for (const auto& [from, end] : parts) to.push_back({piece.kind, piece.leg, from, end, {}});
    };
    for (const SingularPiece& piece : curves_.pieces()) {
      add(piece, projection_.window().pieces(piece.actuated[0], piece.actuated[1]), of_values_);
      if (piece.is_of(mode_)) add(piece, turns.pieces(piece.poses[0], piece.poses[1]), of_poses_);
    }
  }

  /// Those of a pose in the mode that is drawn; nothing where there are none. The pose decides the sign of
  /// B_jj of the joint that is held.
  JointVector actuated_of(const Vector2d& at) const {
    const Pose pose = plane_.slice.pose(at);
    InverseSolution found = inverse(robot_, pose, mode_);
    if (!found) return {};
    const auto held = static_cast<Eigen::Index>(held_.leg);
    found.q[held] = held_.value;
    return mode_.sign(held_.leg) * inverse_diagonal(robot_, pose, found.q)[held] > 0.0 ? found.q
                                                                                       : JointVector();
  }

  Eigen::Index joint(std::size_t axis) const { return static_cast<Eigen::Index>(projection_.legs()[axis]); }

  JointVector actuated_at(const Vector2d& at) const {
    JointVector q(static_cast<Eigen::Index>(robot_.leg_count()));
    q.setConstant(held_.value);
    for (std::size_t i = 0; i < 2; ++i) q[joint(i)] = at[static_cast<Eigen::Index>(i)];
    return q;
  }

  /// A shape for each number of solutions, of the cells of a grid.
  std::vector<PlaneArea> numbers(const Eigen::AlignedBox2d& bounds,
                                 const std::function<JointVector(const Vector2d&)>& actuated) const {
    std::map<std::size_t, PlaneArea> shapes;
    const Vector2d step = bounds.sizes() / cells_of_numbers;
    for (int row = 0; row < cells_of_numbers; ++row)
      for (int column = 0; column < cells_of_numbers; ++column) {
        const auto corner = [&](int x, int y) {
          return Vector2d(bounds.min() + step.cwiseProduct(Vector2d(column + x, row + y)));
        };
        const std::size_t solutions = number_in({corner(0, 0), corner(1, 1)}, actuated);
        if (solutions > 0)
          shapes[solutions].polygons.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
      }
    std::vector<PlaneArea> result;
    for (auto& [solutions, shape] : shapes) {
      shape.color = solutions_color(solutions);
      shape.title = counted(solutions, "solution");
      result.push_back(std::move(shape));
    }
    return result;
  }

  /// At the middle of a cell, or else at most points of it where one is proved; 0 for none. So a strip that
  /// is thinner than a cell is not seen here and there.
  std::size_t number_in(const Eigen::AlignedBox2d& cell,
                        const std::function<JointVector(const Vector2d&)>& actuated) const {
    const auto number_at = [&](const Vector2d& at) {
      const auto component = uniqueness_.component_at(actuated(at));
      return component ? uniqueness_.basic_components[*component].solutions.size() : 0;
    };
    if (const std::size_t middle = number_at(cell.center()); middle > 0) return middle;
    std::map<std::size_t, int> counts;
    for (int i = 0; i < points_of_cell * points_of_cell; ++i) {
      const Vector2d share =
          (Vector2d(i % points_of_cell, i / points_of_cell).array() + 0.5) / points_of_cell;
      if (const std::size_t number = number_at(cell.min() + share.cwiseProduct(cell.sizes())); number > 0)
        ++counts[number];
    }
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? 0 : most->first;
  }

  /// With a letter, as long as there are any.
  static PlaneMark node_mark(const Vector2d& at, std::size_t node) {
    return {at, node < 26 ? std::string(1, static_cast<char>('a' + node)) : "", true};
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries;
    for (const SolutionRegion& region : uniqueness_.regions)
      entries.push_back({solutions_color(region.solutions), false,
                         counted(region.solutions, "solution") + ", " + number_text(region.measure, 4) + " " +
                             uniqueness_.region_unit});
    entries.push_back({no_color, false, "no number is proved, no solution, or out of reach", true});
    for (LegendEntry& entry : boundary_legend(kinds_of(of_values_))) entries.push_back(std::move(entry));
    return entries;
  }

  const Uniqueness& uniqueness_;
  const Manipulator& robot_;
  const HeldJoint held_;
  WorkingMode mode_;
  PosePlane plane_;
  JointProjection projection_;
  SingularCurves curves_;
  std::vector<BoundarySegment> of_poses_, of_values_;
};

constexpr Rgb count_color = 0xCC3311;

/// That of its curves and its legend.
Rgb curve_color(std::size_t i) { return aspect_color(i % 2 == 0 ? 1 : -1, i / 2); }

class CurvesDrawing {
 public:
  CurvesDrawing(const Manipulator& robot, const CuspCurves& found)
      : robot_(robot), found_(found), held_(found.range.leg) {
    others_ = {held_ == 0 ? std::size_t{1} : std::size_t{0}, held_ == 2 ? std::size_t{1} : std::size_t{2}};
  }

  PagePicture draw() const {
    Page page;
    page.side = side_of_planes;
    page.title = robot_.name() + ", " + title(held_) + " from " + number_text(found_.range.lower) + " to " +
                 number_text(found_.range.upper) + ": curves of cusps";
    page.notes = {std::string("Each curve and each number is proved. ") +
                  (found_.complete ? "There are no other curves." : "There may be other curves.") +
                  " Dots: where the value that is held turns back, and two cusps meet."};
    page.figures = {{"", {}, {{plane(others_[0], others_[1])}, {plane(held_, others_[0])}, {counts()}}}};
    for (std::size_t i = 0; i < found_.curves.size(); ++i)
      page.legend.push_back({curve_color(i), true, "curve " + std::to_string(i + 1)});
    return draw_page(page);
  }

 private:
  std::string title(std::size_t leg) const {
    return robot_.leg(leg).actuated_joint + " [" + joint_unit(robot_.leg(leg)) + "]";
  }

  /// From the least to the largest value of a joint on all curves.
  PlaneAxis axis(std::size_t leg) const {
    PlaneAxis result{title(leg), HUGE_VAL, -HUGE_VAL, false};
    for (const CuspCurve& curve : found_.curves)
      for (const Cusp& cusp : curve.points) {
        const double value = cusp.actuated[static_cast<Eigen::Index>(leg)];
        result.lower = std::min(result.lower, value);
        result.upper = std::max(result.upper, value);
      }
    if (!(result.lower < result.upper)) return {title(leg), 0.0, 1.0, false};
    const double more = 0.03 * (result.upper - result.lower);
    result.lower -= more;
    result.upper += more;
    return result;
  }

  PlaneScene plane(std::size_t x, std::size_t y) const {
    PlaneScene panel;
    panel.caption = "cusps, by actuated values";
    panel.axes = {axis(x), axis(y)};
    const auto place = [&](const Cusp& cusp) {
      return Vector2d(cusp.actuated[static_cast<Eigen::Index>(x)],
                      cusp.actuated[static_cast<Eigen::Index>(y)]);
    };
    for (std::size_t i = 0; i < found_.curves.size(); ++i) {
      add_curve(found_.curves[i], place, curve_color(i), "curve " + std::to_string(i + 1), panel);
      for (const std::size_t turn : turns(found_.curves[i]))
        panel.marks.push_back({place(found_.curves[i].points[turn]), ""});
    }
    return panel;
  }

  /// In pieces where the values of a crank go from one end of the turn to the other.
  template <class Place>
  static void add_curve(const CuspCurve& curve, const Place& place, Rgb color, const std::string& words,
                        PlaneScene& panel) {
    PlaneLine line{{}, color, words};
    for (std::size_t n = 0; n < curve.points.size(); ++n) {
      const bool jumps =
          n > 0 && (curve.points[n].actuated - curve.points[n - 1].actuated).cwiseAbs().maxCoeff() > pi;
      if (jumps && !line.points.empty()) panel.lines.push_back(std::exchange(line, {{}, color, words}));
      line.points.push_back(place(curve.points[n]));
    }
    if (curve.closed && !curve.points.empty()) line.points.push_back(place(curve.points.front()));
    panel.lines.push_back(std::move(line));
  }

  /// Points where the value that is held is larger, or smaller, than beside them.
  std::vector<std::size_t> turns(const CuspCurve& curve) const {
    std::vector<std::size_t> result;
    const auto held = [&](std::size_t n) {
      return curve.points[n % curve.points.size()].actuated[static_cast<Eigen::Index>(held_)];
    };
    const std::size_t count = curve.points.size();
    for (std::size_t n = 0; n < count; ++n) {
      if (!curve.closed && (n == 0 || n + 1 == count)) continue;
      if ((held(n) - held(n + count - 1)) * (held(n + 1) - held(n)) < 0.0) result.push_back(n);
    }
    return result;
  }

  PlaneScene counts() const {
    PlaneScene panel;
    panel.caption = "number of cusps";
    std::size_t most = 1;
    for (const CuspCount& each : found_.counts) most = std::max(most, each.cusps);
    panel.axes = {PlaneAxis{title(held_), found_.range.lower, found_.range.upper, false},
                  PlaneAxis{"cusps", 0.0, static_cast<double>(most + 1), false}};
    for (const CuspCount& each : found_.counts) {
      const auto height = static_cast<double>(each.cusps);
      panel.lines.push_back(
          {{{each.lower, height}, {each.upper, height}}, count_color, counted(each.cusps, "cusp")});
    }
    return panel;
  }

  const Manipulator& robot_;
  const CuspCurves& found_;
  std::size_t held_;
  std::array<std::size_t, 2> others_{};
};

}  // namespace

PagePicture draw_uniqueness(const Uniqueness& uniqueness, const std::optional<WorkingMode>& mode) {
  return UniquenessDrawing(uniqueness, mode).draw();
}

PagePicture draw_cusp_curves(const Manipulator& robot, const CuspCurves& found) {
  return CurvesDrawing(robot, found).draw();
}

}  // namespace parallel_aspects::tools
