// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_PROCESSOR_CLOCK_H
#define PARALLEL_ASPECTS_URDF_SETUP_PROCESSOR_CLOCK_H

#include <chrono>
#include <ctime>

namespace parallel_aspects {

/// Processor time of the calling thread. What a search finds within it does not depend on what else runs.
struct ProcessorClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<ProcessorClock>;
  static constexpr bool is_steady = true;

  static time_point now() noexcept {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time_point(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_PROCESSOR_CLOCK_H
