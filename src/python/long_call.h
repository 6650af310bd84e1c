// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PYTHON_LONG_CALL_H
#define PARALLEL_ASPECTS_PYTHON_LONG_CALL_H

#include "parallel_aspects/aspects/map_control.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <pybind11/pybind11.h>

namespace parallel_aspects::python {

/// What a computation in another thread and the thread of Python's call tell each other.
struct LongCall {
  std::atomic<bool> cancelled{false};
  std::atomic<double> share{0.0};  ///< done, 0 to 1

  MapControl control() {
    return {[this](double done) { share = done; }, &cancelled};
  }
};

/// Waits for a computation without the interpreter's lock. Now and then it takes the lock to ask for signals
/// and to call `progress(share)`, which may be None. What these raise, as KeyboardInterrupt at Ctrl-C,
/// cancels the computation and is raised once that has ended. `is_done` waits for so long at most.
void attend(LongCall& call, const pybind11::object& progress,
            const std::function<bool(std::chrono::milliseconds)>& is_done);

/// `compute(const MapControl&)` in a thread of its own, attended. It must not touch Python. What it throws is
/// thrown.
template <class Compute>
auto run_long(const pybind11::object& progress, const Compute& compute) {
  LongCall call;
  auto result = std::async(std::launch::async, [&] { return compute(call.control()); });
  attend(call, progress, [&result](std::chrono::milliseconds most) {
    return result.wait_for(most) == std::future_status::ready;
  });
  return result.get();
}

}  // namespace parallel_aspects::python

#endif  // PARALLEL_ASPECTS_PYTHON_LONG_CALL_H
