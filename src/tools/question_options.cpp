// SPDX-License-Identifier: BSD-3-Clause
#include "tools/question_options.h"

#include "tools/arguments.h"
#include "tools/subcommands.h"

namespace parallel_aspects::tools {

void TextReader::read(const std::string& /*option*/, const std::string& text, std::string& value) {
  value = text;
}

void TextReader::read(const std::string& option, const std::string& text, double& value) {
  value = parse_positive(option, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, Pose& value) {
  value = parse_pose(option, robot_.task_space(), text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, WorkingMode& value) {
  if (const auto mode = parse_mode(option, robot_, text, problems_)) value = *mode;
}

void TextReader::read(const std::string& option, const std::string& text, JointVector& value) {
  std::vector<std::string> names;
  for (const Leg& leg : robot_.legs()) names.push_back(leg.actuated_joint);
  const std::size_t known = problems_.size();
  const std::vector<double> values = parse_numbers(option, text, names, problems_);
  if (problems_.size() > known) return;  // there may be more of them than a vector of joints holds
  value = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void TextReader::read(const std::string& option, const std::string& text, MapSlice& value) {
  value = parse_slice(option, robot_, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, std::vector<double>& values) {
  values = parse_ratio(option, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text, std::vector<WorkingMode>& values) {
  values = parse_modes(option, robot_, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text,
                      std::vector<HeldCoordinate>& values) {
  values = parse_values(option, text, problems_);
}

void TextReader::read(const std::string& option, const std::string& text,
                      std::vector<ask::NamedRange>& values) {
  values = parse_ranges(option, text, problems_);
}

ShownAnswering::ShownAnswering(const Surroundings& surroundings) : shown_(surroundings) {
  control_.cancelled = surroundings.interrupted;
  if (shown_.control().progress)
    control_.progress = [this](const char* /*step*/, double share) { shown_.control().progress(share); };
  control_.note = [&surroundings](const std::string& sentence) {
    surroundings.messages << sentence << std::endl;
  };
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
