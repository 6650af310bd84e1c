// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"

#include <benchmark/benchmark.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/round_trip.h"
#include <algorithm>
#include <ctime>
#include <vector>

namespace parallel_aspects {
namespace {

using RobotMaker = std::shared_ptr<const Manipulator> (*)();

Pose above(double z) {
  Pose pose;
  pose.position.z() = z;
  return pose;
}

void inverse_in_all_modes_of(benchmark::State& state, RobotMaker make, double z) {
  const auto robot = make();
  for (auto _ : state) benchmark::DoNotOptimize(inverse_in_all_modes(*robot, above(z)));
}
BENCHMARK_CAPTURE(inverse_in_all_modes_of, delta, test::delta, -0.6);
BENCHMARK_CAPTURE(inverse_in_all_modes_of, hexa, test::hexa, -0.5);
BENCHMARK_CAPTURE(inverse_in_all_modes_of, stewart, test::stewart, 0.6);

void six_solutions_of_a_3rpr(benchmark::State& state) {
  const auto robot = test::three_rpr();
  JointVector q(3);
  q << 14.98, 15.38, 12.0;
  std::size_t solutions = 0;
  for (auto _ : state) solutions = direct(*robot, q).solutions.size();
  state.counters["solutions"] = static_cast<double>(solutions);
}
BENCHMARK(six_solutions_of_a_3rpr)->Unit(benchmark::kMicrosecond);

void forty_solutions_of_dietmaier(benchmark::State& state) {
  const auto robot = test::dietmaier();
  std::size_t solutions = 0;
  for (auto _ : state) solutions = direct(*robot, test::dietmaier_lengths()).solutions.size();
  state.counters["solutions"] = static_cast<double>(solutions);
}
BENCHMARK(forty_solutions_of_dietmaier)->Unit(benchmark::kMillisecond);

// Measured one by one, for the median and the 99th percentile [s]; of this thread alone, so that a busy
// machine does not count.
class Times {
 public:
  template <class Function>
  void measure(const Function& function) {
    const double start = processor_time();
    function();
    seconds_.push_back(processor_time() - start);
  }

  double quantile(double share) {
    std::sort(seconds_.begin(), seconds_.end());
    return seconds_.empty()
               ? 0.0
               : seconds_[static_cast<std::size_t>(share * static_cast<double>(seconds_.size() - 1))];
  }

 private:
  static double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  std::vector<double> seconds_;
};

void report(benchmark::State& state, const test::RoundTrips& trips, Times& times) {
  state.counters["made"] = trips.made;
  state.counters["missed"] = trips.missed;
  state.counters["unsolved"] = trips.unsolved;
  state.counters["continuum"] = trips.continuum;
  state.counters["median_ms"] = 1e3 * times.quantile(0.5);
  state.counters["p99_ms"] = 1e3 * times.quantile(0.99);
  state.counters["longest_ms"] = 1e3 * times.quantile(1.0);
  if (!trips.first_miss.empty()) state.SetLabel(trips.first_miss);
}

constexpr int round_trip_count = 10000;

// Pose -> actuated joints -> all direct solutions, 10,000 times; `missed` are those that do not contain the
// pose and do not say that they are incomplete.
void round_trips_of(benchmark::State& state, RobotMaker make, Pose home, double spread) {
  const auto robot = make();
  const auto modes = working_modes(*robot);
  test::RoundTrips trips;
  Times times;
  for (auto _ : state) {
    test::RandomRobots random(20260106);
    while (trips.made < round_trip_count) {
      Pose pose = random.pose(robot->task_space(), spread);
      pose.position += home.position;
      const auto pick = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(modes.size())));
      const InverseSolution solution = inverse(*robot, pose, modes[std::min(pick, modes.size() - 1)]);
      if (solution.status == InverseStatus::out_of_reach) continue;
      times.measure([&] { test::count_round_trip(*robot, pose, solution.q, trips); });
    }
  }
  report(state, trips, times);
}

// A pose within three tenths of the robot's size of where it was assembled, turned by up to half a turn.
Pose random_pose(const Mechanism& mechanism, test::RandomRobots& random) {
  const Manipulator& robot = *mechanism.manipulator();
  const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot.task_space()));
  TaskVector step(static_cast<Eigen::Index>(robot.leg_count()));
  for (Eigen::Index k = 0; k < step.size(); ++k)
    step[k] = random.uniform(-1.0, 1.0) * (k < turns ? EIGEN_PI : 0.3 * robot.size());
  return displaced(robot.motions(), mechanism.assembled().pose, step);
}

