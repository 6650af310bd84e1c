// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/regular_workspace.h"
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/drawing/plot.h"
#include "tools/map_choice.h"
#include "tools/numbers.h"
#include "tools/picture_file.h"
#include "tools/report/workspace_report.h"
#include "tools/shape_arguments.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

constexpr unsigned largest_id = 1'000'000'000;

struct WorkspaceArguments {
  RobotChoice robot;
  MapChoice map;
  ConstraintArguments constraints;
  ShapeArguments shape;
  std::string aspect, modes, picture;  // empty where not given
};

std::vector<int> chosen_aspects(const AspectMap& map, const std::string& text) {
  std::vector<int> ids;
  Problems problems;
  if (text.empty())
    for (const Aspect& aspect : map.aspects()) ids.push_back(aspect.id);
  else
    ids.push_back(static_cast<int>(parse_count("--aspect", text, largest_id, problems)));
  if (problems.empty() && !text.empty() &&
      (ids.front() < 1 || static_cast<std::size_t>(ids.front()) > map.aspects().size()))
    problems.push_back("--aspect is " + text + ", but the map has " +
                       counted(map.aspects().size(), "aspect") +
                       ", counted from 1; `aspects map` lists them.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return ids;
}

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

void draw(const std::shared_ptr<const AspectMap>& map, const WorkspaceQuestion& question,
          const std::vector<RegularWorkspace>& workspaces, const std::string& file) {
  PlotOptions options;
  const RegularWorkspace* best = best_of(workspaces);
  const bool is_plane = map->coordinates().size() == 2;
  if (!is_plane && best != nullptr) options.section = section_through(*map, question, *best);
  for (const RegularWorkspace& workspace : workspaces) {
    if (workspace.lower <= 0.0 || (!is_plane && &workspace != best)) continue;
    const Aspect& aspect = map->aspects()[static_cast<std::size_t>(workspace.aspect - 1)];
    options.outlines.push_back({workspace.aspect, outline_of(*map, question, workspace)});
    if (std::find(options.modes.begin(), options.modes.end(), aspect.mode) == options.modes.end())
      options.modes.push_back(aspect.mode);
  }
  if (options.outlines.empty())
    throw InvalidDescription({"No shape was found that --picture could show; leave it out."});
  write_picture_file(file, draw_plot(map, options));
}

void check_picture(const WorkspaceArguments& arguments, const Manipulator& manipulator,
                   const std::optional<MapSlice>& slice, Problems& problems) {
  if (arguments.picture.empty() || !problems.empty()) return;
  if (free_positions(manipulator, slice) < 2)
    problems.emplace_back("--picture shows two positions, but one is free; leave it out.");
}

Report report_of(const WorkspaceArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  Problems problems;
  WorkspaceOptions options;
  options.gap = parse_gap(arguments.shape, problems);
  check_picture_file("--picture", arguments.picture, problems);
  std::optional<MapSlice> slice;
  if (!arguments.map.slice.empty())
    slice = parse_slice("--slice", *manipulator, arguments.map.slice, problems);
  const auto modes = parse_modes("--mode", *manipulator, arguments.modes, problems);
  const WorkspaceQuestion question = parse_shape(arguments.shape, *manipulator, slice, problems);
  check_picture(arguments, *manipulator, slice, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto map = choose_map(manipulator, arguments.map, slice, surroundings, modes).map;
  const std::vector<int> ids = chosen_aspects(*map, arguments.aspect);
  const ShownComputation shown(surroundings);
  options.control = shown.control();
  const auto found = find_regular_workspaces(*map, ids, question, options);
  if (!found) throw Interrupted{};
  if (!arguments.picture.empty()) draw(map, question, *found, arguments.picture);
  return report_workspaces(*map, question, *found, options.gap);
}

std::vector<Option> options_of(WorkspaceArguments& arguments) {
  std::vector<Option> options = robot_options(arguments.robot);
  for (const Option& option : shape_options(arguments.shape, true)) options.push_back(option);
  options.push_back({"--aspect", "N", "In this aspect alone, by its id in `aspects map`", &arguments.aspect});
  options.push_back({"--mode", "\"(+,-)\"",
                     "In these working modes alone; ids are then those of `aspects map --mode`",
                     &arguments.modes, false, Words::signs});
  options.push_back(
      {"--picture", "FILE", "Draw the aspects with the shapes in them, as SVG or PNG", &arguments.picture});
  for (const Option& option : map_choice_options(arguments.map)) options.push_back(option);
  for (const Option& option : constraint_options(arguments.constraints)) options.push_back(option);
  return options;
}

}  // namespace

Subcommand workspace_subcommand() {
  const auto arguments = std::make_shared<WorkspaceArguments>();
  return {"workspace", "Find the largest box, square, disc, cylinder or ball in each aspect, proved",
          options_of(*arguments),
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
