// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/completion.h"

#include "model/linear_algebra.h"
#include "urdf/recognition/follower.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {

Eigen::Matrix3d rotation(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

double angle_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d flat_from = from - axis * axis.dot(from);
  const Eigen::Vector3d flat_to = to - axis * axis.dot(to);
  return std::atan2(axis.dot(flat_from.cross(flat_to)), flat_from.dot(flat_to));
}

std::optional<std::array<double, 2>> angles_about(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                                                  const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                  int branch) {
  const Eigen::Vector3d normal = first.cross(second);
  const double squared_sine = normal.squaredNorm();
  if (squared_sine < 1e-8) return std::nullopt;
  const double cosine = first.dot(second);
  const double along_first = (first.dot(to) - cosine * second.dot(from)) / squared_sine;
  const double along_second = (second.dot(from) - cosine * first.dot(to)) / squared_sine;
  const Eigen::Vector3d in_plane = along_first * first + along_second * second;
  const double height =
      std::sqrt(std::max(0.0, (from.squaredNorm() - in_plane.squaredNorm()) / squared_sine));
  const Eigen::Vector3d between = in_plane + branch * height * normal;
  return std::array<double, 2>{angle_about(first, between, to), angle_about(second, from, between)};
}

namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// A pivot and how far its joint moves away from the assembled configuration [rad].
struct Turn {
  const Pivot* pivot;
  double step;
};
using Turns = std::vector<Turn>;

bool is_free(const Chain& group) {
  return std::any_of(group.begin(), group.end(),
                     [](const Pivot& pivot) { return pivot.kind == PivotKind::ball; });
}

int side(const Vector3d& first, const Vector3d& second, const Vector3d& of) {
  return of.dot(first.cross(second)) < 0.0 ? -1 : 1;
}

Vector3d across(const Vector3d& axis) { return axis.unitOrthogonal(); }

// All but two pivots of a group stay where they are: those whose axes are closest to the rod, which only spin
// it.
std::vector<const Pivot*> two_that_point(const Chain& group, const Vector3d& rod) {
  std::vector<const Pivot*> pivots;
  for (const Pivot& pivot : group) pivots.push_back(&pivot);
  const auto along_rod = [&](const Pivot* a, const Pivot* b) {
    return std::abs(a->axis.dot(rod)) < std::abs(b->axis.dot(rod));
  };
  while (pivots.size() > 2) pivots.erase(std::max_element(pivots.begin(), pivots.end(), along_rod));
  return pivots;
}

// The turns of two pivots that bring `from` to `to`, or as close as they can.
struct Pointing {
  Turns turns;
  bool reaches = false;
};

Pointing pointing(const Pivot& one, const Pivot& other, const Vector3d& rod, const Vector3d& from,
                  const Vector3d& to) {
  const Vector3d first = directed_axis(one), second = directed_axis(other);
  const auto both = angles_about(first, second, from, to, side(first, second, rod));
  if (!both) return {{{&one, angle_about(first, from, to)}}, false};
  const Vector3d reached = rotation(first, (*both)[0]) * rotation(second, (*both)[1]) * from;
  return {{{&one, (*both)[0]}, {&other, (*both)[1]}}, (reached - to).norm() < 1e-9 * to.norm()};
}

// The turn of the last of three pivots that brings `from` across the axis of the second. The other two can
// then point it anywhere, where their axes are orthogonal.
double turn_across(const Pivot& second, const Pivot& last, const Vector3d& from) {
  return angle_about(directed_axis(last), from, directed_axis(second).cross(directed_axis(last)));
}

// Three pivots point where two of them cannot.
Pointing pointing_of_three(const Chain& group, const Vector3d& rod, const Vector3d& from,
                           const Vector3d& to) {
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t j = i + 1; j < group.size(); ++j)
      for (std::size_t k = j + 1; k < group.size(); ++k) {
        const double turn = turn_across(group[j], group[k], from);
        const Matrix3d turned = rotation(directed_axis(group[k]), turn);
        Pointing result = pointing(group[i], group[j], turned * rod, turned * from, to);
        result.turns.push_back({&group[k], turn});
        if (result.reaches) return result;
      }
  return {};
}

// Turns of a group that bring `from` to the direction of `to`, whose length differs where a file is rounded;
// at the assembled configuration the rod points along `rod`.
Turns turns_towards(const Chain& group, const Vector3d& rod, const Vector3d& from, Vector3d to) {
  if (group.empty() || is_free(group)) return {};
  if (to.norm() > 0.0) to *= from.norm() / to.norm();
  const std::vector<const Pivot*> pivots = two_that_point(group, rod);
  const Pointing by_two = pointing(*pivots.front(), *pivots.back(), rod, from, to);
  if (by_two.reaches) return by_two.turns;
  const Pointing by_three = pointing_of_three(group, rod, from, to);
  return by_three.reaches ? by_three.turns : by_two.turns;
}

