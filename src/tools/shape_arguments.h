// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SHAPE_ARGUMENTS_H
#define PARALLEL_ASPECTS_TOOLS_SHAPE_ARGUMENTS_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/regular_workspace.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "tools/subcommands.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Which regular workspace is looked for, as text from the command line; empty where not given.
struct ShapeArguments {
  std::string name, center, ratio, angle, gap;
};

/// `--shape`, `--center`, `--aspect-ratio`, `--orientation` and `--gap`, which fill `arguments`.
std::vector<Option> shape_options(ShapeArguments& arguments, bool is_required);

/// The question; where there are problems it is of no meaning.
WorkspaceQuestion parse_shape(const ShapeArguments& arguments, const Manipulator& manipulator,
                              const std::optional<MapSlice>& slice, Problems& problems);

/// The gap between the bounds of the size, of the upper one.
double parse_gap(const ShapeArguments& arguments, Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SHAPE_ARGUMENTS_H
