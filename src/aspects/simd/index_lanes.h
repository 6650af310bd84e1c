// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_INDEX_LANES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_INDEX_LANES_H

#include "aspects/boxes/box_intervals.h"
#include "aspects/boxes/index_on_arcs.h"
#include "aspects/simd/box_requests.h"
#include "aspects/simd/chart_lanes.h"
#include "aspects/simd/lane_stages.h"

#include <cstddef>
#include <limits>

namespace parallel_aspects {

/// What `ChartClassifier::enclose_index` tells of boxes of one chart and root by intervals and affine forms,
/// one in each lane.
template <class Chart, class Numbers>
class IndexLanes {
 public:
  using Types = LaneTypes<Chart, Numbers>;

  /// `count` boxes of one root, at most as many as there are lanes.
  IndexLanes(const IndexQuestion<Chart>& of, const IndexRequest* boxes, std::size_t count)
      : of_(of), root_(boxes[0].root), count_(count) {
    for (std::size_t i = 0; i < lane_count<Numbers>; ++i) {
      const IndexRequest& at = boxes[i < count ? i : 0];
      share_[i] = at.share;
      for (std::size_t k = 0; k < Types::coordinate_count; ++k)
        ranges_[k].set_lane(i, Interval(at.box.lower[k], at.box.upper[k]));
    }
  }

  void enclose(EnclosedIndex* enclosed) {
    const auto intervals = LaneIntervals<Chart, Numbers>::of(of_.chart, root_, ranges_);
    range_ = by_intervals(intervals);
    Mask nowhere = intervals.entries().reachable_nowhere, open = ~nowhere & ~is_enough();
    if (!in_none(open)) {
      const auto forms = LaneForms<Chart, Numbers>::of(intervals);
      nowhere |= open & forms.entries().reachable_nowhere;
      range_ = where(open, intersection(range_, by_forms(forms)), range_);
      open &= ~nowhere & ~is_enough() & is_near_axis(intervals);
    }
    range_ = where(nowhere, Range(0.0), range_);
    for (std::size_t i = 0; i < count_; ++i) enclosed[i] = {range_.lane(i), open[i] != 0};
  }

 private:
  using Range = typename Types::Range;
  using Form = typename Types::Form;
  using Mask = typename Types::Mask;

  template <class Legs>
  auto squares(const Legs& legs) const {
    return of_.index == ParallelIndex::normalised ? of_.margins.squared_norms(legs, of_.signs)
                                                  : of_.margins.squared_scales(legs);
  }

  /// See BoxIntervals::index.
  Range by_intervals(const LaneIntervals<Chart, Numbers>& intervals) const {
    const Range all = every_index(of_.index), square = squares(intervals.legs());
    const Range index = of_sign(intervals.determinant(of_.signs), of_.sign) * reciprocal(square_root(square));
    return where(square.positive(), intersection(all, index), all);
  }

  /// See BoxForms::index.
  Range by_forms(const LaneForms<Chart, Numbers>& forms) const {
    const Form square = squares(forms.legs());
    const Numbers least = square.range().lower();
    const Form norm = square_root(square, least),
               over_norm = reciprocal(norm, Numbers(square_root(Range(least, least)).lower()));
    const Range index = of_sign((forms.legs().determinant(of_.signs) * over_norm).range(), of_.sign);
    return where(least > 0.0, index, Range(Interval(0.0, std::numeric_limits<double>::infinity())));
  }

  Mask is_enough() const { return range_.upper() - range_.lower() <= share_ * range_.upper(); }

  Mask is_near_axis(const LaneIntervals<Chart, Numbers>& intervals) const {
    Mask result{};
    for (std::size_t j = 0; j < Types::leg_count; ++j) {
      const Range scale = intervals.legs().scale(j);
      result |= scale.lower() < IndexOnArcs<Chart>::near_axis * scale.upper();
    }
    return result;
  }

  const IndexQuestion<Chart>& of_;
  RootIndex root_;
  std::size_t count_;
  typename Types::Ranges ranges_;
  Numbers share_;
  Range range_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_INDEX_LANES_H