// Of more than three pivots, the three that turn one into the other best: each across the next.
Chain three_that_turn(const Chain& group) {
  if (group.size() <= 3) return group;
  Chain best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t j = i + 1; j < group.size(); ++j)
      for (std::size_t k = j + 1; k < group.size(); ++k) {
        const double along =
            std::max(std::abs(group[i].axis.dot(group[j].axis)), std::abs(group[j].axis.dot(group[k].axis)));
        if (!(along < least)) continue;
        least = along;
        best = {group[i], group[j], group[k]};
      }
  return best;
}

// Turns of a group of up to three pivots that make up the rotation `wanted`.
Turns turns_making(const Chain& group, const Matrix3d& wanted) {
  if (group.empty() || is_free(group)) return {};
  const Vector3d first = directed_axis(group.front());
  if (group.size() == 1) return {{&group[0], angle_about(first, across(first), wanted * across(first))}};
  const Vector3d last = directed_axis(group.back());
  Turns turns;
  if (group.size() == 2) {
    turns.push_back({&group[0], angle_about(first, last, wanted * last)});
  } else {
    const Vector3d second = directed_axis(group[1]);
    const auto both = angles_about(first, second, last, wanted * last, side(first, second, last));
    if (!both) return {};
    turns.push_back({&group[0], (*both)[0]});
    turns.push_back({&group[1], (*both)[1]});
  }
  Matrix3d done = Matrix3d::Identity();
  for (const Turn& turn : turns) done = done * rotation(directed_axis(*turn.pivot), turn.step);
  const Vector3d test = across(last);
  turns.push_back({&group.back(), angle_about(last, test, done.transpose() * wanted * test)});
  return turns;
}

Matrix3d product(const Chain& group, const Turns& turns) {
  Matrix3d result = Matrix3d::Identity();
  for (const Pivot& pivot : group)
    for (const Turn& turn : turns)
      if (turn.pivot == &pivot) result = result * rotation(directed_axis(pivot), turn.step);
  return result;
}

Chain reversed(const Chain& chain) {
  Chain result(chain.rbegin(), chain.rend());
  for (Pivot& pivot : result) pivot.sense = -pivot.sense;
  return result;
}

// before * (turns of `near`) * between * (turns of `far`) = target, with all factors motions of space.
struct ChainEquation {
  Isometry3d before, between, target;
  Chain near, far;
  Vector3d near_center;  // on the axes of `near`
  Vector3d tip;          // the end of the rod that the turns of `far` leave in place
};

ChainEquation equation_of(const SplitChain& chain, double step, const Isometry3d& target) {
  const Isometry3d actuation = motion_of(chain.actuation, step), rest = Isometry3d::Identity();
  return {chain.actuated_first ? actuation : rest,
          chain.actuated_first ? rest : actuation,
          target,
          chain.proximal,
          chain.distal,
          chain.proximal_center,
          chain.p};
}

// The same equation from the platform to the base.
ChainEquation inverted(const ChainEquation& equation, const SplitChain& chain) {
  return {Isometry3d::Identity(),
          equation.between.inverse(),
          equation.target.inverse() * equation.before,
          reversed(equation.far),
          reversed(equation.near),
          chain.distal_center,
          chain.c};
}

// The end that is solved first must be able to point the rod; the other must be able to make up any rotation
// left.
bool starts_at_platform(const SplitChain& chain) {
  if (is_free(chain.proximal)) return true;
  const bool far_is_short = !is_free(chain.distal) && !chain.distal.empty() && chain.distal.size() < 3;
  return far_is_short && chain.proximal.size() > 2;
}

}  // namespace

Completion::Completion(ClosureSystem system, Eigen::VectorXd reference, const PlatformMotion& motion,
                       std::vector<RecognisedLeg> legs, std::vector<PassiveChain> passive_chains,
                       std::vector<std::size_t> actuated_variables)
    : system_(std::move(system)),
      reference_(std::move(reference)),
      task_frame_(motion.task_frame),
      point_platform_(motion.point_platform),
      legs_(std::move(legs)),
      passive_chains_(std::move(passive_chains)),
      actuated_variables_(std::move(actuated_variables)) {
  const Isometry3d platform = task_frame_.inverse() * motion.platform;
  reference_pose_.position = platform.translation();
  reference_pose_.orientation = Eigen::Quaterniond(platform.linear()).normalized();
}

JointVector Completion::reference_joints() const {
  JointVector q(static_cast<Eigen::Index>(actuated_variables_.size()));
  for (std::size_t j = 0; j < actuated_variables_.size(); ++j)
    q[static_cast<Eigen::Index>(j)] = reference_[static_cast<Eigen::Index>(actuated_variables_[j])];
  return q;
}

