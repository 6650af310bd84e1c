// SPDX-License-Identifier: BSD-3-Clause
// The metric distance of random reachable configurations, one call at a time on one thread, alone and with
// a map of the default resolution.
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <benchmark/benchmark.h>

#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::size_t configuration_count = 500;

// Of this thread alone, so that a busy machine does not count [s].
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0
                        : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct Configuration {
  Pose pose;
  WorkingMode mode;
};

std::vector<Configuration> configurations(const std::shared_ptr<const Manipulator>& robot) {
  test::PosePairs random(robot, 20261121);
  std::vector<Configuration> found;
  while (found.size() < configuration_count) {
    const WorkingMode mode = random.mode();
    if (const auto pose = random.reached(mode)) found.push_back({*pose, mode});
  }
  return found;
}

/// How one kind of distance came out.
class Tally {
 public:
  void add(const BoundaryDistance& distance) {
    ++all_;
    tight_ += distance.status == DistanceStatus::tight || distance.status == DistanceStatus::absent ||
              distance.status == DistanceStatus::touching;
    no_witness_ += distance.status == DistanceStatus::no_witness;
    unproved_ += std::isfinite(distance.upper) && !distance.upper_proved;
    if (std::isfinite(distance.upper)) ratios_.push_back(distance.lower / distance.upper);
  }

  void report(benchmark::State& state, const std::string& name) const {
    state.counters[name + "_tight_%"] = 100.0 * tight_ / all_;
    state.counters[name + "_no_witness_%"] = 100.0 * no_witness_ / all_;
    state.counters[name + "_unproved_%"] = 100.0 * unproved_ / all_;
    state.counters[name + "_ratio_median"] = quantile(ratios_, 0.5);
    state.counters[name + "_ratio_p10"] = quantile(ratios_, 0.1);
  }

 private:
  double all_ = 0.0, tight_ = 0.0, no_witness_ = 0.0, unproved_ = 0.0;
  std::vector<double> ratios_;
};

/// The map of the meter, and how long its parts took [s].
void use_map(benchmark::State& state, const std::shared_ptr<const Manipulator>& robot,
             BoundaryDistanceMeter& meter) {
  const MapResult computed = compute_aspect_map(robot);
  const auto start = std::chrono::steady_clock::now();
  meter.use(std::make_shared<const DistanceMap>(computed.map));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  state.counters["map_s"] = computed.map->seconds();
  state.counters["made_ready_s"] = taken.count();
}

void measure(benchmark::State& state, const std::string& name, bool with_map) {
  const auto robot = test::shipped(name)->manipulator();
  BoundaryDistanceMeter meter(robot);
  if (with_map) use_map(state, robot, meter);
  std::vector<double> seconds;
  Tally parallel, serial, limit;
  for (auto _ : state) {
    for (const Configuration& configuration : configurations(robot)) {
      const double start = processor_time();
      const BoundaryDistances distances = meter.measure(configuration.pose, configuration.mode);
      seconds.push_back(processor_time() - start);
      parallel.add(distances.parallel);
      serial.add(distances.serial);
      limit.add(distances.actuated_limit);
    }
  }
  state.counters["median_us"] = 1e6 * quantile(seconds, 0.5);
  state.counters["p99.9_us"] = 1e6 * quantile(seconds, 0.999);
  parallel.report(state, "parallel");
  serial.report(state, "serial");
  limit.report(state, "limit");
}

#define PARALLEL_ASPECTS_DISTANCES(robot) \
  BENCHMARK_CAPTURE(measure, robot, #robot, false)->Iterations(1)->Unit(benchmark::kMillisecond)
#define PARALLEL_ASPECTS_DISTANCES_BY_MAP(robot) \
  PARALLEL_ASPECTS_DISTANCES(robot);             \
  BENCHMARK_CAPTURE(measure, robot##_map, #robot, true)->Iterations(1)->Unit(benchmark::kMillisecond)

PARALLEL_ASPECTS_DISTANCES_BY_MAP(five_bar);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(bipod);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(three_rpr);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(three_rrr);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(three_prr);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(delta);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(linear_delta);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(agile_eye);
PARALLEL_ASPECTS_DISTANCES_BY_MAP(spherical_3rrr);
PARALLEL_ASPECTS_DISTANCES(stewart);
PARALLEL_ASPECTS_DISTANCES(hexa);
PARALLEL_ASPECTS_DISTANCES(six_pus);

}  // namespace
}  // namespace parallel_aspects
