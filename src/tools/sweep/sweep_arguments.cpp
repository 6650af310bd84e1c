// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_arguments.h"

#include "tools/numbers.h"
#include "tools/report/report.h"

#include <utility>

namespace parallel_aspects::tools {
namespace {

constexpr unsigned most_shards = 1'000'000;

std::size_t parse_designs(const SweepArguments& arguments, const SweepPlan& plan, Problems& problems) {
  if (plan.sample == SweepSample::grid) {
    if (arguments.designs)
      problems.emplace_back(
          "--designs is of --sample sobol; a grid has as many as its values make. Leave it out.");
    const std::size_t size = grid_size(plan.varied);
    if (size == 0)
      problems.push_back("--vary makes more than " + std::to_string(most_designs) +
                         " designs; give fewer values.");
    return size;
  }
  if (!arguments.designs)
    problems.emplace_back("--sample sobol takes --designs, 1 or more; give how many designs are wanted.");
  return arguments.designs ? arguments.designs->value : 0;
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
  question.map.resolution = arguments.resolution;
  question.map.slice = arguments.slice;
  question.map.modes = arguments.modes;
  if (!question.workspace && (arguments.shape.shape || !arguments.shape.aspect_ratio.empty()))
    problems.emplace_back("--shape is of --report workspace; ask for that, or leave it out.");
  if (!question.workspace) return;
  if (!arguments.shape.shape) {
    problems.emplace_back("--report workspace takes --shape: box, square, disc, cylinder or ball.");
    return;
  }
  ask::ProblemList wrong;
  question.workspace = arguments.shape.of(manipulator, question.map.slice, wrong);
  for (const std::string& text : texts_of(wrong, option_name)) problems.push_back(text);
  question.gap = arguments.shape.gap.value_or(question.gap);
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

}  // namespace

SweepPlan plan_sweep(std::shared_ptr<const Manipulator> robot, const SweepArguments& arguments, Shard& shard,
                     Problems& problems) {
  SweepPlan plan;
  plan.robot = std::move(robot);
  plan.sample = arguments.sample.value_or(SweepSample::grid);
  plan.varied = parse_varied(arguments.vary, plan.sample, problems);
  plan.keep_ties = !arguments.untied;
  if (problems.empty()) plan.count = parse_designs(arguments, plan, problems);
  plan.question = parse_figures(arguments.figures, problems);
  shard = parse_shard(arguments.shard, problems);
  if (!problems.empty()) return plan;
  take_map_options(arguments, *plan.robot, plan.question, problems);
  refuse_six_degrees(*plan.robot, plan.question, problems);
  check_parameters(plan, problems);
  return plan;
}

}  // namespace parallel_aspects::tools