Eigen::VectorXd Completion::joint_values(const Pose& pose, const JointVector& q) const {
  const Isometry3d now = Eigen::Translation3d(pose.position) * pose.orientation;
  const Isometry3d then = Eigen::Translation3d(reference_pose_.position) * reference_pose_.orientation;
  Isometry3d platform = task_frame_ * now * then.inverse() * task_frame_.inverse();
  Eigen::VectorXd values = reference_;
  const JointVector steps = q - reference_joints();
  // A leg whose rod carries the operational point itself turns the link of that point.
  for (std::size_t j = 0; point_platform_ && j < legs_.size(); ++j)
    for (const SplitChain& chain : legs_[j].chains)
      if (chain.distal.empty())
        platform = solve(chain, steps[static_cast<Eigen::Index>(j)], platform, values);
  for (std::size_t j = 0; j < legs_.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    values[static_cast<Eigen::Index>(actuated_variables_[j])] = q[index];
    for (const SplitChain& chain : legs_[j].chains) solve(chain, steps[index], platform, values);
  }
  for (const PassiveChain& chain : passive_chains_)
    if (chain.follower.empty())
      follow(chain, platform, values);
    else
      for (const FollowerStep& each : steps_of_follower(chain.follower, platform, system_.size()))
        set(each.joint, each.step, values);
  return values;
}

Eigen::Isometry3d Completion::solve(const SplitChain& chain, double joint_step,
                                    const Isometry3d& platform_motion, Eigen::VectorXd& values) const {
  ChainEquation equation = equation_of(chain, joint_step, platform_motion);
  if (starts_at_platform(chain)) equation = inverted(equation, chain);
  const Vector3d from = equation.between * equation.tip - equation.near_center;
  const Vector3d to = equation.before.inverse() * (equation.target * equation.tip) - equation.near_center;
  const Turns near = turns_towards(equation.near, equation.tip - equation.near_center, from, to);
  const Isometry3d carried =
      equation.before * about(equation.near_center, product(equation.near, near)) * equation.between;
  const Chain revolute = three_that_turn(equation.far);
  const Turns far = turns_making(revolute, carried.linear().transpose() * equation.target.linear());
  for (const Turn& turn : near) set(*turn.pivot, turn.step, values);
  for (const Turn& turn : far) set(*turn.pivot, turn.step, values);
  return carried;
}

// The rotations make up the orientation, and the slides what is left of the displacement. A ball joint takes
// any orientation, about its centre.
void Completion::follow(const PassiveChain& chain, const Isometry3d& platform_motion,
                        Eigen::VectorXd& values) const {
  Vector3d displacement = platform_motion.translation();
  if (is_free(chain.rotations)) {
    const Vector3d& center = chain.rotations.front().point;
    displacement = platform_motion * center - center;
  } else {
    const Turns turns = turns_making(chain.rotations, platform_motion.linear());
    Isometry3d turned = Isometry3d::Identity();
    for (const Pivot& pivot : chain.rotations)
      for (const Turn& turn : turns)
        if (turn.pivot == &pivot) turned = turned * motion_of(pivot, turn.step);
    displacement = (platform_motion * turned.inverse()).translation();
    for (const Turn& turn : turns) set(*turn.pivot, turn.step, values);
  }
  if (chain.slides.empty()) return;
  Eigen::MatrixXd axes(3, static_cast<Eigen::Index>(chain.slides.size()));
  for (std::size_t k = 0; k < chain.slides.size(); ++k)
    axes.col(static_cast<Eigen::Index>(k)) = directed_axis(chain.slides[k]);
  const Eigen::VectorXd steps = least_squares_solution(axes, displacement, 1e-6);
  for (std::size_t k = 0; k < chain.slides.size(); ++k)
    set(chain.slides[k], steps[static_cast<Eigen::Index>(k)], values);
}

void Completion::set(const Pivot& pivot, double step, Eigen::VectorXd& values) const {
  if (!pivot.variable) return;
  const auto index = static_cast<Eigen::Index>(*pivot.variable);
  if (pivot.kind == PivotKind::prismatic) {
    values[index] = reference_[index] + step;
    return;
  }
  const JointLimits& limits = system_.tree().joint_of(*pivot.variable).limits;
  const double value = std::remainder(reference_[index] + step, 2.0 * EIGEN_PI);
  values[index] = value;
  for (const double turned : {value - 2.0 * EIGEN_PI, value + 2.0 * EIGEN_PI})
    if (!limits.contain(value) && limits.contain(turned)) values[index] = turned;
}

double Completion::residual(const Eigen::VectorXd& values) const {
  return system_.residual(values).lpNorm<Eigen::Infinity>() / system_.size();
}

}  // namespace parallel_aspects
