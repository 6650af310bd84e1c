// SPDX-License-Identifier: BSD-3-Clause
// OMPL takes the planar 3-RPR from one assembly mode to another: the struts are as long at the goal as at the
// start, and nowhere on the way is the robot singular, which is proved.
#include <parallel_aspects/ompl/aspect_space_information.h>
#include <parallel_aspects/urdf/mechanism.h>

#include <iostream>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

namespace pa = parallel_aspects;

int main() {
  const auto robot = pa::models::three_rpr()->manipulator();
  const pa::ModeAndSign side{working_modes(*robot).front(), 1};
  const auto information = make_aspect_space_information(robot, side);
  ompl::base::ScopedState<> start(information), goal(information);
  set_pose(pa::TaskSpace::SE2, pa::Pose::planar(14.67394366, -3.01260312, 2.13290437), *start);
  set_pose(pa::TaskSpace::SE2, pa::Pose::planar(-5.49566082, -13.93549828, -0.04733137), *goal);

  ompl::geometric::SimpleSetup setup(information);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(information));
  setup.setStartAndGoalStates(start, goal);
  if (setup.solve(30.0) != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;
  setup.simplifySolution();
  ompl::geometric::PathGeometric& path = setup.getSolutionPath();
  for (const ompl::base::State* state : path.getStates())
    std::cout << to_string(pa::TaskSpace::SE2, pa::pose_of(pa::TaskSpace::SE2, *state)) << '\n';
  if (!path.check()) return 1;  // simplifying cuts motions in parts, each to be proved anew
  std::cout << "proved\n";
}
