// SPDX-License-Identifier: BSD-3-Clause
//
// Prints a table of docs/development/benchmarks.md: paths around the cusps of the 3-RPR, played into the
// tracker with noise of its encoders. Usage: cusp_campaign
#include "motion/choose/cusp_paths.h"
#include "motion/choose/plan_around_cusp.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include "support/campaign_figures.h"
#include "support/robots/robots.h"
#include <cstddef>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double held = 14.98;
constexpr int steps = 2000;           // of a segment
constexpr unsigned plays = 3;         // of a path, with other noise
constexpr double played_most = 1e-4;  // the default of the tracker

struct Row {
  int paths = 0, followed = 0, followed_finer = 0, plays = 0;
  std::vector<double> index, seconds;
};

/// Whether the tracker is at the end of the path when the values are, with encoders that are off by so much.
bool is_followed(const std::shared_ptr<const Manipulator>& robot, const PlannedPath& path,
                 const std::vector<JointVector>& values, double noise, unsigned seed) {
  TrackerOptions options;
  options.samples.encoder_noise = noise;
  Tracker tracker(robot, options);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-noise * robot->size(), noise * robot->size());
  double time = 0.0;
  const auto noisy = [&](const JointVector& q) -> JointVector {
    return q.unaryExpr([&](double value) { return value + off(random); });
  };
  if (!tracker.start_near(time, noisy(values.front()), path.points.front().pose, 0.02 * robot->size()))
    return false;
  for (const JointVector& q : values)
    if (!tracker.update(time += 1e-3, noisy(q)).followed()) return false;
  const double off_end = (tracker.state().pose.position - path.points.back().pose.position).norm();
  if (off_end > 0.5) std::fprintf(stderr, "wrong: it is followed to another pose, %g m off\n", off_end);
  return off_end <= 0.5;
}

void play(const std::shared_ptr<const Manipulator>& robot, const CuspPlanner& planner,
          const PlannedPath& path, Row& row) {
  const std::vector<JointVector> values = test::values_along(*robot, planner, path, steps);
  ++row.paths;
  row.index.push_back(path.least_index);
  for (unsigned seed = 1; seed <= plays; ++seed) {
    ++row.plays;
    row.followed += is_followed(robot, path, values, played_most, seed) ? 1 : 0;
    row.followed_finer += is_followed(robot, path, values, 0.1 * played_most, seed) ? 1 : 0;
  }
}

Row row_of(const std::shared_ptr<const Manipulator>& robot, CuspPlanner& planner, std::size_t cusp,
           const std::vector<Pose>& starts) {
  Row row;
  for (const Pose& from : starts) {
    const test::Stopwatch stopwatch;
    const PlannedPath path = planner.plan({from, {}}, cusp);
    row.seconds.push_back(stopwatch.seconds());
    if (path) play(robot, planner, path, row);
  }
  return row;
}

/// From all poses of the actuated values that the shipped robot starts with, or from its start alone.
void campaign(const std::string& title, const std::shared_ptr<const Manipulator>& robot, bool only_start) {
  MapOptions options;
  Problems problems;
  options.slice = make_slice(*robot, {{robot->leg(0).actuated_joint, held}}, problems);
  const CuspList list = find_cusps(*robot, *options.slice->joint);
  CuspPlanner planner(compute_aspect_map(robot, options).map, list.cusps);
  const AnchorCircle circle = circle_of_anchor(*robot, *options.slice->joint);
  const Pose start = Pose::planar(-8.72659533, 12.17566975, -0.98697424);
  std::vector<Pose> starts;
  for (const AssemblyMode& each : direct(*robot, Eigen::Vector3d(held, 15.38, 12.0)).solutions)
    if (!only_start || (each.pose.position - start.position).norm() < 1e-3)
      starts.push_back(circle.nearest(each.pose));
  for (std::size_t cusp = 0; cusp < list.cusps.size(); ++cusp) {
    const Row row = row_of(robot, planner, cusp, starts);
    std::printf("| %s | %zu | %d of %zu | %d of %d | %d of %d | %.3f | %.2f |\n", title.c_str(), cusp + 1,
                row.paths, starts.size(), row.followed, row.plays, row.followed_finer, row.plays,
                test::quantile(row.index, 0.5), test::quantile(row.seconds, 1.0));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace parallel_aspects

int main() {
  using namespace parallel_aspects;
  campaign("none", test::three_rpr()->with_constraints({}), false);
  campaign("10 to 32 m", test::three_rpr(), false);
  campaign("10 to 32 m, from its start", test::three_rpr(), true);
}
