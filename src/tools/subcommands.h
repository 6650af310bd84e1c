// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H
#define PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H

#include "tools/command.h"
#include "tools/report/report.h"
#include "tools/shipped_robots.h"

#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Thrown where a computation ended because of Ctrl-C; caught by `run_command`.
struct Interrupted {};

/// Thrown where only the user can answer a question: what is asked, with candidates. Caught by `run_command`.
struct Unanswered {
  Report report;
};

/// Of how many words of the command line a value is made, and which words go on with it after the first.
enum class Words {
  one,
  numbers,
  assignments,  ///< words with a "="
  signs,        ///< words of "+", "-", parentheses, commas and blanks
  names,        ///< any, once all positional arguments are given
  files,        ///< of a positional argument: any, one a line of the value
};

/// What becomes of the file that an option names. None that is read is written, but that a map may be written
/// over the one that was loaded.
enum class FileUse {
  none,    ///< it names none
  robot,   ///< read, where it is the file of a robot and not the name of one
  read,    ///< likewise
  loaded,  ///< a map
  saved,   ///< a map
  written
};

/// `--name VALUE`, or a positional argument where the name has no dashes. `-o` is `--output` too.
struct Option {
  std::string name;
  std::string placeholder;  ///< stands for the value in the help
  std::string help;
  std::string* value;  ///< where the text goes; untouched where the option is not given
  bool required = false;
  Words words = Words::one;
  FileUse file = FileUse::none;
};

/// `--name` without a value.
struct Flag {
  std::string name;
  std::string help;
  bool* value;  ///< turns true where the flag is given
};

/// A subcommand: its options, and what it does once they are filled.
struct Subcommand {
  std::string name;
  std::string help;
  std::vector<Option> options;
  std::function<Report(const Surroundings&)> run;  ///< throws `InvalidDescription` or `Interrupted`
  std::vector<Flag> flags{};
};

/// A program of subcommands.
struct Program {
  std::string name;         ///< as it is called
  std::string description;  ///< what its help begins with
  std::vector<Subcommand> subcommands;
  std::string footer;  ///< what its help ends with
};

/// Runs a command line of that program and returns its exit code. Throws nothing.
int run_program(Program program, int argc, const char* const* argv,
                const Surroundings& surroundings) noexcept;

Subcommand map_subcommand();
Subcommand chart_subcommand();
Subcommand check_subcommand();
Subcommand choose_subcommand();
Subcommand connect_subcommand();
Subcommand describe_subcommand();
Subcommand distance_subcommand();
Subcommand graph_subcommand();
Subcommand inverse_subcommand();
Subcommand direct_subcommand();
Subcommand plan_subcommand();
Subcommand plot_subcommand();
Subcommand robots_subcommand();
Subcommand setup_subcommand();
Subcommand uniqueness_subcommand();
Subcommand sweep_subcommand();
Subcommand merge_subcommand();
Subcommand workspace_subcommand();

/// What the URDF alone tells of a robot, without a YAML. Throws `InvalidDescription`, `Unanswered` or
/// `Interrupted`.
Report describe_bare(const std::string& urdf_file, const Surroundings& surroundings);

/// `ROBOT`, `--urdf FILE` and `--config FILE`, which fill `choice`.
std::vector<Option> robot_options(RobotChoice& choice);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H