// The robots as they are shipped, from their URDF, in random working modes.
void round_trips_of_shipped(benchmark::State& state, const char* name) {
  const auto mechanism = test::shipped(name);
  const Manipulator& robot = *mechanism->manipulator();
  const auto modes = working_modes(robot);
  test::RoundTrips trips;
  Times times;
  for (auto _ : state) {
    test::RandomRobots random(20260108);
    while (trips.made < round_trip_count) {
      const Pose pose = random_pose(*mechanism, random);
      const auto pick = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(modes.size())));
      const InverseSolution solution = inverse(robot, pose, modes[std::min(pick, modes.size() - 1)]);
      if (solution.status == InverseStatus::out_of_reach) continue;
      times.measure([&] { test::count_round_trip(robot, pose, solution.q, trips); });
    }
  }
  report(state, trips, times);
}

// A new platform of general geometry for each pose.
void round_trips_of_general_platforms(benchmark::State& state) {
  test::RoundTrips trips;
  Times times;
  for (auto _ : state) {
    test::RandomRobots random(20260107);
    while (trips.made < round_trip_count) {
      const auto robot = random.robot(TaskSpace::SE3, test::ActuationKind::strut);
      const Pose pose = random.pose(TaskSpace::SE3);
      const JointVector q = inverse(*robot, pose, working_modes(*robot)[0]).q;
      times.measure([&] { test::count_round_trip(*robot, pose, q, trips); });
    }
  }
  report(state, trips, times);
}

#define PARALLEL_ASPECTS_ROUND_TRIPS(robot, z, spread)                    \
  BENCHMARK_CAPTURE(round_trips_of, robot, test::robot, above(z), spread) \
      ->Unit(benchmark::kSecond)                                          \
      ->Iterations(1)

PARALLEL_ASPECTS_ROUND_TRIPS(five_bar, 0.0, 15.0);
PARALLEL_ASPECTS_ROUND_TRIPS(bipod, 0.0, 9.0);
PARALLEL_ASPECTS_ROUND_TRIPS(three_rpr, 0.0, 30.0);
PARALLEL_ASPECTS_ROUND_TRIPS(three_rrr, 0.0, 25.0);
PARALLEL_ASPECTS_ROUND_TRIPS(three_rrr_actuated_elbow, 0.0, 25.0);
PARALLEL_ASPECTS_ROUND_TRIPS(three_prr, 0.0, 0.8);
PARALLEL_ASPECTS_ROUND_TRIPS(delta, -0.6, 0.8);
PARALLEL_ASPECTS_ROUND_TRIPS(linear_delta, 0.0, 0.4);
PARALLEL_ASPECTS_ROUND_TRIPS(agile_eye, 0.0, 1.0);
PARALLEL_ASPECTS_ROUND_TRIPS(spherical_three_rrr, 0.0, 1.0);
PARALLEL_ASPECTS_ROUND_TRIPS(dietmaier, 0.0, 1.0);
PARALLEL_ASPECTS_ROUND_TRIPS(planar_stewart, 0.6, 0.3);
PARALLEL_ASPECTS_ROUND_TRIPS(stewart, 0.6, 0.3);
PARALLEL_ASPECTS_ROUND_TRIPS(octahedral_stewart, 0.6, 0.3);
PARALLEL_ASPECTS_ROUND_TRIPS(hexa, -0.5, 0.3);
PARALLEL_ASPECTS_ROUND_TRIPS(six_pus, 0.6, 0.2);
#define PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(robot) \
  BENCHMARK_CAPTURE(round_trips_of_shipped, robot, #robot)->Unit(benchmark::kSecond)->Iterations(1)

PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(five_bar);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(bipod);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(three_rrr);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(three_rpr);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(three_prr);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(delta);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(linear_delta);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(hexa);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(stewart);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(six_pus);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(agile_eye);
PARALLEL_ASPECTS_SHIPPED_ROUND_TRIPS(spherical_3rrr);
BENCHMARK(round_trips_of_general_platforms)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace parallel_aspects
