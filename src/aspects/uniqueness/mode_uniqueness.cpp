// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/mode_uniqueness.h"

#include "aspects/enclosures/family_images.h"
#include "aspects/regions/basic_regions.h"
#include "aspects/regions/found_regions.h"
#include "aspects/solutions/actuated_space.h"
#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/slice_equations.h"
#include "aspects/solutions/solution_regions.h"
#include "aspects/solutions/strut_solutions.h"
#include "aspects/tree/joint_progress.h"
#include "aspects/uniqueness/solution_numbers.h"
#include "interval/interval.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

// Of all values of a mode: what may be unknown, and which sets are examined.
constexpr double unknown_share_of_mode = 5e-3, least_set_of_mode = 1e-4;

// So many values of what is unknown are solved, for estimates.
constexpr std::size_t unknown_draws = 1000;

// Its joint is held in the slices.
constexpr std::size_t held_of_modes = 0;

/// The values of one working mode, divided, with its regions. Made under a live `RoundingUpward`.
class ModeRegions {
 public:
  ModeRegions(const AspectMap& map, const WorkingMode& mode, std::size_t most_cells,
              const MapControl& control)
      : map_(map),
        mode_(mode),
        equations_(robot(), held_joint(0.0)),
        images_(robot(), mode, value_space_of(robot())),
        space_(images_, unknown_share_of_mode, part_of(control, 0.0, 0.7), most_cells),
        sets_(find_solution_sets(solver(), space_, control, least_set_of_mode)),
        atlas_(
            equations_, solver(), space_, sets_,
            [this](const Box& box, const ActuatedValues& at) { return aspect_of(box, at); },
            part_of(control, 0.7, 1.0)),
        component_of_(space_.pieces().size()) {}

  const WorkingMode& mode() const noexcept { return mode_; }
  const std::vector<SolutionSet>& sets() const noexcept { return sets_; }
  const FoundRegions& found() const noexcept { return atlas_.found(); }
  const ValueSpace& values() const noexcept { return images_.space(); }

  /// What has no number of solutions.
  double unknown() const { return measure_without_number(space_, sets_); }

  /// Of what is in no cell, the share with each number of solutions, from 1, as far as some hundred draws
  /// tell.
  std::map<std::size_t, double> unknown_shares() const {
    std::vector<ActuatedValues> drawn;
    {
      const RoundingUpward rounding;
      drawn = space_.draw_unknown(unknown_draws, mode_.index());
    }
    std::map<std::size_t, double> shares;
    for (const ActuatedValues& values : drawn) {
      const JointVector q = actuated(values);
      std::size_t count = 0;
      for (const AssemblyMode& each : direct(robot(), q).solutions)
        if (working_mode(robot(), each.pose, q) == mode_) ++count;
      if (count > 0) shares[count] += 1.0 / static_cast<double>(drawn.size());
    }
    return shares;
  }

  BasicComponent component(const SolutionSet& set) const {
    BasicComponent result{mode_, actuated(set.inside), {}, {}, set.estimate, set.measure * rounded_down};
    for (const Box& box : *set.solutions) {
      result.solutions.push_back(pose(box, set.inside));
      result.aspects.push_back(aspect_of(box, set.inside));
    }
    return result;
  }

  BasicRegion region(const FoundRegion& found) const {
    const SolutionSet& set = sets_[found.set];
    return {found.aspect,
            found.set,
            pose((*set.solutions)[found.solution], set.inside),
            actuated(set.inside),
            found.measure * rounded_down,
            found.is_unique};
  }

  /// Tells the index of the component that a set is.
  void set_component(const SolutionSet& set, std::size_t index) {
    for (const PieceIndex piece : set.pieces) component_of_[piece] = index;
  }

  std::optional<std::size_t> component_at(const JointVector& q) const {
    const RoundingUpward rounding;
    const auto piece = space_.find(values_in(values(), q));
    return piece ? component_of_[*piece] : std::nullopt;
  }

  std::optional<std::size_t> region_at(const Pose& pose) const {
    const InverseSolution found = inverse(robot(), pose, mode_);
    if (!found || !found.q.allFinite()) return std::nullopt;
    const RoundingUpward rounding;
    const Box box = box_about(circle_at(found.q[held_of_modes]), pose);
    return atlas_.locate(box, values_in(values(), found.q));
  }

 private:
  const Manipulator& robot() const noexcept { return *map_.manipulator(); }

  HeldJoint held_joint(double value) const {
    return {held_of_modes, value, robot().leg(held_of_modes).actuated_by_angle()};
  }

  AnchorCircle circle_at(double held) const { return circle_of_anchor(robot(), held_joint(held)); }

  Pose pose(const Box& box, const ActuatedValues& at) const {
    return circle_at(at[held_of_modes]).pose(pi * box.center(0), pi * box.center(1));
  }

  int aspect_of(const Box& box, const ActuatedValues& at) const {
    return aspect_at(map_, pose(box, at), mode_);
  }

  static JointVector actuated(const ActuatedValues& at) { return Eigen::Vector3d(at[0], at[1], at[2]); }

  SolveAt solver() const {
    return [this](const ActuatedValues& values) { return solutions_at(values); };
  }

  std::optional<std::vector<Box>> solutions_at(const ActuatedValues& values) const {
    const PlanarHeldSlice slice = equations_.slice_at(values[held_of_modes]);
    const auto all = find_slice_solutions(slice, {values[slice.leg(0)], values[slice.leg(1)]});
    if (!all) return std::nullopt;
    std::vector<Box> result;
    for (const SliceSolution& solution : *all) {
      const auto mode = slice.mode_of(solution.posture, slice.place(solution.enclosure));
      if (!mode) return std::nullopt;
      if (*mode == mode_) result.push_back(solution.enclosure);
    }
    return result;
  }

