// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/empty_map.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/constraints.h"
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/drawing/plot.h"
#include "tools/drawing/result_charts.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/question_options.h"
#include "tools/report/basins_report.h"
#include "tools/report/reports.h"
#include "tools/subcommands.h"
#include "tools/subcommands/unlimited_count.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

constexpr unsigned max_threads = 1024;

struct MapArguments {
  RobotChoice robot;
  std::string slice, modes;        // empty where not given
  std::string resolution, region;  // likewise
  std::string threads;
  std::string load_file, save_file;  // empty where not given
  std::string picture_file, basins_file;
  bool neighbours = false;
  bool without_limits = false;
  bool no_symmetry = false;
  bool complete = false;
  bool all_aspects = false;
  bool verbose = false;
  bool persistence = false;
  std::string index_text;
  ParallelIndex index = ParallelIndex::normalised;
  RoadmapArguments roadmap;
  ConstraintArguments constraints;

  bool wants_basins() const { return persistence || !basins_file.empty(); }
};

/// What the command line says, and else the robot's file; the region is not yet looked at.
MapOptions parse_options(const MapArguments& arguments, const MapConfig& section, Problems& problems) {
  MapOptions options;
  options.resolution = section.resolution;
  options.threads = section.threads.value_or(options.threads);
  options.extra_levels = section.extra_levels.value_or(options.extra_levels);
  options.use_symmetry = !arguments.no_symmetry;
  options.complete = arguments.complete;
  if (!arguments.resolution.empty())
    options.resolution = parse_positive("--resolution", arguments.resolution, problems);
  if (!arguments.threads.empty())
    options.threads = parse_count("--threads", arguments.threads, max_threads, problems);
  return options;
}

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

/// Where to look, as the command line says, and else the robot's file; nothing where neither does.
std::optional<Box> find_region(const MapArguments& arguments, const MapSection& section, TaskSpace space,
                               const std::optional<MapSlice>& slice, Problems& problems) {
  std::vector<std::string> names = slice ? coordinate_names(*slice) : coordinate_names(space);
  names.resize(slice ? slice->free_positions() : directions(space));
  if (!arguments.region.empty() && slice && slice->joint)
    problems.emplace_back(
        "--region is of positions, but here every direction and orientation is searched and no more; leave "
        "it "
        "out.");
  else if (!arguments.region.empty() && names.empty())
    problems.emplace_back(
        "--region is of positions, but here every orientation is searched and no more; "
        "leave it out.");
  else if (!arguments.region.empty())
    return parse_region("--region", names, arguments.region, problems);
  if (!arguments.region.empty()) return std::nullopt;
  if (slice && slice->joint) return std::nullopt;
  const auto region = resolve_region(section.config, space, section.file, problems);
  return region && slice ? region_of_slice(*region, *slice, section.file, problems) : region;
}

void refuse_options_of_boxes(const MapArguments& arguments, const Manipulator& manipulator, const Pose& home,
                             Problems& problems) {
  const auto refuse = [&problems](bool is_given, const std::string& options, const std::string& remedy) {
    if (is_given)
      problems.push_back(options + " for maps of boxes, and in SE3 only slices have these; " + remedy + ".");
  };
  const std::string leave = "give --slice, or leave ";
  refuse(!arguments.resolution.empty(), "--resolution is", "give --slice, or --samples for the roadmap");
  refuse(!arguments.load_file.empty() || !arguments.save_file.empty(), "--load and --save are",
         leave + "them out");
  refuse(!arguments.picture_file.empty(), "--picture is",
         "give one that leaves two coordinates free, such as --slice " + example_of_plane(manipulator, home));
  refuse(arguments.wants_basins() || !arguments.index_text.empty(),
         "--persistence, --persistence-picture and --index are", leave + "them out");
  refuse(arguments.neighbours, "--neighbours is", leave + "it out");
  refuse(arguments.without_limits, "--without-limits is", leave + "it out");
  refuse(arguments.no_symmetry, "--no-symmetry is", leave + "it out");
  refuse(arguments.complete, "--complete is", "leave it out");
  refuse(!arguments.modes.empty(), "--mode is", leave + "it out");
}

