// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/drawing/plot.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/question_options.h"
#include "tools/report/reports.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

struct PlotArguments : QuestionArguments {
  std::string file, section, modes, index;
  bool each_aspect = false;
  bool leaves = false;
};

IndexLevels parse_levels(const std::string& text, Problems& problems) {
  const std::vector<double> levels{0.2, 0.4, 0.6, 0.8};
  if (text == "parallel") return {DrawnIndex::parallel, levels};
  if (text == "conditioning") return {DrawnIndex::conditioning, levels};
  if (!text.empty()) problems.push_back("--index is '" + text + "'; give parallel or conditioning.");
  return {};
}

/// The torsion of orientations, "torsion=0.3".
PlotSection parse_torsion(const std::string& text, Problems& problems) {
  PlotSection section;
  const std::string name = "torsion=";
  if (text.rfind(name, 0) != 0)
    problems.push_back("--section is '" + text +
                       "', but orientations are cut at a torsion; give \"torsion=0\".");
  else if (const auto value = parse_numbers("--section", text.substr(name.size()), {"torsion"}, problems);
           !value.empty())
    section.torsion = value.front();
  return section;
}

PlotSection parse_section(const PlotArguments& arguments, const Manipulator& manipulator,
                          Problems& problems) {
  if (manipulator.task_space() == TaskSpace::SO3) return parse_torsion(arguments.section, problems);
  PlotSection section;
  section.slice =
      parse_slice("--section", manipulator, arguments.texts.at("slice") + " " + arguments.section, problems);
  if (problems.empty() && section.slice->dimension() != 2)
    problems.push_back("--section '" + arguments.section + "' leaves " +
                       std::to_string(section.slice->dimension()) +
                       " coordinates free; hold so many that two are left.");
  return section;
}

/// What takes two coordinates of a map that has three.
void check_plane(const PlotArguments& arguments, const Manipulator& manipulator, const Pose& home,
                 Problems& problems) {
  if (!arguments.index.empty() || arguments.each_aspect)
    problems.push_back(
        "--index and --each-aspect are for two coordinates; give a section too, such as --section " +
        example_of_section(manipulator, home) + ".");
  const std::string plane = example_of_plane(manipulator, home);
  if (arguments.leaves)
    problems.push_back("--leaves shows the boxes of maps of two coordinates; " +
                       (plane.empty() ? "leave it out." : "give a slice, such as --slice " + plane + "."));
}

/// What a picture cannot show, with what to do. `home`: a pose of the robot.
void check_dimension(const PlotArguments& arguments, const Manipulator& manipulator, const Pose& home,
                     const std::optional<MapSlice>& slice, Problems& problems) {
  const TaskSpace space = manipulator.task_space();
  const std::size_t dimension = slice ? slice->dimension() : degrees_of_freedom(space);
  if (dimension > 3)
    problems.push_back(
        "'" + manipulator.name() +
        "' has six degrees of freedom, and a picture shows three at most; give a slice, such as --slice " +
        example_of_plane(manipulator, home) + ".");
  if (dimension < 2)
    problems.push_back(
        slice ? "--slice leaves one coordinate free, and a picture takes two or three; hold less."
              : "'" + manipulator.name() +
                    "' has one degree of freedom, and a picture takes two or three; `aspects map` "
                    "lists its aspects.");
  const bool is_volume = slice && slice->free_positions() == 3;
  if (slice && dimension == 3 && !is_volume && arguments.section.empty())
    problems.emplace_back(
        "--slice leaves orientations free, and bodies are drawn of positions; hold one more, or give "
        "--section.");
  const bool is_plane = dimension == 2 || !arguments.section.empty();
  if (dimension == 2 && !arguments.section.empty())
    problems.emplace_back("--section cuts maps of three coordinates, but this one has two; leave it out.");
  if (dimension == 3 && !is_plane) check_plane(arguments, manipulator, home, problems);
  if (arguments.leaves && !arguments.section.empty())
    problems.emplace_back(
        "--leaves shows the boxes of maps of two coordinates; give --slice in place of --section.");
}

