// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/symmetrizing.h"

#include "aspects/symmetry/constraint_symmetry.h"
#include "aspects/symmetry/near_constraints.h"
#include "model/number_text.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

std::string moved(const MovedNumber& most, const std::string& what, const std::string& unit) {
  return what + " by at most " + number_text(most.amount, 2) + " " + unit +
         (most.what.empty() ? "" : " (" + most.what + ")");
}

std::string listed(const std::vector<SymmetricMotion>& motions, TaskSpace space) {
  std::string text;
  for (const SymmetricMotion& each : motions)
    text += (text.empty() ? "" : "; ") + to_string(each.motion, space);
  return text;
}

// By kind, each with nothing but it.
std::vector<std::pair<std::string, Constraints>> kinds_of(const Constraints& all) {
  std::vector<std::pair<std::string, Constraints>> kinds(5);
  for (auto& kind : kinds) kind.second.thickness = all.thickness;
  kinds[0].first = "constraints.workspace";
  kinds[0].second.workspace = all.workspace;
  kinds[1].first = "constraints.obstacles";
  kinds[1].second.obstacles = all.obstacles;
  kinds[2].first = "constraints.self_collision";
  kinds[2].second.self_collision = all.self_collision;
  kinds[3].first = "constraints.cones";
  kinds[3].second.cones = all.cones;
  kinds[4].first = "the limits of passive joints";
  kinds[4].second.passive_limits = all.passive_limits;
  kinds[4].second.passive_cones = all.passive_cones;
  return kinds;
}

// "constraints.workspace and constraints.obstacles": what any motion takes elsewhere.
std::string asymmetric_kinds(const ManipulatorDescription& robot,
                             const std::vector<SymmetricMotion>& motions) {
  std::string text;
  for (const auto& [name, constraints] : kinds_of(robot.constraints)) {
    ManipulatorDescription with_one = robot;
    with_one.constraints = constraints;
    const Manipulator manipulator(with_one);
    const bool taken = std::all_of(motions.begin(), motions.end(), [&](const SymmetricMotion& each) {
      return takes_constraints(each.motion, each.leg_image, manipulator);
    });
    if (!taken) text += (text.empty() ? "" : " and ") + name;
  }
  return text;
}

}  // namespace

void symmetrize_legs(Mechanism::Contents& contents, std::optional<double> tolerance,
                     const SourceNames& files) {
  if (!tolerance) return;
  const Manipulator& robot = *contents.manipulator;
  const TaskSpace space = robot.task_space();
  SymmetricLegs found = nearest_symmetric_legs(space, robot.legs(), robot.size(), *tolerance);
  const std::string asked = "mechanism.symmetrize: " + number_text(*tolerance, 2) + " of " + files.config;
  if (found.motions.empty()) {
    contents.notes.push_back("No motion that permutes the axes of coordinates takes the robot of " +
                             files.urdf + " onto itself within " + asked +
                             "; its numbers are taken as they are.");
    return;
  }
  ManipulatorDescription description = robot.description();
  description.legs = std::exchange(found.legs, {});
  contents.notes.push_back("By " + asked + " the robot of " + files.urdf + " is made symmetric under " +
                           listed(found.motions, space) + ", which moves " +
                           moved(found.length, "lengths", "m") + " and " +
                           moved(found.angle, "angles", "rad") + ".");
  contents.manipulator = std::make_shared<const Manipulator>(std::move(description));
  contents.symmetric = std::move(found);
}

void symmetrize_constraints(ManipulatorDescription& robot, const SymmetricLegs& legs, double size,
                            double tolerance, const SourceNames& files, std::vector<std::string>& notes) {
  if (legs.motions.empty()) return;
  SymmetricConstraints found =
      nearest_symmetric_constraints(robot.constraints, robot.task_space, legs, size, tolerance);
  robot.constraints = std::move(found.constraints);
  if (found.length.amount > 0.0 || found.angle.amount > 0.0)
    notes.push_back("By mechanism.symmetrize the constraints of " + files.config +
                    " and the limits of passive joints are made symmetric, too, which moves " +
                    moved(found.length, "lengths", "m") + " and " + moved(found.angle, "angles", "rad") +
                    ".");
  const std::string left = asymmetric_kinds(robot, legs.motions);
  if (!left.empty())
    notes.push_back("Maps make no use of the symmetry of " + files.urdf +
                    " while these are not symmetric: " + left + ".");
}

}  // namespace parallel_aspects
