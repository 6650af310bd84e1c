// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/star_sets/star_finder.h"

#include "aspects/boxes/charts.h"
#include "aspects/boxes/hinge_chart.h"
#include "aspects/star_sets/folded_leg.h"
#include "aspects/star_sets/star_search.h"

#include <algorithm>
#include <type_traits>

namespace parallel_aspects {
namespace {

template <class Chart>
class ChartStars final : public StarFinder {
  static constexpr std::size_t leg_count = Chart::leg_count;
  using Forms = BoxForms<Chart>;
  using Signs = typename Forms::Signs;
  using Tests = ConstraintTests<Chart::point_dimension>;

 public:
  ChartStars(const Manipulator& manipulator, const std::vector<WorkingMode>& modes)
      : chart_(made_under_upward_rounding<Chart>(manipulator)),
        tests_(made_under_upward_rounding<Tests>(manipulator)) {
    for (std::size_t j = 0; j < leg_count; ++j) types_[j] = manipulator.leg(j).kind().type;
    for (const WorkingMode& mode : modes) {
      Signs signs;
      for (std::size_t j = 0; j < leg_count; ++j) signs[j] = mode.sign(j);
      signs_.push_back(signs);
    }
  }

  Stars find(RootIndex root, const Box& box, const Box& region, std::size_t mode,
             int sign) const noexcept override {
    const BoxIntervals<Chart> intervals({chart_, tests_, root, box});
    if (!intervals.state(signs_[mode]).may_be(sign)) return Stars::none();
    const Forms forms(intervals);
    const LeafState state = forms.state(signs_[mode]);
    if (!state.may_be(sign)) return Stars::none();
    if (state.is_inside(sign)) return Stars::one(box.middle());
    if constexpr (std::is_same_v<Chart, SE2Chart>) {
      const Stars found = find_stars_about_fold(forms.at(), region, signs_[mode], sign);
      if (found.is_known) return found;
    }
    StarSearch<Chart, 0> plain(forms, region, types_, signs_[mode], sign);
    if (!plain.lacks_levels()) {
      const Stars found = plain.find();
      if (found.is_known) return found;
    }
    return find_with_levels(forms, region, signs_[mode], sign);
  }

 private:
  /// With the heights of legs that are not clear, or near that: |B_jj| is curved there.
  Stars find_with_levels(const Forms& forms, const Box& region, const Signs& signs, int sign) const {
    std::array<std::size_t, leg_count> legs{};
    std::size_t count = 0;
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Interval& height = forms.entries().value(j);
      if (rod_depends_on_entry(types_[j]) && height.upper() > curved_from * height.lower()) legs[count++] = j;
    }
    if (count == 1) return find_with<1>(forms, region, signs, sign, {legs[0]});
    if (count == 2) return find_with<2>(forms, region, signs, sign, {legs[0], legs[1]});
    return Stars();
  }

  template <std::size_t Levels>
  Stars find_with(const Forms& forms, const Box& region, const Signs& signs, int sign,
                  const std::array<std::size_t, Levels>& legs) const {
    StarSearch<Chart, Levels> search(forms, region, types_, signs, sign);
    if (!search.set_levels(legs)) return Stars();
    const Stars found = search.find();
    return !found.is_known && search.avoid_ends() ? search.find() : found;
  }

  static constexpr double curved_from = 1.05;  // heights over a box: largest over smallest

  Chart chart_;
  Tests tests_;
  LegTypes<leg_count> types_{};
  std::vector<Signs> signs_;
};

}  // namespace

std::unique_ptr<const StarFinder> make_star_finder(const Manipulator& manipulator,
                                                   const std::vector<WorkingMode>& modes) {
  switch (manipulator.task_space()) {
    case TaskSpace::T2:
      return std::make_unique<const ChartStars<T2Chart>>(manipulator, modes);
    case TaskSpace::SE2:
      return std::make_unique<const ChartStars<SE2Chart>>(manipulator, modes);
    case TaskSpace::T3:
      return std::make_unique<const ChartStars<T3Chart>>(manipulator, modes);
    case TaskSpace::SO3:
      return std::make_unique<const ChartStars<SO3Chart>>(manipulator, modes);
    case TaskSpace::R2:
      return std::make_unique<const ChartStars<R2Chart>>(manipulator, modes);
    case TaskSpace::T1:
    case TaskSpace::R1:
    case TaskSpace::SE3:
      break;
  }
  return nullptr;
}

}  // namespace parallel_aspects
