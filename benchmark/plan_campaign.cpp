// SPDX-License-Identifier: BSD-3-Clause
//
// Prints a table of docs/development/benchmarks.md: paths between random configurations of every shipped
// robot, and how many of them were timed with a proof. Usage: plan_campaign PAIRS SAMPLES [ROBOT...]; every
// path is examined SAMPLES times.
#include "parallel_aspects/motion/plan_path.h"

#include "support/campaign_figures.h"
#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
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

struct Row {
  int pairs = 0, none = 0, unknown = 0, contradicted = 0;
  int to_be_timed = 0, timed = 0, beyond_limits = 0;
  std::vector<double> seconds, quick_seconds,
      lengths;                         // of the paths; the last over the distance of the ends
  std::map<std::string, int> reasons;  // why unknown
};

/// A planner of one robot, and how the pose runs between two points of its paths.
struct Planning {
  std::shared_ptr<const Manipulator> robot;
  std::function<PlannedPath(const PathEnd&, const PathEnd&, PathPreference)> plan;
  PoseBetween between;
  bool no_by_sign_alone = false;
};

void look_at_time(const Planning& planning, const PlannedPath& path, Row& row) {
  const JointVector accelerations = test::usual_accelerations(*planning.robot);
  const bool keeps_control =
      std::none_of(path.crossings.begin(), path.crossings.end(),
                   [](const PathCrossing& crossing) { return crossing.kind == Crossing::parallel; });
  if (accelerations.size() == 0 || !keeps_control) return;
  const TimedPath timed = time_path(SegmentCertifier(planning.robot), path, planning.between, accelerations);
  ++row.to_be_timed;
  row.timed += timed ? 1 : 0;
  row.beyond_limits += test::limits_taken(*planning.robot, timed.waypoints, accelerations) > 1.0 ? 1 : 0;
}

/// Asks about random configurations; where the path must stay in one aspect these have one working mode.
Row ask(const Planning& planning, bool one_mode, int pairs, int samples) {
  const Manipulator& robot = *planning.robot;
  test::PosePairs random(planning.robot, 20261123);
  Row row;
  for (int i = 0; i < pairs; ++i) {
    const WorkingMode first = random.mode(), second = one_mode ? first : random.mode();
    const PathEnd from{random.reached(first).value(), first}, to{random.reached(second).value(), second};
    const test::Stopwatch of_quick;
    const PlannedPath quick = planning.plan(from, to, PathPreference::quick);
    const double quick_seconds = of_quick.seconds();
    const test::Stopwatch stopwatch;
    const PlannedPath path = planning.plan(from, to, PathPreference::shortest);
    const double seconds = stopwatch.seconds();
    ++row.pairs;
    row.none += path.answer == SameAspect::no;
    row.contradicted +=
        path.answer == SameAspect::no && planning.no_by_sign_alone &&
        test::sign_in_doubles(robot, from.pose, first) == test::sign_in_doubles(robot, to.pose, second);
    row.unknown += path.answer == SameAspect::unknown;
    if (path.answer == SameAspect::unknown) ++row.reasons[path.message];
    if (!path) continue;
    row.seconds.push_back(seconds);
    row.quick_seconds.push_back(quick_seconds);
    row.lengths.push_back(test::path_length(robot, path) /
                          std::hypot((to.pose.position - from.pose.position).norm(),
                                     robot.characteristic_length() *
                                         from.pose.orientation.angularDistance(to.pose.orientation)));
    row.contradicted +=
        test::contradictions(robot, path, samples) > 0 || test::contradictions(robot, quick, samples) > 0;
    look_at_time(planning, path, row);
  }
  return row;
}

void print(const std::string& robot, PathPolicy policy, const Row& row) {
  std::printf(
      "| %s | %s | %d | %zu | %d | %d | %.2f | %.1f | %.2f | %.1f | %.1f | %.2f | %d | %d of %d | %d |\n",
      robot.c_str(), name(policy), row.pairs, row.lengths.size(), row.none, row.unknown,
      1e3 * test::quantile(row.quick_seconds, 0.5), 1e3 * test::quantile(row.quick_seconds, 0.95),
      1e3 * test::quantile(row.seconds, 0.5), 1e3 * test::quantile(row.seconds, 0.95),
      1e3 * test::quantile(row.seconds, 1.0), test::quantile(row.lengths, 0.5), row.contradicted, row.timed,
      row.to_be_timed, row.beyond_limits);
  for (const auto& [reason, count] : row.reasons) std::fprintf(stderr, "  %d: %s\n", count, reason.c_str());
  std::fflush(stdout);
}

void plan_in_maps(const std::string& name, const std::shared_ptr<const Manipulator>& robot, int pairs,
                  int samples) {
  const test::Stopwatch of_map;
  PathPlanner planner(compute_aspect_map(robot).map);
  const double map_seconds = of_map.seconds();
  const test::Stopwatch of_graph;
  planner.graph();
  std::fprintf(stderr, "%s: map %.2f s, graph %.2f s\n", name.c_str(), map_seconds, of_graph.seconds());
  for (const PathPolicy policy : {PathPolicy::stay, PathPolicy::serial, PathPolicy::any}) {
    const Planning planning{robot,
                            [&](const PathEnd& from, const PathEnd& to, PathPreference prefer) {
                              return planner.plan(from, to, {policy, prefer, {}});
                            },
                            between_poses(TaskSpace::SE3)};
    print(name, policy, ask(planning, policy == PathPolicy::stay, pairs, samples));
  }
}

/// A robot of struts has one working mode.
void plan_in_roadmaps(const std::string& name, const std::shared_ptr<const Manipulator>& robot, int pairs,
                      int samples) {
  const auto roadmap = compute_pose_roadmap(robot).roadmap;
  for (const PathPolicy policy : {PathPolicy::stay, PathPolicy::serial}) {
    if (policy == PathPolicy::serial && working_modes(*robot).size() == 1) continue;
    const Planning planning{robot,
                            [&](const PathEnd& from, const PathEnd& to, PathPreference prefer) {
                              return plan_in_roadmap(*roadmap, from, to, {policy, prefer, {}});
                            },
                            between_poses(TaskSpace::SE3), true};
    print(name, policy, ask(planning, policy == PathPolicy::stay, pairs, samples));
  }
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
