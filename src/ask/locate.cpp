// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"
#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/inverse_direct.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::ask {
namespace {

int sign_of(double value) { return (value > 0.0) - (value < 0.0); }

std::string branch_text(const Manipulator& robot, const LocatedConfiguration& each) {
  const TaskVector diagonal = inverse_diagonal(robot, each.pose, each.q);
  WorkingMode mode(robot.leg_count());
  for (std::size_t j = 0; j < mode.leg_count(); ++j)
    mode.set_sign(j, diagonal[static_cast<Eigen::Index>(j)] < 0.0 ? -1 : 1);
  return to_string(mode) + ", det A " +
         (each.determinant_sign > 0   ? "> 0"
          : each.determinant_sign < 0 ? "< 0"
                                      : "= 0");
}

bool fits(const Manipulator& robot, const LocatedConfiguration& each, const std::optional<WorkingMode>& mode,
          int sign) {
  if (each.determinant_sign * sign < 0) return false;
  const TaskVector diagonal = inverse_diagonal(robot, each.pose, each.q);
  for (std::size_t j = 0; mode && j < mode->leg_count(); ++j)
    if (diagonal[static_cast<Eigen::Index>(j)] * mode->sign(j) < 0.0) return false;
  return true;
}

/// One question on its way to an answer.
class Locating {
 public:
  Locating(Session& session, const LocateQuestion& question, const Control& control)
      : session_(session), question_(question), control_(control) {}

  Outcome<LocateAnswer> run() {
    check();
    if (problems_.empty()) find();
    if (problems_.empty() && !result_.configurations.empty()) locate();
    return outcome_of(std::move(problems_), control_, std::move(result_));
  }

 private:
  const Manipulator& robot() const { return *session_.robot(); }
  bool has_map() const { return ask::has_map(result_.slice, robot()); }

  void check() {
    result_.task_space = robot().task_space();
    result_.slice = session_.slice_of(question_.map);
    if (!question_.pose && !question_.joints)
      problems_.push_back(
          {ProblemKind::missing, "pose", "{pose} is required", "give the pose of the platform, or {joints}"});
    check_sources(has_map(), question_.map, question_.roadmap, problems_);
  }

  // At a pose the working mode chooses the joint values, also where a leg is stretched and has no sign.
  void find() {
    Pose pose = question_.pose.value_or(Pose());
    if (question_.pose && result_.slice) put_onto_slice(*result_.slice, robot(), "pose", pose, problems_);
    std::optional<WorkingMode> mode = question_.mode;
    if (question_.pose && question_.joints) {
      result_.configurations = {configuration_of(robot(), pose, *question_.joints)};
    } else if (question_.pose) {
      result_.configurations = configurations_at(robot(), pose, mode, result_.reason);
      mode.reset();
    } else {
      result_.status = configurations_at(robot(), *question_.joints, result_.configurations, result_.reason);
    }
    const std::string contradiction =
        keep_stated(robot(), mode, value_of(question_.sign), result_.configurations);
    if (!contradiction.empty()) result_.reason = contradiction;
  }

  void locate() {
    std::shared_ptr<const AspectMap> map = question_.brief ? session_.known_map() : nullptr;
    std::shared_ptr<const PoseRoadmap> roadmap = question_.brief ? session_.known_roadmap() : nullptr;
    if (!question_.brief && has_map()) {
      const FoundMap found = session_.map(question_.map, {}, control_, problems_);
      map = found.map;
      result_.loaded = found.loaded;
    } else if (!question_.brief) {
      roadmap = session_.roadmap(question_.roadmap.options({}), control_, problems_);
    }
    for (LocatedConfiguration& each : result_.configurations)
      locate_in(robot(), map.get(), has_map() ? nullptr : roadmap.get(), each);
  }

  Session& session_;
  const LocateQuestion& question_;
  const Control& control_;
  LocateAnswer result_;
  ProblemList problems_;
};

}  // namespace

LocatedConfiguration configuration_of(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  return {pose,
          q,
          working_mode(robot, pose, q),
          sign_of(direct_determinant(robot, pose, q)),
          robot.within_limits(q),
          missed_margins(robot, pose, q),
          {},
          {}};
}

void locate_in(const Manipulator& robot, const AspectMap* map, const PoseRoadmap* roadmap,
               LocatedConfiguration& configuration) {
  if (map != nullptr && !configuration.mode)
    configuration.location = {LocationStatus::undecided, 0};
  else if (map != nullptr && !robot.within_limits(configuration.q))
    configuration.location = {LocationStatus::outside, 0};
  else if (map != nullptr)
    configuration.location = map->locate(configuration.pose, *configuration.mode);
  if (roadmap != nullptr && configuration.mode)
    configuration.component =
        parallel_aspects::locate(*roadmap, configuration.pose, *configuration.mode).component;
}

std::vector<LocatedConfiguration> configurations_at(const Manipulator& robot, const Pose& pose,
                                                    const std::optional<WorkingMode>& mode,
                                                    std::string& reason) {
  std::vector<LocatedConfiguration> found;
  for (const WorkingMode& each : mode ? std::vector<WorkingMode>{*mode} : working_modes(robot)) {
    const InverseSolution solution = inverse(robot, pose, each);
    if (solution)
      found.push_back(configuration_of(robot, pose, solution.q));
    else
      reason = "No configuration: " + reason_of(robot, pose, solution);
  }
  if (!found.empty()) reason.clear();
  return found;
}

DirectStatus configurations_at(const Manipulator& robot, const JointVector& q,
                               std::vector<LocatedConfiguration>& found, std::string& reason) {
  const DirectResult result = direct(robot, q);
  if (result.status == DirectStatus::continuum)
    reason = "With these actuated joints locked the platform can still move; its pose is not determined.";
  else if (result.status == DirectStatus::unsolved)
    reason = "The direct kinematics could not be solved completely for these actuated joints.";
  else if (result.solutions.empty())
    reason = "The robot does not assemble at these actuated joints.";
  if (result)
    for (const AssemblyMode& each : result.solutions) found.push_back(configuration_of(robot, each.pose, q));
  return result.status;
}

std::string keep_stated(const Manipulator& robot, const std::optional<WorkingMode>& mode, int sign,
                        std::vector<LocatedConfiguration>& configurations) {
  std::string others;
  for (const LocatedConfiguration& each : configurations)
    others += (others.empty() ? "" : " or ") + branch_text(robot, each);
  configurations.erase(
      std::remove_if(configurations.begin(), configurations.end(),
                     [&](const LocatedConfiguration& each) { return !fits(robot, each, mode, sign); }),
      configurations.end());
  if (!configurations.empty() || others.empty()) return "";
  std::string stated = mode ? "working mode " + to_string(*mode) : "";
  if (sign != 0) stated += std::string(stated.empty() ? "" : ", ") + "det A " + (sign > 0 ? "> 0" : "< 0");
  return "The robot is then in " + others + ", which contradicts " + stated + ".";
}

Outcome<LocateAnswer> answer(Session& session, const LocateQuestion& question, const Control& control) {
  return Locating(session, question, control).run();
}

}  // namespace parallel_aspects::ask
