// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_location.h"
#include "parallel_aspects/aspects/same_aspect.h"
#include "parallel_aspects/motion/choose_working_mode.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/map_choice.h"
#include "tools/numbers.h"
#include "tools/report/basins_report.h"
#include "tools/report/bounds_report.h"
#include "tools/report/reports.h"
#include "tools/report/slice_report.h"
#include "tools/report/text_table.h"
#include "tools/subcommands.h"

#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

struct ConnectArguments {
  RobotChoice robot;
  std::string from, to, mode, slice, resolution, index;
  RoadmapArguments roadmap;
  ConstraintArguments constraints;
};

/// What is asked, with every number understood.
struct ConnectQuestion {
  Pose from, to;
  std::vector<WorkingMode> modes;
  RoadmapOptions roadmap;
  std::optional<MapSlice> slice;
  std::optional<double> resolution;
  ParallelIndex index = ParallelIndex::normalised;
  double moved = 0.0;  // onto the slice, at most [m]
};

ConnectQuestion parse(const ConnectArguments& arguments, const Manipulator& manipulator) {
  Problems problems;
  ConnectQuestion question;
  question.from = parse_pose("--from", manipulator.task_space(), arguments.from, problems);
  question.to = parse_pose("--to", manipulator.task_space(), arguments.to, problems);
  question.roadmap = parse_roadmap(arguments.roadmap, problems);
  question.index = parse_index(arguments.index, problems);
  question.modes = working_modes(manipulator);
  if (!arguments.mode.empty())
    if (const auto mode = parse_mode("--mode", manipulator, arguments.mode, problems))
      question.modes = {*mode};
  if (!arguments.resolution.empty())
    question.resolution = parse_positive("--resolution", arguments.resolution, problems);
  question.slice =
      parse_slice_with_ends("--slice", manipulator, arguments.slice,
                            {{"--from", &question.from}, {"--to", &question.to}}, question.moved, problems);
  if (question.resolution && !question.slice && manipulator.task_space() == TaskSpace::SE3)
    problems.emplace_back("--resolution is that of a map of boxes, and in SE3 there is none; leave it out.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return question;
}

/// Asks, until one knows: what is proved of the two poses, a roadmap of the mode, a map.
class Asking {
 public:
  Asking(std::shared_ptr<const Manipulator> manipulator, const ConnectQuestion& question,
         const Surroundings& surroundings)
      : manipulator_(std::move(manipulator)),
        certifier_(manipulator_),
        question_(question),
        surroundings_(surroundings) {}

  AspectComparison ask(const WorkingMode& mode) {
    if (question_.slice) return ask_slice(mode);
    const PoseInMode first{question_.from, mode}, second{question_.to, mode};
    AspectComparison found = same_aspect(certifier_, first, second);
    if (found.searched_sign == 0) return found;
    const std::shared_ptr<const PoseRoadmap> over = roadmap(mode);
    found = same_aspect(*over, first, second, SearchEffort::brief);
    if (found.searched_sign != 0 && has_map()) ask_map(map(), first, second, found);
    if (found.searched_sign != 0 && found.answer == SameAspect::unknown && question_.modes.size() == 1)
      found = same_aspect(*over, first, second);
    return found;
  }

  /// Of two poses that are not proved to lie in different aspects; nothing without a map.
  std::optional<Bottleneck> bottleneck(const WorkingMode& mode, SameAspect answer) {
    if (answer == SameAspect::no || !has_map()) return std::nullopt;
    const Bottleneck found = find_bottleneck(map(), mode, question_.from, question_.to, question_.index, {},
                                             control_of(surroundings_));
    if (found.status == BottleneckStatus::cancelled) throw Interrupted{};
    return found;
  }

 private:
  std::shared_ptr<const PoseRoadmap> roadmap(const WorkingMode& mode) const {
    RoadmapOptions options = question_.roadmap;
    options.modes = {mode};
    return compute_roadmap(manipulator_, options, surroundings_);
  }

  // Maps of one or two degrees of freedom are quick; others are made where they are asked for.
  bool has_map() const {
    return question_.slice || question_.resolution || degrees_of_freedom(manipulator_->task_space()) <= 2;
  }

  const AspectMap& map() {
    if (map_) return *map_;
    MapOptions options;
    options.resolution = question_.resolution;
    options.slice = question_.slice;
    options.modes = question_.modes;
    const MapResult result = compute_aspect_map(manipulator_, options, control_of(surroundings_));
    if (result.status == MapStatus::cancelled) throw Interrupted{};
    if (result.status == MapStatus::refused) throw InvalidDescription({result.message});
    map_ = result.map;
    return *map_;
  }

  // Paths stay in the slice, so that roadmaps are of no use.
  AspectComparison ask_slice(const WorkingMode& mode) {
    const Location first = map().locate(question_.from, mode), second = map().locate(question_.to, mode);
    for (const LocationStatus status : {first.status, second.status}) {
      if (status == LocationStatus::outside)
        return {SameAspect::no, "One of the poses is proved to lie in no aspect of the slice.", {}, 0};
      if (status == LocationStatus::not_mapped)
        return {SameAspect::unknown, "One of the poses lies outside of the slice.", {}, 0};
    }
    if (!first || !second)
      return {SameAspect::unknown,
              "One of the poses is closer to a singularity or a limit than the map can tell.",
              {},
              0};
    if (first.aspect == second.aspect)
      return {SameAspect::yes, "The map of the slice proves it, by a path within the slice.", {}, 0};
    if (!may_be_one(map(), first.aspect, second.aspect))
      return {SameAspect::no, "The map proves them separate within the slice.", {}, 0};
    return {SameAspect::unknown, "The map of the slice neither joins them nor proves them separate.", {}, 0};
  }

  std::shared_ptr<const Manipulator> manipulator_;
  SegmentCertifier certifier_;
  const ConnectQuestion& question_;
  const Surroundings& surroundings_;
  std::shared_ptr<const AspectMap> map_;
};

json json_answer(TaskSpace space, const ModeAnswer& answer) {
  json object = {{"working_mode", answer.mode.signs()},
                 {"same_aspect", name(answer.comparison.answer)},
                 {"reason", answer.comparison.message},
                 {"failing_constraint", nullptr},
                 {"path", json::array()},
                 {"bottleneck", nullptr}};
  if (answer.bottleneck) object["bottleneck"] = json_bottleneck(answer.index, *answer.bottleneck);
  if (answer.comparison.failing) object["failing_constraint"] = name(*answer.comparison.failing);
  for (const Pose& pose : answer.comparison.path) object["path"].push_back(json_pose(space, pose));
  return object;
}

std::string path_text(TaskSpace space, const ModeAnswer& answer) {
  std::string text = "\npath in " + to_string(answer.mode) + ":\n";
  for (const Pose& pose : answer.comparison.path) text += "  " + to_string(space, pose) + '\n';
  return text;
}

std::string answers_text(const Manipulator& manipulator, const Pose& from, const Pose& to,
                         const std::vector<ModeAnswer>& answers) {
  const TaskSpace space = manipulator.task_space();
  TextTable table({"working mode", "same aspect", "why"});
  std::string paths;
  for (const ModeAnswer& answer : answers) {
    table.add({to_string(answer.mode), name(answer.comparison.answer), answer.comparison.message});
    if (answer.comparison.path.size() > 2) paths += path_text(space, answer);
    if (answer.bottleneck)
      paths += "\nin " + to_string(answer.mode) +
               (answer.bottleneck->status == BottleneckStatus::found ? " " : ": ") +
               bottleneck_text(answer.index, *answer.bottleneck) + "\n";
  }
  return manipulator.name() + ", from " + to_string(space, from) + " to " + to_string(space, to) + "\n\n" +
         table.text() + paths;
}

}  // namespace

