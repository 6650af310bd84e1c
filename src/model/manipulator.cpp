// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/manipulator.h"

#include "parallel_aspects/model/problems.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

// Directions come from URDF text with few digits and are normalised there; what is left is rounding.
constexpr double direction_tolerance = 1e-9;

/// No range; the speed stays limited.
JointLimits without_range(const JointLimits& limits) {
  JointLimits result;
  result.velocity = limits.velocity;
  return result;
}

class LegCheck {
 public:
  LegCheck(const Leg& leg, Problems& problems) : leg_(leg), problems_(problems) {
    finite(leg.anchor, "anchor");
    std::visit([this](const auto& actuation) { check(actuation); }, leg.actuation);
    if (std::isnan(leg.limits.lower) || std::isnan(leg.limits.upper) || leg.limits.lower > leg.limits.upper)
      say("has joint limits that are NaN or whose lower end is above the upper one; correct the limits of "
          "joint "
          "'" +
          leg.actuated_joint + "'.");
    if (!std::isfinite(leg.tolerance) || leg.tolerance < 0.0)
      say("has a tolerance that is not finite or is negative; give a length in metres, or 0.");
    if (!(leg.limits.velocity > 0.0))
      say("has a velocity limit that is not positive; give one, or none, to joint '" + leg.actuated_joint +
          "'.");
  }

 private:
  void say(const std::string& text) { problems_.push_back("Leg '" + leg_.name + "' " + text); }

  void finite(const Eigen::Vector3d& value, const std::string& what) {
    if (!value.allFinite()) say("has a " + what + " that is not finite; give finite numbers.");
  }

  void positive(double value, const std::string& what) {
    if (!std::isfinite(value) || value <= 0.0)
      say("has a " + what + " of " + std::to_string(value) + " m; it must be finite and positive.");
  }

  void unit(const Eigen::Vector3d& value, const std::string& what) {
    if (!value.allFinite() || std::abs(value.norm() - 1.0) > direction_tolerance)
      say("has a " + what + " that is not a unit vector; normalise it.");
  }

  void sign(double value) {
    if (value != 1.0 && value != -1.0)
      say("has an actuated joint sense that is neither 1 nor -1; give one of them.");
  }

  void check(const RevoluteActuation& actuation) {
    finite(actuation.center, "actuated joint center");
    unit(actuation.axis, "actuated joint axis");
    unit(actuation.zero_direction, "zero direction");
    if (std::abs(actuation.axis.dot(actuation.zero_direction)) > direction_tolerance)
      say("has a zero direction that is not orthogonal to its actuated joint axis; project it.");
    positive(actuation.radius, "crank length");
    positive(leg_.rod_length, "rod length");
  }

  void check(const PrismaticActuation& actuation) {
    finite(actuation.origin, "actuated joint origin");
    unit(actuation.direction, "actuated joint direction");
    positive(leg_.rod_length, "rod length");
  }

  void check(const StrutActuation& actuation) {
    finite(actuation.base, "base point");
    sign(actuation.sense);
    if (!std::isfinite(actuation.length_at_zero))
      say("has a strut length that is not finite; give a finite one.");
  }

  void check(const ElbowActuation& actuation) {
    finite(actuation.base, "base point");
    positive(actuation.inner_length, "inner length");
    positive(actuation.outer_length, "outer length");
    sign(actuation.sense);
    if (!std::isfinite(actuation.angle_at_zero))
      say("has an elbow angle that is not finite; give a finite one.");
  }

  const Leg& leg_;
  Problems& problems_;
};

void check_names(const std::vector<Leg>& legs, Problems& problems) {
  std::set<std::string> names, joints;
  for (const Leg& leg : legs) {
    if (leg.name.empty() || !names.insert(leg.name).second)
      problems.push_back("Two legs are named '" + leg.name + "', or the name is empty; name each leg once.");
    if (leg.actuated_joint.empty() || !joints.insert(leg.actuated_joint).second)
      problems.push_back("Two legs are actuated by '" + leg.actuated_joint +
                         "', or the joint's name is empty; each leg needs one actuated joint of its own.");
  }
}

void check_leg_count(const ManipulatorDescription& description, Problems& problems) {
  const std::size_t expected = degrees_of_freedom(description.task_space);
  if (description.legs.size() != expected)
    problems.push_back("Manipulator '" + description.name + "' has " +
                       std::to_string(description.legs.size()) + " legs, but its task space " +
                       std::string(name(description.task_space)) + " needs " + std::to_string(expected) +
                       ", one for each degree of freedom of the platform.");
}

void check_hinges(const ManipulatorDescription& description, Problems& problems) {
  if (description.task_space != TaskSpace::R2) return;
  const HingePair& hinges = description.hinges;
  if (!std::isfinite(hinges.offset) ||
      !(hinges.twist > 0.0 && std::sin(hinges.twist) > HingePair::least_sine))
    problems.push_back("The passive chain of '" + description.name +
                       "' needs a finite offset and an angle of more than 0.01 rad between its two axes; "
                       "correct them.");
}

