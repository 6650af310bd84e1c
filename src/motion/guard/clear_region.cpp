// SPDX-License-Identifier: BSD-3-Clause
#include "motion/guard/clear_region.h"

#include "distance/leg_boundary.h"
#include "distance/mode_determinant.h"
#include "model/task_space_traits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

template <TaskSpace space>
class ClearRegionIn final : public ClearRegion {
 public:
  using Chart = LocalChart<space>;
  static constexpr std::size_t size = Chart::size, dimension = Chart::dimension;
  static constexpr std::size_t turns = Chart::turns, moves = Chart::moves;
  using Form = QuadraticForm<size, FormDomain::ball>;
  using Boundary = LegBoundary<dimension>;

  explicit ClearRegionIn(std::shared_ptr<const Manipulator> manipulator)
      : manipulator_(std::move(manipulator)),
        chart_(*manipulator_),
        boundaries_(made(*manipulator_)),
        determinant_(chart_, *manipulator_) {
    if constexpr (turns == 0) return;
    const Eigen::Matrix3d& factor = chart_.metric().half_turns;
    if constexpr (turns == 1) {
      half_turn_ = std::abs(factor(2, 2));
      arm_ = 1.0 / half_turn_;
    } else {  // Frobenius norms are at least the spectral ones
      half_turn_ = factor.norm();
      arm_ = factor.inverse().norm();
    }
  }

  bool usable() const noexcept override { return chart_.metric().usable; }

  void move_to(const Pose& pose, const WorkingMode& mode) noexcept override {
    mode_ = mode;
    chart_.move_to(pose);
    determinant_.set_mode(mode);
    sign_ = determinant_.proved_sign(std::array<Interval, size>{});
  }

  MetricSpeed speed_of(const TaskVector& twist) const noexcept override {
    MetricSpeed speed;
    const Coordinates<size> rate = chart_.rate_of(twist);
    speed.rate = Eigen::Map<const Eigen::Matrix<double, static_cast<int>(size), 1>>(rate.data());
    if constexpr (turns > 0) speed.turn = twist.head(static_cast<Eigen::Index>(turns)).norm();
    const double slide = twist.tail(static_cast<Eigen::Index>(moves)).norm();
    // The centroid goes round the operational point, at a distance that stays.
    const double centroid = std::max(slide + speed.turn * centroid_arm(),
                                     speed.rate.head(static_cast<Eigen::Index>(moves)).norm());
    const double turning = speed.rate.tail(static_cast<Eigen::Index>(turns)).norm();
    speed.path = std::sqrt(centroid * centroid + turning * turning);
    return speed;
  }

  double speed_at_most(double turn, double slide) const noexcept override {
    return slide + turn * (centroid_arm() + arm_);
  }

  ClearHalfSpaces find(Hazard hazard, double radius) const noexcept override {
    assert_rounding_upward();
    ClearHalfSpaces found;
    switch (hazard) {
      case Hazard::parallel_singularity:
        add_parallel(radius, found);
        break;
      case Hazard::serial_singularity:
        for (const Boundary& boundary : boundaries_.serial) add(boundary, radius, found);
        break;
      case Hazard::limit:
        for (const Boundary& boundary : boundaries_.limits) add(boundary, radius, found);
        break;
    }
    return found;
  }

  bool is_ahead_clear(Hazard hazard, const TaskVector& ahead, double radius) noexcept override {
    if constexpr (size > 3) return false;
    assert_rounding_upward();
    Coordinates<size> direction{};
    for (std::size_t i = 0; i < size; ++i) direction[i] = ahead[static_cast<Eigen::Index>(i)];
    determinant_.point_cells_to(direction);
    int boxes = most_boxes;
    switch (hazard) {
      case Hazard::parallel_singularity:
        return sign_ != 0 && is_clear(ahead_of(direction, radius), radius, boxes,
                                      [&](const Cell<size>& cell) { return has_sign(cell, radius); });
      case Hazard::serial_singularity:
        return is_clear_of(boundaries_.serial, ahead_of(direction, radius), radius, boxes);
      case Hazard::limit:
        break;
    }
    return is_clear_of(boundaries_.limits, ahead_of(direction, radius), radius, boxes);
  }