/// A section that meets no aspect would be an empty picture.
void check_section(const AspectMap& map, const PlotOptions& options) {
  if (!options.section || !options.section->slice) return;
  const std::vector<std::string> names = map.coordinates();
  for (const HeldCoordinate& held : options.section->slice->held_coordinates) {
    const auto name = std::find(names.begin(), names.end(), held.name);
    if (name == names.end() || held.name.size() > 1) continue;  // angles come round
    const auto i = static_cast<std::size_t>(name - names.begin());
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    for (const Aspect& aspect : map.aspects()) {
      lower = std::min(lower, aspect.bounds.lower[i]);
      upper = std::max(upper, aspect.bounds.upper[i]);
    }
    if (held.value >= lower && held.value <= upper) continue;
    throw InvalidDescription({"--section holds " + held.name + " at " + number_text(held.value) +
                              ", where '" + map.manipulator()->name() + "' has no aspect; give " + held.name +
                              " from " + number_text(lower, 4) + " to " + number_text(upper, 4) + "."});
  }
}

Report report_plot(const AspectMap& map, const PlotOptions& options, const std::string& file,
                   double seconds) {
  Report report;
  const auto& modes = options.modes.empty() ? map.working_modes() : options.modes;
  report.json = {{"picture", file}, {"proved_count", map.proved_count()}, {"seconds", seconds}};
  for (const WorkingMode& mode : modes) report.json["working_modes"].push_back(mode.signs());
  report.text = map.manipulator()->name() + ": " + aspect_count(map) + "; drawn in " +
                shown_briefly(seconds) + " s: " + file + "\n";
  return report;
}

Report report_of(const PlotArguments& arguments, const Surroundings& surroundings) {
  Problems problems;
  PlotOptions options;
  options.each_aspect = arguments.each_aspect;
  options.leaves = arguments.leaves;
  options.levels = parse_levels(arguments.index, problems);
  check_picture_file("-o", arguments.file, problems);
  const auto mechanism = load_robot(arguments.robot, std::move(problems));
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  problems.clear();
  const auto source = read_question<ask::MapSource>(*manipulator, arguments.texts, problems);
  options.modes = parse_modes("--mode", *manipulator, arguments.modes, problems);
  if (problems.empty())
    check_dimension(arguments, *manipulator, mechanism->assembled().pose, source.hold, problems);
  if (problems.empty() && !arguments.section.empty())
    options.section = parse_section(arguments, *manipulator, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto map = map_of(manipulator, source, surroundings);
  if (map->aspects().empty())
    throw InvalidDescription({"'" + manipulator->name() +
                              "' has no aspect there, so that nothing is drawn; `aspects map` says more."});
  check_section(*map, options);
  const auto start = std::chrono::steady_clock::now();
  const MapControl control = control_of(surroundings);
  const PagePicture picture = draw_plot(map, options, [&control] {
    if (is_cancelled(control)) throw Interrupted{};
  });
  write_picture_file(arguments.file, picture);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return report_plot(*map, options, arguments.file, taken.count());
}

}  // namespace

Subcommand plot_subcommand() {
  const auto arguments = std::make_shared<PlotArguments>();
  return question_subcommand<ask::MapSource>(
      "plot", "Draw the aspects in the workspace and in joint space, as SVG or PNG", arguments, report_of,
      {{"-o", "FILE", "The picture: an .svg or a .png", &arguments->file, true, Words::one,
        FileUse::written}},
      {{"--section", "\"z=0.3\"",
        "Cut a map of three coordinates: what is held, with its value [m or rad]; in SO3 \"torsion=0\"",
        &arguments->section, false, Words::assignments},
       {"--mode", "\"(+,-)\"", "Draw these working modes only, as signs of B_jj", &arguments->modes, false,
        Words::signs},
       {"--index", "NAME",
        "Draw lines of equal index: parallel, or conditioning for isoconditioning lines (the inverse "
        "condition "
        "number)",
        &arguments->index}},
      {{"--each-aspect", "A figure for each aspect, not for each working mode", &arguments->each_aspect},
       {"--leaves", "Draw the boxes of the map, with those that are undecided", &arguments->leaves}});
}

}  // namespace parallel_aspects::tools
