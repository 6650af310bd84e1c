// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_search.h"
#include "aspects/cusps/cusp_tube.h"
#include "aspects/uniqueness/curve_runs.h"
#include "interval/half_turns.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace parallel_aspects {
namespace {

// Evaluations of the cusp functions in all postures, so that an answer comes within minutes.
constexpr std::size_t most_evaluations_for_curves = 12000000;

HeldJoint middle_of(const Manipulator& manipulator, const HeldRange& range) {
  return {range.leg, 0.5 * (range.lower + range.upper), manipulator.leg(range.leg).actuated_by_angle()};
}

/// Values that lie in one of these.
std::vector<CuspEvent> merged(std::vector<CuspEvent> events) {
  std::sort(events.begin(), events.end(),
            [](const CuspEvent& a, const CuspEvent& b) { return a.lower < b.lower; });
  std::vector<CuspEvent> result;
  for (const CuspEvent& each : events) {
    if (result.empty() || each.lower > result.back().upper)
      result.push_back(each);
    else
      result.back().upper = std::max(result.back().upper, each.upper);
  }
  return result;
}

/// How often the curve, between its events, has each value of such a gap between these.
std::size_t crossings(const CuspCurve& curve, double lower, double upper) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < curve.events.size(); ++i) {
    if (i + 1 == curve.events.size() && !curve.closed) break;
    const CuspEvent &a = curve.events[i], &b = curve.events[(i + 1) % curve.events.size()];
    if (std::min(a.upper, b.upper) <= lower && upper <= std::max(a.lower, b.lower)) ++count;
  }
  return count;
}

class CurvesOfRange {
 public:
  CurvesOfRange(const Manipulator& manipulator, const HeldRange& range)
      : manipulator_(manipulator), range_(range) {
    const HeldJoint joint = middle_of(manipulator, range);
    const RoundingUpward rounding;
    slice_.emplace(manipulator, joint);
    const Interval held = Interval(range.lower, range.upper) * reciprocal(pi_enclosure());
    bounds_.lower = held.lower();
    bounds_.upper = held.upper();
    if (!joint.is_angle) bounds_.weights[2] = pi / circle_of_anchor(manipulator, joint).radius;
  }

  CuspCurves find(const MapControl& control) {
    result_.range = range_;
    result_.complete = true;
    const std::vector<SlicePosture> postures = slice_->postures();
    const double share = 1.0 / static_cast<double>(postures.size());
    for (std::size_t i = 0; i < postures.size(); ++i) {
      const double done = share * static_cast<double>(i);
      find_in(postures[i], most_evaluations_for_curves / postures.size(),
              part_of(control, done, done + share));
    }
    result_.undecided = merged(std::move(result_.undecided));
    result_.complete = result_.undecided.empty() && !is_cancelled(control);
    count();
    return std::move(result_);
  }

 private:
  void find_in(const SlicePosture& posture, std::size_t most_evaluations, const MapControl& control) {
    std::vector<CurveRun> runs;
    {
      const RoundingUpward rounding;
      SliceFamily family(*slice_, posture);
      const CuspTraces found = find_cusp_traces(family, bounds_, most_evaluations, control);
      for (const Box& box : found.undecided) add_undecided(box);
      for (const CuspTrace& trace : found.traces) add_runs(trace, family, control, runs);
    }
    for (const CurveRun& run : runs) add(run, posture);
  }

  void add_runs(const CuspTrace& trace, SliceFamily& family, const MapControl& control,
                std::vector<CurveRun>& runs) {
    CurveRuns found = runs_of(family, trace, {bounds_.lower, bounds_.upper}, control);
    touches_.insert(touches_.end(), found.touches.begin(), found.touches.end());
    std::move(found.runs.begin(), found.runs.end(), std::back_inserter(runs));
  }

  void add_undecided(const Box& box) {
    const Interval values = held_values(box);
    result_.undecided.push_back({CuspEventKind::unknown, values.lower(), values.upper()});
  }

  void add(const CurveRun& run, const SlicePosture& posture) {
    CuspCurve curve;
    curve.closed = run.closed;
    curve.events = run.events;
    for (const CurvePoint& point : run.points) curve.points.push_back(cusp_of(point, posture));
    for (const CuspEvent& event : run.events)
      if (event.kind == CuspEventKind::unknown) result_.undecided.push_back(event);
    result_.curves.push_back(std::move(curve));
  }

  Cusp cusp_of(const CurvePoint& point, const SlicePosture& posture) const {
    HeldJoint held = middle_of(manipulator_, range_);
    held.value = std::clamp(pi * point.box.center(2), range_.lower, range_.upper);
    WorkingMode mode(manipulator_.leg_count());
    mode.set_sign(held.leg, point.held_sign);
    for (std::size_t i = 0; i < 2; ++i) mode.set_sign(slice_->leg(i), posture[i]);
    const Pose pose =
        circle_of_anchor(manipulator_, held).pose(pi * point.box.center(0), pi * point.box.center(1));
    JointVector q = inverse(manipulator_, pose, mode).q;
    q[static_cast<Eigen::Index>(held.leg)] = held.value;
    const double widest = std::max({point.box.width(0), point.box.width(1), point.box.width(2)});
    return {q, mode, pose, 0.5 * pi * widest};
  }

  void count() {
    std::vector<CuspEvent> events = touches_;
    events.insert(events.end(), result_.undecided.begin(), result_.undecided.end());
    for (const CuspCurve& curve : result_.curves)
      events.insert(events.end(), curve.events.begin(), curve.events.end());
    events.push_back({CuspEventKind::range_end, range_.lower, range_.lower});
    events.push_back({CuspEventKind::range_end, range_.upper, range_.upper});
    const std::vector<CuspEvent> walls = merged(std::move(events));
    for (std::size_t i = 0; i + 1 < walls.size(); ++i) add_count(walls[i].upper, walls[i + 1].lower);
  }

  void add_count(double lower, double upper) {
    std::size_t cusps = 0;
    for (const CuspCurve& curve : result_.curves) cusps += crossings(curve, lower, upper);
    result_.counts.push_back({lower, upper, cusps});
  }

  const Manipulator& manipulator_;
  HeldRange range_;
  std::optional<PlanarHeldSlice> slice_;
  TraceBounds bounds_;
  CuspCurves result_;
  std::vector<CuspEvent> touches_;
};

}  // namespace

CuspCurves find_cusp_curves(const Manipulator& manipulator, const HeldRange& range,
                            const MapControl& control) {
  return CurvesOfRange(manipulator, range).find(control);
}

const char* name(CuspEventKind kind) noexcept {
  switch (kind) {
    case CuspEventKind::range_end:
      return "end of the range";
    case CuspEventKind::limit:
      return "limit";
    case CuspEventKind::turn:
      return "turn";
    case CuspEventKind::serial:
      return "serial singularity";
    case CuspEventKind::unknown:
      break;
  }
  return "unknown";
}

}  // namespace parallel_aspects
