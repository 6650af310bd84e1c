// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/choice_report.h"

#include "tools/command.h"
#include "tools/report/bounds_report.h"
#include "tools/report/text_table.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

const char* name_of(Violation kind) {
  switch (kind) {
    case Violation::singularity:
      return "parallel_singularity";
    case Violation::out_of_reach:
      return "serial_singularity";
    case Violation::joint_limit:
      return "actuated_limit";
    case Violation::constraint:
      return "constraint";
    case Violation::none:
      break;
  }
  return "none";
}

json json_violation(const Manipulator& manipulator, const TrajectoryViolation& violation) {
  return {{"kind", name_of(violation.kind)},
          {"leg", violation.leg ? json(manipulator.leg(*violation.leg).name) : json()},
          {"constraint", violation.constraint ? json(name(*violation.constraint)) : json()},
          {"after", violation.after},
          {"before", violation.before}};
}

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

std::string shown_determinant_sign(int sign) { return sign == 0 ? "-" : shown_sign(sign); }

void add_row(const ModeOnPath& mode, TextTable& table) {
  const bool safe = mode.clearance.has_value();
  table.add({to_string(mode.mode), name(mode.check.answer), shown_determinant_sign(mode.determinant_sign),
             mode.aspect > 0 ? std::to_string(mode.aspect) : "-",
             safe ? shown_bound(mode.clearance->lower, Side::below) : "-",
             safe ? shown_briefly(mode.clearance->time) : "-",
             safe ? shown_briefly(mode.total_travel()) : "-", safe ? shown_briefly(mode.least_time) : "-",
             safe ? "" : mode.check.reason});
}

int code_of(TrajectoryAnswer answer) {
  return answer == TrajectoryAnswer::safe     ? exit_code::ok
         : answer == TrajectoryAnswer::unsafe ? exit_code::unsafe
                                              : exit_code::unknown;
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
  return {object,
          manipulator.name() + ", can be done: " + name(choice.answer) + "\n" + choice.reason + "\n\n" +
              table.text() + '\n' + constraints.text,
          code_of(choice.answer)};
}

}  // namespace parallel_aspects::tools
