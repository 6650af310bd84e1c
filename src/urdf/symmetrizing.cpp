// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/symmetrizing.h"

#include "aspects/symmetry/near_symmetry.h"
#include "model/number_text.h"

#include <utility>

namespace parallel_aspects {
namespace {

std::string number(double value) { return number_text(value, 2); }

std::string moved(const MovedNumber& most, const std::string& what, const std::string& unit) {
  return what + " by at most " + number(most.amount) + " " + unit +
         (most.what.empty() ? "" : " (" + most.what + ")");
}

std::string listed(const std::vector<RigidSymmetry>& motions, TaskSpace space) {
  std::string text;
  for (const RigidSymmetry& motion : motions) text += (text.empty() ? "" : "; ") + to_string(motion, space);
  return text;
}

}  // namespace

std::shared_ptr<const Manipulator> symmetrized(std::shared_ptr<const Manipulator> robot,
                                               std::optional<double> tolerance, const SourceNames& files,
                                               std::vector<std::string>& notes) {
  if (!tolerance) return robot;
  const TaskSpace space = robot->task_space();
  SymmetricLegs found = nearest_symmetric_legs(space, robot->legs(), robot->size(), *tolerance);
  const std::string asked = "mechanism.symmetrize: " + number(*tolerance) + " of " + files.config;
  if (found.motions.empty()) {
    notes.push_back("No motion that permutes the axes of coordinates takes the robot of " + files.urdf +
                    " onto itself within " + asked + "; its numbers are taken as they are.");
    return robot;
  }
  ManipulatorDescription description = robot->description();
  description.legs = std::move(found.legs);
  notes.push_back("By " + asked + " the robot of " + files.urdf + " is made symmetric under " +
                  listed(found.motions, space) + ", which moves " + moved(found.length, "lengths", "m") +
                  " and " + moved(found.angle, "angles", "rad") + ".");
  return std::make_shared<const Manipulator>(std::move(description));
}

}  // namespace parallel_aspects