// With six degrees of freedom there is a roadmap in place of a map.
Report roadmap_report(std::shared_ptr<const Manipulator> manipulator, const Pose& home,
                      const MapArguments& arguments, const MapSection& section,
                      const Surroundings& surroundings) {
  Problems problems;
  RoadmapOptions options = parse_roadmap(arguments.roadmap, problems);
  options.threads = parse_options(arguments, section.config, problems).threads;
  options.region = find_region(arguments, section, manipulator->task_space(), std::nullopt, problems);
  refuse_options_of_boxes(arguments, *manipulator, home, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return report_roadmap(*compute_roadmap(std::move(manipulator), options, surroundings), arguments.verbose);
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

/// The options that depend on the robot.
void add_coverage(const MapArguments& arguments, const MapSection& section, const Manipulator& manipulator,
                  const Pose& home, MapOptions& options) {
  Problems problems;
  if (!arguments.roadmap.samples.empty() || !arguments.roadmap.seed.empty())
    problems.push_back("--samples and --seed are for roadmaps, in SE3 without --slice; the map of '" +
                       manipulator.name() + "' is one of boxes, so give --resolution.");
  options.modes = parse_modes("--mode", manipulator, arguments.modes, problems);
  if (!arguments.slice.empty())
    options.slice = parse_slice("--slice", manipulator, arguments.slice, problems);
  if (arguments.complete && !arguments.slice.empty())
    problems.push_back("--complete is for maps of all poses, not for slices; leave out one of the two.");
  const std::size_t whole = degrees_of_freedom(manipulator.task_space());
  if (!arguments.slice.empty() && !problems.empty() && whole == 2)
    problems.back() += " The map of T2 has two coordinates as it is, so that it needs no --slice.";
  if (problems.empty())
    options.region = find_region(arguments, section, manipulator.task_space(), options.slice, problems);
  const std::size_t dimension = options.slice ? options.slice->dimension() : whole;
  if (problems.empty() && !arguments.picture_file.empty() && dimension != 2)
    problems.push_back("--picture is of two coordinates, but the map has " + std::to_string(dimension) +
                       picture_remedy(manipulator, home));
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
}

std::shared_ptr<const AspectMap> compute(std::shared_ptr<const Manipulator> manipulator,
                                         const MapOptions& options, const Surroundings& surroundings) {
  return completed(
             surroundings,
             [&](const MapControl& control) { return compute_aspect_map(manipulator, options, control); })
      .map;
}

/// The map in the file that is to be loaded; null, with the reason as a message, where it is of no use. A
/// file that the map is saved to need not be there the first time.
std::shared_ptr<const AspectMap> load(const std::shared_ptr<const Manipulator>& manipulator,
                                      const MapOptions& options, const MapArguments& arguments,
                                      const Surroundings& surroundings) {
  const std::string& file = arguments.load_file;
  if (file.empty() || (file == arguments.save_file && !std::filesystem::exists(file))) return nullptr;
  const MapResult result = load_map(manipulator, options, file);
  if (result.status != MapStatus::complete) surroundings.messages << result.message << std::endl;
  return result.map;
}

// The boxes that are proved, and those that are not.
void draw(const std::shared_ptr<const AspectMap>& map, const std::string& file) {
  PlotOptions options;
  options.leaves = true;
  write_picture_file(file, draw_plot(map, options));
}

MapBasins basins_of(const AspectMap& map, const MapArguments& arguments, const Surroundings& surroundings) {
  const auto basins =
      find_basins(map, arguments.index, arguments.wants_basins() ? BasinDetail::basins : BasinDetail::depths,
                  control_of(surroundings));
  if (!basins) throw Interrupted{};
  return *basins;
}

std::string reason_of_none(const AspectMap& map, const Surroundings& surroundings) {
  const MapControl control = control_of(surroundings);
  std::string reason = why_empty(map, control);
  if (is_cancelled(control)) throw Interrupted{};
  return reason;
}

Report load_or_compute(const std::shared_ptr<const Manipulator>& manipulator, const MapOptions& options,
                       const MapArguments& arguments, const Surroundings& surroundings) {
  std::shared_ptr<const AspectMap> map = load(manipulator, options, arguments, surroundings);
  const bool loaded = map != nullptr;
  if (!loaded) map = compute(manipulator, options, surroundings);
  save_with_gates(*map, arguments.save_file, surroundings);
  if (!arguments.picture_file.empty()) draw(map, arguments.picture_file);
  const MapBasins basins = basins_of(*map, arguments, surroundings);
  Report report = report_map(
      *map, {loaded, arguments.all_aspects, arguments.verbose, &basins, reason_of_none(*map, surroundings)});
  if (arguments.persistence) add_persistence(*map, basins, report);
  if (!arguments.basins_file.empty())
    write_output_file("Picture", arguments.basins_file, draw_basins(*map, basins));
  add_count_without_limits(*map, options, arguments.without_limits, surroundings, report);
  if (arguments.neighbours) add_neighbours(*map, find_neighbours(*map, control_of(surroundings)), report);
  return report;
}

std::vector<Option> options_of(MapArguments& arguments) {
  std::vector<Option> options = robot_options(arguments.robot);
  options.push_back(
      {"--resolution", "R",
       "Longest edge of an undecided leaf of the base map [m or rad]; by default what suits the robot",
       &arguments.resolution});
  options.push_back({"--region", "\"x=0:5 y=0:9\"",
                     "Where to look: a lower and an upper end of every position that is free [m]; by default "
                     "all that the legs reach",
                     &arguments.region, false, Words::assignments});
  options.push_back(
      {"--slice", "\"z=1\"",
       "Map a line, plane or volume of poses: what is held, with its value [m or rad]; the "
       "rest is free. In SE2 an actuated joint may be held, such as \"strut_1_joint=15\"; ends of "
       "aspects are then those of (direction, phi), poses still (x, y, phi)",
       &arguments.slice, false, Words::assignments});
  options.push_back({"--mode", "\"(+,-)\"",
                     "Map these working modes only, as signs of B_jj; by default every one", &arguments.modes,
                     false, Words::signs});
  options.push_back({"--threads", "N",
                     "Threads to compute with; by default one a core. The result does not depend on it",
                     &arguments.threads});
  options.push_back({"--load", "FILE", "Take the map from this file if it is of this robot and these options",
                     &arguments.load_file, false, Words::one, FileUse::loaded});
  options.push_back({"--save", "FILE", "Write the map to this file, for --load", &arguments.save_file, false,
                     Words::one, FileUse::saved});
  options.push_back({"--picture", "FILE",
                     "Draw as SVG or PNG what `aspects plot --leaves` does, where two coordinates are free",
                     &arguments.picture_file, false, Words::one, FileUse::written});
  options.push_back({"--persistence-picture", "FILE",
                     "Draw as SVG what --persistence lists, a bar over the index for each basin",
                     &arguments.basins_file, false, Words::one, FileUse::written});
  options.push_back({"--samples", "N",
                     "With six degrees of freedom: poses of the certified roadmap, by default 1000",
                     &arguments.roadmap.samples});
  options.push_back({"--seed", "N", "With six degrees of freedom: seed of its poses, by default 1",
                     &arguments.roadmap.seed});
  options.push_back(index_option(arguments.index_text));
  for (const Option& option : constraint_options(arguments.constraints)) options.push_back(option);
  return options;
}

Report report_of(MapArguments arguments, const Surroundings& surroundings) {
  Problems problems;
  arguments.index = parse_index(arguments.index_text, problems);
  const MapSection section = load_map_section(arguments.robot, problems);
  MapOptions map_options = parse_options(arguments, section.config, problems);
  check_map_output("--save", arguments.save_file, problems);
  check_picture_file("--picture", arguments.picture_file, problems);
  check_output_file("--persistence-picture", arguments.basins_file, problems);
  const auto mechanism = load_robot(arguments.robot, std::move(problems));
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  const Pose home = mechanism->assembled().pose;
  if (manipulator->task_space() == TaskSpace::SE3 && arguments.slice.empty())
    return roadmap_report(manipulator, home, arguments, section, surroundings);
  add_coverage(arguments, section, *manipulator, home, map_options);
  Report report = load_or_compute(manipulator, map_options, arguments, surroundings);
  for (const Note& note : mechanism->notes_in_pieces())
    if (note.is_on_limits_left_out) report.text += "\nnote: " + note.text() + "\n";
  return report;
}

}  // namespace

Subcommand map_subcommand() {
  const auto arguments = std::make_shared<MapArguments>();
  return {
      "map",
      "Compute the certified map of aspects, or with six degrees of freedom a certified roadmap",
      options_of(*arguments),
      [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); },
      {{"--neighbours", "Tell which aspects touch across a singularity, and where that is proved",
        &arguments->neighbours},
       {"--without-limits",
        "Count the aspects without limits of joints, too, where that may take longer than the map",
        &arguments->without_limits},
       {"--no-symmetry", "Compute what symmetries of the robot show to be the same, too",
        &arguments->no_symmetry},
       {"--complete",
        "Prove that no small aspects hide, if possible, in many times the time; needed with three degrees of "
        "freedom and for fine maps with two",
        &arguments->complete},
       {"--all", "List aspects below 1 % of the largest too", &arguments->all_aspects},
       {"--persistence", "List the basins of each aspect: which parts of it a larger margin separates",
        &arguments->persistence},
       {"--verbose", "List every joint that a note is about", &arguments->verbose}}};
}

}  // namespace parallel_aspects::tools
