// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_COMMAND_H
#define PARALLEL_ASPECTS_TOOLS_COMMAND_H

#include <atomic>
#include <functional>
#include <istream>
#include <ostream>

namespace parallel_aspects::tools {

/// Exit codes of the command.
namespace exit_code {
inline constexpr int ok = 0;
inline constexpr int bad_input = 1;     ///< the robot, a file or a value was refused
inline constexpr int bad_usage = 2;     ///< the command line was not understood, or an argument is missing
inline constexpr int needs_answer = 3;  ///< `setup`: a question is open that only the user can answer
inline constexpr int proved_no = 3;   ///< `check`, `choose`, `plan`: no, proved; `check`: or too fast, proved
inline constexpr int not_proved = 4;  ///< `check`, `choose`, `plan`: neither yes nor no is proved
inline constexpr int interrupted = 130;  ///< by Ctrl-C
}  // namespace exit_code

/// What the command talks to.
struct Surroundings {
  std::ostream& output;                            ///< results, complete or not at all
  std::ostream& messages;                          ///< problems, one a line, and the progress bar
  bool messages_on_terminal = false;               ///< whether to draw a progress bar
  const std::atomic<bool>* interrupted = nullptr;  ///< turns true at Ctrl-C
  std::istream* answers = nullptr;                 ///< a terminal where questions may be asked; null for none
  bool json = false;                               ///< whether the result is to be JSON
};

/// Runs the command line `aspects ...` and returns its exit code. Throws nothing.
int run_command(int argc, const char* const* argv, const Surroundings& surroundings) noexcept;

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_COMMAND_H
