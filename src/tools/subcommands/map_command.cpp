// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/whole_file.h"
#include "model/coefficients.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_file.h"
#include "parallel_aspects/model/constraints.h"
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/report/bounds_report.h"
#include "tools/report/map_drawing.h"
#include "tools/report/numbers.h"
#include "tools/report/reports.h"
#include "tools/report/text_table.h"
#include "tools/subcommands.h"

#include <filesystem>
#include <optional>
#include <unistd.h>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

constexpr unsigned most_threads = 1024;

json json_aspect(const AspectMap& map, const Aspect& aspect) {
  return {{"id", aspect.id},
          {"working_mode", aspect.mode.signs()},
          {"det_a_sign", aspect.determinant_sign},
          {"measure", json_number(aspect.measure)},
          {"measure_lower", json_number(aspect.measure_lower)},
          {"measure_upper", json_number(aspect.measure_upper)},
          {"unit", map.unit()},
          {"inside_leaves", aspect.inside_leaves},
          {"bounding_box", json_box(map.coordinates(), aspect.bounds)},
          {"deepest_pose", json_pose(map.manipulator()->task_space(), aspect.deepest)},
          {"clearance", json_number(aspect.deepest_clearance)},
          {"unresolved_with", aspect.unresolved_with}};
}

/// What is held and what is free; null where all poses are mapped.
json json_slice(const AspectMap& map) {
  if (!map.slice()) return nullptr;
  json held = json::object();
  for (const HeldCoordinate& each : map.slice()->held_coordinates) held[each.name] = json_number(each.value);
  const bool freely = map.slice()->rotation == MapSlice::Rotation::freely;
  json axis = nullptr;
  if (map.slice()->rotation == MapSlice::Rotation::about_axis)
    axis = {map.slice()->axis.x(), map.slice()->axis.y(), map.slice()->axis.z()};
  return {{"held", held},
          {"axis", axis},
          {"free", freely ? std::vector<std::string>{"roll", "pitch", "yaw"} : map.coordinates()}};
}

/// Null where the map was loaded.
json json_symmetry(const AspectMap& map) {
  if (!map.symmetry_use()) return nullptr;
  return {{"motions", map.symmetry_use()->motions}, {"computed_modes", map.symmetry_use()->computed_modes}};
}

json json_map(const AspectMap& map) {
  const TaskSpace space = map.manipulator()->task_space();
  json object = {{"mechanism", map.manipulator()->name()},
                 {"task_space", std::string(name(space))},
                 {"slice", json_slice(map)},
                 {"region", json_box(map.coordinates(), map.region())},
                 {"resolution", json_number(map.resolution())},
                 {"seconds", json_number(map.seconds())},
                 {"symmetry", json_symmetry(map)},
                 {"unit", map.unit()},
                 {"working_modes", json::array()},
                 {"aspects", json::array()},
                 {"proved_count", map.proved_count()},
                 {"count_at_most", map.count_at_most() ? json(*map.count_at_most()) : json()},
                 {"indeterminate_leaves", map.indeterminate_leaves()},
                 {"inside_components", map.aspects().size()},
                 {"unresolved", map.unresolved()},
                 {"measure_undecided", json_number(map.measure_undecided())}};
  for (const WorkingMode& mode : map.working_modes()) object["working_modes"].push_back(mode.signs());
  for (const Aspect& aspect : map.aspects()) object["aspects"].push_back(json_aspect(map, aspect));
  return object;
}

std::string pose_text(TaskSpace space, const Pose& pose) {
  std::string text;
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  for (const double coordinate : coefficients_of(coordinates))
    text += (text.empty() ? "(" : ", ") + shown_briefly(coordinate);
  return text + ")";
}

std::string bounds_text(const Box& box) {
  std::string text;
  for (std::size_t i = 0; i < box.dimension; ++i)
    text += (i == 0 ? "" : " x ") + std::string("[") + shown_briefly(box.lower[i]) + ", " +
            shown_briefly(box.upper[i]) + "]";
  return text;
}

