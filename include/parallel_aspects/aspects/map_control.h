// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_CONTROL_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_CONTROL_H

#include <atomic>
#include <functional>

namespace parallel_aspects {

/// Hooks into a long computation. Both may be left empty.
struct MapControl {
  std::function<void(double)> progress;  ///< called with the share done, 0 to 1, from the calling thread
  const std::atomic<bool>* cancelled = nullptr;  ///< polled; the computation ends soon after it turns true
};

/// Whether the computation is to end.
inline bool is_cancelled(const MapControl& control) noexcept {
  return control.cancelled != nullptr && control.cancelled->load(std::memory_order_relaxed);
}

/// The control of a part of the work, from one share of the whole to another.
inline MapControl part_of(const MapControl& control, double from, double to) {
  MapControl part = control;
  if (control.progress)
    part.progress = [whole = control.progress, from, to](double share) { whole(from + (to - from) * share); };
  return part;
}

/// How a computation ended.
enum class MapStatus { complete, cancelled, refused };

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_CONTROL_H
