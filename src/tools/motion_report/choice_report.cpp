// SPDX-License-Identifier: BSD-3-Clause
#include "tools/motion_report/choice_report.h"

#include "tools/motion_report/violation_report.h"
#include "tools/report/bounds_report.h"
#include "tools/report/text_table.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

json json_clearance(const Manipulator& manipulator, const PathClearance& clearance) {
  return {{"proved", json_number(clearance.lower)},
          {"measured", json_number(clearance.measured)},
          {"time", clearance.time},
          {"singularity", clearance.serial ? "serial" : "parallel"},
          {"leg", clearance.serial ? json(manipulator.leg(clearance.leg).name) : json()},
          {"measures", clearance.measures}};
}

json json_travel(const Manipulator& manipulator, const ModeOnPath& mode) {
  json travel = json::array();
  for (std::size_t j = 0; j < mode.travel.size(); ++j)
    travel.push_back({{"joint", manipulator.leg(j).actuated_joint}, {"travel", mode.travel[j]}});
  return travel;
}

json json_mode(const Manipulator& manipulator, const ModeOnPath& mode) {
  const bool safe = mode.check.answer == TrajectoryAnswer::safe;
  const TrajectoryCheck& check = mode.check;
  return {{"working_mode", mode.mode.signs()},
          {"answer", name(check.answer)},
          {"reason", check.reason},
          {"determinant_sign", mode.determinant_sign},
          {"aspect", mode.aspect > 0 ? json(mode.aspect) : json()},
          {"free_until", check.free_until},
          {"first_violation", check.violation ? json_violation(manipulator, *check.violation) : json()},
          {"clearance", mode.clearance ? json_clearance(manipulator, *mode.clearance) : json()},
          {"least_index",
           {{"parallel", json_number(check.parallel_index.value)},
            {"serial", json_number(check.serial_index.value)}}},
          {"travel", json_travel(manipulator, mode)},
          {"total_travel", safe ? json(mode.total_travel()) : json()},
          {"least_time", safe ? json(mode.least_time) : json()}};
}

std::string shown_determinant_sign(int sign) { return sign == 0 ? "" : shown_sign(sign); }

void add_row(const ModeOnPath& mode, TextTable& table) {
  const bool safe = mode.clearance.has_value();
  table.add({to_string(mode.mode), name(mode.check.answer), shown_determinant_sign(mode.determinant_sign),
             mode.aspect > 0 ? std::to_string(mode.aspect) : "-",
             safe ? shown_bound(mode.clearance->lower, Side::below) : "-",
             safe ? shown_briefly(mode.clearance->time) : "-",
             safe ? shown_briefly(mode.total_travel()) : "-", safe ? shown_briefly(mode.least_time) : "-",
             safe ? "" : mode.check.reason});
}

json json_change(const Manipulator& manipulator, const PostureChange& change) {
  const TaskSpace space = manipulator.task_space();
  return {{"time", change.time},
          {"pose", json_pose(space, change.pose)},
          {"singular_pose", json_pose(space, change.singular)},
          {"leg", manipulator.leg(change.leg).name},
          {"from", change.from.signs()},
          {"to", change.to.signs()},
          {"detour", change.detour}};
}

std::string change_text(const Manipulator& manipulator, const PostureChange& change) {
  const TaskSpace space = manipulator.task_space();
  return "at " + shown(change.time) + " s from " + to_string(change.from) + " to " + to_string(change.to) +
         ": leave the path at " + to_string(space, change.pose) + ", go straight to " +
         to_string(space, change.singular) + ", where B_jj = 0 of leg '" + manipulator.leg(change.leg).name +
         "', and back; " + shown_briefly(change.detour) + " m\n";
}

json json_poses(TaskSpace space, const std::vector<Pose>& poses) {
  json array = json::array();
  for (const Pose& pose : poses) array.push_back(json_pose(space, pose));
  return array;
}

json json_mode(TaskSpace space, const ModeInRegion& mode) {
  const bool safe = mode.answer == TrajectoryAnswer::safe;
  return {{"working_mode", mode.mode.signs()},
          {"answer", name(mode.answer)},
          {"reason", mode.reason},
          {"determinant_sign", mode.determinant_sign},
          {"least_index",
           safe ? json{{"lower", mode.least_index.lower}, {"upper", mode.least_index.upper}} : json()},
          {"witnesses", json_poses(space, mode.witnesses)},
          {"undecided", mode.undecided}};
}

