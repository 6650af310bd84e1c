// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H
#define PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H

#include "tools/command.h"
#include "tools/report/report.h"
#include "tools/shipped_robots.h"

#include <functional>
#include <stdexcept>
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
Subcommand fields_subcommand();
Subcommand graph_subcommand();
Subcommand inverse_subcommand();
Subcommand jacobian_subcommand();
Subcommand locate_subcommand();
Subcommand direct_subcommand();
Subcommand plan_subcommand();
Subcommand plot_subcommand();
Subcommand robots_subcommand();
Subcommand setup_subcommand();
Subcommand uniqueness_subcommand();
Subcommand sweep_subcommand();
Subcommand merge_subcommand();
Subcommand workspace_subcommand();

/// Subcommands that are asked of serial arms, too, with the options of arms added.
Subcommand arm_describe(Subcommand made);
Subcommand arm_map(Subcommand made);
Subcommand arm_locate(Subcommand made);
Subcommand arm_connect(Subcommand made);
Subcommand arm_inverse(Subcommand made);
Subcommand arm_direct(Subcommand made);
Subcommand arm_uniqueness(Subcommand made);

/// Others, which say that they are not.
Subcommand arm_refused(Subcommand made);

/// What the URDF alone tells of a robot, without a YAML. Throws `InvalidDescription`, `Unanswered` or
/// `Interrupted`.
Report describe_bare(const std::string& urdf_file, const Surroundings& surroundings);

/// `ROBOT`, `--urdf FILE` and `--config FILE`, which fill `choice`.
std::vector<Option> robot_options(RobotChoice& choice);

/// Thrown where a command line is not understood: an argument is missing, unknown, empty or given twice.
/// What is wrong with a value, or with two that do not go together, is an `InvalidDescription`. what() is a
/// message for the user, without a full stop.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The arguments after the subcommand's name: `--name VALUE`, `--name=VALUE`, `--flag` and positional values,
/// in any order. Fills the values and flags of `subcommand`. The argument after `--name` is its value,
/// whatever it looks like, so that negative numbers and modes such as `--` need no quotes; a list goes on
/// over the arguments after it that `Words` says, up to the next option. Behind `--` there are no options.
/// False where one of them asks for help; the rest is then not examined. Throws `UsageError` where an option
/// is not known, given twice, empty, without its value or required and missing.
bool parse_arguments(const Subcommand& subcommand, const std::vector<std::string>& arguments);

/// "; did you mean NAME?" where one of `known` is near, else nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

bool asks_for_help(const std::string& argument);

/// Usage of a subcommand of that program, its arguments and options, each on a line of its own.
std::string help_of(const std::string& program, const Subcommand& subcommand);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SUBCOMMANDS_H
