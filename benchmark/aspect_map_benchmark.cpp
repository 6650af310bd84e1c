// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"

#include <benchmark/benchmark.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

namespace parallel_aspects {
namespace {

// The paper's five-bar over [-20, 20]^2, all four working modes, everything that `compute_aspect_map`
// reports; with its symmetry and without.
void five_bar_map(benchmark::State& state) {
  const auto robot = test::five_bar();
  MapOptions options;
  options.resolution = 0.1;
  options.region = Box{2, {-20.0, -20.0, 0.0}, {20.0, 20.0, 0.0}};
  options.threads = static_cast<unsigned>(state.range(0));
  options.use_symmetry = state.range(1) != 0;
  for (auto _ : state) benchmark::DoNotOptimize(compute_aspect_map(robot, options).map);
}
BENCHMARK(five_bar_map)
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->ArgNames({"threads", "symmetry"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Time against resolution, in units of a micrometre; the boundary is a curve, so it should double as this
// halves.
void five_bar_map_by_resolution(benchmark::State& state) {
  const auto robot = test::five_bar();
  MapOptions options;
  options.resolution = 1e-6 * static_cast<double>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(compute_aspect_map(robot, options).map);
}
BENCHMARK(five_bar_map_by_resolution)
    ->RangeMultiplier(2)
    ->Range(12500, 400000)
    ->ArgName("um")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void map_once(benchmark::State& state, const std::shared_ptr<const Manipulator>& robot,
              const MapOptions& options) {
  std::shared_ptr<const AspectMap> map;
  for (auto _ : state) map = compute_aspect_map(robot, options).map;
  state.counters["proved"] = static_cast<double>(map->proved_count());
  state.counters["components"] = static_cast<double>(map->aspects().size());
}

// The 3-RRR of Caro et al. in all orientations; its leaves have edges of 0.134 m and 2 pi / 256.
void three_rrr_map(benchmark::State& state) {
  MapOptions options;
  options.resolution = 0.135;
  options.threads = static_cast<unsigned>(state.range(0));
  map_once(state, test::three_rrr(), options);
}
BENCHMARK(three_rrr_map)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

// The shipped Delta, which is symmetric to the last digit, with longer cranks.
void delta_map(benchmark::State& state) {
  std::vector<Leg> legs = test::shipped("delta")->manipulator()->legs();
  for (Leg& leg : legs) std::get<RevoluteActuation>(leg.actuation).radius = 0.35;
  MapOptions options;
  options.resolution = 0.01;
  options.threads = static_cast<unsigned>(state.range(0));
  map_once(state, test::manipulator("delta", TaskSpace::T3, std::move(legs)), options);
}
BENCHMARK(delta_map)->Arg(1)->Arg(2)->ArgName("threads")->Iterations(1)->UseRealTime()->Unit(
    benchmark::kSecond);

// A pose in an inside leaf, and one that needs a proof of its own.
void locate(benchmark::State& state) {
  const auto map = compute_aspect_map(test::five_bar()).map;
  const WorkingMode mode = map->working_modes().front();
  Pose pose;
  pose.position << 5.4, state.range(0) == 0 ? 6.5 : 11.9, 0.0;
  for (auto _ : state) benchmark::DoNotOptimize(map->locate(pose, mode));
}
BENCHMARK(locate)->Arg(0)->Arg(1)->ArgName("near_boundary");

// A saved map, from the file to an `AspectMap` that answers.
void load(benchmark::State& state, const std::shared_ptr<const Manipulator>& robot,
          const MapOptions& options) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / (robot->name() + "_benchmark.map");
  const SaveResult saved = save_map(*compute_aspect_map(robot, options).map, file);
  if (!saved.saved) return state.SkipWithError(saved.message.c_str());
  for (auto _ : state)
    if (!load_map(robot, options, file).map) state.SkipWithError("The map was refused.");
  state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(file));
  std::filesystem::remove(file);
}

void load_five_bar_map(benchmark::State& state) {
  MapOptions options;
  options.resolution = 0.1;
  options.region = Box{2, {-20.0, -20.0, 0.0}, {20.0, 20.0, 0.0}};
  load(state, test::five_bar(), options);
}
BENCHMARK(load_five_bar_map)->Unit(benchmark::kMillisecond);

void load_three_rrr_map(benchmark::State& state) { load(state, test::three_rrr(), {}); }
BENCHMARK(load_three_rrr_map)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parallel_aspects
