// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/working_mode.h"
#include "tools/report/reports.h"
#include "tools/report/text_table.h"
#include "tools/subcommands.h"

#include <variant>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

json json_point(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

struct DriveJson {
  const Leg& leg;

  json operator()(const RevoluteDrive& drive) const {
    return {{"center", json_point(drive.center)},
            {"axis", json_point(drive.axis)},
            {"zero_direction", json_point(drive.zero_direction)},
            {"crank_length", drive.radius},
            {"rod_length", leg.rod_length}};
  }
  json operator()(const PrismaticDrive& drive) const {
    return {{"origin", json_point(drive.origin)},
            {"direction", json_point(drive.direction)},
            {"rod_length", leg.rod_length}};
  }
  json operator()(const StrutDrive& drive) const {
    return {
        {"base", json_point(drive.base)}, {"length_at_zero", drive.length_at_zero}, {"sense", drive.sense}};
  }
  json operator()(const ElbowDrive& drive) const {
    return {{"base", json_point(drive.base)},
            {"inner_length", drive.inner_length},
            {"outer_length", drive.outer_length},
            {"angle_at_zero", drive.angle_at_zero},
            {"sense", drive.sense}};
  }
};

struct DriveText {
  const Leg& leg;

  std::string operator()(const RevoluteDrive& drive) const {
    return "crank " + shown(drive.radius) + ", rod " + shown(leg.rod_length);
  }
  std::string operator()(const PrismaticDrive&) const { return "rod " + shown(leg.rod_length); }
  std::string operator()(const StrutDrive& drive) const { return shown(drive.length_at_zero) + " at q = 0"; }
  std::string operator()(const ElbowDrive& drive) const {
    return "inner " + shown(drive.inner_length) + ", outer " + shown(drive.outer_length);
  }
};

json json_limits(const JointLimits& limits) {
  return {{"lower", json_number(limits.lower)}, {"upper", json_number(limits.upper)}};
}

json json_joint_limits(const Mechanism& mechanism) {
  json object = json::object();
  for (std::size_t k = 0; k < mechanism.joint_names().size(); ++k)
    object[mechanism.joint_names()[k]] = json_limits(mechanism.joint_limits()[k]);
  return object;
}

json json_leg(const Leg& leg) {
  json object = std::visit(DriveJson{leg}, leg.drive);
  object["name"] = leg.name;
  object["kind"] = std::string(kind_name(leg.drive));
  object["driven_joint"] = leg.driven_joint;
  object["unit"] = drive_unit(leg);
  object["anchor"] = json_point(leg.anchor);
  object["limits"] = json_limits(leg.limits);
  return object;
}

json json_frame(const Eigen::Isometry3d& frame) {
  const Eigen::Quaterniond rotation(frame.rotation());
  return {{"position", json_point(frame.translation())},
          {"quaternion_xyzw", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}}};
}

json json_modes(const Manipulator& manipulator) {
  json modes = json::array();
  for (const WorkingMode& mode : working_modes(manipulator)) modes.push_back(mode.signs());
  return modes;
}

json json_mechanism(const Mechanism& mechanism) {
  const Manipulator& manipulator = *mechanism.manipulator();
  json legs = json::array();
  for (const Leg& leg : manipulator.legs()) legs.push_back(json_leg(leg));
  return {{"mechanism", manipulator.name()},
          {"task_space", std::string(name(manipulator.task_space()))},
          {"mobility", mechanism.mobility()},
          {"idle_freedoms", mechanism.idle_freedoms()},
          {"base_frame", manipulator.base_frame()},
          {"task_frame", json_frame(manipulator.task_frame())},
          {"platform_link", mechanism.platform_link()},
          {"size", manipulator.size()},
          {"legs", legs},
          {"joints", mechanism.joint_names()},
          {"joint_limits", json_joint_limits(mechanism)},
          {"working_modes", json_modes(manipulator)},
          {"notes", mechanism.notes()}};
}

std::string point_text(const Eigen::Vector3d& point) {
  return "(" + shown(point.x()) + ", " + shown(point.y()) + ", " + shown(point.z()) + ")";
}

std::string limits_text(const Leg& leg) {
  if (!leg.limits.limited()) return "none";
  return "[" + shown(leg.limits.lower) + ", " + shown(leg.limits.upper) + "] " + drive_unit(leg);
}

std::string leg_table(const Manipulator& manipulator) {
  TextTable table({"leg", "kind", "driven joint", "lengths [m]", "base point [m]", "anchor [m]", "limits"});
  for (const Leg& leg : manipulator.legs())
    table.add({leg.name, std::string(kind_name(leg.drive)), leg.driven_joint,
               std::visit(DriveText{leg}, leg.drive), point_text(leg.base_point()), point_text(leg.anchor),
               limits_text(leg)});
  return table.text();
}

std::string modes_text(const Manipulator& manipulator) {
  std::string text;
  for (const WorkingMode& mode : working_modes(manipulator)) text += ' ' + to_string(mode);
  return text;
}

std::string mobility_text(const Mechanism& mechanism) {
  const std::string text = std::to_string(mechanism.mobility());
  const int idle = mechanism.idle_freedoms();
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

std::string mechanism_text(const Mechanism& mechanism) {
  const Manipulator& manipulator = *mechanism.manipulator();
  const TaskSpace space = manipulator.task_space();
  std::string text = manipulator.name() + ": fully parallel, task space " + std::string(name(space)) +
                     ", mobility " + mobility_text(mechanism) + ", " +
                     counted(manipulator.leg_count(), "leg") + "\n";
  text += "base link " + manipulator.base_frame() + ", operational point at the origin of " +
          mechanism.platform_link() + ", size " + shown(manipulator.size()) + " m\n\n";
  text += leg_table(manipulator);
  text += "\nworking modes, as signs of B_jj:" + modes_text(manipulator) + "\n";
  text += joints_text(mechanism);
  for (const std::string& note : mechanism.notes()) text += "note: " + note + '\n';
  return text;
}

}  // namespace

Report report_mechanism(const Mechanism& mechanism) {
  return {json_mechanism(mechanism), mechanism_text(mechanism)};
}

Subcommand describe_subcommand() {
  const auto choice = std::make_shared<RobotChoice>();
  return {"describe", "Show what is recognised in the description of a robot", robot_options(*choice),
          [choice](const Surroundings&) { return report_mechanism(*load_robot(*choice)); }};
}

}  // namespace parallel_aspects::tools
