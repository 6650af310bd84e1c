// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/map.h"
#include "tools/arguments.h"
#include "tools/drawing/result_charts.h"
#include "tools/motion_report/plan_report.h"
#include "tools/output_file.h"
#include "tools/question_options.h"
#include "tools/subcommands.h"

#include <memory>
#include <utility>

namespace parallel_aspects::tools {
namespace {

struct GraphArguments : QuestionArguments {
  std::string picture_file;
  bool dot = false;
};

Report report_of(const GraphArguments& arguments, const Surroundings& surroundings) {
  const auto robot = robot_of(arguments);
  Problems problems;
  check_svg_file("--picture", arguments.picture_file, problems);
  const auto question = read_question<ask::GraphQuestion>(*robot, arguments.texts, problems);
  if (!arguments.picture_file.empty() && robot->task_space() == TaskSpace::SE3 && !question.map.hold)
    problems.emplace_back(
        "--picture is for maps, and in SE3 only slices have these; give --slice, or --dot for the graph over "
        "the roadmap.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const ask::GraphAnswer answer = asked(robot, question, surroundings);
  Report report = report_graph(*robot, answer);
  report.text += source_text(question.map, answer.loaded);
  if (!arguments.picture_file.empty())
    write_output_file("Picture", arguments.picture_file, draw_graph(*answer.map, *answer.graph));
  if (arguments.dot) report.text = graph_as_dot(answer);
  return report;
}

}  // namespace

Subcommand graph_subcommand() {
  const auto arguments = std::make_shared<GraphArguments>();
  return question_subcommand<ask::GraphQuestion>(
      "graph", "List through which gates aspects are joined, and which are proved apart", arguments,
      report_of, {},
      {{"--picture", "FILE", "Draw aspects and gates as SVG", &arguments->picture_file, false, Words::one,
        FileUse::written}},
      {{"--dot", "Print the graph for Graphviz", &arguments->dot}});
}

}  // namespace parallel_aspects::tools
