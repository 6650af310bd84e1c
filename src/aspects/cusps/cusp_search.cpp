// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_search.h"

#include "aspects/cusps/cusp_functions.h"
#include "aspects/zeros/known_zeros.h"
#include "aspects/zeros/krawczyk.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>

namespace parallel_aspects {
namespace {

// Boxes that are larger are not worth Newton's test, and smaller ones not worth being divided [half turns].
constexpr double largest_tested = 0.1, smallest_box = 0x1p-30;

// Boxes that are looked at in all. A slice with some ten cusps takes some ten thousand.
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

}  // namespace parallel_aspects
