// SPDX-License-Identifier: BSD-3-Clause
#include "motion/demo_rounds.h"
#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <benchmark/benchmark.h>

#include "support/robots/shipped.h"
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

struct Round {
  Pose start;
  std::vector<JointVector> samples;  // of the actuated joints, at 1 kHz
};

// A round of five seconds through all degrees of freedom about the first random pose that leaves room for
// one.
Round round_of(const Mechanism& mechanism) {
  const Manipulator& robot = *mechanism.manipulator();
  test::RandomRobots random(1);
  const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot.task_space()));
  Round round;
  for (int i = 0; i < 2000; ++i) {
    TaskVector step(static_cast<Eigen::Index>(robot.leg_count()));
    for (Eigen::Index k = 0; k < step.size(); ++k)
      step[k] = random.uniform(-1.0, 1.0) * (k < turns ? 0.2 : 0.1 * robot.size());
    round.start = displaced(robot.motions(), mechanism.assembled().pose, step);
    for (const WorkingMode& mode : working_modes(robot)) {
      const auto corners =
          plan_local_motion(robot, round.start, mode, [](const Pose&, const JointVector&) { return true; });
      if (corners.size() < 2) continue;
      const std::size_t between = 5000 / (corners.size() - 1);
      for (std::size_t k = 0; k + 1 < corners.size(); ++k)
        for (std::size_t n = 0; n < between; ++n)
          round.samples.push_back(corners[k] + (corners[k + 1] - corners[k]) * static_cast<double>(n) /
                                                   static_cast<double>(between));
      return round;
    }
  }
  return round;
}

// One update each; the time of every one is taken, its own cost of some 20 ns included.
void update_of(benchmark::State& state, const char* name) {
  const auto mechanism = test::shipped(name);
  const auto [start_pose, samples] = round_of(*mechanism);
  if (samples.empty()) return state.SkipWithError("no motion was found");
  TrackerOptions options;
  options.samples.check_velocity = false;
  Tracker tracker(mechanism->manipulator(), options);
  if (!tracker.start_near(0.0, samples[0], start_pose, 1e-3 * mechanism->manipulator()->size()))
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

// With a candidate for every assembly mode of the actuated joints.
void update_of_candidates(benchmark::State& state, const char* name) {
  const auto mechanism = test::shipped(name);
  const std::vector<JointVector> samples = round_of(*mechanism).samples;
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
