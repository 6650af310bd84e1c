// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/pose_roadmap.h"

#include <benchmark/benchmark.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace parallel_aspects {
namespace {

struct Segment {
  Pose from, to;
  WorkingMode mode;
};

// Between configurations of one side, taken from the robot's reachable poses.
std::vector<Segment> segments(const std::shared_ptr<const Manipulator>& robot, bool free) {
  const SegmentCertifier certifier(robot);
  test::PosePairs random(robot, 20261121);
  std::vector<Segment> found;
  while (found.size() < 200) {
    const WorkingMode mode = random.mode();
    const Segment segment{random.reached(mode).value(), random.reached(mode).value(), mode};
    if (certifier.prove(segment.from, mode).sign != certifier.prove(segment.to, mode).sign) continue;
    const bool is_free = certifier.prove(segment.from, segment.to, mode).verdict == SegmentVerdict::free;
    if (is_free == free) found.push_back(segment);
  }
  return found;
}

// One segment between random configurations of one side: `free` ones are proved free, others blocked or left
// undecided.
void prove_segment(benchmark::State& state, const std::string& name) {
  const auto robot = test::shipped(name)->manipulator();
  const SegmentCertifier certifier(robot);
  const std::vector<Segment> all = segments(robot, state.range(0) == 1);
  std::size_t i = 0, parts = 0;
  for (auto _ : state) {
    const Segment& segment = all[i++ % all.size()];
    const SegmentProof proof = certifier.prove(segment.from, segment.to, segment.mode);
    parts += static_cast<std::size_t>(proof.parts);
    benchmark::DoNotOptimize(proof);
  }
  state.counters["parts"] = static_cast<double>(parts) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(prove_segment, stewart, "stewart")
    ->Arg(1)
    ->Arg(0)
    ->ArgName("free")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(prove_segment, hexa, "hexa")
    ->Arg(1)
    ->Arg(0)
    ->ArgName("free")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(prove_segment, six_pus, "six_pus")
    ->Arg(1)
    ->Arg(0)
    ->ArgName("free")
    ->Unit(benchmark::kMicrosecond);

// All working modes.
void roadmap(benchmark::State& state, const std::string& name) {
  const auto robot = test::shipped(name)->manipulator();
  RoadmapOptions options;
  options.samples = static_cast<std::size_t>(state.range(0));
  options.threads = static_cast<unsigned>(state.range(1));
  for (auto _ : state) {
    const auto made = compute_pose_roadmap(robot, options).roadmap;
    state.counters["sides"] = static_cast<double>(made->sides().size());
    state.counters["components"] = static_cast<double>(made->component_count());
  }
}
BENCHMARK_CAPTURE(roadmap, stewart, "stewart")
    ->ArgsProduct({{1000, 10000}, {1, 2}})
    ->ArgNames({"samples", "threads"})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(roadmap, hexa, "hexa")
    ->ArgsProduct({{1000}, {1, 2}})
    ->ArgNames({"samples", "threads"})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(roadmap, six_pus, "six_pus")
    ->ArgsProduct({{1000}, {1, 2}})
    ->ArgNames({"samples", "threads"})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Questions about random configurations of one side, over a roadmap of 1,000 poses; with the shares answered.
void same_aspect_of(benchmark::State& state, const std::string& name) {
  const auto robot = test::shipped(name)->manipulator();
  test::PosePairs random(robot, 4);
  RoadmapOptions options;
  options.modes = {random.mode()};
  const auto roadmap = compute_pose_roadmap(robot, options).roadmap;
  std::vector<std::pair<PoseInMode, PoseInMode>> questions;
  while (questions.size() < 100) {
    const WorkingMode mode = options.modes.front();
    const PoseInMode first{random.reached(mode).value(), mode}, second{random.reached(mode).value(), mode};
    if (same_aspect(roadmap->certifier(), first, second).answer != SameAspect::no)
      questions.emplace_back(first, second);
  }
  std::size_t i = 0, yes = 0;
  for (auto _ : state) {
    const auto& question = questions[i++ % questions.size()];
    yes += same_aspect(*roadmap, question.first, question.second).answer == SameAspect::yes;
  }
  state.counters["share_yes"] = static_cast<double>(yes) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(same_aspect_of, stewart, "stewart")->Unit(benchmark::kMillisecond)->Iterations(200);
BENCHMARK_CAPTURE(same_aspect_of, hexa, "hexa")->Unit(benchmark::kMillisecond)->Iterations(200);
BENCHMARK_CAPTURE(same_aspect_of, six_pus, "six_pus")->Unit(benchmark::kMillisecond)->Iterations(200);

// From the cancellation to the end of a computation that would take minutes; the time it had before is the
// argument.
void cancel(benchmark::State& state, const std::string& name) {
  const auto robot = test::shipped(name)->manipulator();
  RoadmapOptions options;
  options.samples = static_cast<std::size_t>(state.range(0));
  double longest = 0.0;
  for (auto _ : state) {
    std::atomic<bool> cancelled{false};
    MapControl control;
    control.cancelled = &cancelled;
    std::thread worker([&] { benchmark::DoNotOptimize(compute_pose_roadmap(robot, options, control)); });
    std::this_thread::sleep_for(std::chrono::milliseconds(state.range(1)));
    const auto start = std::chrono::steady_clock::now();
    cancelled = true;
    worker.join();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    state.SetIterationTime(seconds);
    longest = std::max(longest, seconds);
  }
  state.counters["longest_ms"] = 1e3 * longest;
}
BENCHMARK_CAPTURE(cancel, hexa, "hexa")
    ->ArgsProduct({{3000}, {30, 100, 1000, 3000}})
    ->ArgNames({"samples", "after_ms"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);
BENCHMARK_CAPTURE(cancel, stewart, "stewart")
    ->ArgsProduct({{30000}, {100, 1000, 2000, 4000, 5000, 6000, 7000}})
    ->ArgNames({"samples", "after_ms"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(2);

}  // namespace
}  // namespace parallel_aspects
