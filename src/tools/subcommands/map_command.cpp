// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"
#include "model/message_text.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/drawing/plot.h"
#include "tools/drawing/result_charts.h"
#include "tools/output_file.h"
#include "tools/question_options.h"
#include "tools/report/reports.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

struct MapArguments : QuestionArguments {
  std::string picture_file, basins_file;  // empty where not given
  bool without_limits = false;
  bool all_aspects = false;
  bool verbose = false;
};

/// The ranges of a robot's file that belong to the free positions of a slice.
std::optional<Box> region_of_slice(const Box& region, const MapSlice& slice, const std::string& file,
                                   Problems& problems) {
  Box result;
  for (std::size_t i = 0; i < region.dimension; ++i) {
    const double held = slice.held.position[static_cast<Eigen::Index>(i)];
    if (slice.moves[i]) {
      result.lower[result.dimension] = region.lower[i];
      result.upper[result.dimension++] = region.upper[i];
    } else if (!(region.lower[i] <= held && held <= region.upper[i])) {
      problems.push_back("--slice holds position " + std::to_string(i + 1) + " at " + shown(held) +
                         " m, outside of the map.region of " + file + "; hold it inside, or give --region.");
    }
  }
  return result.dimension > 0 ? std::optional<Box>(result) : std::nullopt;
}

/// Where to look, as the robot's file says; empty where it does not.
std::vector<ask::NamedRange> find_region(const MapSection& section, TaskSpace space,
                                         const std::optional<MapSlice>& slice, Problems& problems) {
  if (slice && slice->joint) return {};
  std::optional<Box> region = resolve_region(section.config, space, section.file, problems);
  if (region && slice) region = region_of_slice(*region, *slice, section.file, problems);
  const std::vector<std::string> names = slice ? coordinate_names(*slice) : coordinate_names(space);
  return region ? ask::ranges_of(names, *region) : std::vector<ask::NamedRange>();
}

/// With six degrees of freedom, where there is a roadmap in place of a map, what is of boxes alone.
void refuse_options_of_boxes(const MapArguments& arguments, const Manipulator& robot, const Pose& home,
                             Problems& problems) {
  const std::string boxes = " is for maps of boxes, and in SE3 only slices have these; give ";
  if (arguments.without_limits) problems.push_back("--without-limits" + boxes + "--slice, or leave it out.");
  if (!arguments.basins_file.empty())
    problems.push_back("--persistence-picture" + boxes + "--slice, or leave it out.");
  if (!arguments.picture_file.empty())
    problems.push_back("--picture" + boxes + "one that leaves two coordinates free, such as --slice " +
                       example_of_plane(robot, home) + ".");
}

/// What to do for a picture of two coordinates, where the map has another number of them.
std::string picture_remedy(const Manipulator& manipulator, const Pose& home) {
  const TaskSpace space = manipulator.task_space();
  if (degrees_of_freedom(space) == 2) return "; leave out --slice, without which it has two.";
  if (degrees_of_freedom(space) < 2) return "; leave it out.";
  const std::string plane = example_of_plane(manipulator, home);
  if (plane.empty())
    return "; leave it out, and draw a section with `aspects plot`, such as --section " +
           example_of_section(manipulator, home) + ".";
  return "; give a slice that leaves two free, such as --slice " + plane + ".";
}

// The boxes that are proved, and those that are not.
void draw(const std::shared_ptr<const AspectMap>& map, const std::string& file) {
  PlotOptions options;
  options.leaves = true;
  write_picture_file(file, draw_plot(map, options));
}

bool is_roadmap(const Manipulator& robot, const ask::MapQuestion& question) {
  return robot.task_space() == TaskSpace::SE3 && !question.source.hold;
}

