// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/mpi_crew.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

namespace parallel_aspects::mpi {
namespace {

constexpr int first = 0;
constexpr int count_tag = 1, head_tag = 2, bytes_tag = 3;

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

std::optional<std::vector<Bytes>> MpiCrew::perform(std::size_t count,
                                                   const std::function<Bytes(std::size_t)>& work,
                                                   const MapControl& control) {
  restart_counter();
  std::vector<Result> mine;
  try {
    for (std::uint64_t task = next_task(); task < count && !is_cancelled(control); task = next_task()) {
      mine.push_back({task, work(task)});
      if (control.progress) control.progress(static_cast<double>(task + 1) / static_cast<double>(count));
    }
  } catch (const std::exception& problem) {
    end_all(rank_, problem.what());
  }
  if (largest(is_cancelled(control) ? 1 : 0) > 0) return std::nullopt;
  std::vector<Bytes> results(is_first() ? count : 0);
  if (!is_first()) send(mine);
  if (!is_first()) return results;
  for (Result& result : mine) results[result.task] = std::move(result.bytes);
  for (int sender = first + 1; sender < size_; ++sender) receive(sender, results);
  return results;
}

void MpiCrew::send(const std::vector<Result>& results) {
  const std::uint64_t count = results.size();
  MPI_Send(&count, 1, MPI_UINT64_T, first, count_tag, MPI_COMM_WORLD);
  for (const Result& result : results) {
    const std::array<std::uint64_t, 2> head{result.task, result.bytes.size()};
    MPI_Send(head.data(), 2, MPI_UINT64_T, first, head_tag, MPI_COMM_WORLD);
    for (std::size_t at = 0; at < result.bytes.size(); at += largest_message)
      MPI_Send(result.bytes.data() + at,
               static_cast<int>(std::min(largest_message, result.bytes.size() - at)), MPI_BYTE, first,
               bytes_tag, MPI_COMM_WORLD);
    bytes_sent_ += sizeof head + result.bytes.size();
  }
}

void MpiCrew::receive(int sender, std::vector<Bytes>& results) const {
  std::uint64_t count = 0;
  MPI_Recv(&count, 1, MPI_UINT64_T, sender, count_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  for (std::uint64_t i = 0; i < count; ++i) {
    std::array<std::uint64_t, 2> head{};
    MPI_Recv(head.data(), 2, MPI_UINT64_T, sender, head_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    Bytes bytes(head[1]);
    for (std::size_t at = 0; at < bytes.size(); at += largest_message)
      MPI_Recv(bytes.data() + at, static_cast<int>(std::min(largest_message, bytes.size() - at)), MPI_BYTE,
               sender, bytes_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    results[head[0]] = std::move(bytes);
  }
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
