// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/shape_arguments.h"
#include "tools/subcommands.h"
#include "tools/sweep/sweep_file.h"
#include "tools/sweep/sweep_plan.h"
#include "tools/sweep/sweep_run.h"

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

constexpr unsigned most_threads = 1024, most_shards = 1'000'000;

struct SweepArguments {
  RobotChoice robot;
  ConstraintArguments constraints;
  ShapeArguments shape;
  std::string vary, sample, designs, figures, shard, resolution, slice, modes,
      threads;  // empty where not given
  std::string file;
  bool untied = false;
};

struct MergeArguments {
  std::string parts, file;
};

SweepSample parse_sample(const std::string& text, Problems& problems) {
  if (!text.empty() && text != "grid" && text != "sobol")
    problems.push_back("--sample is '" + text + "'; give grid or sobol.");
  return text == "sobol" ? SweepSample::sobol : SweepSample::grid;
}

std::size_t parse_designs(const SweepArguments& arguments, const SweepPlan& plan, Problems& problems) {
  if (plan.sample == SweepSample::grid) {
    if (!arguments.designs.empty())
      problems.emplace_back(
          "--designs is of --sample sobol; a grid has as many as its values make. Leave it out.");
    const std::size_t size = grid_size(plan.varied);
    if (size == 0)
      problems.push_back("--vary makes more than " + std::to_string(most_designs) +
                         " designs; give fewer values.");
    return size;
  }
  const std::size_t count =
      arguments.designs.empty() ? 0 : parse_count("--designs", arguments.designs, most_designs, problems);
  if (count == 0 && problems.empty())
    problems.emplace_back("--sample sobol takes --designs, 1 or more; give how many designs are wanted.");
  return count;
}

Shard parse_shard(const std::string& text, Problems& problems) {
  Shard shard;
  if (text.empty()) return shard;
  const std::size_t slash = text.find('/');
  Problems found;
  shard.index = parse_count("--shard", text.substr(0, slash), most_shards, found);
  shard.count =
      slash == std::string::npos ? 0 : parse_count("--shard", text.substr(slash + 1), most_shards, found);
  if (!found.empty() || shard.index < 1 || shard.index > shard.count)
    problems.push_back("--shard is '" + text + "'; give the part and how many there are, such as 1/4.");
  return shard;
}

/// What the columns report; the shape is not yet looked at.
DesignQuestion parse_figures(const std::string& text, Problems& problems) {
  DesignQuestion question;
  if (text.empty()) return question;
  question.count = false;
  for (const std::string& word : words_of_list(text)) {
    if (word == "count")
      question.count = true;
    else if (word == "measures")
      question.measures = true;
    else if (word == "clearance")
      question.clearance = true;
    else if (word == "workspace")
      question.workspace.emplace();
    else
      problems.push_back("--report has '" + word + "'; give count, measures, clearance or workspace.");
  }
  return question;
}

void take_map_options(const SweepArguments& arguments, const Manipulator& manipulator,
                      DesignQuestion& question, Problems& problems) {
  question.map.threads = 1;  // one a design
  if (!arguments.resolution.empty())
    question.map.resolution = parse_positive("--resolution", arguments.resolution, problems);
  if (!arguments.slice.empty())
    question.map.slice = parse_slice("--slice", manipulator, arguments.slice, problems);
  question.map.modes = parse_modes("--mode", manipulator, arguments.modes, problems);
  if (!question.workspace && (!arguments.shape.name.empty() || !arguments.shape.ratio.empty()))
    problems.emplace_back("--shape is of --report workspace; ask for that, or leave it out.");
  if (!question.workspace || !problems.empty()) return;
  if (arguments.shape.name.empty()) {
    problems.emplace_back("--report workspace takes --shape: box, square, disc, cylinder or ball.");
    return;
  }
  question.workspace = parse_shape(arguments.shape, manipulator, question.map.slice, problems);
  question.gap = arguments.shape.gap.empty() ? question.gap : parse_gap(arguments.shape, problems);
}

void refuse_six_degrees(const Manipulator& manipulator, const DesignQuestion& question, Problems& problems) {
  if (manipulator.task_space() == TaskSpace::SE3 && !question.map.slice && problems.empty())
    problems.push_back(
        "'" + manipulator.name() +
        "' has six degrees of freedom, which are more than can be mapped; give --slice, such as "
        "\"roll=0 pitch=0 yaw=0\".");
}

void check_parameters(const SweepPlan& plan, Problems& problems) {
  std::vector<std::string> names;
  for (const VariedParameter& each : plan.varied) names.push_back(each.name);
  const Problems more = problems_of(*plan.robot, names, plan.keep_ties);
  problems.insert(problems.end(), more.begin(), more.end());
}

Report report_sweep(const SweepPlan& plan, const Shard& shard, std::size_t before, const SweepFile& rows,
                    const std::string& file) {
  Report report;
  report.json = {{"file", file},          {"mechanism", plan.robot->name()},
                 {"designs", plan.count}, {"shard", {{"index", shard.index}, {"count", shard.count}}},
                 {"rows", rows.rows()},   {"rows_before", before}};
  report.text =
      file + ": " + std::to_string(rows.rows()) + " of " + counted(plan.count, "design") +
      (shard.count > 1 ? ", shard " + std::to_string(shard.index) + "/" + std::to_string(shard.count) : "") +
      (before > 0 ? ", " + std::to_string(before) + " of them from before" : "") + "\n";
  return report;
}

