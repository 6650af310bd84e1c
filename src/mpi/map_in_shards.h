// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MPI_MAP_IN_SHARDS_H
#define PARALLEL_ASPECTS_MPI_MAP_IN_SHARDS_H

#include "tools/subcommands.h"

#include "mpi/mpi_crew.h"

namespace parallel_aspects::mpi {

/// `map` of `aspects_mpi`. The crew must outlive it.
tools::Subcommand map_in_shards(MpiCrew& crew);

}  // namespace parallel_aspects::mpi

#endif  // PARALLEL_ASPECTS_MPI_MAP_IN_SHARDS_H
