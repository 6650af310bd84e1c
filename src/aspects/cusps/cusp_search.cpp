// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_search.h"

#include "aspects/cusps/cusp_functions.h"
#include "aspects/cusps/cusp_trace.h"
#include "aspects/cusps/cusp_tube.h"
#include "aspects/zeros/krawczyk.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

// Boxes that are larger are not worth Newton's test, and smaller ones not worth being divided [half turns].
constexpr double largest_tested = 0.1, smallest_box = 0x1p-30;

// Boxes that are examined in all. A slice with some ten cusps takes some ten thousand.
constexpr std::size_t largest_effort = 1000000;

// Boxes of one size that are left at once. Some thousand are where D and both equations vanish along curves;
// these would take all of the effort, and settle nothing.
constexpr std::size_t most_open = 20000;

// Newton's test of a somewhat larger box also proves cusps that lie on a face.
constexpr double inflation = 1.5;

// What is left after these is rounding.
constexpr int contractions = 8;

using Over = CuspFunctions<1>;
using AtCenter = CuspFunctions<0>;

bool may_vanish(const Interval& center, const CuspGradient<2>& gradient, const SliceCenter& middle) {
  return may_vanish(center + gradient[0] * middle.offset(0) + gradient[1] * middle.offset(1));
}

/// A box of the slice in one posture.
class CuspTest {
 public:
  CuspTest(const HeldSlice& slice, const SlicePosture& posture, const Box& box)
      : slice_(slice), posture_(posture), box_(box), place_(slice.place(box)) {}

  bool may_hold_cusp() const {
    const auto legs = legs_over(slice_, posture_, place_);
    if (!legs) return true;
    if (is_out_of_reach(*legs) || !may_be_singular(*legs, place_.over())) return false;
    const Over over(*legs, place_.over());
    if (!over.may_have_cusp()) return false;
    if (!are_regular(*legs)) return true;
    const auto center = at_center();
    if (!center) return true;
    const SliceCenter& middle = place_.middle();
    const TotalGradients<2> slopes(*legs, over, place_.over());
    return may_vanish(center->d.value(), slopes.d, middle) &&
           may_vanish(center->along_kernel[0].value(), slopes.along_kernel[0], middle) &&
           may_vanish(center->along_kernel[1].value(), slopes.along_kernel[1], middle);
  }

  /// The equation that is the better one of the two in the middle; nothing where none is of use.
  std::optional<std::size_t> better_equation() const {
    const auto center = at_center();
    if (!center) return std::nullopt;
    return center->better_equation();
  }

  /// Of D and {D, g_i}.
  ZeroSearch newton(std::size_t i) const {
    const auto legs = legs_over(slice_, posture_, place_);
    const auto center = at_center();
    if (!legs || !are_regular(*legs) || !center) return {Zeros::unknown, box_};
    const TotalGradients<2> slopes(*legs, Over(*legs, place_.over()), place_.over());
    return krawczyk_test(
        box_, {{center->d.value(), center->along_kernel[i].value()}, {{slopes.d, slopes.along_kernel[i]}}});
  }

  /// Whether the gradient of g_i does not vanish.
  bool has_rank_one(std::size_t i) const {
    const auto leg = slice_.leg_over(i, posture_[i], place_);
    if (!leg) return false;
    const auto g = leg->equation.jet<1>(place_.over());
    return !may_vanish(g.at(1, 0)) || !may_vanish(g.at(0, 1));
  }

 private:
  std::optional<AtCenter> at_center() const {
    const SlicePlace at = place_.at_center();
    const auto legs = legs_over(slice_, posture_, at);
    if (!legs || !are_regular(*legs)) return std::nullopt;
    return AtCenter(*legs, at.over());
  }

  const HeldSlice& slice_;
  SlicePosture posture_;
  Box box_;
  SlicePlace place_;
};

/// The search in one posture.
class CuspSearch {
 public:
  CuspSearch(const HeldSlice& slice, const SlicePosture& posture, const MapControl& control)
      : slice_(slice), posture_(posture), control_(control) {}

