// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

// So far may rows be ahead of one that takes long.
constexpr std::size_t most_waiting = 10'000;

constexpr std::chrono::milliseconds between_looks{100};

/// Rows that are computed in any order, and taken in theirs.
class Rows {
 public:
  Rows(const SweepPlan& plan, const Shard& shard, std::size_t first, const std::atomic<bool>* cancelled)
      : plan_(plan),
        shard_(shard),
        next_(first),
        taken_(first),
        end_(shard.rows(plan.count)),
        outer_(cancelled) {}

  /// Until there are no more; for threads.
  void work() noexcept {
    try {
      while (const auto row = claim()) put(*row, row_of(plan_, shard_.design(*row), {nullptr, &ended_}));
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = std::current_exception();
      ended_ = true;
    }
    changed_.notify_all();
  }

  /// The next row in order; empty at the end, and where it was cancelled. `wait` is called now and then.
  template <class Wait>
  std::string take(const Wait& wait) {
    std::unique_lock<std::mutex> lock(mutex_);
    while (taken_ < end_ && done_.count(taken_) == 0 && !ended_) {
      changed_.wait_for(lock, between_looks);
      if (outer_ != nullptr && outer_->load()) ended_ = true;
      wait();
    }
    const auto found = done_.find(taken_);
    if (found == done_.end()) return "";
    std::string row = std::move(found->second);
    done_.erase(found);
    ++taken_;
    changed_.notify_all();
    return row;
  }

  void end() {
    ended_ = true;
    changed_.notify_all();
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::optional<std::size_t> claim() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ended_ && next_ >= taken_ + most_waiting) changed_.wait_for(lock, between_looks);
    if (ended_ || next_ >= end_) return std::nullopt;
    return next_++;
  }

  void put(std::size_t row, std::string text) {
    if (text.empty()) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    done_.emplace(row, std::move(text));
    changed_.notify_all();
  }

  const SweepPlan& plan_;
  Shard shard_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::size_t, std::string> done_;
  std::size_t next_, taken_, end_;
  const std::atomic<bool>* outer_;
  std::atomic<bool> ended_{false};
  std::exception_ptr failure_;
};

}  // namespace

void run_sweep(const SweepPlan& plan, const Shard& shard, unsigned threads, const MapControl& control,
               const SweepProgress& progress, SweepFile& file) {
  Rows rows(plan, shard, file.rows(), control.cancelled);
  std::vector<std::thread> workers;
  const unsigned count = threads == 0 ? std::max(1U, std::thread::hardware_concurrency()) : threads;
  for (unsigned i = 0; i < count; ++i) workers.emplace_back([&rows] { rows.work(); });
  const auto tell = [&] {
    if (progress) progress(file.rows(), shard.rows(plan.count));
  };
  try {
    for (std::string row = rows.take(tell); !row.empty(); row = rows.take(tell)) file.add(row);
  } catch (...) {
    rows.end();
    for (std::thread& worker : workers) worker.join();
    throw;
  }
  rows.end();
  for (std::thread& worker : workers) worker.join();
  tell();
  rows.rethrow();
}

}  // namespace parallel_aspects::tools
