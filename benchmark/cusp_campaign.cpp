// SPDX-License-Identifier: BSD-3-Clause
//
// Prints a table of docs/uniqueness.md: paths around the cusps of the 3-RPR, played into the tracker with
// noise of its encoders. Usage: cusp_campaign [STARTS]
#include "motion/choose/plan_around_cusp.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/tracking/tracker.h"

#include "support/campaign_figures.h"
#include "support/robots.h"
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double held = 14.98;
constexpr int steps = 2000;        // of a segment
constexpr unsigned plays = 3;      // of a path, with other noise
constexpr double played_most = 1e-4;  // the default of the tracker

struct Row {
  int paths = 0, followed = 0, followed_finer = 0, plays = 0;
  std::vector<double> index, noise, seconds;
};

/// Actuated values along a path, which stop at each of its points without a jerk.
std::vector<JointVector> values_along(const Manipulator& robot, const CuspPlanner& planner,
                                      const PlannedPath& path) {
  std::vector<JointVector> values;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k <= steps; ++k) {
      const double share = 0.5 - 0.5 * std::cos(EIGEN_PI * k / steps);
      const Pose pose = planner.between(path.points[i].pose, path.points[i + 1].pose, share);
      values.push_back(inverse(robot, pose, path.points[i].mode).q);
    }
  return values;
}

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
  return (tracker.state().pose.position - path.points.back().pose.position).norm() < 0.5;
}

void play(const std::shared_ptr<const Manipulator>& robot, const CuspPlanner& planner, const PlannedPath& path,
          Row& row) {
  const std::vector<JointVector> values = values_along(*robot, planner, path);
  ++row.paths;
  row.index.push_back(path.least_index);
  for (unsigned seed = 1; seed <= plays; ++seed) {
    ++row.plays;
    row.followed += is_followed(robot, path, values, played_most, seed) ? 1 : 0;
    row.followed_finer += is_followed(robot, path, values, 0.1 * played_most, seed) ? 1 : 0;
  }
}

void campaign(const std::string& title, const std::shared_ptr<const Manipulator>& robot) {
  MapOptions options;
  Problems problems;
  options.slice = make_slice(*robot, {{robot->leg(0).actuated_joint, held}}, problems);
  const auto map = compute_aspect_map(robot, options).map;
  const CuspList list = find_cusps(*robot, *options.slice->joint);
  CuspPlanner planner(map, list.cusps);
  const auto starts = direct(*robot, Eigen::Vector3d(held, 15.38, 12.0)).solutions;
  for (std::size_t cusp = 0; cusp < list.cusps.size(); ++cusp) {
    Row row;
    for (const AssemblyMode& start : starts) {
      const test::Stopwatch stopwatch;
      const Pose from = circle_of_anchor(*robot, *options.slice->joint).nearest(start.pose);
      const PlannedPath path = planner.plan({from, {}}, cusp);
      row.seconds.push_back(stopwatch.seconds());
      if (path) {
        std::printf("  cusp %zu from %.3f %.3f: index %.5f det %.4g points %zu turns", cusp + 1, from.position.x(), from.position.y(), path.least_index, path.least_det_a, path.points.size());
        for (int t : planner.turns_around_cusps(path)) std::printf(" %d", t);
        std::printf(" noise %.3g room %.3g s %.3f\n", planner.followed_noise(path), planner.least_room(path), row.seconds.back());
        play(robot, planner, path, row);
      } else std::printf("  cusp %zu from %.3f %.3f: %s\n", cusp + 1, from.position.x(), from.position.y(), path.message.c_str());
    }
    std::printf("| %s | %zu | %d | %d of %d | %d of %d | %.4f | %.2f |\n", title.c_str(), cusp + 1, row.paths,
                row.followed, row.plays, row.followed_finer, row.plays, test::quantile(row.index, 0.5),
                test::quantile(row.seconds, 1.0));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace parallel_aspects

int main() {
  using namespace parallel_aspects;
  campaign("none", test::three_rpr()->with_constraints({}));
  campaign("10 to 32 m", test::three_rpr());
}
