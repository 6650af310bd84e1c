// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/motion/plan_path.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/drawing/result_charts.h"
#include "tools/map_choice.h"
#include "tools/motion_report/plan_report.h"
#include "tools/output_file.h"
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
  RoadmapArguments roadmap;
  std::string picture_file;
  bool dot = false;
};

/// With six degrees of freedom: the components of a roadmap.
Report report_over_roadmap(const std::shared_ptr<const Manipulator>& manipulator,
                           const GraphArguments& arguments, const Surroundings& surroundings) {
  Problems problems;
  const RoadmapOptions options = parse_roadmap(arguments.roadmap, problems);
  const MapChoice& map = arguments.map;
  if (!map.resolution.empty() || !map.load_file.empty() || !map.save_file.empty())
    problems.emplace_back(
        "--resolution, --load and --save are for maps, and in SE3 only slices have these; give --slice, or "
        "leave them out.");
  if (!arguments.picture_file.empty())
    problems.emplace_back(
        "--picture is for maps, and in SE3 only slices have these; give --slice, or --dot for the graph over "
        "the roadmap.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const ShownComputation shown(surroundings);
  const auto roadmap = compute_roadmap(manipulator, options, part_of(shown.control(), 0.0, 0.5));
  const auto graph = compute_roadmap_graph(*roadmap, part_of(shown.control(), 0.5, 1.0));
  if (!graph) throw Interrupted{};
  Report report = report_graph(*roadmap, *graph);
  if (arguments.dot) report.text = graph_as_dot(*graph);
  return report;
}

Report report_over_map(const std::shared_ptr<const Manipulator>& manipulator, const GraphArguments& arguments,
                       const std::optional<MapSlice>& slice, const Surroundings& surroundings) {
  if (!arguments.roadmap.samples.empty() || !arguments.roadmap.seed.empty())
    throw InvalidDescription(
        {"--samples and --seed are for roadmaps, in SE3 without --slice; leave them out."});
  const ask::FoundMap chosen = choose_map(manipulator, arguments.map, slice, surroundings);
  const AspectMap& map = *chosen.map;
  const auto graph = compute_aspect_graph(map, control_of(surroundings));
  if (!graph) throw Interrupted{};
  Report report = report_graph(map, *graph);
  report_source(arguments.map, chosen, report);
  if (!arguments.picture_file.empty())
    write_output_file("Picture", arguments.picture_file, draw_graph(map, *graph));
  if (arguments.dot) report.text = graph_as_dot(map, *graph);
  return report;
}

Report report_of(const GraphArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  Problems problems;
  check_svg_file("--picture", arguments.picture_file, problems);
  check_map_output("--save", arguments.map.save_file, problems);
  std::optional<MapSlice> slice;
  if (!arguments.map.slice.empty())
    slice = parse_slice("--slice", *manipulator, arguments.map.slice, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const bool has_map = slice || manipulator->task_space() != TaskSpace::SE3;
  return has_map ? report_over_map(manipulator, arguments, slice, surroundings)
                 : report_over_roadmap(manipulator, arguments, surroundings);
}

}  // namespace

Subcommand graph_subcommand() {
  const auto arguments = std::make_shared<GraphArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  for (const Option& option : map_choice_options(arguments->map)) options.push_back(option);
  options.push_back({"--picture", "FILE", "Draw aspects and gates as SVG", &arguments->picture_file, false,
                     Words::one, FileUse::written});
  options.push_back({"--samples", "N", "With six degrees of freedom: poses of the roadmap, by default 1000",
                     &arguments->roadmap.samples});
  options.push_back({"--seed", "N", "With six degrees of freedom: seed of its poses, by default 1",
                     &arguments->roadmap.seed});
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"graph",
          "Tell through which gates aspects are joined, and which are proved apart",
          options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); },
          {{"--dot", "Print the graph for Graphviz", &arguments->dot}}};
}

}  // namespace parallel_aspects::tools
