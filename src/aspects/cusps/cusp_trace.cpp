// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_trace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

// Steps along a curve, by coordinates times their weights [half turns].
constexpr double first_step = 0.01, longest_step = 0.03, shortest_step = 0x1p-26;
constexpr double growth = 1.5;

// A tube begins before its first point, and ends behind its last, by this share of the step.
constexpr double overhang = 0.02;

constexpr std::size_t most_tubes = 100000;

double dot(const MapPoint& a, const MapPoint& b, const MapPoint& weights) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) sum += weights[i] * a[i] * weights[i] * b[i];
  return sum;
}

/// One tube, and the point it ends at.
struct TraceStep {
  CuspTube tube;
  Box point;
  MapPoint direction{};
  bool is_end = false;  ///< of another trace
};

/// From a point along one of both directions of its curve.
class Walk {
 public:
  /// `behind`, if any, is a point of the curve to go away from.
  Walk(SliceFamily& family, const Box& start, const Box* behind, const TraceBounds& bounds,
       const std::vector<Box>& ends, const MapControl& control)
      : family_(family), bounds_(bounds), ends_(ends), control_(control) {
    trace_.points.push_back(start);
    if (behind != nullptr) behind_ = *behind;
  }

  CuspTrace go(double sense) {
    direction_ = tangent_at(family_, trace_.points.front().middle());
    if (direction_)
      for (double& each : *direction_) each *= sense;
    TraceEnd& end = trace_.ends[1];
    while (!trace_.closed) {
      if (has_left()) return std::move(trace_);
      if (trace_.tubes.size() >= most_tubes || is_cancelled(control_) || !advance()) {
        end = TraceEnd::failed;
        return std::move(trace_);
      }
    }
    return std::move(trace_);
  }

 private:
  bool has_left() {
    if (is_at_end_) return true;
    if (trace_.tubes.empty()) return false;
    const CuspTube& tube = trace_.tubes.back();
    const Box hull = hull_of(tube, intersection(tube.cross, tube.enclosed));
    return hull.upper[2] < bounds_.lower || hull.lower[2] > bounds_.upper ||
           family_.within_limits(hull) == Verdict::fails;
  }

  bool advance() {
    if (!direction_) return false;
    for (; step_ >= shortest_step; step_ *= 0.5)
      if (auto next = step_of(step_)) {
        take(std::move(*next));
        step_ = std::min(longest_step, growth * step_);
        return true;
      }
    return false;
  }

  void take(TraceStep next) {
    direction_ = next.direction;
    behind_ = trace_.points.back();
    is_at_end_ = next.is_end;
    trace_.tubes.push_back(std::move(next.tube));
    if (is_closed_by(trace_.tubes.back(), next.point))
      trace_.closed = true;
    else
      trace_.points.push_back(next.point);
  }

  /// Whether the tube, from its first point on, comes to the start.
  bool is_closed_by(const CuspTube& tube, const Box& end) const {
    const Box& start = trace_.points.front();
    if (trace_.tubes.size() < 3 || !contains(tube, start)) return false;
    const Interval from = along(tube, trace_.points.back()), to = along(tube, end), at = along(tube, start);
    return from.lower() < to.lower() ? from.upper() < at.lower() : at.upper() < from.lower();
  }

  /// A tube of that length from the last point on.
  std::optional<TraceStep> step_of(double length) {
    const Box& from = trace_.points.back();
    const MapPoint at = from.middle();
    const std::size_t axis = steepest_axis(*direction_, bounds_.weights);
    const double norm = std::sqrt(dot(*direction_, *direction_, bounds_.weights));
    if (!(norm > 0.0) || !std::isfinite(norm)) return std::nullopt;
    MapPoint middle = at;
    for (std::size_t i = 0; i < 3; ++i) middle[i] += 0.5 * length * (*direction_)[i] / norm;
    const double forward = middle[axis] - at[axis];
    const auto near = near_cusp(family_, axis, middle);
    if (!near) return std::nullopt;
    const auto tube = tube_about(family_, axis, *near, (1.0 + 2.0 * overhang) * std::abs(forward));
    if (!tube || !contains(*tube, from)) return std::nullopt;
    if (behind_ && may_meet(*tube, *behind_)) return std::nullopt;
    for (const Box& end : ends_)
      if (may_meet(*tube, end)) return ended_at(*tube, end, forward);
    return ended(*tube, forward);
  }

  /// Nothing where the end may be behind.
  std::optional<TraceStep> ended_at(const CuspTube& tube, const Box& end, double forward) const {
    const Interval from = along(tube, trace_.points.back()), at = along(tube, end);
    const bool is_ahead = forward > 0.0 ? from.upper() < at.lower() : at.upper() < from.lower();
    if (!is_ahead || !contains(tube, end)) return std::nullopt;
    return TraceStep{tube, end, {}, true};
  }