  // SE2: with half turns a, a', D = 2 arm |sin(a - a')| and |r - r'| = 2 arm |sin a - sin a'|, so their ratio
  // is at least cos((a - a') / 2) >= cos a for the larger one. Else, with v the vector parts of quaternions,
  // those between two poses are (w v' - w' v - v x v'), which is off v' - v by (1 - w + |v| + V^2 / W)
  // |v' - v| at most where |v|, |v'| <= V, W^2 = 1 - V^2.
  double distortion(double radius) const noexcept override {
    if constexpr (turns == 0) return 0.0;
    const double v = 0.5 * half_turn_ * radius;
    if (!(v < 0.5)) return 1.0;
    const double w = std::sqrt(1.0 - v * v);
    if constexpr (turns == 1) return v * v;
    return std::min(1.0, half_turn_ * arm_ * (v + v * v + v * v / w));
  }

  // The centroid turns about the operational point; the rate of v is (w omega + omega x v) / 2, less than
  // |omega| (|v| + |v|^2) / 2 from omega / 2. In SE2 sin is within its argument's cube over 6.
  double bend(double angle) const noexcept override {
    if constexpr (turns == 0) return 0.0;
    const double squared = angle * angle;
    const double centroid = centroid_arm() * squared;
    if constexpr (turns == 1) return centroid + arm_ * squared * angle / 24.0;
    return centroid + arm_ * squared * (0.5 + 0.25 * angle);
  }

 private:
  static constexpr int most_boxes = turns > 0 ? 24 : 10;

  // The half of a ball that is ahead, and a little more for rounding. Its first axis is the direction or the
  // opposite, by the reflection of the determinant's cells.
  static Cell<size> ahead_of(const Coordinates<size>& direction, double radius) noexcept {
    constexpr double rounding = 1e-9;
    Cell<size> cell;
    cell.half_width.fill(radius * (1.0 + rounding));
    cell.half_width[0] = radius * (0.5 + rounding);
    cell.center[0] = direction[0] > 0.0 ? -0.5 * radius : 0.5 * radius;
    return cell;
  }

  // Halves the cell until each part in the ball is clear, or the boxes are used up.
  template <class IsClear>
  bool is_clear(const Cell<size>& cell, double radius, int& boxes, const IsClear& clear) const noexcept {
    if (cell.least_length() > radius * (1.0 + 1e-9)) return true;
    if (--boxes < 0) return false;
    if (clear(cell)) return true;
    for (const Cell<size>& half : cell.halves(cell.widest()))
      if (!is_clear(half, radius, boxes, clear)) return false;
    return true;
  }

  bool has_sign(const Cell<size>& cell, double radius) const noexcept {
    typename ModeDeterminant<space>::OverCell over;
    const double within = radius * (1.0 + 1e-9);
    if (!determinant_.over(cell, within, over)) return true;  // no leg reaches there
    const Interval range = range_in_ball(over.determinant, cell, within);
    return sign_ > 0 ? range.positive() : range.negative();
  }

  bool is_clear_of(const std::vector<Boundary>& boundaries, const Cell<size>& ahead, double radius,
                   int& boxes) const noexcept {
    return std::all_of(boundaries.begin(), boundaries.end(), [&](const Boundary& boundary) {
      if (is_elsewhere(boundary, radius)) return true;
      return is_clear(ahead, radius, boxes, [&](const Cell<size>& cell) {
        using Over = QuadraticForm<size>;
        const std::array<Over, size> y = determinant_.reflected(cell.template forms<Over>());
        const Interval range = range_in_ball(distance_at(boundary, y).linear(), cell, radius * (1.0 + 1e-9));
        return range.positive() || range.negative();
      });
    });
  }

  template <class Scalar>
  Scalar distance_at(const Boundary& boundary, const std::array<Scalar, size>& y) const noexcept {
    typename Chart::template Vector<Scalar> arm;
    if constexpr (turns > 0) arm = chart_.arm(boundary.leg, chart_.rotation(y.data() + moves));
    return boundary.signed_distance(chart_.displacement(boundary.leg, arm, y));
  }

  // Whether no pose of the boundary is in the ball, by how far an anchor can move.
  bool is_elsewhere(const Boundary& boundary, double radius) const noexcept {
    if (boundary.branch != 0 && boundary.branch != mode_.sign(boundary.leg)) return true;
    const auto& here = chart_.displacement_at_origin(boundary.leg);
    const double turning = turns > 0 ? chart_.turning(boundary.leg) : 0.0;
    const double travel = std::sqrt((moves > 0 ? 1.0 : 0.0) + turning * turning) * radius;
    const Interval distance = boundary.signed_distance(here);
    if (distance.lower() > travel || -distance.upper() > travel) return true;
    if (!boundary.sided) return false;
    const Interval side = Interval(static_cast<double>(mode_.sign(boundary.leg))) * boundary.side(here);
    return side.upper() + travel < 0.0;
  }