Report report_comparison(const Manipulator& manipulator, const Pose& from, const Pose& to,
                         const std::vector<ModeAnswer>& answers) {
  const TaskSpace space = manipulator.task_space();
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(space))},
                 {"from", json_pose(space, from)},
                 {"to", json_pose(space, to)},
                 {"answers", json::array()}};
  for (const ModeAnswer& answer : answers) object["answers"].push_back(json_answer(space, answer));
  const Report constraints = report_constraints(manipulator);
  object.update(constraints.json);
  return {object, answers_text(manipulator, from, to, answers) + '\n' + constraints.text};
}

namespace {

/// That the answers are of a slice, and what was done to the poses.
void add_slice(const ConnectQuestion& question, Report& report) {
  if (!question.slice) return;
  report.json["slice"] = json_slice(question.slice);
  report.json["moved_onto_slice"] = question.moved;
  report.text += "\nslice " + to_string(*question.slice) +
                 ": aspects of the slice, of which two may be joined outside of it\n";
  if (question.moved > 0.0)
    report.text += "the poses are moved onto the slice, by at most " + shown(question.moved) + " m\n";
}

}  // namespace

Subcommand connect_subcommand() {
  const auto arguments = std::make_shared<ConnectArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back(
      {"--from", "\"x y\"", "A pose of the platform, quoted; lengths [m]", &arguments->from, true});
  options.push_back({"--to", "\"x y\"", "Another one", &arguments->to, true});
  options.push_back(
      {"--mode", "\"(+,-)\"", "Working mode, as signs of B_jj; by default every one", &arguments->mode});
  options.push_back({"--slice", "\"phi=0\"",
                     "Ask within a slice: held pose coordinates, or in SE2 an actuated joint, with the value "
                     "[m or rad]; its map answers. Poses are (x, y, phi) whatever is held",
                     &arguments->slice});
  options.push_back({"--samples", "N",
                     "Poses of the roadmap that is asked where the straight way is not free",
                     &arguments->roadmap.samples});
  options.push_back({"--seed", "N", "Seed of the roadmap", &arguments->roadmap.seed});
  options.push_back({"--resolution", "R",
                     "Resolution of the map that is asked last [m or rad]; by default one is made in T2 only",
                     &arguments->resolution});
  options.push_back(index_option(arguments->index));
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"connect", "Tell whether two poses lie in one aspect, with a certified path", options,
          [arguments](const Surroundings& surroundings) {
            const auto mechanism = load_robot(arguments->robot);
            const auto manipulator =
                choose_constraints(mechanism->mapped_manipulator(), arguments->constraints);
            const ConnectQuestion question = parse(*arguments, *manipulator);
            Asking asking(manipulator, question, surroundings);
            std::vector<ModeAnswer> answers;
            for (const WorkingMode& mode : question.modes) {
              const AspectComparison found = asking.ask(mode);
              answers.push_back({mode, found, question.index, asking.bottleneck(mode, found.answer)});
            }
            Report report = report_comparison(*manipulator, question.from, question.to, answers);
            add_slice(question, report);
            return report;
          }};
}

}  // namespace parallel_aspects::tools