std::string aspect_table(const AspectMap& map) {
  TextTable table({">id", "working mode", "det A", ">measure [" + map.unit() + "]", ">at least", ">at most",
                   ">leaves", "bounds", "deepest pose", ">clearance"});
  for (const Aspect& aspect : map.aspects())
    table.add({std::to_string(aspect.id), to_string(aspect.mode), shown_sign(aspect.determinant_sign),
               shown(aspect.measure), shown(aspect.measure_lower), shown(aspect.measure_upper),
               std::to_string(aspect.inside_leaves), bounds_text(aspect.bounds),
               pose_text(map.manipulator()->task_space(), aspect.deepest),
               shown_briefly(aspect.deepest_clearance)});
  return table.text();
}

std::string unresolved_text(const std::vector<std::pair<int, int>>& pairs) {
  if (pairs.empty()) return "none; all are proved separate";
  std::string text;
  for (const auto& pair : pairs)
    text += (text.empty() ? "" : ", ") + std::to_string(pair.first) + " with " + std::to_string(pair.second);
  return text;
}

/// What is proved of aspects that are not listed.
std::string completeness_text(const AspectMap& map) {
  const auto most = map.count_at_most();
  if (!most) return "";
  return *most == map.proved_count() ? ", proved to be all" : ", " + std::to_string(*most) + " at most";
}

/// Which symmetries were used, and what for.
std::string symmetry_text(const AspectMap& map) {
  if (!map.symmetry_use() || map.symmetry_use()->motions.empty()) return "";
  std::string text;
  for (const std::string& motion : map.symmetry_use()->motions) text += (text.empty() ? " " : "; ") + motion;
  return "symmetry" + text + ": components of " +
         counted(map.symmetry_use()->computed_modes, "working mode") + " computed\n";
}

std::string map_text(const AspectMap& map) {
  const TaskSpace space = map.manipulator()->task_space();
  std::string text = map.manipulator()->name() + ": " + counted(map.aspects().size(), "aspect") + " in " +
                     counted(map.working_modes().size(), "working mode") + ", " +
                     std::to_string(map.proved_count()) + " proved distinct" + completeness_text(map) + "\n";
  if (map.slice())
    text += "slice " + to_string(*map.slice()) +
            ": aspects of the slice, of which two may be joined outside of it\n";
  text += "task space " + std::string(name(space)) + ", region " + bounds_text(map.region()) +
          ", resolution " + shown(map.resolution()) + ", " + shown(map.seconds()) + " s\n" +
          symmetry_text(map) + "\n";
  text += aspect_table(map);
  text += "\npairs that could be one aspect: " + unresolved_text(map.unresolved()) + "\n";
  text += "undecided, over all working modes: " + shown(map.measure_undecided()) + " " + map.unit() + "\n";
  return text;
}

struct MapArguments {
  RobotChoice robot;
  std::string slice, modes;        // empty where not given
  std::string resolution, region;  // likewise
  std::string threads;
  std::string load_file, save_file;  // empty where not given
  std::string picture_file;
  bool neighbours = false;
  bool no_symmetry = false;
  RoadmapArguments roadmap;
  ConstraintArguments constraints;
};

/// What the command line says, and else the robot's file; the region is not yet looked at.
MapOptions parse_options(const MapArguments& arguments, const MapConfig& section, Problems& problems) {
  MapOptions options;
  options.resolution = section.resolution;
  options.threads = section.threads.value_or(options.threads);
  options.extra_levels = section.extra_levels.value_or(options.extra_levels);
  options.use_symmetry = !arguments.no_symmetry;
  if (!arguments.resolution.empty())
    options.resolution = parse_positive("--resolution", arguments.resolution, problems);
  if (!arguments.threads.empty())
    options.threads = parse_count("--threads", arguments.threads, most_threads, problems);
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
  if (!arguments.region.empty() && names.empty())
    problems.emplace_back(
        "--region is of positions, but here every orientation is searched and no more; "
        "leave it out.");
  else if (!arguments.region.empty())
    return parse_region("--region", names, arguments.region, problems);
  if (!arguments.region.empty()) return std::nullopt;
  const auto region = resolve_region(section.config, space, section.file, problems);
  return region && slice ? region_of_slice(*region, *slice, section.file, problems) : region;
}