  const AspectMap& map_;
  WorkingMode mode_;
  FamilyEquations equations_;
  FamilyImages images_;
  ActuatedSpace space_;
  std::vector<SolutionSet> sets_;
  RegionAtlas atlas_;
  std::vector<std::optional<std::size_t>> component_of_;  // by piece
};

/// All working modes, with the first region of each.
struct RegionsOfModes {
  std::shared_ptr<const AspectMap> map;
  std::vector<std::unique_ptr<ModeRegions>> modes;
  std::vector<std::size_t> first_regions;

  RegionsOfModes(std::shared_ptr<const AspectMap> of, std::size_t most_cells, const MapControl& control)
      : map(std::move(of)) {
    const std::vector<WorkingMode> all = working_modes(*map->manipulator());
    modes.resize(all.size());
    JointProgress progress(control, all.size());
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
      const RoundingUpward rounding;
      modes[i] = std::make_unique<ModeRegions>(*map, all[i], most_cells / all.size(), progress.of(i));
    });
  }

  /// Index in `modes`.
  std::optional<std::size_t> find(const WorkingMode& mode) const {
    for (std::size_t i = 0; i < modes.size(); ++i)
      if (modes[i]->mode() == mode) return i;
    return std::nullopt;
  }

  std::optional<std::size_t> component_at(const JointVector& q, const WorkingMode& mode) const {
    const auto i = find(mode);
    return i && q.size() == 3 && q.allFinite() ? modes[*i]->component_at(q) : std::nullopt;
  }

  std::optional<std::size_t> region_at(const Pose& pose, const WorkingMode& mode) const {
    const auto i = find(mode);
    const auto region = i ? modes[*i]->region_at(pose) : std::nullopt;
    return region ? std::optional<std::size_t>(first_regions[*i] + *region) : std::nullopt;
  }
};

/// A set of values with solutions, of a mode by its index.
struct SetOfMode {
  std::size_t mode;
  const SolutionSet* set;
};

/// The largest first.
std::vector<SetOfMode> sets_with_solutions(const RegionsOfModes& of) {
  std::vector<SetOfMode> result;
  for (std::size_t i = 0; i < of.modes.size(); ++i)
    for (const SolutionSet& set : of.modes[i]->sets())
      if (set.solutions && !set.solutions->empty()) result.push_back({i, &set});
  std::stable_sort(result.begin(), result.end(),
                   [](const SetOfMode& a, const SetOfMode& b) { return a.set->estimate > b.set->estimate; });
  return result;
}

/// What is known of each number with its share of what is unknown.
void estimate(const std::map<std::size_t, double>& shares, SolutionNumbers& numbers) {
  for (SolutionRegion& region : numbers.regions) region.measure = region.measure_lower;
  for (const auto& [solutions, share] : shares) {
    auto region = std::find_if(numbers.regions.begin(), numbers.regions.end(),
                               [n = solutions](const SolutionRegion& each) { return each.solutions >= n; });
    if (region == numbers.regions.end() || region->solutions != solutions)
      region = numbers.regions.insert(region, {{}, solutions, 0.0, 0.0, numbers.measure_unknown});
    region->measure += share * numbers.measure_unknown;
  }
}

void add_numbers(const RegionsOfModes& of, Uniqueness& result) {
  std::vector<SolutionNumbers> numbers(of.modes.size());
  for (const auto& [i, set] : sets_with_solutions(of)) {
    of.modes[i]->set_component(*set, result.basic_components.size());
    result.basic_components.push_back(of.modes[i]->component(*set));
    add_component(result.basic_components.back(), numbers[i]);
  }
  std::vector<std::map<std::size_t, double>> shares(of.modes.size());
  tbb::parallel_for(std::size_t{0}, shares.size(),
                    [&](std::size_t i) { shares[i] = of.modes[i]->unknown_shares(); });
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    set_unknown(of.modes[i]->unknown(), numbers[i]);
    estimate(shares[i], numbers[i]);
    result.measure_unknown += numbers[i].measure_unknown;
    for (SolutionRegion& region : numbers[i].regions) {
      region.mode = of.modes[i]->mode();
      result.regions.push_back(region);
    }
  }
}

void add_regions(RegionsOfModes& of, Uniqueness& result) {
  FoundRegions found;
  std::size_t sets = 0;
  for (const auto& mode : of.modes) {
    of.first_regions.push_back(found.regions.size());
    append(mode->found(), sets, found);
    for (const FoundRegion& region : mode->found().regions) {
      result.basic_regions.push_back(mode->region(region));
      result.basic_regions.back().over += sets;
    }
    sets += mode->sets().size();
  }
  add_domains(find_uniqueness_domains(found), result);
}

}  // namespace

void find_regions_of_modes(std::size_t most_cells, const MapControl& control, Uniqueness& result) {
  const auto modes = std::make_shared<RegionsOfModes>(result.map, most_cells, control);
  if (is_cancelled(control)) return;
  result.has_regions = result.has_domains = result.by_mode = true;
  result.region_unit = unit_of(modes->modes.front()->values());
  add_numbers(*modes, result);
  add_regions(*modes, result);
  result.component_of = [modes](const JointVector& q, const WorkingMode& mode) {
    return modes->component_at(q, mode);
  };
  result.region_of = [modes](const Pose& pose, const WorkingMode& mode) {
    return modes->region_at(pose, mode);
  };
}

}  // namespace parallel_aspects
