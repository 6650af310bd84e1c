// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_ARGUMENTS_H
#define PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_ARGUMENTS_H

#include "parallel_aspects/ask/workspace.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "tools/sweep/sweep_file.h"
#include "tools/sweep/sweep_plan.h"

#include <memory>
#include <string>

namespace parallel_aspects::tools {

/// What a sweep varies and reports, as text from the command line; empty where not given. The shape is
/// understood, as that of `aspects workspace`.
struct SweepArguments {
  ask::ShapeQuestion shape{};
  std::string vary, sample, designs, figures, shard, resolution, slice, modes;
  bool untied = false;
};

/// What they say whatever the robot is. Where there are problems it is of no meaning.
SweepPlan parse_sweep(const SweepArguments& arguments, Shard& shard, Problems& problems);

/// The rest, of this robot.
void set_robot(std::shared_ptr<const Manipulator> robot, const SweepArguments& arguments, SweepPlan& plan,
               Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_ARGUMENTS_H
