// SPDX-License-Identifier: BSD-3-Clause
//
// How long the computation of a map goes on after it was cancelled, at moments spread over all its phases.
//   map_cancelling ROBOT SECONDS [CANCELS]     SECONDS: over which the moments are spread
#include "parallel_aspects/aspects/aspect_map.h"

#include "support/robots/shipped.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "map_cancelling ROBOT SECONDS [CANCELS]\n");
    return EXIT_FAILURE;
  }
  const double span = std::atof(argv[2]);
  const int cancels = argc > 3 ? std::atoi(argv[3]) : 10;
  const auto robot = parallel_aspects::test::shipped(argv[1])->manipulator();
  double worst = 0.0, worst_share = 0.0;
  for (int i = 0; i < cancels; ++i) {
    std::atomic<bool> cancelled{false};
    std::atomic<double> share{0.0};
    Clock::time_point asked;
    std::thread canceller([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>(span * (i + 0.5) / cancels));
      asked = Clock::now();
      cancelled = true;
    });
    parallel_aspects::MapControl control;
    control.cancelled = &cancelled;
    control.progress = [&](double done) { share = done; };
    const auto result = parallel_aspects::compute_aspect_map(robot, {}, control);
    const Clock::time_point ended = Clock::now();
    canceller.join();
    if (result.status != parallel_aspects::MapStatus::cancelled) continue;
    const double late = milliseconds(ended - asked);
    std::printf("%s: cancelled at %3.0f %%, ended %.0f ms later\n", argv[1], 100.0 * share, late);
    if (late > worst) worst_share = share;
    worst = std::max(worst, late);
  }
  std::printf("%s: at worst %.0f ms, at %.0f %%\n", argv[1], worst, 100.0 * worst_share);
}
