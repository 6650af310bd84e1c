// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "model/spherical_links.h"
#include "parallel_aspects/ask/robot_description.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/wings.h"
#include "parallel_aspects/singularity/indices.h"
#include "tools/report/answer_json.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/report/reports.h"
#include "tools/robot_report/reach_report.h"
#include "tools/subcommands.h"

#include <variant>

namespace parallel_aspects::tools {

Report report_robots(const std::vector<std::string>& names) {
  Report report{{{"robots", names}}, ""};
  for (const std::string& name : names) report.text += name + '\n';
  return report;
}

Subcommand robots_subcommand() {
  return {"robots", "List the shipped robots", {}, [](const Surroundings&) {
            const auto share = share_folder();
            Report report = report_robots(shipped_robots(share));
            report.json["arms"] = shipped_arms(share);
            for (const std::string& arm : shipped_arms(share)) report.text += arm + " (serial arm)\n";
            return report;
          }};
}

namespace {

struct ActuatedJointText {
  const Leg& leg;

  std::string operator()(const RevoluteActuation& actuation) const {
    return "crank " + shown(actuation.radius) + ", rod " + shown(leg.rod_length);
  }
  std::string operator()(const PrismaticActuation&) const { return "rod " + shown(leg.rod_length); }
  std::string operator()(const StrutActuation& actuation) const {
    return shown(actuation.length_at_zero) + " at q = 0";
  }
  std::string operator()(const ElbowActuation& actuation) const {
    return "inner " + shown(actuation.inner_length) + ", outer " + shown(actuation.outer_length);
  }
};

std::string point_text(const Eigen::Vector3d& point) {
  const Eigen::Vector3d told = point.unaryExpr(&without_noise);
  return "(" + shown(told.x()) + ", " + shown(told.y()) + ", " + shown(told.z()) + ")";
}

std::string limits_text(const Leg& leg) {
  if (!leg.limits.limited()) return "none";
  return "[" + shown(leg.limits.lower) + ", " + shown(leg.limits.upper) + "] " + joint_unit(leg);
}

std::string length_table(const Manipulator& manipulator) {
  TextTable table({"leg", "kind", "actuated joint", "lengths [m]", "base point [m]", "anchor [m]", "limits"});
  for (const Leg& leg : manipulator.legs())
    table.add({leg.name, std::string(leg.kind().name), leg.actuated_joint,
               std::visit(ActuatedJointText{leg}, leg.actuation), point_text(leg.base_point()),
               point_text(leg.anchor), limits_text(leg)});
  return table.text();
}

// Only the directions of the axes count, and the angles between them.
std::string angle_table(const Manipulator& manipulator) {
  TextTable table({"leg", "actuated joint", "crank", "rod", "axis of the actuated joint",
                   "axis at the platform", "limits"});
  for (const Leg& leg : manipulator.legs()) {
    const SphericalLinks links = *spherical_links(leg);
    table.add({leg.name, leg.actuated_joint, shown_angle(links.crank), shown_angle(links.rod),
               point_text(leg.crank()->axis), point_text(leg.anchor), limits_text(leg)});
  }
  return table.text();
}

std::string leg_table(const Manipulator& manipulator) {
  return moves_on_unit_sphere(manipulator) ? angle_table(manipulator) : length_table(manipulator);
}

std::string modes_text(const Manipulator& manipulator) {
  std::string text;
  for (const WorkingMode& mode : working_modes(manipulator)) text += ' ' + to_string(mode);
  return text;
}

std::string mobility_text(const Mechanism& mechanism) {
  const std::string text = std::to_string(mechanism.mobility());
  const int idle = mechanism.idle_degrees_of_freedom();
  return idle == 0 ? text : text + " of which " + std::to_string(idle) + " idle";
}

// Every movable joint, with its limits where it has some.
std::string joints_text(const Mechanism& mechanism) {
  std::string text = "joints:";
  for (std::size_t k = 0; k < mechanism.joint_names().size(); ++k) {
    const JointLimits& limits = mechanism.joint_limits()[k];
    text += ' ' + mechanism.joint_names()[k];
    if (limits.limited()) text += " [" + shown(limits.lower) + ", " + shown(limits.upper) + "]";
  }
  return text + '\n';
}

// Where poses are counted from, so that nobody guesses.
std::string frame_text(const Manipulator& manipulator) {
  const std::string start = "poses are given in the task frame, ";
  const Eigen::Isometry3d& frame = manipulator.task_frame();
  if (frame.matrix().isIdentity()) return start + "which is the frame of " + manipulator.base_frame() + "\n";
  const Eigen::Matrix3d axes = frame.linear();
  return start + "which has in that of " + manipulator.base_frame() + " its origin at " +
         point_text(frame.translation()) + " m, x along " + point_text(axes.col(0)) + ", y along " +
         point_text(axes.col(1)) + "\n";
}

// Those in force, and what the home pose lacks of them.
std::string margins_text(const Mechanism& mechanism) {
  const Manipulator& manipulator = *mechanism.manipulator();
  const std::string margins = to_string(manipulator.constraints().margins);
  if (margins.empty()) return "";
  const AssembledConfiguration home = mechanism.home();
  const std::string missed = missed_margins(manipulator, home.pose, home.q);
  return "margins from singularities: " + margins + (missed.empty() ? "" : "; at the home pose " + missed) +
         "\n";
}

std::string size_text(const Manipulator& manipulator) {
  return moves_on_unit_sphere(manipulator) ? "" : ", size " + shown(manipulator.size()) + " m";
}

std::string mechanism_text(const ask::RobotDescription& description, bool verbose) {
  const Mechanism& mechanism = *description.mechanism;
  const Manipulator& manipulator = *mechanism.manipulator();
  const TaskSpace space = manipulator.task_space();
  std::string text = manipulator.name() + ": fully parallel, task space " + std::string(name(space)) +
                     ", mobility " + mobility_text(mechanism) + ", " +
                     counted(manipulator.leg_count(), "leg") + "\n";
  text += "base link " + manipulator.base_frame() + ", operational point at the origin of " +
          mechanism.platform_link() + size_text(manipulator) + "\n";
  text += frame_text(manipulator) + home_text(description) + reach_text(description) + "\n";
  text += leg_table(manipulator);
  text += "\nworking modes, as signs of B_jj:" + modes_text(manipulator) + "\n";
  text += joints_text(mechanism) + margins_text(mechanism) + cones_text(manipulator, verbose);
  return text + notes_text(mechanism.notes_in_pieces(), verbose);
}

}  // namespace

Report report_mechanism(const std::shared_ptr<const Mechanism>& mechanism, bool verbose) {
  ask::Session session(mechanism->manipulator());
  session.know(mechanism);
  const ask::RobotDescription description = answer(session, ask::DescribeQuestion()).answer;
  return {answer_json(*mechanism->manipulator(), description), mechanism_text(description, verbose)};
}

namespace {

// What `map` and `plan` refuse is refused here, too.
std::shared_ptr<const Mechanism> load_checked(const RobotChoice& robot) {
  Problems problems;
  const MapSection section = load_map_section(robot, problems);
  auto mechanism = load_robot(robot, problems);
  resolve_region(section.config, mechanism->manipulator()->task_space(), section.file, problems);
  if (!problems.empty()) throw InvalidDescription(problems);
  return mechanism;
}

}  // namespace

Subcommand describe_subcommand() {
  struct Arguments {
    RobotChoice robot;
    bool verbose = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  return {"describe",
          "Show what is recognised in the description of a robot",
          robot_options(arguments->robot),
          [arguments](const Surroundings& surroundings) {
            const RobotChoice& robot = arguments->robot;
            const std::string urdf = robot.urdf_file();
            if constexpr (wings::setup)
              if (!urdf.empty() && robot.config_file().empty()) return describe_bare(urdf, surroundings);
            return report_mechanism(load_checked(robot), arguments->verbose);
          },
          {{"--verbose", "List every joint that a note is about", &arguments->verbose}}};
}

}  // namespace parallel_aspects::tools
