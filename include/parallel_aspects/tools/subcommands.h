// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H
#define PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H

#include "parallel_aspects/tools/command.h"
#include "parallel_aspects/tools/report.h"
#include "parallel_aspects/tools/shipped_robots.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace parallel_aspects::tools {

/// Thrown where a computation ended because of Ctrl-C; caught by `run_command`.
struct Interrupted {};

/// A subcommand: its options, and what it does once they are parsed.
struct Subcommand {
  CLI::App* app = nullptr;
  std::function<Report(const Surroundings&)> run;  ///< throws `InvalidDescription` or `Interrupted`
};

/// Each adds one subcommand to `aspects`.
Subcommand add_map(CLI::App& aspects);
Subcommand add_describe(CLI::App& aspects);
Subcommand add_inverse(CLI::App& aspects);
Subcommand add_direct(CLI::App& aspects);
Subcommand add_robots(CLI::App& aspects);

/// Adds `ROBOT`, `--urdf FILE` and `--config FILE`, which fill `choice`.
void add_robot_options(CLI::App& subcommand, RobotChoice& choice);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H
