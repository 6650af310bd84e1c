// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/map_in_shards.h"
#include "mpi/mpi_crew.h"
#include <atomic>
#include <csignal>
#include <iostream>
#include <mpi.h>
#include <sstream>
#include <unistd.h>

namespace {

std::atomic<bool> interrupted{false};

void interrupt(int) { interrupted = true; }

// mpirun passes Ctrl-C on to all processes; the second one ends them at once.
void ask_at_first_interrupt() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

// What is the same in all processes is printed by the first.
int run(int argc, char** argv) {
  parallel_aspects::mpi::MpiCrew crew;
  std::ostringstream nowhere;
  const bool on_terminal = crew.is_first() && isatty(STDERR_FILENO) == 1;
  return parallel_aspects::tools::run_program(
      {"aspects_mpi",
       "Maps of aspects that are larger than one process: mpirun -n N aspects_mpi map ROBOT --folder DIR.",
       {map_in_shards(crew)},
       ""},
      argc, argv,
      {crew.is_first() ? std::cout : nowhere, crew.is_first() ? std::cerr : nowhere, on_terminal,
       &interrupted});
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  ask_at_first_interrupt();
  const int code = run(argc, argv);
  MPI_Finalize();
  return code;
}
