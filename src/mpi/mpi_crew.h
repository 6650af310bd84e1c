// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MPI_MPI_CREW_H
#define PARALLEL_ASPECTS_MPI_MPI_CREW_H

#include "aspects/shards/sharded_map.h"

#include <cstdint>
#include <mpi.h>
#include <vector>

namespace parallel_aspects::mpi {

/// All processes of `mpirun`. Tasks are taken one by one from a counter that the first process holds, so that
/// whoever is done first takes the next. Parts are kept by one process after the other. To be made in all
/// processes at once, and gone before MPI_Finalize.
class MpiCrew final : public ShardCrew {
 public:
  MpiCrew();
  ~MpiCrew() override;
  MpiCrew(const MpiCrew&) = delete;
  MpiCrew& operator=(const MpiCrew&) = delete;

  bool is_first() const override { return rank_ == 0; }
  std::optional<PartResults> perform(std::size_t count, std::size_t parts, const ShardFunction& work,
                                     const MapControl& control) override;
  std::vector<Bytes> gather(std::size_t parts, const PartFunction& work) override;
  Bytes tell_all(Bytes bytes) override;

  int rank() const noexcept { return rank_; }
  int size() const noexcept { return size_; }

  /// Sum of a number over all processes, and the largest.
  std::uint64_t sum(std::uint64_t number) const;
  std::uint64_t largest(std::uint64_t number) const;

  /// What this process has sent to others.
  std::uint64_t bytes_sent() const noexcept { return bytes_sent_; }

 private:
  struct Result {
    std::uint64_t task;
    std::vector<Bytes> parts;
  };

  void restart_counter();
  std::uint64_t next_task();
  int keeper(std::size_t part) const noexcept;
  Bytes kept_by(int keeper, std::vector<Result>& results) const;
  PartResults exchange(std::size_t count, std::size_t parts, std::vector<Result>& mine);
  void send(int to, const Bytes& bytes);
  Bytes receive(int from) const;

  int rank_ = 0, size_ = 1;
  MPI_Win window_{};
  std::uint64_t* counter_ = nullptr;  // in the first process
  std::uint64_t bytes_sent_ = 0;
};

}  // namespace parallel_aspects::mpi

#endif  // PARALLEL_ASPECTS_MPI_MPI_CREW_H