/// What is asked, by the command line and else by the robot's file.
ask::MapQuestion read(const MapArguments& arguments, const Manipulator& robot, const MapSection& section,
                      Problems& problems) {
  auto question = read_question<ask::MapQuestion>(robot, arguments.texts, problems, arguments.flags);
  const MapConfig& config = section.config;
  if (!question.threads && config.threads) question.threads.emplace().value = *config.threads;
  if (question.region.empty() && problems.empty())
    question.region = find_region(section, robot.task_space(), question.source.hold, problems);
  if (is_roadmap(robot, question)) return question;
  if (!question.source.resolution) question.source.resolution = config.resolution;
  if (!question.extra_levels && config.extra_levels)
    question.extra_levels.emplace().value = static_cast<unsigned>(*config.extra_levels);
  if (!question.index) question.index = ParallelIndex::normalised;
  return question;
}

void check_picture(const MapArguments& arguments, const Manipulator& robot, const Pose& home,
                   const std::optional<MapSlice>& slice, Problems& problems) {
  const std::size_t dimension = slice ? slice->dimension() : degrees_of_freedom(robot.task_space());
  if (problems.empty() && !arguments.picture_file.empty() && dimension != 2)
    problems.push_back("--picture is of two coordinates, but the map has " + std::to_string(dimension) +
                       picture_remedy(robot, home));
}

// Of the smallest ones in the region, all of which the second map could take at most: 256 by 256.
constexpr double max_boxes_to_count = 65536.0;

// With six legs a box takes some twenty times as long.
constexpr double max_boxes_with_six_legs = 4096.0;

// Of unit quaternions: four charts, each from -1 to 1 in three coordinates.
constexpr double charts = 4.0, width_of_chart = 2.0;

double smallest_boxes(const AspectMap& map) {
  const Box region = map.region();
  if (region.dimension == 0) return charts * std::pow(width_of_chart / map.resolution(), 3.0);
  double count = 1.0;
  for (std::size_t k = 0; k < region.dimension; ++k)
    count *= std::max(1.0, (region.upper[k] - region.lower[k]) / map.resolution());
  return count;
}

// By the region alone: how many leaves a map has within limits, or what time it took, says little of that
// without them.
bool is_cheap(const AspectMap& map) {
  const bool six_legs = map.manipulator()->leg_count() == max_legs;
  return smallest_boxes(map) <= (six_legs ? max_boxes_with_six_legs : max_boxes_to_count);
}

ConstraintKinds limits_of_joints(const Manipulator& manipulator) {
  ConstraintKinds kinds;
  kinds[index_of(ConstraintKind::actuated_limits)] = kinds[index_of(ConstraintKind::passive_limits)] = true;
  return kinds & manipulator.constraint_kinds();
}

// Nothing where no position is free.
std::optional<Box> searched_positions(const AspectMap& map) {
  Box positions = map.region();
  positions.dimension =
      map.slice() ? map.slice()->free_positions() : directions(map.manipulator()->task_space());
  return positions.dimension > 0 ? std::optional<Box>(positions) : std::nullopt;
}

// "A" or "A,B" and the like.
std::string kinds_text(ConstraintKinds kinds, const std::string& between, const std::string& after) {
  std::string text;
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kinds[index_of(kind)]) text += (text.empty() ? "" : between) + std::string(name(kind)) + after;
  return text;
}

