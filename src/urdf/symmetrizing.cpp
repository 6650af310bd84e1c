// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/symmetrizing.h"

#include "aspects/symmetry/constraint_symmetry.h"
#include "aspects/symmetry/near_constraints.h"
#include "model/number_text.h"
#include "urdf/stated_constraints.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double usual_tolerance = 1e-4, exact = 1e-11;  // of the size of the robot, and rad

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

struct LostMotions {
  std::vector<SymmetricMotion> motions;  // that take a constraint elsewhere
  std::string kinds;                     // of such: "constraints.workspace and constraints.obstacles"
};

LostMotions lost_motions(const ManipulatorDescription& robot, const std::vector<SymmetricMotion>& motions) {
  LostMotions lost;
  std::vector<bool> is_lost(motions.size(), false);
  for (const auto& [name, constraints] : kinds_of(robot.constraints)) {
    ManipulatorDescription with_one = robot;
    with_one.constraints = constraints;
    const Manipulator manipulator(with_one);
    bool any = false;
    for (std::size_t k = 0; k < motions.size(); ++k) {
      if (takes_constraints(motions[k].motion, motions[k].leg_image, manipulator)) continue;
      any = is_lost[k] = true;
    }
    if (any) lost.kinds += (lost.kinds.empty() ? "" : " and ") + name;
  }
  for (std::size_t k = 0; k < motions.size(); ++k)
    if (is_lost[k]) lost.motions.push_back(motions[k]);
  return lost;
}

bool bounds_no_map(const Leg& leg, const ConstraintsConfig& config) {
  return !config.actuated_limits ||
         (!config.strict_limits && leg.actuated_by_angle() && leaves_nearly_a_turn(leg.limits));
}

// Limits that bound no map are not compared.
std::vector<Leg> legs_to_compare(const Manipulator& robot, const MechanismConfig& config) {
  std::vector<Leg> legs = robot.legs();
  for (Leg& leg : legs)
    if (bounds_no_map(leg, config.constraints)) leg.limits = {};
  return legs;
}

SymmetricLegs symmetric_legs(const Manipulator& robot, const MechanismConfig& config, double tolerance) {
  const std::vector<Leg> legs = legs_to_compare(robot, config);
  SymmetricLegs found = nearest_symmetric_legs(robot.task_space(), legs, robot.size(), tolerance);
  for (std::size_t j = 0; j < legs.size(); ++j)
    if (bounds_no_map(robot.leg(j), config.constraints)) found.legs[j].limits = robot.leg(j).limits;
  return found;
}

// Moves no more than the loader rounds anyway, so that it is not reported.
void keep_decimal_symmetry(Mechanism::Contents& contents, const MechanismConfig& config) {
  const Manipulator& robot = *contents.manipulator;
  SymmetricLegs found =
      symmetric_in_decimals(robot.task_space(), legs_to_compare(robot, config), robot.size());
  if (found.motions.empty()) return;
  ManipulatorDescription description = robot.description();
  for (std::size_t j = 0; j < found.legs.size(); ++j) description.legs[j].actuation = found.legs[j].actuation;
  contents.manipulator = std::make_shared<const Manipulator>(std::move(description));
  contents.symmetric = std::move(found);
}

}  // namespace

void symmetrize_legs(Mechanism::Contents& contents, const MechanismConfig& config, const SourceNames& files) {
  if (!config.symmetrize) return keep_decimal_symmetry(contents, config);
  const Manipulator& robot = *contents.manipulator;
  const TaskSpace space = robot.task_space();
  SymmetricLegs found = symmetric_legs(robot, config, *config.symmetrize);
  const std::string asked =
      "mechanism.symmetrize: " + number_text(*config.symmetrize, 2) + " of " + files.config;
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

std::optional<std::string> note_on_symmetry(const Mechanism::Contents& contents,
                                            const MechanismConfig& config, const SourceNames& files) {
  const Manipulator& robot = *contents.manipulator;
  const TaskSpace space = robot.task_space();
  if (config.symmetrize || space == TaskSpace::SE3) return std::nullopt;
  const SymmetricLegs found = symmetric_legs(robot, config, usual_tolerance);
  const double size = space == TaskSpace::SO3 ? 1.0 : robot.size();
  if (found.length.amount <= exact * size && found.angle.amount <= exact) return std::nullopt;
  return files.urdf + " is symmetric under " + listed(found.motions, space) + " but for " +
         number_text(found.length.amount, 2) + " m and " + number_text(found.angle.amount, 2) +
         " rad, as if rounded; mechanism: {symmetrize: 1.0e-4} in " + files.config +
         " takes the symmetric robot nearest to it, whose maps take less time.";
}

void symmetrize_constraints(ManipulatorDescription& robot, const SymmetricLegs& legs, double size,
                            double tolerance, const SourceNames& files, Notes& notes) {
  if (legs.motions.empty()) return;
  SymmetricConstraints found = nearest_symmetric_constraints(robot, legs, size, tolerance);
  robot.constraints = std::move(found.constraints);
  if (found.length.amount > 0.0 || found.angle.amount > 0.0)
    notes.push_back("By mechanism.symmetrize the constraints of " + files.config +
                    " and the limits of passive joints are made symmetric, too, which moves " +
                    moved(found.length, "lengths", "m") + " and " + moved(found.angle, "angles", "rad") +
                    ".");
  const LostMotions lost = lost_motions(robot, legs.motions);
  if (lost.motions.empty()) return;
  const bool all = lost.motions.size() == legs.motions.size();
  notes.push_back("Maps make no use of " +
                  (all ? "the symmetry" : "symmetry " + listed(lost.motions, robot.task_space)) + " of " +
                  files.urdf + " while these are not symmetric: " + lost.kinds + ".");
}

}  // namespace parallel_aspects
