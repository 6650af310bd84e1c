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

/// What is known of a connected set of values.
struct CountedSet {
  std::optional<std::vector<SliceSolution>> solutions;  // of the values inside
  std::optional<std::size_t> component;                 // in the list, if there is a solution
};

class NumberedGrid {
 public:
  NumberedGrid(const Manipulator& manipulator, std::shared_ptr<const SliceOfValues> values,
               std::shared_ptr<const AspectMap> map, const SeeStrip& see, const MapControl& control)
      : map_(std::move(map)), values_(std::move(values)), grid_(values_->ranges, cells_an_axis(manipulator)) {
    const std::array<double, 2> steps = grid_.steps();
    const double step = std::min(steps[0], steps[1]);
    const StripSizes sizes{0.25 * step, step};
    const auto mark = [&](const ValueStrip& strip) {
      see(strip);
      return grid_.mark(strip);
    };
    enclose_parallel_singularities(slice(), ranges(), sizes, part_of(control, 0.0, 0.6), mark);
    enclose_serial_singularities(slice(), ranges(), sizes, part_of(control, 0.6, 0.8), mark);
    if (is_cancelled(control)) return;
    grid_.join(least_cells_of_set);
    for (const GridSet& set : grid_.sets()) {
      sets_.push_back({find_slice_solutions(slice(), set.inside), {}});
      const double share = static_cast<double>(sets_.size()) / static_cast<double>(grid_.sets().size());
      if (control.progress) control.progress(0.8 + 0.2 * share);
    }
  }

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
    const auto set = grid_.set_of(ranges().values_of(actuated));
    return set ? sets_[*set].component : std::nullopt;
  }

 private:
  const HeldSlice& slice() const noexcept { return *values_->slice; }
  const JointRanges& ranges() const noexcept { return values_->ranges; }
  double measure(double cells) const noexcept { return cells * grid_.cell_measure(); }

  BasicComponent component(const GridSet& set, const std::vector<SliceSolution>& solutions) const {
    BasicComponent result;
    result.inside = ranges().actuated(set.inside);
    for (const SliceSolution& solution : solutions) {
      result.solutions.push_back(values_->pose_of(solution.enclosure));
      const auto mode = values_->mode_of(solution);
      result.aspects.push_back(map_ && mode ? aspect_at(*map_, result.solutions.back(), *mode) : 0);
    }
    result.measure = measure(static_cast<double>(set.cells) + set.cells_beside);
    result.measure_lower = measure(static_cast<double>(set.cells)) * rounded_down;
    return result;
  }

  std::shared_ptr<const AspectMap> map_;
  std::shared_ptr<const SliceOfValues> values_;
  ValueGrid grid_;
  std::vector<CountedSet> sets_;
};

}  // namespace

SliceOfValues::SliceOfValues(const Manipulator& manipulator, const HeldJoint& joint)
    : held(joint), slice(make_held_slice(manipulator, held)), ranges(manipulator, held, *slice) {}

std::optional<WorkingMode> SliceOfValues::mode_of(const SliceSolution& solution) const {
  return slice->mode_of(solution.posture, slice->place(solution.enclosure));
}

Pose SliceOfValues::pose_of(const Box& solution) const {
  return slice->pose({solution.center(0), solution.center(1)});
}

SolutionNumbers find_solution_numbers(const Manipulator& manipulator,
                                      std::shared_ptr<const SliceOfValues> values,
                                      std::shared_ptr<const AspectMap> map, const SeeStrip& see,
                                      const MapControl& control) {
  assert_rounding_upward();
  const std::string unit = values->ranges.unit();
  const auto grid =
      std::make_shared<NumberedGrid>(manipulator, std::move(values), std::move(map), see, control);
  SolutionNumbers result;
  if (is_cancelled(control)) return result;
  result.has_regions = true;
  result.region_unit = unit;
  grid->add_to(result);
  result.component_of = [grid](const JointVector& q, const WorkingMode& /*all*/) {
    return grid->component_at(q);
  };
  return result;
}

}  // namespace parallel_aspects
