// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <benchmark/benchmark.h>

#include "support/robots/robots.h"
#include <cmath>
#include <memory>
#include <vector>

namespace parallel_aspects {
namespace {

using RobotMaker = std::shared_ptr<const Manipulator> (*)();

constexpr double duration = 10.0;  // [s]
constexpr int rate = 100;          // [1/s]

// Round a circle of a tenth of a metre, turning a little where the platform turns.
Pose circle(const Manipulator& robot, double height, double time) {
  const double angle = 0.2 * EIGEN_PI * time;
  Pose pose;
  pose.position = {0.1 * std::cos(angle), 0.1 * std::sin(angle), height};
  if (has_rotation(robot.task_space()))
    pose.orientation = Eigen::AngleAxisd(0.1 * std::sin(angle), Eigen::Vector3d::UnitZ());
  return pose;
}

WorkingMode first_mode(const Manipulator& robot, double height) {
  for (const WorkingMode& mode : working_modes(robot))
    if (inverse(robot, circle(robot, height, 0.0), mode).status == InverseStatus::solved) return mode;
  return working_modes(robot).front();
}

std::vector<PoseWaypoint> poses(const Manipulator& robot, double height) {
  std::vector<PoseWaypoint> waypoints;
  for (int i = 0; i <= rate * duration; ++i) {
    const double time = static_cast<double>(i) / rate;
    waypoints.push_back({time, circle(robot, height, time)});
  }
  return waypoints;
}

// Cubics, by central differences of the joint values.
std::vector<JointWaypoint> joints(const Manipulator& robot, double height) {
  const WorkingMode mode = first_mode(robot, height);
  constexpr double step = 1e-4;
  const auto at = [&](double time) { return inverse(robot, circle(robot, height, time), mode).q; };
  std::vector<JointWaypoint> waypoints;
  for (int i = 0; i <= rate * duration; ++i) {
    const double time = static_cast<double>(i) / rate;
    waypoints.push_back({time, at(time), (at(time + step) - at(time - step)) / (2.0 * step), {}});
  }
  return waypoints;
}

void report(benchmark::State& state, const TrajectoryCheck& check) {
  state.SetLabel(std::string(name(check.answer)) + ": " + check.reason);
}

void check_joints_of(benchmark::State& state, RobotMaker make, double height) {
  const SegmentCertifier certifier(make());
  const Manipulator& robot = *certifier.manipulator();
  const auto waypoints = joints(robot, height);
  TrajectoryCheck check;
  for (auto _ : state) check = check_trajectory(certifier, waypoints, {circle(robot, height, 0.0), 0});
  report(state, check);
}
BENCHMARK_CAPTURE(check_joints_of, delta, test::delta, -0.6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check_joints_of, stewart, test::stewart, 0.6)->Unit(benchmark::kMillisecond);

void check_poses_of(benchmark::State& state, RobotMaker make, double height) {
  const SegmentCertifier certifier(make());
  const Manipulator& robot = *certifier.manipulator();
  const auto waypoints = poses(robot, height);
  TrajectoryCheck check;
  for (auto _ : state) check = check_trajectory(certifier, waypoints, first_mode(robot, height));
  report(state, check);
}
BENCHMARK_CAPTURE(check_poses_of, delta, test::delta, -0.6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check_poses_of, stewart, test::stewart, 0.6)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parallel_aspects
