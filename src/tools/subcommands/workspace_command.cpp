// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/joint_range.h"
#include "model/angles.h"
#include "parallel_aspects/ask/workspace.h"
#include "tools/arguments.h"
#include "tools/drawing/plot.h"
#include "tools/output_file.h"
#include "tools/question_options.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/report/reports.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

struct WorkspaceArguments : QuestionArguments {
  std::string picture;  // empty where not given
};

constexpr int sides_of_circle = 180;

/// The outline of a shape in the plane of the first two free positions.
std::vector<Eigen::Vector2d> outline_of(const AspectMap& map, const WorkspaceQuestion& question,
                                        const RegularWorkspace& workspace) {
  const Eigen::Vector2d center(workspace.center[0], workspace.center[1]);
  std::vector<Eigen::Vector2d> line;
  if (question.shape == RegularShape::box || question.shape == RegularShape::square) {
    const auto lengths = lengths_of(map, question, workspace.lower);
    const Eigen::Vector2d half(0.5 * lengths.front().second,
                               0.5 * lengths[lengths.size() > 1 ? 1 : 0].second);
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
      line.emplace_back(center + half.cwiseProduct(Eigen::Vector2d(x, y)));
    return line;
  }
  for (int i = 0; i <= sides_of_circle; ++i) {
    const double angle = 2.0 * EIGEN_PI * i / sides_of_circle;
    line.emplace_back(center + workspace.lower * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return line;
}

/// The same in a plane of angles, where it goes on beyond half a turn: cut there.
std::vector<std::vector<Eigen::Vector2d>> outlines_of(const AspectMap& map, const WorkspaceQuestion& question,
                                                      const RegularWorkspace& workspace) {
  std::vector<Eigen::Vector2d> line = outline_of(map, question, workspace);
  if (!has_hinges(map.manipulator()->task_space())) return {line};
  line.pop_back();  // what `copies_of` takes is closed by itself
  const JointRange<2> turn{Eigen::Vector2d::Constant(-pi), Eigen::Vector2d::Constant(pi), {true, true}};
  auto copies = turn.copies_of(line, false);
  for (auto& copy : copies) copy.push_back(copy.front());
  return copies;
}

/// Where a map of three coordinates is cut: through the middle of the best shape.
PlotSection section_through(const AspectMap& map, const WorkspaceQuestion& question,
                            const RegularWorkspace& workspace) {
  const bool turns = free_positions(*map.manipulator(), map.slice()) == 2;
  const double angle = question.angle ? 0.5 * (question.angle->lower + question.angle->upper) : 0.0;
  std::vector<HeldCoordinate> held =
      map.slice() ? map.slice()->held_coordinates : std::vector<HeldCoordinate>();
  held.push_back({map.coordinates().back(), turns ? angle : workspace.center[2]});
  Problems problems;
  PlotSection section;
  section.slice = make_slice(*map.manipulator(), held, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return section;
}

void draw(const ask::LargestShapeAnswer& answer, const std::string& file) {
  PlotOptions options;
  const AspectMap& map = *answer.map;
  const ask::ShapeInAspect* best = answer.best();
  const bool is_plane = map.coordinates().size() == 2;
  if (!is_plane && best != nullptr) options.section = section_through(map, answer.question, best->found);
  for (const ask::ShapeInAspect& each : answer.workspaces) {
    if (each.center.empty() || (!is_plane && &each != best)) continue;
    for (auto& line : outlines_of(map, answer.question, each.found))
      options.outlines.push_back({each.found.aspect, std::move(line)});
    if (std::find(options.modes.begin(), options.modes.end(), each.mode) == options.modes.end())
      options.modes.push_back(each.mode);
  }
  if (options.outlines.empty())
    throw InvalidDescription({"No shape was found that --picture could show; leave it out."});
  write_picture_file(file, draw_plot(answer.map, options));
}

ask::LargestShapeQuestion read(const WorkspaceArguments& arguments, const Manipulator& robot) {
  Problems problems;
  auto question = read_question<ask::LargestShapeQuestion>(robot, arguments.texts, problems);
  check_picture_file("--picture", arguments.picture, problems);
  if (!arguments.picture.empty() && problems.empty() && free_positions(robot, question.map.hold) < 2)
    problems.emplace_back("--picture shows two positions, but one is free; leave it out.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return question;
}

std::string center_text(const ask::ShapeInAspect& shape) {
  std::string text;
  for (const HeldCoordinate& each : shape.center) text += (text.empty() ? "(" : ", ") + shown(each.value);
  return text.empty() ? "-" : text + ")";
}

std::string unit_of(const ask::LargestShapeAnswer& answer) {
  return has_hinges(answer.task_space) ? "rad" : "m";
}

std::string shapes_table(const ask::LargestShapeAnswer& answer) {
  const std::string size = lengths_of(*answer.map, answer.question, 1.0).front().first;
  const std::string unit = " [" + unit_of(answer) + "]";
  TextTable table(
      {">aspect", "working mode", "det A", ">" + size + unit, ">at most", "center" + unit, "gap closed"});
  for (const ask::ShapeInAspect& each : answer.workspaces)
    table.add({std::to_string(each.found.aspect), to_string(each.mode), shown_sign(each.determinant_sign),
               shown_bound(each.found.lower, Side::below), shown_bound(each.found.upper, Side::above),
               center_text(each), each.found.proved ? "yes" : "no"});
  return table.text();
}

std::string best_shape_text(const ask::LargestShapeAnswer& answer) {
  const std::string shape = name(answer.question.shape);
  const ask::ShapeInAspect* best = answer.best();
  if (best == nullptr) return "No " + shape + " is proved to lie in an aspect.\n";
  std::vector<std::string> lengths;
  for (const auto& [what, length] : best->lengths)
    lengths.push_back(what + " " + shown_bound(length, Side::below) + " " + unit_of(answer));
  return "The largest " + shape + " lies in aspect " + std::to_string(best->found.aspect) + ": " +
         joined(lengths, ", ") + ", center " + center_text(*best) +
         ".\nProved: each shape lies in its aspect, and none in it is larger than `at most`.\n";
}

Report report_workspaces(const ask::LargestShapeAnswer& answer) {
  const Manipulator& robot = *answer.map->manipulator();
  Report report = constrained_report(robot, answer,
                                     robot.name() + ": the largest " +
                                         std::string(name(answer.question.shape)) + " in each aspect" +
                                         (answer.slice ? " of the slice " + to_string(*answer.slice) : "") +
                                         "\n\n" + shapes_table(answer) + "\n" + best_shape_text(answer));
  report.json["margins"] = json_margins(robot.constraints().margins);
  report.json["tolerance"] = json_number(robot.tolerance());
  return report;
}

Report report_of(const WorkspaceArguments& arguments, const Surroundings& surroundings) {
  const auto robot = robot_of(arguments);
  const ask::LargestShapeQuestion question = read(arguments, *robot);
  const ask::LargestShapeAnswer answer = asked(robot, question, surroundings);
  if (!arguments.picture.empty()) draw(answer, arguments.picture);
  Report report = report_workspaces(answer);
  report.text += source_text(question.map, answer.loaded);
  return report;
}

}  // namespace

Subcommand workspace_subcommand() {
  const auto arguments = std::make_shared<WorkspaceArguments>();
  return question_subcommand<ask::LargestShapeQuestion>(
      "workspace", "Find the largest box, square, disc, cylinder or ball in each aspect, proved", arguments,
      report_of, {},
      {{"--picture", "FILE", "Draw the aspects with the shapes in them, as SVG or PNG", &arguments->picture,
        false, Words::one, FileUse::written}});
}

}  // namespace parallel_aspects::tools
