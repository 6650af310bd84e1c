// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include <atomic>
#include <csignal>
#include <iostream>
#include <unistd.h>

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only set a lock-free flag");

void interrupt(int) { interrupted = true; }

// The second Ctrl-C ends the program at once.
void ask_at_first_interrupt() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  ask_at_first_interrupt();
  const bool messages_on_terminal = isatty(STDERR_FILENO) == 1;
  std::istream* answers = messages_on_terminal && isatty(STDIN_FILENO) == 1 ? &std::cin : nullptr;
  return parallel_aspects::tools::run_command(
      argc, argv, {std::cout, std::cerr, messages_on_terminal, &interrupted, answers});
}
