// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "support/many_joints.h"
#include "support/robots/shipped.h"

namespace parallel_aspects {
namespace {

// URDF and YAML of a robot, from text to a recognised and proved mechanism.
void load(benchmark::State& state, const test::Description& description) {
  for (auto _ : state) benchmark::DoNotOptimize(test::load(description));
}

void load_hexapod_of_200_joints(benchmark::State& state) {
  load(state, test::HexapodOf200Joints().description());
}
BENCHMARK(load_hexapod_of_200_joints)->Unit(benchmark::kMillisecond);

void load_shipped(benchmark::State& state, const char* robot) { load(state, test::shipped_text(robot)); }
BENCHMARK_CAPTURE(load_shipped, five_bar, "five_bar")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_shipped, delta, "delta")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_shipped, agile_eye, "agile_eye")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load_shipped, hexa, "hexa")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parallel_aspects
