// SPDX-License-Identifier: BSD-3-Clause
#include "arms/arm_inverse.h"

#include <Eigen/Dense>

#include "arms/inverse_candidates.h"
#include "arms/solution_proof.h"
#include <algorithm>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

constexpr int most_steps = 40;
constexpr double solved = 1e-9;  // of angles, and of lengths as a share of the reach
constexpr double same = 1e-6;    // angles of one solution
constexpr int places_of_search = 200;

bool all_turn(const SerialArm& arm) {
  return std::all_of(arm.joints().begin(), arm.joints().end(),
                     [](const ArmJoint& joint) { return joint.turns; });
}

bool is_parallel(const RationalAngle& twist) { return twist.quarters % 2 == 0 && twist.half_tangent == 0; }
bool is_perpendicular(const RationalAngle& twist) {
  return twist.quarters % 2 != 0 && twist.half_tangent == 0;
}

// Slides along the normal, whose links add nothing, and turning joints about it.
bool is_simple_plane(const SerialArm& arm) {
  std::size_t slides = 0;
  for (const ArmJoint& joint : arm.joints()) {
    if (!is_parallel(joint.twist)) return false;
    if (joint.turns) continue;
    ++slides;
    if (joint.length != 0 || joint.turn.quarters != 0 || joint.turn.half_tangent != 0) return false;
  }
  return slides == (arm.task() == ArmTask::position_and_turn ? 1U : 0U);
}

// What is left to the goal: lengths as shares of the reach, and angles.
Eigen::VectorXd difference(const SerialArm& arm, const Eigen::Isometry3d& at, const Eigen::Isometry3d& goal) {
  const Eigen::Vector3d way = (goal.translation() - at.translation()) / std::max(arm.reach(), 1e-9);
  const Eigen::AngleAxisd turn(goal.linear() * at.linear().transpose());
  const Eigen::Vector3d turned = turn.angle() * turn.axis();
  const Eigen::Vector3d z = at.linear().col(2), other = goal.linear().col(2);
  const double sine = z.cross(other).norm(), bend = std::atan2(sine, z.dot(other));
  const Eigen::Vector3d across =
      sine > 0.0 ? Eigen::Vector3d(bend / sine * z.cross(other)) : Eigen::Vector3d::Zero();
  Eigen::VectorXd result(static_cast<Eigen::Index>(coordinate_count(arm.task())));
  const Eigen::Matrix3d& plane = arm.plane();
  switch (arm.task()) {
    case ArmTask::plane_position:
      return (plane.transpose() * way).head<2>();
    case ArmTask::plane_pose:
      result << (plane.transpose() * way).head<2>(), turned.dot(plane.col(2));
      return result;
    case ArmTask::position:
      return way;
    case ArmTask::orientation:
      return turned;
    case ArmTask::direction:
      return at.linear().leftCols<2>().transpose() * across;
    case ArmTask::position_and_turn:
      result << way, turned.dot(plane.col(2));
      return result;
    case ArmTask::position_and_direction:
      result << way, at.linear().leftCols<2>().transpose() * across;
      return result;
    case ArmTask::pose:
      break;
  }
  result << way, turned;
  return result;
}

Eigen::MatrixXd scaled_jacobian(const SerialArm& arm, const Eigen::VectorXd& q) {
  Eigen::MatrixXd jacobian = arm.jacobian(q);
  const Eigen::Index lengths = arm.task() == ArmTask::orientation || arm.task() == ArmTask::direction ? 0
                               : arm.task() == ArmTask::plane_position || arm.task() == ArmTask::plane_pose
                                   ? 2
                                   : 3;
  jacobian.topRows(lengths) /= std::max(arm.reach(), 1e-9);
  return jacobian;
}

// Newton's method; the joint values where it ends are a solution or not.
double polish(const SerialArm& arm, const Eigen::Isometry3d& goal, Eigen::VectorXd& q) {
  double best = difference(arm, arm.tip(q), goal).norm();
  for (int step = 0; step < most_steps && best > 1e-15; ++step) {
    const Eigen::VectorXd change =
        scaled_jacobian(arm, q).colPivHouseholderQr().solve(difference(arm, arm.tip(q), goal));
    if (!change.allFinite()) break;
    double share = std::min(1.0, 1.0 / change.cwiseAbs().maxCoeff());
    Eigen::VectorXd next = q + share * change;
    double left = difference(arm, arm.tip(next), goal).norm();
    for (int halving = 0; halving < 8 && !(left < best); ++halving) {
      share *= 0.5;
      next = q + share * change;
      left = difference(arm, arm.tip(next), goal).norm();
    }
    if (!(left < best)) break;
    best = left;
    q = next;
  }
  return best;
}

