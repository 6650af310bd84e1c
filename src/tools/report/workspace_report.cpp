// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/workspace_report.h"

#include "tools/report/answer_json.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/report/reports.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

std::string center_text(const ask::ShapeInAspect& shape) {
  std::string text;
  for (const HeldCoordinate& each : shape.center) text += (text.empty() ? "(" : ", ") + shown(each.value);
  return text.empty() ? "-" : text + ")";
}

std::string table_of(const ask::LargestShapeAnswer& answer) {
  const std::string size = lengths_of(*answer.map, answer.question, 1.0).front().first;
  TextTable table(
      {">aspect", "working mode", "det A", ">" + size + " [m]", ">at most", "center [m]", "gap closed"});
  for (const ask::ShapeInAspect& each : answer.workspaces)
    table.add({std::to_string(each.found.aspect), to_string(each.mode), shown_sign(each.determinant_sign),
               shown_bound(each.found.lower, Side::below), shown_bound(each.found.upper, Side::above),
               center_text(each), each.found.proved ? "yes" : "no"});
  return table.text();
}

std::string best_text(const ask::LargestShapeAnswer& answer) {
  const std::string shape = name(answer.question.shape);
  const ask::ShapeInAspect* best = answer.best();
  if (best == nullptr) return "No " + shape + " is proved to lie in an aspect.\n";
  std::vector<std::string> lengths;
  for (const auto& [what, length] : best->lengths)
    lengths.push_back(what + " " + shown_bound(length, Side::below) + " m");
  return "The largest " + shape + " lies in aspect " + std::to_string(best->found.aspect) + ": " +
         joined(lengths, ", ") + ", center " + center_text(*best) +
         ".\nProved: each shape lies in its aspect, and none in it is larger than `at most`.\n";
}

}  // namespace

Report report_workspaces(const ask::LargestShapeAnswer& answer) {
  const Manipulator& robot = *answer.map->manipulator();
  Report report{answer_json(robot, answer), ""};
  report.json["mechanism"] = robot.name();
  report.json["margins"] = json_margins(robot.constraints().margins);
  report.json["tolerance"] = json_number(robot.tolerance());
  const Report bounds = report_constraints(robot);
  report.json.update(bounds.json);
  report.text = robot.name() + ": the largest " + std::string(name(answer.question.shape)) +
                " in each aspect" + (answer.slice ? " of the slice " + to_string(*answer.slice) : "") +
                "\n\n" + table_of(answer) + "\n" + best_text(answer) + bounds.text;
  return report;
}

}  // namespace parallel_aspects::tools