Problems find_problems(const ManipulatorDescription& description) {
  Problems problems;
  if (description.name.empty()) problems.emplace_back("The manipulator has no name; give one.");
  check_leg_count(description, problems);
  check_hinges(description, problems);
  check_names(description.legs, problems);
  for (const Leg& leg : description.legs) LegCheck(leg, problems);
  if (!description.task_frame.matrix().allFinite())
    problems.emplace_back("The task frame is not finite; give finite numbers.");
  const Problems of_constraints =
      find_problems(description.constraints, description.task_space, description.legs);
  problems.insert(problems.end(), of_constraints.begin(), of_constraints.end());
  return problems;
}

double mean_anchor_distance(const std::vector<Leg>& legs) {
  double sum = 0.0;
  for (const Leg& leg : legs) sum += leg.anchor.squaredNorm();
  return std::sqrt(sum / static_cast<double>(legs.size()));
}

double robot_size(const std::vector<Leg>& legs) {
  double spread = 0.0, reach = 0.0;
  for (const Leg& one : legs) {
    for (const Leg& other : legs) spread = std::max(spread, (one.base_point() - other.base_point()).norm());
    if (std::isfinite(one.longest_reach())) reach = std::max(reach, one.longest_reach());
    reach = std::max(reach, one.rod_length);
  }
  return spread + reach;
}

}  // namespace

Manipulator::Manipulator(ManipulatorDescription description) : description_(std::move(description)) {
  Problems problems = find_problems(description_);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const double distance = mean_anchor_distance(description_.legs);
  characteristic_length_ = has_rotation(description_.task_space) && distance > 0.0 ? distance : 1.0;
  size_ = robot_size(description_.legs);
}

ConstraintKinds Manipulator::constraint_kinds() const noexcept {
  const Constraints& constraints = description_.constraints;
  ConstraintKinds kinds;
  kinds[index_of(ConstraintKind::actuated_limits)] =
      std::any_of(legs().begin(), legs().end(), [](const Leg& leg) { return leg.limits.limited(); });
  kinds[index_of(ConstraintKind::passive_limits)] = !constraints.passive_limits.empty() ||
                                                    !constraints.passive_cones.empty() ||
                                                    !constraints.hinge_limits.empty();
  kinds[index_of(ConstraintKind::cones)] = !constraints.cones.empty();
  kinds[index_of(ConstraintKind::self_collision)] = constraints.self_collision.has_value();
  kinds[index_of(ConstraintKind::obstacles)] = !constraints.obstacles.empty();
  kinds[index_of(ConstraintKind::workspace)] = constraints.workspace.has_value();
  kinds[index_of(ConstraintKind::margins)] = constraints.margins.any();
  return kinds;
}

std::shared_ptr<const Manipulator> Manipulator::with_constraints(ConstraintKinds kinds) const {
  const auto asked = [&kinds](ConstraintKind kind) { return kinds[index_of(kind)]; };
  ManipulatorDescription description = description_;
  Constraints& constraints = description.constraints;
  if (!asked(ConstraintKind::actuated_limits))
    for (Leg& leg : description.legs) leg.limits = without_range(leg.limits);
  if (!asked(ConstraintKind::passive_limits)) {
    constraints.passive_limits.clear();
    constraints.passive_cones.clear();
    constraints.hinge_limits.clear();
    constraints.missing_joints.clear();
  }
  if (!asked(ConstraintKind::cones)) constraints.cones.clear();
  if (!asked(ConstraintKind::self_collision))
    constraints.self_collision.reset();
  else if (!constraints.self_collision)
    constraints.self_collision.emplace();
  if (!asked(ConstraintKind::obstacles)) constraints.obstacles.clear();
  if (!asked(ConstraintKind::workspace)) constraints.workspace.reset();
  if (!asked(ConstraintKind::margins)) constraints.margins = {};
  return std::make_shared<const Manipulator>(std::move(description));
}

std::shared_ptr<const Manipulator> Manipulator::with_margins(const Margins& margins) const {
  ManipulatorDescription description = description_;
  description.constraints.margins = margins;
  return std::make_shared<const Manipulator>(std::move(description));
}

std::shared_ptr<const Manipulator> Manipulator::with_tolerance(double share) const {
  ManipulatorDescription description = description_;
  for (Leg& leg : description.legs) leg.tolerance = share * size_;
  return std::make_shared<const Manipulator>(std::move(description));
}

double Manipulator::tolerance() const noexcept {
  double largest = 0.0;
  for (const Leg& leg : legs()) largest = std::max(largest, leg.tolerance);
  return largest;
}

bool Manipulator::within_limits(const JointVector& q) const noexcept {
  for (std::size_t j = 0; j < leg_count(); ++j) {
    const double value = q[static_cast<Eigen::Index>(j)];
    if (!std::isfinite(value) || !leg(j).limits.contain(value)) return false;
  }
  return true;
}

}  // namespace parallel_aspects
