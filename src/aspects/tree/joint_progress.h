// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_JOINT_PROGRESS_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_JOINT_PROGRESS_H

#include "parallel_aspects/aspects/map_slice.h"

#include <atomic>
#include <cstddef>
#include <numeric>
#include <thread>
#include <vector>

namespace parallel_aspects {

/// Progress of equal parts of the work that run at the same time. The thread that made this reports it, while
/// it works on one of them.
class JointProgress {
 public:
  /// The control of the whole must outlive it.
  JointProgress(const MapControl& whole, std::size_t parts) : whole_(whole), shares_(parts) {}

  MapControl of(std::size_t part) {
    MapControl control = whole_;
    if (whole_.progress) control.progress = [this, part](double share) { report(part, share); };
    return control;
  }

 private:
  void report(std::size_t part, double share) {
    shares_[part] = share;
    if (std::this_thread::get_id() != thread_) return;
    const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.0);
    whole_.progress(sum / static_cast<double>(shares_.size()));
  }

  const MapControl& whole_;
  const std::thread::id thread_ = std::this_thread::get_id();
  std::vector<std::atomic<double>> shares_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_JOINT_PROGRESS_H
