// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/solution_numbers.h"

#include "aspects/cusps/held_slice.h"
#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/slice_solver.h"
#include "aspects/solutions/value_grid.h"
#include "aspects/solutions/value_strips.h"
#include "aspects/uniqueness/number_table.h"
#include "interval/rounding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

/// Of the grid of joint values. Of all values strips take some fiftieth in SE2, and some twelfth in SO3,
/// where boxes take ten times the processor time.
std::size_t cells_an_axis(const Manipulator& manipulator) noexcept {
  return manipulator.task_space() == TaskSpace::SO3 ? 1024 : 2048;
}

// Of robots with such slices.
constexpr std::size_t slice_leg_count = 3;

// Smaller sets are slivers between strips.
constexpr std::size_t least_cells = 16;

/// What is known of a connected set of values.
struct CountedSet {
  std::optional<std::vector<SliceSolution>> solutions;  // of the values inside
  std::optional<std::size_t> component;                 // in the list, if there is a solution
};

class NumberedGrid {
 public:
  NumberedGrid(const Manipulator& manipulator, const HeldJoint& held, std::shared_ptr<const AspectMap> map,
               const MapControl& control)
      : map_(std::move(map)),
        held_(held),
        slice_(make_held_slice(manipulator, held_)),
        ranges_(manipulator, held_, *slice_),
        grid_(ranges_, cells_an_axis(manipulator)) {
    const std::array<double, 2> steps = grid_.steps();
    const double step = std::min(steps[0], steps[1]);
    const StripSizes sizes{0.25 * step, step};
    const auto mark = [this](const ValueStrip& strip) { return grid_.mark(strip); };
    enclose_parallel_singularities(*slice_, ranges_, sizes, control, mark);
    enclose_serial_singularities(*slice_, ranges_, sizes, control, mark);
    if (is_cancelled(control)) return;
    grid_.join(least_cells);
    for (const GridSet& set : grid_.sets()) sets_.push_back({find_slice_solutions(*slice_, set.inside), {}});
  }

  const JointRanges& ranges() const noexcept { return ranges_; }

  void add_to(SolutionNumbers& result) {
    double unknown = measure(static_cast<double>(grid_.cells_in_none()));
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const GridSet& set = grid_.sets()[i];
      if (!sets_[i].solutions) unknown += measure(static_cast<double>(set.cells));
      if (!sets_[i].solutions || sets_[i].solutions->empty()) continue;
      sets_[i].component = result.basic_components.size();
      add_component(component(set, *sets_[i].solutions), result);
    }
    set_unknown(unknown, result);
  }

  std::optional<std::size_t> component_at(const JointVector& actuated) const noexcept {
    if (actuated.size() != static_cast<Eigen::Index>(slice_leg_count)) return std::nullopt;
    const auto set = grid_.set_of(ranges_.values_of(actuated));
    return set ? sets_[*set].component : std::nullopt;
  }

 private:
  double measure(double cells) const noexcept { return cells * grid_.cell_measure(); }

  BasicComponent component(const GridSet& set, const std::vector<SliceSolution>& solutions) const {
    BasicComponent result;
    result.inside = ranges_.actuated(set.inside);
    for (const SliceSolution& solution : solutions) {
      result.solutions.push_back(slice_->pose({solution.enclosure.center(0), solution.enclosure.center(1)}));
      const auto mode = mode_of(solution);
      result.aspects.push_back(map_ && mode ? aspect_at(*map_, result.solutions.back(), *mode) : 0);
    }
    result.measure = measure(static_cast<double>(set.cells) + set.cells_beside);
    result.measure_lower = measure(static_cast<double>(set.cells)) * rounded_down;
    return result;
  }

  std::optional<WorkingMode> mode_of(const SliceSolution& solution) const {
    const int held = slice_->held_sign(slice_->place(solution.enclosure));
    if (held == 0 || solution.posture[0] == 0 || solution.posture[1] == 0) return std::nullopt;
    WorkingMode mode(slice_leg_count);
    mode.set_sign(held_.leg, held);
    for (std::size_t i = 0; i < 2; ++i) mode.set_sign(slice_->leg(i), solution.posture[i]);
    return mode;
  }

  std::shared_ptr<const AspectMap> map_;
  HeldJoint held_;
  std::unique_ptr<const HeldSlice> slice_;
  JointRanges ranges_;
  ValueGrid grid_;
  std::vector<CountedSet> sets_;
};

}  // namespace

SolutionNumbers find_solution_numbers(const Manipulator& manipulator, const HeldJoint& held,
                                      std::shared_ptr<const AspectMap> map, const MapControl& control) {
  const RoundingUpward rounding;
  const auto grid = std::make_shared<NumberedGrid>(manipulator, held, std::move(map), control);
  SolutionNumbers result;
  if (is_cancelled(control)) return result;
  result.has_regions = true;
  result.region_unit = grid->ranges().unit();
  grid->add_to(result);
  result.component_of = [grid](const JointVector& q) { return grid->component_at(q); };
  return result;
}

}  // namespace parallel_aspects
