// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/tracking/local_motion.h"
#include "parallel_aspects/tracking/roadmap.h"
#include "parallel_aspects/tracking/tracker.h"

#include <benchmark/benchmark.h>

#include "support/shipped.h"
#include "support/tracking_campaign.h"
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

namespace parallel_aspects {
namespace {

double quantile(std::vector<double>& values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// Samples at 1 kHz of a round of five seconds through all freedoms about the pose that the robot was
// assembled in.
std::vector<JointVector> samples_of(const Mechanism& mechanism) {
  const Manipulator& robot = *mechanism.manipulator();
  const AssembledConfiguration start = mechanism.assembled();
  const auto mode = working_mode(robot, start.pose, start.q);
  std::vector<JointVector> samples;
  if (!mode) return samples;
  const auto corners =
      plan_local_motion(robot, start.pose, *mode, [](const Pose&, const JointVector&) { return true; });
  const std::size_t between = 5000 / std::max<std::size_t>(1, corners.size());
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (std::size_t i = 0; i < between; ++i)
      samples.push_back(corners[k] + (corners[k + 1] - corners[k]) * static_cast<double>(i) /
                                         static_cast<double>(between));
  return samples;
}

// One update each; the time of every one is taken, its own cost of some 20 ns included.
void update_of(benchmark::State& state, const char* name) {
  const auto mechanism = test::shipped(name);
  const auto samples = samples_of(*mechanism);
  if (samples.empty()) return state.SkipWithError("no motion was found");
  TrackerOptions options;
  options.samples.check_velocity = false;
  Tracker tracker(mechanism->manipulator(), options);
  if (!tracker.start(0.0, samples[0], mechanism->assembled().pose, 1e-3 * mechanism->manipulator()->size()))
    return state.SkipWithError("the tracker did not start");
  std::vector<double> nanoseconds;
  std::size_t i = 0;
  for (auto _ : state) {
    const JointVector& q = samples[i++ % samples.size()];
    const auto start = std::chrono::steady_clock::now();
    tracker.update(1e-3 * static_cast<double>(i), q);
    const auto end = std::chrono::steady_clock::now();
    nanoseconds.push_back(std::chrono::duration<double, std::nano>(end - start).count());
  }
  if (!tracker.state().followed()) state.SkipWithError("the tracker lost the robot");
  state.counters["median_ns"] = quantile(nanoseconds, 0.5);
  state.counters["p99.9_ns"] = quantile(nanoseconds, 0.999);
}

// With a candidate for every assembly mode of the drives.
void update_of_candidates(benchmark::State& state, const char* name) {
  const auto mechanism = test::shipped(name);
  const auto samples = samples_of(*mechanism);
  if (samples.empty()) return state.SkipWithError("no motion was found");
  TrackerOptions options;
  options.samples.check_velocity = false;
  Tracker tracker(mechanism->manipulator(), options);
  tracker.update(0.0, samples[0]);
  tracker.find_candidates();
  const JointVector step = samples[1] - samples[0];
  std::size_t i = 0;
  for (auto _ : state) {
    const double side = ++i % 2 == 0 ? 0.0 : 1.0;
    tracker.update(1e-3 * static_cast<double>(i), samples[0] + side * step);
  }
  state.counters["candidates"] = static_cast<double>(tracker.candidates().size());
}

const bool registered = [] {
  for (const char* name : test::campaign_robots) {
    benchmark::RegisterBenchmark(("update/" + std::string(name)).c_str(), update_of, name);
    benchmark::RegisterBenchmark(("update_of_candidates/" + std::string(name)).c_str(), update_of_candidates,
                                 name);
  }
  return true;
}();

}  // namespace
}  // namespace parallel_aspects
