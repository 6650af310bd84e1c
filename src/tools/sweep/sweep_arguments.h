// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_ARGUMENTS_H
#define PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_ARGUMENTS_H

#include "parallel_aspects/ask/workspace.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "tools/sweep/sweep_file.h"
#include "tools/sweep/sweep_plan.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// All values, for whoever reads one by its name.
inline constexpr std::array<SweepSample, 2> choices(SweepSample /*tag*/) {
  return {SweepSample::grid, SweepSample::sobol};
}
/// "grid" or "sobol".
inline const char* name(SweepSample sample) { return sample == SweepSample::grid ? "grid" : "sobol"; }

/// What a sweep varies and reports.
struct SweepArguments {
  std::string vary{};                                    ///< as of `parse_varied`
  std::optional<SweepSample> sample{};                   ///< by default grid
  std::optional<ask::Count<1, most_designs>> designs{};  ///< of sobol
  std::string figures{}, shard{};                        ///< by default the count, and all of it
  std::optional<double> resolution{};                    ///< of each map
  std::optional<MapSlice> slice{};                       ///< likewise
  std::vector<WorkingMode> modes{};                      ///< likewise
  bool untied = false;                                   ///< whether symmetries tie no parameters
  ask::ShapeQuestion shape{};                            ///< of the workspace
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, SweepArguments& arguments) {
  visit(
      {"vary", "\"crank_1=0.2:0.4:21 rod=1\"",
       "Lengths and points by name, as `aspects describe` lists them: a value, or a range with the number of "
       "its values [m]"},
      arguments.vary);
  visit({"sample", "NAME", "grid, which is the default, or sobol"}, arguments.sample);
  visit({"designs", "N", "How many designs of {sample} sobol"}, arguments.designs);
  visit({"report", "LIST",
         "What to report of each design: count, which is the default, measures, clearance, workspace"},
        arguments.figures);
  visit({"shard", "i/n", "This part of the designs alone, i from 1; `aspects merge` joins them"},
        arguments.shard);
  visit({"resolution", "R", "Of each map [m or rad]; by default what suits each design"},
        arguments.resolution);
  visit({"slice", "\"z=1\"", "Map what holds these coordinates alone, as of `aspects map`"}, arguments.slice);
  visit({"mode", "\"(+,-)\"", "Map these working modes only"}, arguments.modes);
  visit({"untied", "", "Vary parameters alone that symmetries of the robot tie to each other"},
        arguments.untied);
  describe(visit, arguments.shape);
}

/// All designs of this robot, and which part of them. Where there are problems, which write fields by `name`,
/// it is of no meaning.
SweepPlan plan_sweep(std::shared_ptr<const Manipulator> robot, const SweepArguments& arguments,
                     const ask::FieldName& name, Shard& shard, Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_ARGUMENTS_H
