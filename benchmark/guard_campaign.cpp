// SPDX-License-Identifier: BSD-3-Clause
//
// Prints the table of docs/development/benchmarks.md: every shipped robot, pushed into each kind of hazard at
// 500 Hz. Usage: guard_campaign RUNS SEED [ROBOT...]
#include "support/guard_campaign.h"

#include "support/robots/shipped.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

struct Row {
  int runs = 0, below = 0, turns = 0, inside = 0, deeper = 0, left = 0;
  double over = std::numeric_limits<double>::infinity();
  std::vector<double> ends, times;
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

TaskVector random_aside(const Manipulator& robot, const TaskVector& towards, test::PosePairs& random,
                        double share) {
  TaskVector aside = TaskVector::Zero(static_cast<Eigen::Index>(robot.leg_count()));
  if (towards.size() == 0) return aside;
  for (Eigen::Index i = 0; i < aside.size(); ++i) aside[i] = share * random.uniform(-1.0, 1.0);
  aside.head(static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot.task_space()))) /=
      robot.characteristic_length();
  return aside;
}

// From below the threshold, first further in, then out.
void leave(test::GuardLoop& loop, const test::GuardStart& start, Hazard hazard, const GuardOptions& options,
           Row& row) {
  const double stop = options.stop[static_cast<std::size_t>(hazard)];
  const auto inside = test::pose_before(loop, start, hazard, 0.6 * stop);
  if (!inside) return;
  const TaskVector none =
      TaskVector::Zero(test::distance_to(loop.measure(*inside, start.mode), hazard).direction.size());
  const test::GuardRun in = loop.push(*inside, start.mode, hazard, 5.0 * stop, 0.2, options.latency, none, 1);
  const test::GuardRun out =
      loop.push(*inside, start.mode, hazard, 5.0 * stop, 3.0, options.latency, none, 1, -1.0);
  ++row.inside;
  row.deeper += in.lost || in.least_gain < -1e-3 * stop;
  row.left += !out.lost && out.last > stop;
}

Row push(const std::shared_ptr<const Manipulator>& robot, Hazard hazard, int runs, std::uint64_t seed) {
  const GuardOptions options = test::guard_options_for(*robot);
  test::GuardLoop loop(robot, options);
  test::PosePairs random(robot, seed);
  Row row;
  for (int i = 0; i < runs; ++i) {
    const auto start = test::draw_start(random, loop, hazard, options);
    if (!start) continue;
    const double delays[] = {0.0, options.latency, -options.latency};
    const BoundaryDistances from = loop.measure(start->pose, start->mode);
    const TaskVector aside =
        random_aside(*robot, test::distance_to(from, hazard).direction, random, i % 2 == 0 ? 0.0 : 1.0);
    const test::GuardRun run = loop.push(start->pose, start->mode, hazard, 0.2 * robot->size(), 3.0,
                                         delays[i % 3], aside, seed + static_cast<std::uint64_t>(i));
    ++row.runs;
    row.below += run.lost || run.over < 0.0;
    row.over = std::min(row.over, run.over);
    row.turns = std::max(row.turns, run.turns);
    row.ends.push_back(run.pushed / options.stop[0]);
    row.times.insert(row.times.end(), run.times.begin(), run.times.end());
    leave(loop, *start, hazard, options, row);
  }
  row.over /= options.stop[0];
  return row;
}

void print(const std::string& name, Hazard hazard, const Row& row) {
  if (row.runs == 0) {
    std::printf("| %s | %s | 0 | | | | | | | | |\n", name.c_str(), parallel_aspects::name(hazard));
    return;
  }
  std::printf("| %s | %s | %d | %d | %.3f | %.2f | %d | %d / %d | %d | %.1f | %.1f |\n", name.c_str(),
              parallel_aspects::name(hazard), row.runs, row.below, row.over, quantile(row.ends, 0.5),
              row.turns, row.left, row.inside, row.deeper, 1e6 * quantile(row.times, 0.5),
              1e6 * quantile(row.times, 0.99));
  std::fflush(stdout);
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  using namespace parallel_aspects;  // NOLINT: the program is this file
  const int runs = argc > 1 ? std::atoi(argv[1]) : 12;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 20261123;
  std::vector<std::string> robots{"five_bar",       "bipod",   "three_rpr",    "three_rrr",
                                  "three_prr",      "delta",   "linear_delta", "agile_eye",
                                  "spherical_3rrr", "stewart", "hexa",         "six_pus"};
  if (argc > 3) robots.assign(argv + 3, argv + argc);
  for (const std::string& name : robots)
    for (const Hazard hazard : {Hazard::parallel_singularity, Hazard::serial_singularity, Hazard::limit})
      print(name, hazard, push(test::shipped(name)->manipulator(), hazard, runs, seed));
}
