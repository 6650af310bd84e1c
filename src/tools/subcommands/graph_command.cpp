// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_graph.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/drawing/graph_drawing.h"
#include "tools/map_choice.h"
#include "tools/output_file.h"
#include "tools/picture_file.h"
#include "tools/report/plan_report.h"
#include "tools/subcommands.h"

#include <memory>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

struct GraphArguments {
  RobotChoice robot;
  MapChoice map;
  ConstraintArguments constraints;
  std::string picture_file;
  bool dot = false;
};

Report report_of(const GraphArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  Problems problems;
  check_svg_file("--picture", arguments.picture_file, problems);
  std::optional<MapSlice> slice;
  if (!arguments.map.slice.empty())
    slice = parse_slice("--slice", *manipulator, arguments.map.slice, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto map = choose_map(manipulator, arguments.map, slice, surroundings);
  const auto graph = compute_aspect_graph(*map, control_of(surroundings));
  if (!graph) throw Interrupted{};
  Report report = report_graph(*map, *graph);
  if (!arguments.picture_file.empty())
    write_output_file("Picture", arguments.picture_file, draw_graph(*map, *graph));
  if (arguments.dot) report.text = graph_as_dot(*map, *graph);
  return report;
}

}  // namespace

Subcommand graph_subcommand() {
  const auto arguments = std::make_shared<GraphArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  for (const Option& option : map_choice_options(arguments->map)) options.push_back(option);
  options.push_back({"--picture", "FILE", "Draw aspects and gates as SVG", &arguments->picture_file});
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"graph",
          "Tell through which gates aspects are joined, and which are proved apart",
          options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); },
          {{"--dot", "Print the graph for Graphviz", &arguments->dot}}};
}

}  // namespace parallel_aspects::tools
