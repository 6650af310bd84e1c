// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/solution_numbers.h"

#include "aspects/cusps/held_slice.h"
#include "aspects/regions/found_regions.h"
#include "aspects/regions/grid_regions.h"
#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/slice_equations.h"
#include "aspects/solutions/strut_solutions.h"
#include "aspects/solutions/value_grid.h"
#include "aspects/solutions/value_strips.h"
#include "interval/interval.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {

int aspect_at(const AspectMap& map, const Pose& pose, const WorkingMode& mode) {
  const int id = map.locate(pose, mode).aspect;
  if (id == 0) return 0;
  return map.aspects()[static_cast<std::size_t>(id - 1)].unresolved_with.empty() ? id : 0;
}

void add_component(BasicComponent component, SolutionNumbers& result) {
  const std::size_t solutions = component.solutions.size();
  auto region = std::find_if(result.regions.begin(), result.regions.end(),
                             [&](const SolutionRegion& each) { return each.solutions >= solutions; });
  if (region == result.regions.end() || region->solutions != solutions)
    region = result.regions.insert(region, {{}, solutions, 0.0, 0.0, 0.0});
  region->measure += component.measure;
  region->measure_lower += component.measure_lower;
  result.basic_components.push_back(std::move(component));
}

void set_unknown(double unknown, SolutionNumbers& result) {
  result.measure_unknown = unknown * rounded_up;
  for (SolutionRegion& region : result.regions)
    region.measure_upper = (region.measure_lower + unknown) * rounded_up;
}

void add_domains(FoundDomains domains, Uniqueness& result) {
  result.domains_complete = domains.complete;
  for (auto& each : domains.domains) {
    UniquenessDomain domain{result.basic_regions[each.front()].aspect, false, std::move(each), 0.0};
    for (const std::size_t region : domain.basic_regions)
      domain.measure_lower += result.basic_regions[region].measure_lower * rounded_down;
    result.domains.push_back(std::move(domain));
  }
}

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

namespace {

// Of the grid of each working mode. There are fewer strips than in that of all of them.
constexpr std::size_t cells_of_mode = 1024;

/// The values of one working mode.
class ModeGrid {
 public:
  ModeGrid(const SliceOfValues& values, const AspectMap& map, const WorkingMode& mode)
      : values_(values), map_(map), mode_(mode), grid_(values.ranges, cells_of_mode) {}

  void see(const ValueStrip& strip) {
    const HeldSlice& slice = *values_.slice;
    if (may_be(values_.held.leg, strip.held) && may_be(slice.leg(0), strip.posture[0]) &&
        may_be(slice.leg(1), strip.posture[1]))
      grid_.mark(strip);
  }

  void find_regions(const MapControl& control) {
    grid_.join(least_cells_of_set);
    const SolveMode solve = [this](const std::array<double, 2>& values) { return solutions_at(values); };
    regions_.emplace(*values_.slice, grid_, solve, control);
  }

  const WorkingMode& mode() const noexcept { return mode_; }
  const ValueGrid& grid() const noexcept { return grid_; }
  const GridRegions& regions() const { return *regions_; }

 private:
  /// Whether a leg of this mode may have such a sign.
  bool may_be(std::size_t leg, int sign) const noexcept { return sign * mode_.sign(leg) >= 0; }

  std::optional<ModeSolutions> solutions_at(const std::array<double, 2>& values) const {
    const auto all = find_slice_solutions(*values_.slice, values);
    if (!all) return std::nullopt;
    ModeSolutions result;
    for (const SliceSolution& solution : *all) {
      const auto mode = values_.mode_of(solution);
      if (!mode) return std::nullopt;
      if (*mode != mode_) continue;
      result.boxes.push_back(solution.enclosure);
      result.aspects.push_back(aspect_at(map_, values_.pose_of(solution.enclosure), mode_));
    }
    return result;
  }

  const SliceOfValues& values_;
  const AspectMap& map_;
  WorkingMode mode_;
  ValueGrid grid_;
  std::optional<GridRegions> regions_;
};

/// All of them, with the first region of each.
struct GridsOfModes {
  SliceOfValues values;
  std::shared_ptr<const AspectMap> map;
  std::vector<std::unique_ptr<ModeGrid>> modes;
  std::vector<std::size_t> first_regions;

  explicit GridsOfModes(const std::shared_ptr<const AspectMap>& of)
      : values(*of->manipulator(), *of->slice()->joint), map(of) {
    for (const WorkingMode& mode : working_modes(*map->manipulator()))
      modes.push_back(std::make_unique<ModeGrid>(values, *map, mode));
  }

  std::optional<std::size_t> region_at(const Pose& pose, const WorkingMode& mode) const {
    const Manipulator& robot = *map->manipulator();
    const InverseSolution found = inverse(robot, pose, mode);
    if (!found || !found.q.allFinite()) return std::nullopt;
    const RoundingUpward rounding;
    const Box box = box_about(circle_of_anchor(robot, values.held), pose);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      if (modes[i]->mode() != mode) continue;
      const auto region = modes[i]->regions().locate(box, values.ranges.values_of(found.q));
      if (region) return first_regions[i] + *region;
    }
    return std::nullopt;
  }
};

void add_regions(const SliceOfValues& values, const ModeGrid& of, std::size_t first_set,
                 std::vector<BasicRegion>& result) {
  for (const FoundRegion& region : of.regions().found().regions)
    result.push_back({region.aspect, first_set + region.set, values.pose_of(of.regions().solution_of(region)),
                      values.ranges.actuated(of.grid().sets()[region.set].inside),
                      region.measure * rounded_down, region.is_unique});
}

}  // namespace

void find_regions_of_slice(const MapControl& control, Uniqueness& result) {
  const RoundingUpward rounding;
  const auto grids = std::make_shared<GridsOfModes>(result.map);
  const auto see = [&](const ValueStrip& strip) {
    for (const auto& mode : grids->modes) mode->see(strip);
  };
  const std::shared_ptr<const SliceOfValues> values(grids, &grids->values);
  static_cast<SolutionNumbers&>(result) =
      find_solution_numbers(*result.map->manipulator(), values, result.map, see, part_of(control, 0.0, 0.7));
  if (is_cancelled(control)) return;
  tbb::parallel_for(std::size_t{0}, grids->modes.size(), [&](std::size_t i) {
    const RoundingUpward rounding_of_thread;
    grids->modes[i]->find_regions(control);
  });
  if (is_cancelled(control)) return;
  FoundRegions found;
  std::size_t sets = 0;
  for (const auto& mode : grids->modes) {
    grids->first_regions.push_back(found.regions.size());
    append(mode->regions().found(), sets, found);
    add_regions(*values, *mode, sets, result.basic_regions);
    sets += mode->grid().sets().size();
  }
  if (control.progress) control.progress(1.0);
  result.has_domains = true;
  result.region_of = [grids](const Pose& pose, const WorkingMode& mode) {
    return grids->region_at(pose, mode);
  };
  add_domains(find_uniqueness_domains(found), result);
}

}  // namespace parallel_aspects
