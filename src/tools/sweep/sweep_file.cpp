// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <sys/file.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {

SweepFile::SweepFile(const SweepPlan& plan, const Shard& shard, std::string file) : file_(std::move(file)) {
  open();
  const std::string start =
      header_line({fingerprint(plan), plan.count, shard}) + "\n" + column_line(plan) + "\n";
  const std::string text = contents();
  if (text.size() < start.size()) {
    if (start.compare(0, text.size(), text) != 0) refuse("is of another sweep or none");
    write(start.substr(text.size()));
  } else {
    if (text.compare(0, start.size(), start) != 0)
      refuse("is of another robot, command, shard or version of the package");
    take_rows(plan, shard, text, start.size());
  }
}

SweepFile::Descriptor::~Descriptor() {
  if (number >= 0) close(number);
}

void SweepFile::refuse(const std::string& why) const {
  throw InvalidDescription(
      {"'" + file_ + "' " + why + "; it stays as it is. Give another file, or move this one away."});
}

void SweepFile::open() {
  descriptor_.number = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_.number < 0) refuse(std::string("cannot be written: ") + std::strerror(errno));
  if (flock(descriptor_.number, LOCK_EX | LOCK_NB) != 0) refuse("is being written by another process");
}

std::string SweepFile::contents() const {
  std::string text;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t count = read(descriptor_.number, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

// What follows the last line end is of a row that was cut off.
void SweepFile::take_rows(const SweepPlan& plan, const Shard& shard, const std::string& text,
                          std::size_t at) {
  for (std::size_t end = text.find('\n', at); end != std::string::npos; end = text.find('\n', at)) {
    if (rows_ == shard.rows(plan.count)) refuse("has more rows than its sweep");
    const std::string start = row_start(plan, shard.design(rows_));
    if (text.compare(at, start.size(), start) != 0 ||
        !is_row_of(column_line(plan), text.substr(at, end - at)))
      refuse("has another row " + std::to_string(rows_ + 1) + " than its sweep");
    at = end + 1;
    ++rows_;
  }
  if (ftruncate(descriptor_.number, static_cast<off_t>(at)) != 0)
    refuse(std::string("cannot be written: ") + std::strerror(errno));
}

void SweepFile::write(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor_.number, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(std::string("cannot be written: ") + std::strerror(errno));
    done += static_cast<std::size_t>(count);
  }
}

void SweepFile::add(const std::string& row) {
  write(row + "\n");
  ++rows_;
}

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
