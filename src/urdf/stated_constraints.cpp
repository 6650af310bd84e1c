// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/stated_constraints.h"

#include "aspects/symmetry/near_constraints.h"
#include "aspects/symmetry/robot_symmetry.h"
#include "model/message_text.h"
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
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
  if (config.symmetrize || space == TaskSpace::SE3 || has_hinges(space)) return std::nullopt;
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

namespace {

// The workspace of the YAML, as far as slides let the operational point go there.
void intersect(const WorkspaceBox& slides, TaskSpace space, const SourceNames& files,
               std::optional<WorkspaceBox>& workspace, Problems& problems) {
  if (!workspace) workspace = slides;
  workspace->lower = workspace->lower.cwiseMax(slides.lower);
  workspace->upper = workspace->upper.cwiseMin(slides.upper);
  const auto count = static_cast<Eigen::Index>(directions(space));
  if ((workspace->lower.head(count).array() >= workspace->upper.head(count).array()).any())
    problems.push_back(files.config +
                       " has a constraints.workspace that the limits of the passive slides in " + files.urdf +
                       " leave no room in; widen one of them.");
}

// What limits may lack of a full turn where none are meant [rad].
constexpr double nearly_a_turn = 0.01;

constexpr double unlimited = std::numeric_limits<double>::infinity();

// Takes limits of revolute joints that leave nearly a full turn as none of the aspects.
class FullTurns {
 public:
  explicit FullTurns(const Mechanism::Contents& contents) : tree_(contents.completion.system().tree()) {}

  void leave_out(ManipulatorDescription& description) {
    for (Leg& leg : description.legs)
      if (leg.limits.limited() && is_left_out(leg.actuated_joint))
        leg.limits = {-unlimited, unlimited, leg.limits.velocity};
    auto& limits = description.constraints.passive_limits;
    limits.erase(std::remove_if(limits.begin(), limits.end(),
                                [this](const PassiveLimit& limit) { return is_left_out(limit.joint); }),
                 limits.end());
    auto& cones = description.constraints.passive_cones;
    cones.erase(std::remove_if(cones.begin(), cones.end(),
                               [this](const PassiveCone& cone) { return is_left_out(cone.joint); }),
                cones.end());
    auto& missing = description.constraints.missing_joints;
    missing.erase(std::remove_if(missing.begin(), missing.end(),
                                 [this](const std::string& joint) { return is_left_out(joint); }),
                  missing.end());
  }

  bool any() const { return !names_.empty(); }

  Note note(const SourceNames& files) const {
    Note note = files.urdf +
                " limits joints to less than 0.01 rad below a full turn, which bounds no aspect: " +
                listed_names(names_) + "; constraints: {strict_limits: true} in " + files.config +
                " takes the limits as they are.";
    note.is_on_limits_left_out = true;
    return note;
  }

 private:
  bool turns(const std::string& name) const {
    const auto joint = tree_.joint_named(name);
    return joint && tree_.joints[*joint].motion == JointMotion::revolute &&
           leaves_nearly_a_turn(tree_.joints[*joint].limits);
  }

  bool is_left_out(const std::string& joint) {
    if (!turns(joint)) return false;
    if (!contains(names_, joint)) names_.push_back(joint);
    return true;
  }

  const Tree& tree_;
  std::vector<std::string> names_;
};

// Those that the loader found; a workspace that slides leave bounds the stated one.
void keep_passive_limits(const Constraints& found, TaskSpace space, const SourceNames& files,
                         Constraints& constraints, Problems& problems) {
  constraints.passive_limits = found.passive_limits;
  constraints.passive_cones = found.passive_cones;
  constraints.hinge_limits = found.hinge_limits;
  constraints.missing_joints = found.missing_joints;
  if (found.workspace) intersect(*found.workspace, space, files, constraints.workspace, problems);
}

}  // namespace

bool leaves_nearly_a_turn(const JointLimits& limits) {
  const double lacking = 2.0 * EIGEN_PI - (limits.upper - limits.lower);
  return 0.0 < lacking && lacking < nearly_a_turn;
}

void add_stated_constraints(const ConstraintsConfig& config, std::optional<double> symmetrize,
                            const SourceNames& files, Mechanism::Contents& contents, Problems& problems) {
  const std::size_t before = problems.size();
  ManipulatorDescription description = contents.manipulator->description();
  const Constraints found = description.constraints;
  const ConstrainedRobot robot{description.task_space, description.legs.size(), contents.point_platform};
  description.constraints = resolve_constraints(config, robot, files.config, problems);
  if (config.passive_limits)
    keep_passive_limits(found, description.task_space, files, description.constraints, problems);
  if (!config.actuated_limits)
    for (Leg& leg : description.legs) leg.limits = {};
  if (problems.size() > before) return;
  ManipulatorDescription mapped = description;
  FullTurns full_turns(contents);
  if (!config.strict_limits) full_turns.leave_out(mapped);
  try {
    contents.manipulator = std::make_shared<const Manipulator>(description);
    if (!contents.symmetric.motions.empty()) {
      Notes unused;  // what bounds maps is reported, and what rounding moves is not
      const double size = contents.manipulator->size(), tolerance = symmetrize.value_or(rounding_of_decimals);
      symmetrize_constraints(description, contents.symmetric, size, tolerance, files, unused);
      symmetrize_constraints(mapped, contents.symmetric, size, tolerance, files,
                             symmetrize ? contents.notes : unused);
      contents.manipulator = std::make_shared<const Manipulator>(description);
    }
  } catch (const InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems()) problems.push_back(files.config + ": " + problem);
  }
  contents.mapped_manipulator = contents.manipulator;
  if (problems.size() > before || !full_turns.any()) return;
  contents.mapped_manipulator = std::make_shared<const Manipulator>(std::move(mapped));
  contents.notes.push_back(full_turns.note(files));
}

}  // namespace parallel_aspects
