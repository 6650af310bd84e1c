// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/mpi_crew.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

namespace parallel_aspects::mpi {
namespace {

constexpr int first = 0;
constexpr int size_tag = 1, bytes_tag = 2;

// MPI counts in int.
constexpr std::size_t largest_message = std::size_t{1} << 30;

/// A fault of one process alone, such as a full disk: the others would wait for it for ever.
[[noreturn]] void end_all(int rank, const char* why) {
  std::fprintf(stderr, "Process %d ends all: %s\n", rank, why);
  MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  std::abort();
}

}  // namespace

MpiCrew::MpiCrew() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  const MPI_Aint size = rank_ == first ? sizeof(std::uint64_t) : 0;
  MPI_Win_allocate(size, sizeof(std::uint64_t), MPI_INFO_NULL, MPI_COMM_WORLD, &counter_, &window_);
  MPI_Win_lock_all(0, window_);
}

MpiCrew::~MpiCrew() {
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

void MpiCrew::restart_counter() {
  if (is_first()) {
    const std::uint64_t zero = 0;
    MPI_Accumulate(&zero, 1, MPI_UINT64_T, first, 0, 1, MPI_UINT64_T, MPI_REPLACE, window_);
    MPI_Win_flush(first, window_);
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

std::uint64_t MpiCrew::next_task() {
  const std::uint64_t one = 1;
  std::uint64_t task = 0;
  MPI_Fetch_and_op(&one, &task, MPI_UINT64_T, first, 0, MPI_SUM, window_);
  MPI_Win_flush(first, window_);
  return task;
}

std::optional<PartResults> MpiCrew::perform(std::size_t count, std::size_t parts, const ShardFunction& work,
                                            const MapControl& control) {
  restart_counter();
  std::vector<Result> mine;
  try {
    for (std::uint64_t task = next_task(); task < count && !is_cancelled(control); task = next_task()) {
      mine.push_back({task, work(task)});
      if (control.progress) control.progress(static_cast<double>(task + 1) / static_cast<double>(count));
    }
    if (largest(is_cancelled(control) ? 1 : 0) > 0) return std::nullopt;
    return exchange(count, parts, mine);
  } catch (const std::exception& problem) {
    end_all(rank_, problem.what());
  }
}

std::vector<Bytes> MpiCrew::gather(std::size_t parts, const PartFunction& work) {
  std::vector<Bytes> results(parts);
  try {
    for (std::size_t part = 0; part < parts; ++part)
      if (keeper(part) == rank_) results[part] = work(part);
    for (std::size_t part = 0; part < parts; ++part) {
      if (keeper(part) == first) continue;
      if (keeper(part) == rank_) send(first, results[part]);
      if (is_first()) results[part] = receive(keeper(part));
    }
  } catch (const std::exception& problem) {
    end_all(rank_, problem.what());
  }
  return is_first() ? results : std::vector<Bytes>();
}

int MpiCrew::keeper(std::size_t part) const noexcept {
  return static_cast<int>(part % static_cast<std::size_t>(size_));
}

/// What is of the parts of one process, which is let go of.
Bytes MpiCrew::kept_by(int keeper, std::vector<Result>& results) const {
  ByteWriter writer;
  for (Result& result : results)
    for (std::size_t part = 0; part < result.parts.size(); ++part) {
      if (this->keeper(part) != keeper || result.parts[part].empty()) continue;
      writer.put_u64(result.task);
      writer.put_u64(part);
      writer.put_u64(result.parts[part].size());
      writer.put_bytes(std::exchange(result.parts[part], {}));
    }
  return writer.bytes();
}

// All go through the pairs of processes in the same order, so that none waits for one that waits for it.
PartResults MpiCrew::exchange(std::size_t count, std::size_t parts, std::vector<Result>& mine) {
  PartResults results(parts);
  for (std::size_t part = 0; part < parts; ++part)
    if (keeper(part) == rank_) results[part].resize(count);
  const int keepers = static_cast<int>(std::min(parts, static_cast<std::size_t>(size_)));
  for (int sender = first; sender < size_; ++sender)
    for (int to = first; to < keepers; ++to) {
      if (rank_ != sender && rank_ != to) continue;
      Bytes bytes = rank_ == sender ? kept_by(to, mine) : receive(sender);
      if (rank_ == sender && rank_ != to) send(to, std::exchange(bytes, {}));
      ByteReader reader(bytes.data(), bytes.size());
      while (reader.left() > 0) {
        const std::uint64_t task = reader.take_u64(), part = reader.take_u64();
        results[part][task] = reader.take_bytes(reader.take_u64());
      }
    }
  return results;
}

void MpiCrew::send(int to, const Bytes& bytes) {
  const std::uint64_t size = bytes.size();
  MPI_Send(&size, 1, MPI_UINT64_T, to, size_tag, MPI_COMM_WORLD);
  for (std::size_t at = 0; at < bytes.size(); at += largest_message)
    MPI_Send(bytes.data() + at, static_cast<int>(std::min(largest_message, bytes.size() - at)), MPI_BYTE, to,
             bytes_tag, MPI_COMM_WORLD);
  bytes_sent_ += sizeof size + bytes.size();
}

Bytes MpiCrew::receive(int from) const {
  std::uint64_t size = 0;
  MPI_Recv(&size, 1, MPI_UINT64_T, from, size_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  Bytes bytes(size);
  for (std::size_t at = 0; at < bytes.size(); at += largest_message)
    MPI_Recv(bytes.data() + at, static_cast<int>(std::min(largest_message, bytes.size() - at)), MPI_BYTE,
             from, bytes_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return bytes;
}

Bytes MpiCrew::tell_all(Bytes bytes) {
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, first, MPI_COMM_WORLD);
  bytes.resize(size);
  for (std::size_t at = 0; at < bytes.size(); at += largest_message)
    MPI_Bcast(bytes.data() + at, static_cast<int>(std::min(largest_message, bytes.size() - at)), MPI_BYTE,
              first, MPI_COMM_WORLD);
  if (is_first()) bytes_sent_ += bytes.size() * static_cast<std::uint64_t>(size_ - 1);
  return bytes;
}

std::uint64_t MpiCrew::sum(std::uint64_t number) const {
  std::uint64_t total = 0;
  MPI_Allreduce(&number, &total, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return total;
}

std::uint64_t MpiCrew::largest(std::uint64_t number) const {
  std::uint64_t found = 0;
  MPI_Allreduce(&number, &found, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  return found;
}

}  // namespace parallel_aspects::mpi
