// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_COMMAND_LINE_H
#define PARALLEL_ASPECTS_TOOLS_COMMAND_LINE_H

#include "tools/subcommands.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

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
/// False where one of them asks for help; the rest is then not looked at. Throws `UsageError` where an option
/// is not known, given twice, empty, without its value or required and missing.
bool parse_arguments(const Subcommand& subcommand, const std::vector<std::string>& arguments);

/// "; did you mean NAME?" where one of `known` is near, else nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

bool asks_for_help(const std::string& argument);

/// Usage of a subcommand of that program, its arguments and options, each on a line of its own.
std::string help_of(const std::string& program, const Subcommand& subcommand);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_COMMAND_LINE_H
