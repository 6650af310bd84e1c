// SPDX-License-Identifier: BSD-3-Clause
#include "tools/question_options.h"

#include "ask/question_parts.h"
#include "model/task_space_traits.h"
#include "tools/arguments.h"
#include "tools/output_file.h"
#include "tools/subcommands.h"

#include <utility>

namespace parallel_aspects::tools {

void TextReader::read(const std::string& option, const std::string& text, std::string& value) {
  if (option == option_name("save")) check_map_output(option, text, problems_);
  value = text;
}

void TextReader::read(const std::string& option, const std::string& text, double& value) {
  value = parse_positive(option, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, Pose& value) {
  if (robot_ != nullptr) value = parse_pose(option, robot_->motions(), text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, WorkingMode& value) {
  if (robot_ == nullptr) return;
  if (const auto mode = parse_mode(option, *robot_, text, problems_)) value = *mode;
}

void TextReader::read(const std::string& option, const std::string& text, JointVector& value) {
  if (robot_ == nullptr) return;
  std::vector<std::string> names;
  for (const Leg& leg : robot_->legs()) names.push_back(leg.actuated_joint);
  const std::size_t known = problems_.size();
  const std::vector<double> values = parse_numbers(option, text, names, problems_);
  if (problems_.size() > known) return;  // there may be more of them than a vector of joints holds
  value = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void TextReader::read(const std::string& option, const std::string& text, MapSlice& value) {
  if (robot_ != nullptr) value = parse_slice(option, *robot_, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, HeldJoint& value) {
  if (robot_ != nullptr) value = parse_held_joint(option, *robot_, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, HeldRange& value) {
  if (robot_ != nullptr) value = parse_held_range(option, *robot_, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, std::vector<double>& values) {
  values = parse_ratio(option, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, std::vector<WorkingMode>& values) {
  if (robot_ != nullptr) values = parse_modes(option, *robot_, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text,
                      std::vector<HeldCoordinate>& values) {
  const bool has_example = example_.find('=') != std::string::npos;
  values = parse_values(option, text, problems_, has_example ? example_ : "\"parallel=0.05 serial=0.1\"");
}

void TextReader::read(const std::string& option, const std::string& text,
                      std::vector<ask::NamedRange>& values) {
  if (robot_ != nullptr) values = parse_ranges(option, text, problems_, example_of_ranges());
}

// Of the positions of the robot, where it has some.
std::string TextReader::example_of_ranges() const {
  std::vector<std::string> names = coordinate_names(robot_->task_space());
  names.resize(directions(robot_->task_space()));
  return names.empty() || example_.find("x=") == std::string::npos ? example_ : ask::example_of_ranges(names);
}

ask::ConstraintChoice constraint_choice(const Manipulator& robot, const QuestionTexts& texts) {
  Problems reported_by_choose_constraints;
  return read_question<ask::ConstraintChoice>(robot, texts, reported_by_choose_constraints);
}

std::shared_ptr<const Manipulator> choose_constraints(const std::shared_ptr<const Manipulator>& robot,
                                                      const QuestionTexts& texts) {
  Problems problems;
  ask::ProblemList wrong;
  const auto choice = read_question<ask::ConstraintChoice>(*robot, texts, problems);
  auto chosen = ask::constrained(robot, choice, wrong);
  for (const std::string& each : texts_of(wrong, option_name)) problems.push_back(each);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return chosen;
}

ShownAnswering::ShownAnswering(const Surroundings& surroundings) : shown_(surroundings) {
  control_.cancelled = surroundings.interrupted;
  if (shown_.control().progress)
    control_.progress = [this](const char* /*step*/, double share) { shown_.control().progress(share); };
  control_.note = [&surroundings](const std::string& sentence) {
    surroundings.messages << sentence << std::endl;
  };
}

std::shared_ptr<const AspectMap> map_of(const std::shared_ptr<const Manipulator>& robot,
                                        const ask::MapSource& source, const Surroundings& surroundings) {
  ask::ProblemList problems;
  const ShownAnswering shown(surroundings);
  auto found = ask::Session(robot).map(source, {}, shown.control(), problems).map;
  if (!problems.empty()) refuse(problems);
  if (!found) throw Interrupted{};
  return found;
}

std::string source_text(const ask::MapSource& source, bool loaded) {
  std::string text;
  if (!source.load.empty())
    text += loaded ? "the map is that of " + source.load + "\n"
                   : "the map was computed, as " + source.load + " does not have it\n";
  if (!source.save.empty()) text += "the map is saved to " + source.save + "\n";
  return text;
}

void refuse(const ask::ProblemList& problems) {
  for (const ask::Problem& problem : problems)
    if (problem.kind == ask::ProblemKind::missing) {
      const std::string text = text_of(problem, option_name);
      throw UsageError(text.substr(0, text.size() - 1));  // those end in their own way
    }
  throw InvalidDescription(texts_of(problems, option_name));
}

}  // namespace parallel_aspects::tools
