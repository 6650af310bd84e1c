// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/map_in_shards.h"

#include "ask/question_parts.h"
#include "aspects/shards/sharded_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/numbers.h"
#include "tools/question_options.h"
#include "tools/report/report.h"

#include <chrono>
#include <cstdio>
#include <memory>
#include <numeric>
#include <sys/resource.h>

namespace parallel_aspects::mpi {
namespace {

using tools::Option;
using tools::Report;
using tools::Surroundings;

constexpr unsigned highest_level = 9;
constexpr unsigned max_threads = 1024;

struct ShardArguments {
  tools::RobotChoice robot;
  tools::QuestionTexts constraints;
  std::string resolution, slice, modes, region;  // empty where not given
  std::string level = "2", threads = "1", folder;
};

/// What the run itself took, which differs between runs.
struct RunFigures {
  double seconds = 0.0;
  int processes = 1;
  std::uint64_t bytes_sent = 0, peak_kilobytes = 0;
};

std::optional<Box> region_of(const ShardArguments& arguments, const tools::MapSection& section,
                             TaskSpace space, const std::optional<MapSlice>& slice, Problems& problems) {
  std::vector<std::string> names = slice ? coordinate_names(*slice) : coordinate_names(space);
  names.resize(slice ? slice->free_positions() : directions(space));
  if (arguments.region.empty())
    return slice ? std::nullopt : resolve_region(section.config, space, section.file, problems);
  ask::ProblemList found;
  const auto ranges = tools::parse_ranges("--region", arguments.region, problems);
  const Box region = ask::box_of("region", names, ranges, found);
  for (const std::string& each : texts_of(found, tools::option_name)) problems.push_back(each);
  return region;
}

MapOptions options_of(const ShardArguments& arguments, const tools::MapSection& section,
                      const Manipulator& manipulator, Problems& problems) {
  MapOptions options;
  options.resolution = section.config.resolution;
  options.extra_levels = section.config.extra_levels.value_or(options.extra_levels);
  if (!arguments.resolution.empty())
    options.resolution = tools::parse_positive("--resolution", arguments.resolution, problems);
  options.threads = tools::parse_count("--threads", arguments.threads, max_threads, problems);
  options.modes = tools::parse_modes("--mode", manipulator, arguments.modes, problems);
  if (!arguments.slice.empty())
    options.slice = tools::parse_slice("--slice", manipulator, arguments.slice, problems);
  if (problems.empty())
    options.region = region_of(arguments, section, manipulator.task_space(), options.slice, problems);
  return options;
}

ShardPlan plan_of(const ShardArguments& arguments, const tools::MapSection& section,
                  const Manipulator& manipulator) {
  Problems problems;
  const unsigned level = tools::parse_count("--shard-level", arguments.level, highest_level, problems);
  const MapOptions options = options_of(arguments, section, manipulator, problems);
  ShardPlan plan;
  if (problems.empty()) {
    const std::string problem = make_shard_plan(manipulator, options, level, plan);
    if (!problem.empty()) problems.push_back(problem);
  }
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return plan;
}

nlohmann::json json_of(const LeafTotal& total) {
  nlohmann::json levels = nlohmann::json::object();
  for (std::size_t level = 0; level < total.of_level.size(); ++level)
    if (total.of_level[level] > 0) levels[std::to_string(level)] = total.of_level[level];
  return {{"leaves_by_level", levels}, {"measure", total.measure}};
}

nlohmann::json json_of(const ShardedMap& map, const ShardPlan& plan, const Manipulator& manipulator) {
  nlohmann::json json;
  json["robot"] = manipulator.name();
  json["resolution"] = plan.map.resolution;
  json["unit"] =
      plan.map.slice ? measure_unit(*plan.map.slice) : std::string(measure_unit(manipulator.task_space()));
  json["shards"] = plan.count();
  json["proved_count"] = map.proved_count;
  json["aspects"] = nlohmann::json::array();
  for (const ShardedMap::Part& part : map.aspects) {
    nlohmann::json aspect = json_of(part.inside);
    aspect["id"] = json["aspects"].size() + 1;
    aspect["working_mode"] = to_string(part.mode);
    aspect["determinant_sign"] = part.determinant_sign;
    json["aspects"].push_back(aspect);
  }
  json["unresolved"] = map.unresolved;
  json["undecided"] = json_of(map.undecided);
  json["rounds"] = map.rounds;
  json["divided_leaves"] = map.divided_leaves;
  return json;
}

nlohmann::json json_of(const RunFigures& run) {
  return {{"seconds", run.seconds},
          {"processes", run.processes},
          {"bytes_sent", run.bytes_sent},
          {"peak_kilobytes", run.peak_kilobytes}};
}

std::string text_of(const ShardedMap& map, const ShardPlan& plan, const RunFigures& run,
                    const std::string& unit) {
  double largest = 0.0;
  for (const ShardedMap::Part& part : map.aspects) largest = std::max(largest, part.inside.measure);
  constexpr double share_shown = 0.01;
  tools::TextTable table({"aspect", "working mode", "det A", "proved [" + unit + "]", "leaves"});
  std::size_t small = 0;
  for (std::size_t i = 0; i < map.aspects.size(); ++i) {
    const ShardedMap::Part& part = map.aspects[i];
    small += part.inside.measure < share_shown * largest;
    if (part.inside.measure < share_shown * largest) continue;
    const auto& of_level = part.inside.of_level;
    table.add({std::to_string(i + 1), to_string(part.mode), tools::shown_sign(part.determinant_sign),
               tools::shown(part.inside.measure),
               std::to_string(std::accumulate(of_level.begin(), of_level.end(), std::uint64_t{0}))});
  }
  return std::to_string(map.proved_count) + " aspects at least (" +
         tools::counted(map.aspects.size(), "component") + ", " +
         tools::counted(map.unresolved.size(), "pair") + " unresolved), from " +
         tools::counted(plan.count(), "shard") + " by " +
         tools::counted(static_cast<std::size_t>(run.processes), "process", "processes") + " in " +
         tools::shown_briefly(run.seconds) + " s, " +
         tools::shown_briefly(static_cast<double>(run.peak_kilobytes) / 1000.0) + " MB at most in one.\n" +
         table.text() +
         (small == 0 ? "" : tools::counted(small, "component") + " below 1 % of the largest.\n") +
         "Undecided in all: " + tools::shown(map.undecided.measure) + " " + unit + ".\n";
}

std::uint64_t peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss);
}