std::string poses_text(TaskSpace space, const std::vector<Pose>& poses) {
  std::string text;
  for (const Pose& pose : poses) text += (text.empty() ? " (" : "; ") + to_string(space, pose);
  return text.empty() ? "" : text + ")";
}

void add_row(TaskSpace space, const ModeInRegion& mode, TextTable& table) {
  const bool safe = mode.answer == TrajectoryAnswer::safe;
  table.add({to_string(mode.mode), name(mode.answer), shown_determinant_sign(mode.determinant_sign),
             safe ? shown_bound(mode.least_index.lower, Side::below) : "-",
             safe ? "" : mode.reason + poses_text(space, mode.witnesses)});
}

}  // namespace

Report report_path_choice(const Manipulator& manipulator, const PathChoice& choice, Preference preference) {
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(manipulator.task_space()))},
                 {"prefer", name(preference)},
                 {"answer", name(choice.answer)},
                 {"proved", choice.answer != TrajectoryAnswer::unknown},
                 {"reason", choice.reason},
                 {"modes", json::array()}};
  TextTable table({"working mode", "all of it", "det A", ">aspect", ">clear by [m]", ">near at [s]",
                   ">travel [" + joint_unit(manipulator.leg(0)) + "]", ">time [s]", "why not"});
  for (const ModeOnPath& mode : choice.modes) {
    object["modes"].push_back(json_mode(manipulator, mode));
    add_row(mode, table);
  }
  const Report constraints = report_constraints(manipulator);
  object.update(constraints.json);
  return {object, manipulator.name() + ", can be done: " + name(choice.answer) + "\n" + choice.reason +
                      "\n\n" + table.text() + '\n' + constraints.text};
}

void add_changes(const Manipulator& manipulator, const ChangingPath& path, Report& report) {
  json object = {{"answer", name(path.answer)},
                 {"proved", path.answer != TrajectoryAnswer::unknown},
                 {"reason", path.reason},
                 {"pieces", json::array()},
                 {"changes", json::array()}};
  report.text += "\nwith changes of posture: " + std::string(name(path.answer)) + "\n" + path.reason + "\n";
  for (const PathPiece& piece : path.pieces) {
    object["pieces"].push_back(
        {{"working_mode", piece.mode.signs()}, {"start", piece.start}, {"end", piece.end}});
    report.text +=
        "from " + shown(piece.start) + " s to " + shown(piece.end) + " s in " + to_string(piece.mode) + "\n";
  }
  for (const PostureChange& change : path.changes) {
    object["changes"].push_back(json_change(manipulator, change));
    report.text += change_text(manipulator, change);
  }
  report.json["with_changes"] = std::move(object);
}

Report report_region_choice(const Manipulator& manipulator, const RegionQuestion& question,
                            const RegionChoice& choice) {
  const TaskSpace space = manipulator.task_space();
  const std::vector<std::string> names =
      question.slice ? coordinate_names(*question.slice) : coordinate_names(space);
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(space))},
                 {"region", json_box(names, question.region)},
                 {"slice", question.slice ? json(to_string(*question.slice)) : json()},
                 {"answer", name(choice.answer)},
                 {"proved", choice.answer != TrajectoryAnswer::unknown},
                 {"reason", choice.reason},
                 {"apart", nullptr},
                 {"modes", json::array()}};
  TextTable table({"working mode", "in one aspect", "det A", ">index at least", "why not"});
  for (const ModeInRegion& mode : choice.modes) {
    object["modes"].push_back(json_mode(space, mode));
    add_row(space, mode, table);
  }
  std::string text =
      manipulator.name() + ", t-connected: " + name(choice.answer) + "\n" + choice.reason + "\n";
  if (choice.apart) {
    const std::vector<Pose> pair{choice.apart->first, choice.apart->second};
    object["apart"] = json_poses(space, pair);
    text += "joined in no working mode: " + to_string(space, pair[0]) + " and " + to_string(space, pair[1]) +
            "\n";
  }
  const Report constraints = report_constraints(manipulator);
  object.update(constraints.json);
  return {object, text + '\n' + table.text() + '\n' + constraints.text};
}

}  // namespace parallel_aspects::tools