  void run(CuspBoxes& result) {
    boxes_.push_back(whole_slice());
    for (std::size_t effort = 0; !boxes_.empty() && boxes_.size() < most_open; ++effort) {
      if (is_cancelled(control_)) result.cancelled = true;
      if (result.cancelled || effort >= largest_effort) break;
      const Box box = boxes_.front();
      boxes_.pop_front();
      if (!examine(box)) result.undecided.push_back({box, posture_});
    }
    result.has_curves = result.has_curves || boxes_.size() >= most_open;
    for (const Box& box : boxes_) result.undecided.push_back({box, posture_});
    for (const KnownZero& each : known_.all())
      result.cusps.push_back({without_turns(each.enclosure), posture_});
  }

 private:
  CuspTest test(const Box& box) const { return {slice_, posture_, box}; }

  /// Left out are boxes that hold no cusp, or a known one alone; all others end among the undecided ones.
  /// False where the box is too small to be divided.
  bool examine(const Box& box) {
    if (known_.cover(box) || !test(box).may_hold_cusp()) return true;
    const double width = std::max(box.width(0), box.width(1));
    if (width < largest_tested && is_settled(scaled(box, inflation))) return true;
    if (width < smallest_box) return false;
    for (const Box& half : halves_of(box)) boxes_.push_back(half);
    return true;
  }

  /// Whether it is proved that the box holds no cusp, or one, which then is known.
  bool is_settled(const Box& box) {
    const auto i = test(box).better_equation();
    if (!i) return false;
    const ZeroSearch found = test(box).newton(*i);
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    Box enclosure = found.enclosure;
    for (int k = 0; k < contractions; ++k)
      enclosure = intersection(enclosure, test(enclosure).newton(*i).enclosure);
    return test(enclosure).has_rank_one(*i) && known_.note({box, enclosure});
  }

  const HeldSlice& slice_;
  SlicePosture posture_;
  const MapControl& control_;
  std::deque<Box> boxes_;  // the largest first
  KnownZeros known_;
};

}  // namespace

CuspBoxes find_cusp_boxes(const HeldSlice& slice, const MapControl& control) {
  assert_rounding_upward();
  CuspBoxes result;
  for (const SlicePosture& posture : slice.postures()) CuspSearch(slice, posture, control).run(result);
  return result;
}

namespace {

class CurveSearch {
 public:
  CurveSearch(SliceFamily& family, const TraceBounds& bounds, std::size_t most_evaluations,
              const MapControl& control)
      : family_(family),
        bounds_(bounds),
        most_evaluations_(most_evaluations),
        control_(control),
        cores_(bounds) {
    // Curves are followed a little farther, so that what touches the range from outside is known, too.
    const double more = 0.01 * (bounds.upper - bounds.lower);
    trace_bounds_ = bounds;
    trace_bounds_.lower -= more;
    trace_bounds_.upper += more;
  }

  CuspTraces run() {
    Box whole = whole_slice();
    whole.dimension = 3;
    whole.lower[2] = bounds_.lower;
    whole.upper[2] = bounds_.upper;
    boxes_.push_back(whole);
    double done = 0.0;
    for (std::size_t count = 0; !boxes_.empty(); ++count) {
      const std::size_t effort = family_.evaluations();
      if (count % 1024 == 0) tell(done / whole.measure(), effort);
      const Box box = boxes_.back();
      boxes_.pop_back();
      const std::size_t left = boxes_.size();
      if (effort >= most_evaluations_ || is_cancelled(control_)) stopped_ = true;
      if (stopped_ || !examine(box)) result_.undecided.push_back(box);
      if (boxes_.size() == left) done += box.measure();
    }
    return std::move(result_);
  }

 private:
  /// The search ends with the last box or the last of the effort; each box brings one of both nearer.
  void tell(double done, std::size_t effort) const {
    if (!control_.progress) return;
    const double spent = std::min(1.0, static_cast<double>(effort) / static_cast<double>(most_evaluations_));
    control_.progress(done + (1.0 - done) * spent);
  }