// Angles from -half_turn to half_turn, or within limits where a turn more or less is.
void normalise(const SerialArm& arm, Eigen::VectorXd& q) {
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmJoint& joint = arm.joints()[i];
    if (!joint.turns) continue;
    double& value = q[static_cast<Eigen::Index>(i)];
    value = std::remainder(value, 2.0 * half_turn);
    for (const double turn : {2.0 * half_turn, -2.0 * half_turn})
      if (!arm.turns_freely(i) && !joint.limits.contain(value) && joint.limits.contain(value + turn))
        value += turn;
  }
}

bool is_same(const SerialArm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double apart = arm.joints()[i].turns ? std::remainder(a[at] - b[at], 2.0 * half_turn)
                                               : (a[at] - b[at]) / std::max(arm.reach(), 1e-9);
    if (!(std::abs(apart) < same)) return false;
  }
  return true;
}

Candidates candidates(const SerialArm& arm, InverseMethod method, const Eigen::Isometry3d& tip) {
  const Eigen::Isometry3d goal = arm.base().inverse() * tip * arm.tool().inverse();
  switch (method) {
    case InverseMethod::planar:
      return planar_candidates(arm, goal);
    case InverseMethod::position:
      return position_candidates(link_numbers(arm), 1e-9 * static_cast<double>(arm.tip_height()),
                                 arm.base().inverse() * tip.translation());
    case InverseMethod::wrist:
      return wrist_candidates(arm, goal);
    case InverseMethod::three_parallel:
      return three_parallel_candidates(arm, goal);
    case InverseMethod::elimination:
    case InverseMethod::search:
      break;
  }
  Candidates found;
  if (method == InverseMethod::elimination) found = elimination_candidates(arm, goal);
  std::mt19937 random(1);
  for (int k = 0; k < places_of_search; ++k) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(arm.size()));
    for (std::size_t i = 0; i < arm.size(); ++i) {
      const JointLimits& limits = arm.joints()[i].limits;
      const bool bounded = std::isfinite(limits.lower) && std::isfinite(limits.upper);
      const double size = arm.joints()[i].turns ? half_turn : std::max(arm.reach(), 1.0);
      const double lower = bounded ? limits.lower : -size, upper = bounded ? limits.upper : size;
      q[static_cast<Eigen::Index>(i)] = std::uniform_real_distribution<double>(lower, upper)(random);
    }
    found.push_back(q);
  }
  return found;
}

// The closed forms' equations have two solutions each and no others; each is met where a candidate of it is
// proved to be a solution, or where it has none.
std::string reason_of(InverseMethod method) {
  switch (method) {
    case InverseMethod::planar:
    case InverseMethod::wrist:
    case InverseMethod::position:
    case InverseMethod::three_parallel:
      return "the closed form has no others";
    case InverseMethod::elimination:
      return "found as eigenvalues and by a search, which are not proved to miss none";
    case InverseMethod::search:
      break;
  }
  return "found by Newton's method from many places, which may miss some";
}

}  // namespace

const char* name(InverseMethod method) {
  switch (method) {
    case InverseMethod::planar:
      return "planar";
    case InverseMethod::position:
      return "position";
    case InverseMethod::wrist:
      return "wrist";
    case InverseMethod::three_parallel:
      return "three_parallel";
    case InverseMethod::elimination:
      return "elimination";
    case InverseMethod::search:
      break;
  }
  return "search";
}

InverseMethod inverse_method(const SerialArm& arm) {
  const auto& joints = arm.joints();
  const bool in_plane = arm.task() == ArmTask::plane_position || arm.task() == ArmTask::plane_pose ||
                        arm.task() == ArmTask::position_and_turn;
  if (in_plane && is_simple_plane(arm)) return InverseMethod::planar;
  if (!all_turn(arm)) return InverseMethod::search;
  if (arm.task() == ArmTask::position) return InverseMethod::position;
  if (arm.task() != ArmTask::pose) return InverseMethod::search;
  const bool ends_meet = joints[4].length == 0;
  if (joints[3].length == 0 && ends_meet && joints[4].offset == 0 && !is_parallel(joints[3].twist) &&
      !is_parallel(joints[4].twist))
    return InverseMethod::wrist;
  if (is_parallel(joints[1].twist) && is_parallel(joints[2].twist) && ends_meet &&
      !is_parallel(joints[0].twist) && !is_parallel(joints[3].twist) && !is_parallel(joints[4].twist))
    return InverseMethod::three_parallel;
  return InverseMethod::elimination;
}