  double centroid_arm() const noexcept { return moves > 0 ? chart_.center_at_pose().norm() : 0.0; }

  static LegBoundaries<dimension> made(const Manipulator& manipulator) {
    const RoundingUpward rounding;
    return leg_boundaries<dimension>(manipulator);
  }

  static std::array<Form, size> ball(double radius) noexcept {
    std::array<Form, size> y;
    for (std::size_t i = 0; i < size; ++i) y[i] = Form::coordinate(0.0, radius, i);
    return y;
  }

  void add_parallel(double radius, ClearHalfSpaces& found) const noexcept {
    const Form value = determinant_.in_ball(radius);
    add(sign_ < 0 ? -value : value, radius, {}, found);
    if (sign_ == 0) found.list[found.count - 1].clearance = -unbounded;
  }

  void add(const Boundary& boundary, double radius, ClearHalfSpaces& found) const noexcept {
    if (is_elsewhere(boundary, radius)) return;
    const Interval here = boundary.signed_distance(chart_.displacement_at_origin(boundary.leg));
    const Form value = distance_at(boundary, ball(radius));
    add(here.upper() < 0.0 ? -value : value, radius, {{}, 0.0, boundary.leg, boundary.end}, found);
    if (!here.positive() && !here.negative()) found.list[found.count - 1].clearance = -unbounded;
  }

  // Where the value, which encloses a function that vanishes at the hazard, is positive.
  static void add(const Form& value, double radius, ClearHalfSpace half_space,
                  ClearHalfSpaces& found) noexcept {
    if (found.count == ClearHalfSpaces::most) {  // what is not examined is not clear
      found.list[found.count - 1].clearance = -unbounded;
      return;
    }
    Cell<size> cell;
    cell.half_width.fill(radius);
    const LinearModel<size> model(value.linear(), cell);
    const double least = -(model.error - model.below_at_origin), length = model.gradient_length;
    half_space.normal = TaskVector::Zero(static_cast<Eigen::Index>(size));
    half_space.clearance = least > 0.0 ? unbounded : -unbounded;
    if (length > 0.0) {
      half_space.clearance = least / length;
      for (std::size_t i = 0; i < size; ++i)
        half_space.normal[static_cast<Eigen::Index>(i)] = model.gradient[i] / length;
    }
    found.list[found.count++] = half_space;
  }

  std::shared_ptr<const Manipulator> manipulator_;
  Chart chart_;
  LegBoundaries<dimension> boundaries_;
  ModeDeterminant<space> determinant_;
  WorkingMode mode_;
  int sign_ = 0;
  double half_turn_ = 0.0;  // |v| is at most half of this times |y| [1/m]
  double arm_ = 0.0;        // |y| changes by this for each radian at most [m]
};

/// Where poses have no coordinates in which distances are lengths, nothing is proved clear.
class NoClearRegion final : public ClearRegion {
 public:
  bool usable() const noexcept override { return false; }
  void move_to(const Pose&, const WorkingMode&) noexcept override {}
  MetricSpeed speed_of(const TaskVector&) const noexcept override { return {}; }
  double speed_at_most(double, double) const noexcept override { return unbounded; }
  ClearHalfSpaces find(Hazard, double) const noexcept override { return {}; }
  bool is_ahead_clear(Hazard, const TaskVector&, double) noexcept override { return false; }
  double distortion(double) const noexcept override { return 1.0; }
  double bend(double) const noexcept override { return unbounded; }
};

}  // namespace

std::unique_ptr<ClearRegion> make_clear_region(std::shared_ptr<const Manipulator> manipulator) {
  const TaskSpace task_space = manipulator->task_space();
  return with_task_space(task_space, [&](auto constant) -> std::unique_ptr<ClearRegion> {
    constexpr TaskSpace space = decltype(constant)::value;
    if constexpr (is_of_hinges(space))
      return std::make_unique<NoClearRegion>();
    else
      return std::make_unique<ClearRegionIn<space>>(std::move(manipulator));
  });
}

}  // namespace parallel_aspects