  /// Left out are boxes that hold no cusp within limits, or those of a known arc alone; all others end among
  /// the undecided ones. False where the box is too small to be divided.
  bool examine(const Box& box) {
    if (!family_.may_hold_cusp(box)) return true;
    const double width = bounds_.weights[longest_axis(box)] * box.width(longest_axis(box));
    if (width < largest_tested && (cores_.holds(box) || is_settled(box))) return true;
    if (width < smallest_singular && (width < smallest_box || !family_.over(box))) return false;
    divide(box);
    return true;
  }

  std::size_t longest_axis(const Box& box) const {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (bounds_.weights[i] * box.width(i) > bounds_.weights[longest] * box.width(longest)) longest = i;
    return longest;
  }

  void divide(const Box& box) {
    const std::size_t axis = longest_axis(box);
    Box first = box, second = box;
    first.upper[axis] = second.lower[axis] = box.center(axis);
    boxes_.push_back(second);
    boxes_.push_back(first);
  }

  /// Whether it is proved that the box holds no cusp, or those of one arc, which then is known.
  bool is_settled(const Box& box) {
    auto tube = tube_over(family_, scaled(box, inflation), bounds_.weights);
    if (!tube) return false;
    const Zeros zeros = test_tube(family_, *tube);
    if (zeros != Zeros::one) return zeros == Zeros::none;
    MapPoint at{};
    at[tube->axis] = tube->middle;
    for (std::size_t i = 0; i < 2; ++i) at[tube->others[i]] = tube->enclosed.center(i);
    const auto point = cusp_near(family_, tube->axis, at);
    return point && contains(*tube, *point) && note(*point) && is_within_bounds(*tube);
  }

  /// A trace ends outside of bounds, or where it failed; so where it has a point of an arc without these, it
  /// has all of it.
  bool is_within_bounds(const CuspTube& tube) {
    const Box hull = hull_of(tube, intersection(tube.cross, tube.enclosed));
    return trace_bounds_.lower <= hull.lower[2] && hull.upper[2] <= trace_bounds_.upper &&
           family_.within_limits(hull) == Verdict::holds &&
           std::none_of(ends_.begin(), ends_.end(), [&](const Box& end) { return may_meet(tube, end); });
  }

  /// Whether it is proved that a cusp lies on a known curve, or on none of these, which then is known.
  bool note(const Box& point) {
    if (cores_.holds(point)) return true;
    for (const CuspTrace& trace : result_.traces)
      for (const CuspTube& tube : trace.tubes)
        if (may_meet(tube, point)) return false;
    CuspTrace trace = trace_cusps(family_, point, trace_bounds_, ends_, control_);
    if (trace.tubes.empty()) return false;
    if (!trace.closed) ends_.insert(ends_.end(), {trace.points.front(), trace.points.back()});
    for (std::size_t i = 0; i < trace.tubes.size(); ++i) cores_.add(core_of(trace, i));
    result_.traces.push_back(std::move(trace));
    return true;
  }

  // Boxes that are larger are not worth Newton's test, and smaller ones not worth being divided [half turns,
  // times weights].
  static constexpr double largest_tested = 0.1, smallest_box = 0x1p-18;

  // Of boxes that touch a serial singularity. A crank and a rod of one length are folded along whole curves.
  static constexpr double smallest_singular = 0x1p-14;

  // Newton's test of a somewhat larger box also proves curves along a face.
  static constexpr double inflation = 1.2;

  SliceFamily& family_;
  TraceBounds bounds_, trace_bounds_;
  std::size_t most_evaluations_;
  const MapControl& control_;
  std::vector<Box> boxes_;
  TubeIndex cores_;
  std::vector<Box> ends_;  // of traces
  CuspTraces result_;
  bool stopped_ = false;
};

}  // namespace

CuspTraces find_cusp_traces(SliceFamily& family, const TraceBounds& bounds, std::size_t most_evaluations,
                            const MapControl& control) {
  assert_rounding_upward();
  return CurveSearch(family, bounds, most_evaluations, control).run();
}

}  // namespace parallel_aspects