bool has_one_solution_a_sign(const SerialArm& arm) {
  const auto& joints = arm.joints();
  switch (inverse_method(arm)) {
    case InverseMethod::planar:
    case InverseMethod::three_parallel:
      return true;
    case InverseMethod::position:
    case InverseMethod::wrist: {
      // theta3 alone by one equation, then theta2 by another.
      if (joints[0].length == 0 || is_parallel(joints[0].twist)) return true;
      // In a plane that theta1 turns: in front of its axis or behind, elbow up or down.
      return is_perpendicular(joints[0].twist) && is_parallel(joints[1].twist);
    }
    case InverseMethod::elimination:
    case InverseMethod::search:
      break;
  }
  return false;
}

ArmSolutions inverse_solutions(const SerialArm& arm, const Eigen::Isometry3d& tip) {
  const InverseMethod method = inverse_method(arm);
  ArmSolutions result;
  const SolutionProof proof(arm, tip);
  for (Eigen::VectorXd q : candidates(arm, method, tip)) {
    if (!q.allFinite()) continue;
    const double left = polish(arm, tip, q);
    if (!(left < solved)) continue;
    normalise(arm, q);
    if (std::any_of(result.all.begin(), result.all.end(),
                    [&](const ArmSolution& each) { return is_same(arm, each.q, q); }))
      continue;
    result.all.push_back({q, left, proof.has_one_near(q)});
  }
  std::sort(result.all.begin(), result.all.end(), [](const ArmSolution& a, const ArmSolution& b) {
    return std::lexicographical_compare(a.q.data(), a.q.data() + a.q.size(), b.q.data(),
                                        b.q.data() + b.q.size());
  });
  const bool all_proved = std::all_of(result.all.begin(), result.all.end(),
                                      [](const ArmSolution& each) { return each.is_proved; });
  result.is_complete = method != InverseMethod::elimination && method != InverseMethod::search && all_proved;
  result.reason = all_proved
                      ? reason_of(method)
                      : "a solution is so close to a singularity that solutions there may be one or two";
  return result;
}

Eigen::Isometry3d tip_with(const SerialArm& arm, const Eigen::VectorXd& coordinates) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arm.size()));
  Eigen::Isometry3d tip = arm.tip(zero);
  const Eigen::Matrix3d& plane = arm.plane();
  const auto turn = [](const Eigen::Vector3d& angles) {
    return (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
  };
  const auto pointing = [&](const Eigen::Vector3d& z) {
    return (Eigen::Quaterniond::FromTwoVectors(tip.linear().col(2), z) * tip.linear()).eval();
  };
  switch (arm.task()) {
    case ArmTask::plane_pose:
      tip.linear() = Eigen::AngleAxisd(coordinates[2], plane.col(2)) * tip.linear();
      [[fallthrough]];
    case ArmTask::plane_position:
      tip.translation() =
          plane.leftCols<2>() * coordinates.head<2>() + plane.col(2).dot(tip.translation()) * plane.col(2);
      return tip;
    case ArmTask::position_and_turn:
      tip.linear() = Eigen::AngleAxisd(coordinates[3], plane.col(2)) * tip.linear();
      [[fallthrough]];
    case ArmTask::position:
      tip.translation() = coordinates.head<3>();
      return tip;
    case ArmTask::orientation:
      tip.linear() = turn(coordinates);
      return tip;
    case ArmTask::direction:
      tip.linear() = pointing(coordinates);
      return tip;
    case ArmTask::position_and_direction:
      tip.translation() = coordinates.head<3>();
      tip.linear() = pointing(coordinates.tail<3>());
      return tip;
    case ArmTask::pose:
      break;
  }
  tip.translation() = coordinates.head<3>();
  tip.linear() = turn(coordinates.tail<3>());
  return tip;
}

}  // namespace parallel_aspects