/// A long computation is not to be lost to a folder that is not there, or a file that cannot be replaced.
void check_file(const std::string& option, const std::string& file, Problems& problems) {
  if (file.empty()) return;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
    problems.push_back(option + " is '" + file +
                       "', which is in no folder that can be written to; give another.");
  else if (std::error_code error;
           std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
    problems.push_back(option + " is '" + file + "', which is not a regular file; give another.");
}

// With six degrees of freedom there is a roadmap in place of a map.
Report roadmap_report(std::shared_ptr<const Manipulator> manipulator, const MapArguments& arguments,
                      const MapSection& section, const Surroundings& surroundings) {
  Problems problems;
  RoadmapOptions options = parse_roadmap(arguments.roadmap, problems);
  options.threads = parse_options(arguments, section.config, problems).threads;
  options.region = find_region(arguments, section, manipulator->task_space(), std::nullopt, problems);
  if (!arguments.resolution.empty())
    problems.emplace_back(
        "--resolution is that of a map of boxes, which there is none of in SE3 without --slice; give that or "
        "--samples.");
  if (!arguments.load_file.empty() || !arguments.save_file.empty())
    problems.emplace_back(
        "--load and --save are for maps of boxes, which there is none of in SE3 without --slice; leave them "
        "out.");
  if (!arguments.picture_file.empty())
    problems.emplace_back(
        "--picture is for maps of boxes, which there is none of in SE3 without --slice; give a slice of two "
        "free "
        "coordinates.");
  if (arguments.neighbours)
    problems.emplace_back(
        "--neighbours is for maps of boxes, which there is none of in SE3 without --slice; leave it out.");
  if (arguments.no_symmetry)
    problems.emplace_back(
        "--no-symmetry is for maps of boxes, which there is none of in SE3 without --slice; leave it out.");
  if (!arguments.modes.empty())
    problems.emplace_back(
        "--mode is for maps of boxes, which there is none of in SE3 without --slice; leave it out.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return report_roadmap(*compute_roadmap(std::move(manipulator), options, surroundings));
}

/// The options that depend on the robot.
void add_coverage(const MapArguments& arguments, const MapSection& section, const Manipulator& manipulator,
                  MapOptions& options) {
  Problems problems;
  if (!arguments.roadmap.samples.empty() || !arguments.roadmap.seed.empty())
    problems.push_back("--samples and --seed are for roadmaps, in SE3 without --slice; the map of '" +
                       manipulator.name() + "' is one of boxes, so give --resolution.");
  options.modes = parse_modes("--mode", manipulator, arguments.modes, problems);
  if (!arguments.slice.empty())
    options.slice = parse_slice("--slice", manipulator.task_space(), arguments.slice, problems);
  if (problems.empty())
    options.region = find_region(arguments, section, manipulator.task_space(), options.slice, problems);
  const std::size_t dimension =
      options.slice ? options.slice->dimension() : degrees_of_freedom(manipulator.task_space());
  if (problems.empty() && !arguments.picture_file.empty() && dimension != 2)
    problems.push_back("--picture is of two coordinates, but the map has " + std::to_string(dimension) +
                       "; give a slice that leaves two free.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
}

std::shared_ptr<const AspectMap> compute(std::shared_ptr<const Manipulator> manipulator,
                                         const MapOptions& options, const Surroundings& surroundings) {
  const auto result = completed(surroundings, [&](const MapControl& control) {
    return compute_aspect_map(manipulator, options, control);
  });
  return result.map;
}

/// The map in the file that is to be loaded; null, with the reason as a message, where it is of no use.
std::shared_ptr<const AspectMap> load(const std::shared_ptr<const Manipulator>& manipulator,
                                      const MapOptions& options, const MapArguments& arguments,
                                      const Surroundings& surroundings) {
  if (arguments.load_file.empty()) return nullptr;
  const MapResult result = load_map(manipulator, options, arguments.load_file);
  if (result.status != MapStatus::complete) surroundings.messages << result.message << std::endl;
  return result.map;
}

void save(const AspectMap& map, const MapArguments& arguments) {
  if (arguments.save_file.empty()) return;
  const SaveResult result = save_map(map, arguments.save_file);
  if (!result.saved) throw InvalidDescription({result.message});
}

void draw(const AspectMap& map, const MapArguments& arguments) {
  if (arguments.picture_file.empty()) return;
  const std::string svg = draw_map(map);
  const std::string problem = replace_file(arguments.picture_file, Bytes(svg.begin(), svg.end()));
  if (!problem.empty())
    throw InvalidDescription({"Picture '" + arguments.picture_file + "' is not written, since " + problem +
                              "; give a file in a folder that can be written to and has room."});
}

Report load_or_compute(const std::shared_ptr<const Manipulator>& manipulator, const MapOptions& options,
                       const MapArguments& arguments, const Surroundings& surroundings) {
  std::shared_ptr<const AspectMap> map = load(manipulator, options, arguments, surroundings);
  const bool loaded = map != nullptr;
  if (!loaded) map = compute(manipulator, options, surroundings);
  save(*map, arguments);
  draw(*map, arguments);
  Report report = report_map(*map, loaded);
  if (arguments.neighbours) {
    MapControl control;
    control.cancelled = surroundings.interrupted;
    add_neighbours(*map, find_neighbours(*map, control), report);
  }
  return report;
}

}  // namespace

Report report_map(const AspectMap& map, bool loaded) {
  Report report{json_map(map), map_text(map)};
  const Report bounds = report_bounds(map);
  report.json.update(bounds.json);
  report.text += bounds.text;
  report.json["loaded"] = loaded;
  return report;
}

Subcommand map_subcommand() {
  const auto arguments = std::make_shared<MapArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back(
      {"--resolution", "R",
       "Longest edge of an undecided leaf of the base map [m or rad]; by default what suits the robot",
       &arguments->resolution});
  options.push_back({"--region", "\"x=0:5 y=0:9\"",
                     "Where to look: a lower and an upper end of every position that is free [m]; by default "
                     "all that the legs reach",
                     &arguments->region});
  options.push_back({"--slice", "\"z=1\"",
                     "Map a line, plane or volume of poses: what is held, with its value [m or rad]; the "
                     "rest is free",
                     &arguments->slice});
  options.push_back({"--mode", "\"(+,-)\"",
                     "Map these working modes only, as signs of B_jj; by default every one",
                     &arguments->modes});
  options.push_back({"--threads", "N",
                     "Threads to compute with; by default one a core. The result does not depend on it",
                     &arguments->threads});
  options.push_back({"--load", "FILE", "Take the map from this file if it is of this robot and these options",
                     &arguments->load_file});
  options.push_back({"--save", "FILE", "Write the map to this file, for --load", &arguments->save_file});
  options.push_back({"--picture", "FILE",
                     "Draw the aspects of every working mode as SVG, where two coordinates are free",
                     &arguments->picture_file});
  options.push_back({"--samples", "N",
                     "With six degrees of freedom: poses of the certified roadmap, by default 1000",
                     &arguments->roadmap.samples});
  options.push_back({"--seed", "N", "With six degrees of freedom: seed of its poses, by default 1",
                     &arguments->roadmap.seed});
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"map",
          "Compute the certified map of aspects, or with six degrees of freedom a certified roadmap",
          options,
          [arguments](const Surroundings& surroundings) {
            Problems problems;
            const MapSection section = load_map_section(arguments->robot, problems);
            MapOptions map_options = parse_options(*arguments, section.config, problems);
            check_file("--save", arguments->save_file, problems);
            check_file("--picture", arguments->picture_file, problems);
            const auto mechanism = load_robot(arguments->robot, std::move(problems));
            const auto manipulator = choose_constraints(mechanism->manipulator(), arguments->constraints);
            if (manipulator->task_space() == TaskSpace::SE3 && arguments->slice.empty())
              return roadmap_report(manipulator, *arguments, section, surroundings);
            add_coverage(*arguments, section, *manipulator, map_options);
            return load_or_compute(manipulator, map_options, *arguments, surroundings);
          },
          {{"--neighbours", "Tell which aspects touch across a singularity, and where that is proved",
            &arguments->neighbours},
           {"--no-symmetry", "Compute what symmetries of the robot show to be the same, too",
            &arguments->no_symmetry}}};
}

}  // namespace parallel_aspects::tools