Report sweep(const SweepPlan& plan, const Shard& shard, const SweepArguments& arguments, unsigned threads,
             const Surroundings& surroundings) {
  SweepFile file(plan, shard, arguments.file);
  const std::size_t before = file.rows();
  std::optional<ProgressBar> bar;
  if (surroundings.messages_on_terminal) bar.emplace(surroundings.messages);
  const auto start = std::chrono::steady_clock::now();
  const MapControl control = control_of(surroundings);
  const auto progress = [&](std::size_t rows, std::size_t of) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    const auto share = [of](std::size_t n) { return static_cast<double>(n) / static_cast<double>(of); };
    if (bar && of > 0) bar->show(share(rows), share(before), taken.count());
  };
  run_sweep(plan, shard, threads, control, progress, file);
  if (is_cancelled(control)) throw Interrupted{};
  return report_sweep(plan, shard, before, file, arguments.file);
}

Report report_of(const SweepArguments& arguments, const Surroundings& surroundings) {
  Problems problems;
  SweepPlan plan;
  plan.sample = parse_sample(arguments.sample, problems);
  plan.varied = parse_varied(arguments.vary, plan.sample, problems);
  plan.keep_ties = !arguments.untied;
  if (problems.empty()) plan.count = parse_designs(arguments, plan, problems);
  plan.question = parse_figures(arguments.figures, problems);
  const Shard shard = parse_shard(arguments.shard, problems);
  const unsigned threads =
      arguments.threads.empty() ? 0 : parse_count("--threads", arguments.threads, most_threads, problems);
  check_output_file("-o", arguments.file, problems);
  const auto mechanism = load_robot(arguments.robot, std::move(problems));
  plan.robot = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  problems.clear();
  take_map_options(arguments, *plan.robot, plan.question, problems);
  refuse_six_degrees(*plan.robot, plan.question, problems);
  check_parameters(plan, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return sweep(plan, shard, arguments, threads, surroundings);
}

std::vector<Option> options_of(SweepArguments& arguments) {
  std::vector<Option> options = robot_options(arguments.robot);
  options.push_back(
      {"--vary", "\"crank_1=0.2:0.4:21 rod=1\"",
       "Lengths and points by name, as `aspects describe` lists them: a value, or a range with the "
       "number of its values [m]",
       &arguments.vary, true});
  options.push_back({"-o", "FILE", "Rows as CSV; where it is there, the same command goes on with it",
                     &arguments.file, true});
  options.push_back({"--sample", "NAME", "grid, which is the default, or sobol", &arguments.sample});
  options.push_back({"--designs", "N", "How many designs of --sample sobol", &arguments.designs});
  options.push_back(
      {"--report", "LIST",
       "What to report of each design: count, which is the default, measures, clearance, workspace",
       &arguments.figures});
  options.push_back({"--shard", "i/n", "This part of the designs alone, i from 1; `aspects merge` joins them",
                     &arguments.shard});
  options.push_back({"--resolution", "R", "Of each map [m or rad]; by default what suits each design",
                     &arguments.resolution});
  options.push_back({"--slice", "\"z=1\"", "Map what holds these coordinates alone, as of `aspects map`",
                     &arguments.slice});
  options.push_back({"--mode", "\"(+,-)\"", "Map these working modes only", &arguments.modes});
  options.push_back({"--threads", "N", "Designs at a time; by default one a core", &arguments.threads});
  for (const Option& option : shape_options(arguments.shape, false)) options.push_back(option);
  for (const Option& option : constraint_options(arguments.constraints)) options.push_back(option);
  return options;
}

Report report_of(const MergeArguments& arguments) {
  Problems problems;
  const std::vector<std::string> files = words_of_list(arguments.parts);
  std::vector<NamedFile> inputs;
  for (const std::string& file : files) inputs.push_back({"a part", file});
  check_output_file("-o", arguments.file, problems);
  check_distinct_files({{"-o", arguments.file}}, inputs, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  write_output_file("The merged file", arguments.file, merged_parts(files));
  Report report;
  report.json = {{"file", arguments.file}, {"parts", files}};
  report.text = arguments.file + ": merged from " + counted(files.size(), "part") + "\n";
  return report;
}

}  // namespace

Subcommand sweep_subcommand() {
  const auto arguments = std::make_shared<SweepArguments>();
  return {"sweep",
          "Map many designs, with other lengths of links and places of joints, a row each",
          options_of(*arguments),
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); },
          {{"--untied", "Vary parameters alone that symmetries of the robot tie to each other",
            &arguments->untied}}};
}

Subcommand merge_subcommand() {
  const auto arguments = std::make_shared<MergeArguments>();
  return {"merge",
          "Join the parts of a sweep that was computed in shards",
          {{"PARTS", "", "Files of all shards, separated by blanks or commas; quote them", &arguments->parts,
            true},
           {"-o", "FILE", "The whole sweep", &arguments->file, true}},
          [arguments](const Surroundings&) { return report_of(*arguments); }};
}

}  // namespace parallel_aspects::tools