  std::optional<TraceStep> ended(const CuspTube& tube, double forward) {
    MapPoint end{};
    end[tube.axis] = tube.middle + forward;
    for (std::size_t i = 0; i < 2; ++i) end[tube.others[i]] = tube.cross.center(i) + tube.slope[i] * forward;
    const auto point = cusp_near(family_, tube.axis, end);
    if (!point || !contains(tube, *point)) return std::nullopt;
    auto tangent = tangent_at(family_, point->middle());
    if (!tangent) return std::nullopt;
    if (((*tangent)[tube.axis] > 0.0) != (forward > 0.0))
      for (double& each : *tangent) each = -each;
    return TraceStep{tube, without_turns(*point), *tangent};
  }

  SliceFamily& family_;
  TraceBounds bounds_;
  const std::vector<Box>& ends_;
  const MapControl& control_;
  CuspTrace trace_;
  bool is_at_end_ = false;
  std::optional<MapPoint> direction_;
  std::optional<Box> behind_;
  double step_ = first_step;
};

/// Both walks as one: the one against the direction, turned round, goes first.
CuspTrace joined(CuspTrace back, const CuspTrace& forth) {
  std::reverse(back.points.begin(), back.points.end());
  std::reverse(back.tubes.begin(), back.tubes.end());
  back.points.insert(back.points.end(), forth.points.begin() + 1, forth.points.end());
  back.tubes.insert(back.tubes.end(), forth.tubes.begin(), forth.tubes.end());
  back.ends = {back.ends[1], forth.ends[1]};
  return back;
}

}  // namespace

CuspTube core_of(const CuspTrace& trace, std::size_t i) noexcept {
  CuspTube core = trace.tubes[i];
  const Interval from = along(core, trace.points[i]) - Interval(core.middle);
  const Interval to = along(core, trace.points[(i + 1) % trace.points.size()]) - Interval(core.middle);
  core.half = std::max(
      from.lower() < to.lower() ? std::min(-from.upper(), to.lower()) : std::min(-to.upper(), from.lower()),
      -1.0);
  return core;
}

CuspTrace trace_cusps(SliceFamily& family, const Box& start, const TraceBounds& bounds,
                      const std::vector<Box>& ends, const MapControl& control) {
  CuspTrace forth = Walk(family, start, nullptr, bounds, ends, control).go(1.0);
  if (forth.closed) return forth;
  const Box* const behind = forth.points.size() > 1 ? &forth.points[1] : nullptr;
  return joined(Walk(family, start, behind, bounds, ends, control).go(-1.0), forth);
}

namespace {

// In a turn. Steps along a curve are not longer than about a cell; near folds they are much shorter.
constexpr int cells = 64;

int wrapped(int cell) noexcept { return ((cell % cells) + cells) % cells; }

}  // namespace

TubeIndex::TubeIndex(const TraceBounds& bounds)
    : first_(bounds.lower), per_unit_{0.5 * cells, 0.5 * cells, 0.5 * cells * bounds.weights[2]} {}

int TubeIndex::cell_of(double value, std::size_t axis) const noexcept {
  const double from = axis == 2 ? value - first_ : value;
  return static_cast<int>(std::clamp(std::floor(from * per_unit_[axis]), -1e6, 1e6));
}

void TubeIndex::add(const CuspTube& tube) {
  const Box hull = hull_of(tube, tube.cross);
  Cell lower{}, upper{};
  for (std::size_t i = 0; i < 3; ++i) {
    lower[i] = cell_of(hull.lower[i], i);
    upper[i] = cell_of(hull.upper[i], i);
    if (i < 2) upper[i] = std::min(upper[i], lower[i] + cells - 1);
  }
  for (int a = lower[0]; a <= upper[0]; ++a)
    for (int b = lower[1]; b <= upper[1]; ++b)
      for (int c = lower[2]; c <= upper[2]; ++c)
        by_cell_[{wrapped(a), wrapped(b), c}].push_back(tubes_.size());
  tubes_.push_back(tube);
}

bool TubeIndex::holds(const Box& box) const {
  const auto found = by_cell_.find(
      {wrapped(cell_of(box.center(0), 0)), wrapped(cell_of(box.center(1), 1)), cell_of(box.center(2), 2)});
  return found != by_cell_.end() &&
         std::any_of(found->second.begin(), found->second.end(),
                     [&](std::size_t tube) { return contains(tubes_[tube], box); });
}

}  // namespace parallel_aspects
