// SPDX-License-Identifier: BSD-3-Clause
//
// Prints a table of docs/development/benchmarks.md: short, clear, fast and quick paths between the same
// random configurations. Usage: preference_campaign PAIRS [ROBOT...]
#include "parallel_aspects/motion/plan_path.h"

#include "support/campaign_figures.h"
#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::array preferences{PathPreference::shortest, PathPreference::clear, PathPreference::fast,
                                 PathPreference::quick};

/// By preference: what its paths have of what the short ones have.
struct Figures {
  std::vector<double> length, index, seconds, milliseconds;
};

struct Row {
  int found = 0;
  std::array<Figures, preferences.size()> figures;
  int clearer = 0, faster = 0;  // than the short one, by more than a hundredth
};

using Plan = std::function<PlannedPath(const PathEnd&, const PathEnd&, const PathWish&)>;

/// One question, once for each.
void ask(const Manipulator& robot, const Plan& plan, const PathTime& time, const PathEnd& from,
         const PathEnd& to, Row& row) {
  std::array<PlannedPath, preferences.size()> paths;
  std::array<double, preferences.size()> seconds{}, taken{};
  for (std::size_t k = 0; k < preferences.size(); ++k) {
    const test::Stopwatch stopwatch;
    paths[k] = plan(from, to, {PathPolicy::stay, preferences[k], time});
    taken[k] = stopwatch.seconds();
    if (!paths[k]) return;
    seconds[k] = time(paths[k]);
  }
  ++row.found;
  for (std::size_t k = 0; k < preferences.size(); ++k) {
    Figures& figures = row.figures[k];
    figures.length.push_back(test::path_length(robot, paths[k]) / test::path_length(robot, paths[0]));
    figures.index.push_back(paths[k].least_index);
    figures.seconds.push_back(seconds[k] / seconds[0]);
    figures.milliseconds.push_back(1e3 * taken[k]);
  }
  row.clearer += paths[1].least_index > 1.01 * paths[0].least_index ? 1 : 0;
  row.faster += seconds[2] < 0.99 * seconds[0] ? 1 : 0;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

void print(const std::string& robot, const Row& row) {
  for (std::size_t k = 0; k < preferences.size(); ++k) {
    const Figures& figures = row.figures[k];
    const int better = k == 1 ? row.clearer : k == 2 ? row.faster : 0;
    std::printf("| %s | %s | %d | %.3f | %.4f | %.4f | %.3f | %d | %.2f | %.1f |\n", robot.c_str(),
                name(preferences[k]), row.found, mean(figures.length), mean(figures.index),
                test::quantile(figures.index, 0.1), mean(figures.seconds), better,
                test::quantile(figures.milliseconds, 0.5), test::quantile(figures.milliseconds, 0.95));
  }
  std::fflush(stdout);
}

/// Random configurations of one working mode that a path joins.
Row campaign(const std::shared_ptr<const Manipulator>& robot, const Plan& plan, int pairs) {
  const SegmentCertifier certifier(robot);
  const PathTime time =
      path_timer(certifier, between_poses(TaskSpace::SE3), test::usual_accelerations(*robot));
  test::PosePairs random(robot, 20261123);
  Row row;
  for (int i = 0; i < pairs; ++i) {
    const WorkingMode mode = random.mode();
    ask(*robot, plan, time, {random.reached(mode).value(), mode}, {random.reached(mode).value(), mode}, row);
  }
  return row;
}

void run(const std::string& name, int pairs) {
  const auto robot = test::shipped(name)->mapped_manipulator();
  if (test::usual_accelerations(*robot).size() == 0) return;
  if (robot->task_space() == TaskSpace::SE3) {
    const auto roadmap = compute_pose_roadmap(robot).roadmap;
    const Plan plan = [&](const PathEnd& from, const PathEnd& to, const PathWish& wish) {
      return plan_in_roadmap(*roadmap, from, to, wish);
    };
    return print(name, campaign(robot, plan, pairs));
  }
  PathPlanner planner(compute_aspect_map(robot).map);
  const Plan plan = [&](const PathEnd& from, const PathEnd& to, const PathWish& wish) {
    return planner.plan(from, to, wish);
  };
  print(name, campaign(robot, plan, pairs));
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  std::vector<std::string> robots(argv + std::min(argc, 2), argv + argc);
  if (robots.empty())
    robots = {"bipod",        "five_bar",  "three_rpr",      "three_rrr", "three_prr", "delta",
              "linear_delta", "agile_eye", "spherical_3rrr", "hexa",      "six_pus",   "stewart"};
  for (const std::string& robot : robots) parallel_aspects::run(robot, argc > 1 ? std::atoi(argv[1]) : 100);
  return EXIT_SUCCESS;
}
