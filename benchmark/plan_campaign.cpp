// SPDX-License-Identifier: BSD-3-Clause
//
// Prints the table of docs/planning.md: paths between random configurations of every shipped robot.
// Usage: plan_campaign PAIRS SAMPLES [ROBOT...]; every path is looked at SAMPLES times.
#include "parallel_aspects/motion/plan_path.h"

#include "support/configuration_at.h"
#include "support/path_samples.h"
#include "support/pose_pairs.h"
#include "support/shipped.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

/// Of the processor, so that other work on the machine counts nothing.
class Stopwatch {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct Row {
  int pairs = 0, none = 0, unknown = 0, contradicted = 0;
  std::vector<double> seconds, lengths;  // of the paths; the latter over the distance of their ends
  std::map<std::string, int> reasons;    // why unknown
};

/// How many samples of a path contradict it, by formulas of the tests.
int contradictions(const Manipulator& robot, const PlannedPath& path, int samples) {
  constexpr double rounding = 1e-9;
  int count = 0;
  double sign = 0.0;
  const int each = 1 + samples / std::max(1, static_cast<int>(path.points.size()) - 1);
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k <= each; ++k) {
      const Pose pose = test::mixed_pose(path.points[i].pose, path.points[i + 1].pose, k / double(each));
      const test::ConfigurationAt<double> at(robot, pose, path.points[i].mode);
      const double index = at.parallel();
      if (sign == 0.0) sign = index > 0.0 ? 1.0 : -1.0;
      count += at.squared_serial() < -rounding || at.within_limits() < -rounding || index * sign < -rounding;
    }
  return count;
}

using Plan = std::function<PlannedPath(const PathEnd&, const PathEnd&)>;

/// Asks about random configurations; where the path must stay in one aspect these have one working mode.
Row ask(const std::shared_ptr<const Manipulator>& robot, const Plan& plan, bool one_mode, int pairs,
        int samples) {
  test::PosePairs random(robot, 20261123);
  Row row;
  for (int i = 0; i < pairs; ++i) {
    const WorkingMode first = random.mode(), second = one_mode ? first : random.mode();
    const PathEnd from{random.reached(first).value(), first}, to{random.reached(second).value(), second};
    const Stopwatch stopwatch;
    const PlannedPath path = plan(from, to);
    const double seconds = stopwatch.seconds();
    ++row.pairs;
    row.none += path.answer == SameAspect::no;
    row.unknown += path.answer == SameAspect::unknown;
    if (path.answer == SameAspect::unknown) ++row.reasons[path.message];
    if (!path) continue;
    row.seconds.push_back(seconds);
    row.lengths.push_back((path.length + robot->characteristic_length() * path.turned) /
                          std::hypot((to.pose.position - from.pose.position).norm(),
                                     robot->characteristic_length() *
                                         from.pose.orientation.angularDistance(to.pose.orientation)));
    row.contradicted += contradictions(*robot, path, samples) > 0;
  }
  return row;
}

void print(const std::string& robot, PathPolicy policy, const Row& row) {
  std::printf("| %s | %s | %d | %zu | %d | %d | %.2f | %.1f | %.1f | %.2f | %d |\n", robot.c_str(),
              name(policy), row.pairs, row.lengths.size(), row.none, row.unknown,
              1e3 * quantile(row.seconds, 0.5), 1e3 * quantile(row.seconds, 0.95),
              1e3 * quantile(row.seconds, 1.0), quantile(row.lengths, 0.5), row.contradicted);
  for (const auto& [reason, count] : row.reasons) std::fprintf(stderr, "  %d: %s\n", count, reason.c_str());
  std::fflush(stdout);
}

void plan_in_maps(const std::string& name, const std::shared_ptr<const Manipulator>& robot, int pairs,
                  int samples) {
  const Stopwatch of_map;
  PathPlanner planner(compute_aspect_map(robot).map);
  const double map_seconds = of_map.seconds();
  const Stopwatch of_graph;
  planner.graph();
  std::fprintf(stderr, "%s: map %.2f s, graph %.2f s\n", name.c_str(), map_seconds, of_graph.seconds());
  for (const PathPolicy policy : {PathPolicy::stay, PathPolicy::serial})
    print(name, policy,
          ask(
              robot, [&](const PathEnd& from, const PathEnd& to) { return planner.plan(from, to, policy); },
              policy == PathPolicy::stay, pairs, samples));
}

void plan_in_roadmaps(const std::string& name, const std::shared_ptr<const Manipulator>& robot, int pairs,
                      int samples) {
  const auto roadmap = compute_pose_roadmap(robot).roadmap;
  print(
      name, PathPolicy::stay,
      ask(
          robot, [&](const PathEnd& from, const PathEnd& to) { return plan_in_roadmap(*roadmap, from, to); },
          true, pairs, samples));
}

int run(int pairs, int samples, const std::vector<std::string>& robots) {
  for (const std::string& name : robots) {
    const auto robot = test::shipped(name)->mapped_manipulator();
    (robot->task_space() == TaskSpace::SE3 ? plan_in_roadmaps : plan_in_maps)(name, robot, pairs, samples);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  std::vector<std::string> robots(argv + std::min(argc, 3), argv + argc);
  if (robots.empty())
    robots = {"bipod",        "five_bar",  "three_rpr",      "three_rrr", "three_prr", "delta",
              "linear_delta", "agile_eye", "spherical_3rrr", "hexa",      "six_pus",   "stewart"};
  const int pairs = argc > 1 ? std::atoi(argv[1]) : 100, samples = argc > 2 ? std::atoi(argv[2]) : 2000;
  return parallel_aspects::run(pairs, samples, robots);
}