/// Where joints have limits: adds how many aspects there are without them in the region of the map, and in
/// the text, where it is another number, what leaves the limits out. Nothing where there are none, or where
/// the region has so many boxes that it may take longer than the map, unless it is `asked_for`.
void add_count_without_limits(const AspectMap& map, const ask::MapQuestion& question, bool asked_for,
                              const Surroundings& surroundings, Report& report) {
  const Manipulator& manipulator = *map.manipulator();
  const ConstraintKinds limits = limits_of_joints(manipulator);
  if (limits.none() || !(asked_for || is_cheap(map))) return;
  MapOptions options = options_of(map);
  options.region = searched_positions(map);
  options.complete = false;
  options.use_symmetry = !question.no_symmetry;
  if (question.threads) options.threads = question.threads->value;
  const auto free = manipulator.with_constraints(manipulator.constraint_kinds() & ~limits);
  const auto result = completed(
      surroundings, [&](const MapControl& control) { return compute_aspect_map(free, options, control); });
  const std::size_t count = result.map->aspects().size();
  report.json["without_limits"] = {{"components", count}, {"left_out", nlohmann::json::array()}};
  for (const ConstraintKind kind : all_constraint_kinds)
    if (limits[index_of(kind)]) report.json["without_limits"]["left_out"].push_back(name(kind));
  if (count == map.aspects().size()) return;
  report.text += "\nwithout limits of joints there are " + std::to_string(count) + " in place of " +
                 counted(map.aspects().size(), "component") + " here; --no-constraint " +
                 kinds_text(limits, ",", "") + " leaves them out, and so does constraints: {" +
                 kinds_text(limits, ", ", ": false") + "} in the YAML\n";
}

Report map_report(const std::shared_ptr<const Manipulator>& robot, const MapArguments& arguments,
                  ask::MapQuestion question, const Surroundings& surroundings) {
  question.persistence = question.persistence || !arguments.basins_file.empty();
  const ask::MapAnswer answer = asked(robot, question, surroundings);
  if (answer.sampled) return report_roadmap(*robot, answer, arguments.verbose);
  const AspectMap& map = *answer.map;
  if (!arguments.picture_file.empty()) draw(answer.map, arguments.picture_file);
  Report report = report_map(answer, {arguments.all_aspects, arguments.verbose});
  if (!arguments.basins_file.empty())
    write_output_file("Picture", arguments.basins_file, draw_basins(map, *answer.basins));
  add_count_without_limits(map, question, arguments.without_limits, surroundings, report);
  report.text += neighbours_text(answer);
  return report;
}

Report report_of(const MapArguments& arguments, const Surroundings& surroundings) {
  Problems problems;
  const MapSection section = load_map_section(arguments.robot, problems);
  check_picture_file("--picture", arguments.picture_file, problems);
  check_output_file("--persistence-picture", arguments.basins_file, problems);
  check_texts<ask::MapQuestion>(arguments.texts, problems);
  const auto mechanism = load_robot(arguments.robot, std::move(problems));
  const auto robot = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  const Pose home = mechanism->assembled().pose;
  problems = {};
  const ask::MapQuestion question = read(arguments, *robot, section, problems);
  if (is_roadmap(*robot, question))
    refuse_options_of_boxes(arguments, *robot, home, problems);
  else
    check_picture(arguments, *robot, home, question.source.hold, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  Report report = map_report(robot, arguments, question, surroundings);
  if (is_roadmap(*robot, question)) return report;
  for (const Note& note : mechanism->notes_in_pieces())
    if (note.is_on_limits_left_out) report.text += "\nnote: " + note.text() + "\n";
  return report;
}

}  // namespace

Subcommand map_subcommand() {
  const auto arguments = std::make_shared<MapArguments>();
  return question_subcommand<ask::MapQuestion>(
      "map", "Compute the certified map of aspects, or with six degrees of freedom a certified roadmap",
      arguments, report_of, {},
      {{"--picture", "FILE",
        "Draw as SVG or PNG what `aspects plot --leaves` does, where two coordinates are free",
        &arguments->picture_file, false, Words::one, FileUse::written},
       {"--persistence-picture", "FILE",
        "Draw as SVG what --persistence lists, a bar over the index for each basin", &arguments->basins_file,
        false, Words::one, FileUse::written}},
      {{"--without-limits",
        "Count the aspects without limits of joints, too, where that may take longer than the map",
        &arguments->without_limits},
       {"--all", "List aspects below 1 % of the largest too", &arguments->all_aspects},
       {"--verbose", "List every joint that a note is about", &arguments->verbose}});
}

}  // namespace parallel_aspects::tools
