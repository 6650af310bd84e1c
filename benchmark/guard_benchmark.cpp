// SPDX-License-Identifier: BSD-3-Clause
// One call of the guard, in a loop that pushes a robot towards its nearest parallel singularity.
#include <benchmark/benchmark.h>

#include "support/guard_campaign.h"
#include "support/robots/shipped.h"
#include <string>

namespace parallel_aspects {
namespace {

/// From free motion to a stand.
void push(benchmark::State& state, const std::string& name) {
  const auto robot = test::shipped(name)->manipulator();
  const GuardOptions options = test::guard_options_for(*robot);
  test::GuardLoop loop(robot, options);
  test::PosePairs random(robot, 20261123);
  const auto start = test::draw_start(random, loop, Hazard::parallel_singularity, options);
  if (!start) return state.SkipWithError("no start was found");
  const BoundaryDistances measured = loop.measure(start->pose, start->mode);
  const ProvedDistances proved = test::proved_of(measured, start->pose, start->mode);
  const TaskVector twist = 0.2 * robot->size() * measured.parallel.direction;
  MotionGuard guard(robot, options);
  Pose pose = start->pose;
  double time = 0.0;
  for (auto _ : state) {
    const GuardedMotion motion =
        guard.guard(test::tracked_at(*robot, pose, start->mode, time), proved, twist, time);
    pose = displaced(robot->motions(), pose, test::guard_step * motion.twist);
    time += test::guard_step;
  }
}

BENCHMARK_CAPTURE(push, five_bar, "five_bar")->Iterations(2000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(push, three_rrr, "three_rrr")->Iterations(2000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(push, delta, "delta")->Iterations(2000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(push, spherical_3rrr, "spherical_3rrr")->Iterations(2000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(push, stewart, "stewart")->Iterations(2000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace parallel_aspects
