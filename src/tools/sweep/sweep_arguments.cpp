// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_arguments.h"

#include "tools/numbers.h"
#include "tools/report/report.h"

#include <utility>

namespace parallel_aspects::tools {
namespace {

constexpr unsigned most_shards = 1'000'000;

/// The fields of a sweep, understood; messages name them as the face does.
class Reading {
 public:
  Reading(const SweepArguments& arguments, const ask::FieldName& name, Problems& problems)
      : arguments_(arguments), name_(name), problems_(problems) {}

  std::size_t designs(const SweepPlan& plan) {
    if (plan.sample == SweepSample::grid) {
      if (arguments_.designs)
        refuse("{designs} is of {sample} sobol; a grid has as many as its values make. Leave it out.");
      const std::size_t size = grid_size(plan.varied);
      if (size == 0)
        refuse("{vary} makes more than " + std::to_string(most_designs) + " designs; give fewer values.");
      return size;
    }
    if (!arguments_.designs)
      refuse("{sample} sobol takes {designs}, 1 or more; give how many designs are wanted.");
    return arguments_.designs ? arguments_.designs->value : 0;
  }

  Shard shard() {
    Shard shard;
    const std::string& text = arguments_.shard;
    if (text.empty()) return shard;
    const std::size_t slash = text.find('/');
    Problems found;
    shard.index = parse_count("", text.substr(0, slash), most_shards, found);
    shard.count =
        slash == std::string::npos ? 0 : parse_count("", text.substr(slash + 1), most_shards, found);
    if (!found.empty() || shard.index < 1 || shard.index > shard.count)
      refuse("{shard} is '" + ask::given(text) + "'; give the part and how many there are, such as 1/4.");
    return shard;
  }

  /// What the columns report; the shape is not yet examined.
  DesignQuestion figures() {
    DesignQuestion question;
    if (arguments_.figures.empty()) return question;
    question.count = false;
    for (const std::string& word : words_of_list(arguments_.figures)) {
      if (word == "count")
        question.count = true;
      else if (word == "measures")
        question.measures = true;
      else if (word == "clearance")
        question.clearance = true;
      else if (word == "workspace")
        question.workspace.emplace();
      else
        refuse("{report} has '" + ask::given(word) + "'; give count, measures, clearance or workspace.");
    }
    return question;
  }

  void take_map_options(const Manipulator& robot, DesignQuestion& question) {
    question.map.threads = 1;  // one a design
    question.map.resolution = arguments_.resolution;
    question.map.slice = arguments_.slice;
    question.map.modes = arguments_.modes;
    const ask::ShapeQuestion& shape = arguments_.shape;
    if (!question.workspace && (shape.shape || !shape.aspect_ratio.empty()))
      refuse("{shape} is of {report} workspace; ask for that, or leave it out.");
    if (!question.workspace) return;
    if (!shape.shape) return refuse("{report} workspace takes {shape}: box, square, disc, cylinder or ball.");
    ask::ProblemList wrong;
    question.workspace = shape.of(robot, question.map.slice, wrong);
    for (const std::string& text : texts_of(wrong, name_)) problems_.push_back(text);
    question.gap = shape.gap.value_or(question.gap);
  }

  void refuse_six_degrees(const Manipulator& robot, const DesignQuestion& question) {
    if (robot.task_space() == TaskSpace::SE3 && !question.map.slice && problems_.empty())
      refuse("'" + ask::given(robot.name()) +
             "' has six degrees of freedom, which are more than can be mapped; give {slice}, such as "
             "\"roll=0 pitch=0 yaw=0\".");
  }

 private:
  void refuse(const std::string& text) { problems_.push_back(ask::with_names(text, name_)); }

  const SweepArguments& arguments_;
  const ask::FieldName& name_;
  Problems& problems_;
};

void check_parameters(const SweepPlan& plan, Problems& problems) {
  std::vector<std::string> names;
  for (const VariedParameter& each : plan.varied) names.push_back(each.name);
  const Problems more = problems_of(*plan.robot, names, plan.keep_ties);
  problems.insert(problems.end(), more.begin(), more.end());
}

}  // namespace

SweepPlan plan_sweep(std::shared_ptr<const Manipulator> robot, const SweepArguments& arguments,
                     const ask::FieldName& name, Shard& shard, Problems& problems) {
  Reading reading(arguments, name, problems);
  SweepPlan plan;
  plan.robot = std::move(robot);
  plan.sample = arguments.sample.value_or(SweepSample::grid);
  plan.varied = parse_varied(name("vary"), arguments.vary, plan.sample, problems);
  plan.keep_ties = !arguments.untied;
  if (problems.empty()) plan.count = reading.designs(plan);
  plan.question = reading.figures();
  shard = reading.shard();
  if (!problems.empty()) return plan;
  reading.take_map_options(*plan.robot, plan.question);
  reading.refuse_six_degrees(*plan.robot, plan.question);
  check_parameters(plan, problems);
  return plan;
}

}  // namespace parallel_aspects::tools
