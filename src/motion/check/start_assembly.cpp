// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/start_assembly.h"

#include "model/number_text.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "tracking/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double fitting_angle = 0.01;  // [rad]
constexpr double full_turn = 2.0 * static_cast<double>(EIGEN_PI);
constexpr double fitting_share = 0.01;  // of the robot's size

/// How far the joint value of a leg is from the nearest one that the pose asks for, modulo whole turns.
double misfit(const Leg& leg, const Pose& pose, double q) {
  double least = std::numeric_limits<double>::infinity();
  for (const int sign : {1, -1}) {
    if (!leg.has_branch(sign)) continue;
    const double off = joint_value(leg, pose.transform(leg.anchor), sign) - q;
    least = std::min(least, std::abs(leg.actuated_by_angle() ? std::remainder(off, full_turn) : off));
  }
  return least;
}

std::string ambiguity(const Manipulator& manipulator, const Candidates& candidates,
                      const std::vector<std::size_t>& possible) {
  std::string text = "The first waypoint has " + std::to_string(possible.size()) + " assembly modes (";
  for (std::size_t i = 0; i < possible.size(); ++i)
    text += (i == 0 ? "" : "; ") + to_string(manipulator.task_space(), candidates[possible[i]].point.pose);
  return text + "); state the start pose.";
}

}  // namespace

StartAssembly find_start(const Manipulator& manipulator, const PoseCertifier& certifier, const JointVector& q,
                         const TrajectoryStart& start) {
  StartAssembly found;
  if (start.pose) {
    if (!certify_solution(certifier, *start.pose, q, found.point))
      found.problem = "No direct solution is proved near the start pose: it is too near to det A = 0.";
    return found;
  }
  Candidates candidates;
  candidates.find(manipulator, certifier, q);
  std::vector<std::size_t> possible;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (start.determinant_sign == 0 || candidates[i].determinant_sign != -start.determinant_sign)
      possible.push_back(i);
  if (possible.size() > 1)
    found.problem = ambiguity(manipulator, candidates, possible);
  else if (possible.empty())
    found.problem = "The robot is not found to assemble at the first waypoint.";
  else if (!candidates.complete() || !candidates[possible.front()].followed)
    found.problem =
        "The first waypoint is too near to det A = 0 to know the assembly mode; state the start pose.";
  else
    found.point = candidates[possible.front()].point;
  return found;
}

std::string start_misfit(const Manipulator& manipulator, const JointVector& q, const TrajectoryStart& start) {
  if (!start.pose) return "";
  if (!start.pose->position.allFinite() || !start.pose->orientation.coeffs().allFinite())
    return "The start pose has a number that is not finite; correct it.";
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const double off = misfit(leg, *start.pose, q[static_cast<Eigen::Index>(j)]);
    if (!(off <= (leg.actuated_by_angle() ? fitting_angle : fitting_share * manipulator.size())))
      return "The start pose does not fit the first waypoint: joint '" + leg.actuated_joint + "' is off by " +
             number_text(off) + (leg.actuated_by_angle() ? " rad" : " m") + "; correct one of the two.";
  }
  return "";
}

}  // namespace parallel_aspects