Report report_of(const ShardArguments& arguments, MpiCrew& crew, const Surroundings& surroundings) {
  const auto start = std::chrono::steady_clock::now();
  Problems problems;
  const tools::MapSection section = tools::load_map_section(arguments.robot, problems);
  const auto mechanism = tools::load_robot(arguments.robot, std::move(problems));
  const auto manipulator = tools::choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  const ShardPlan plan = plan_of(arguments, section, *manipulator);
  const tools::ShownComputation shown(surroundings);
  const auto map =
      compute_sharded_map(plan, arguments.folder, crew, shown.control(), [&crew](const std::string& note) {
        std::fprintf(stderr, "%s (process %d)\n", note.c_str(), crew.rank());
      });
  if (!map) throw tools::Interrupted{};
  const RunFigures run{std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                       crew.size(), crew.sum(crew.bytes_sent()), crew.largest(peak_kilobytes())};
  if (!crew.is_first()) return {};
  Report report;
  report.json = json_of(*map, plan, *manipulator);
  report.text = text_of(*map, plan, run, report.json["unit"]);
  report.json["run"] = json_of(run);
  return report;
}

std::vector<Option> options_of(ShardArguments& arguments) {
  std::vector<Option> options = tools::robot_options(arguments.robot);
  options.push_back(
      {"--folder", "DIR",
       "Where finished shards are kept, a file each; all processes must see it. The same command "
       "takes them up again",
       &arguments.folder, true});
  options.push_back(
      {"--shard-level", "N",
       "How often the space is halved in every coordinate to give the shards; by default 2, that is "
       "64 of them in three degrees of freedom",
       &arguments.level});
  options.push_back(
      {"--resolution", "R",
       "Longest edge of an undecided leaf of the base map [m or rad]; by default what suits the robot",
       &arguments.resolution});
  options.push_back(
      {"--region", "\"x=0:5 y=0:9\"",
       "Where to look: a lower and an upper end of every position that is free [m]; by default all "
       "that the legs reach",
       &arguments.region, false, tools::Words::assignments});
  options.push_back({"--slice", "\"z=1\"",
                     "Map a line, plane or volume of poses: what is held, with its value", &arguments.slice,
                     false, tools::Words::assignments});
  options.push_back({"--mode", "\"(+,-)\"", "Map these working modes only; by default every one",
                     &arguments.modes, false, tools::Words::signs});
  options.push_back(
      {"--threads", "N", "Threads of each process; by default 1, and 0 for one a core", &arguments.threads});
  for (const Option& option : tools::constraint_options(arguments.constraints)) options.push_back(option);
  return options;
}

}  // namespace

tools::Subcommand map_in_shards(MpiCrew& crew) {
  const auto arguments = std::make_shared<ShardArguments>();
  return {"map", "Compute the certified map of aspects in shards, by all processes together",
          options_of(*arguments), [arguments, &crew](const Surroundings& surroundings) {
            return report_of(*arguments, crew, surroundings);
          }};
}

}  // namespace parallel_aspects::mpi
