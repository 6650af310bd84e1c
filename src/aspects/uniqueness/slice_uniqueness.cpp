// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/slice_uniqueness.h"

#include "aspects/regions/grid_regions.h"
#include "aspects/regions/uniqueness_domains.h"
#include "aspects/solutions/strut_poses.h"
#include "aspects/uniqueness/number_table.h"
#include "aspects/uniqueness/solution_numbers.h"
#include "interval/rounding.h"
#include "parallel_aspects/kinematics/inverse.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {
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
