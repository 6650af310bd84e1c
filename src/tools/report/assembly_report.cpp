// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/report.h"
#include "tools/report/uniqueness_report.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

// What text has of them; JSON has all.
constexpr std::size_t changes_in_text = 4;
constexpr std::size_t least_samples_in_text = 2;

/// "1: 19, 3: 156".
std::string counts_text(const PosesBySolutions& counts) {
  std::string text;
  for (const auto& [solutions, poses] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(solutions) + ": " + std::to_string(poses);
  return text;
}

std::size_t count_changes(const AssemblySurvey& survey) {
  std::size_t count = 0;
  for (const ComponentSurvey& component : survey.components) count += component.change ? 1 : 0;
  return count;
}

std::string headline(const PoseRoadmap& roadmap, const AssemblySurvey& survey) {
  const Manipulator& robot = *roadmap.certifier().manipulator();
  return robot.name() + ": of " + counted(survey.components.size(), "connected set") + " of poses " +
         std::to_string(count_changes(survey)) +
         " are proved to lie in aspects that are no uniqueness domains\ntask space " +
         std::string(name(robot.task_space())) + ", a certified roadmap of " +
         counted(roadmap.poses().size(), "sampled pose") + ", seed " +
         std::to_string(roadmap.options().seed) + "; the actuated values of " +
         counted(survey.poses, "of its configurations", "of its configurations") + " were examined\n";
}

std::string components_text(const AssemblySurvey& survey) {
  TextTable table({"working mode", "det A", ">component", ">samples", ">examined",
                   "by solutions in the same aspect, at least", ">unknown", "aspect is a uniqueness domain"});
  std::size_t left_out = 0;
  for (const ComponentSurvey& component : survey.components) {
    if (component.samples < least_samples_in_text && !component.change) {
      ++left_out;
      continue;
    }
    table.add({to_string(component.mode), shown_sign(component.determinant_sign),
               std::to_string(component.component + 1), std::to_string(component.samples),
               std::to_string(component.poses), counts_text(component.in_aspect),
               std::to_string(component.unknown), component.change ? "no, proved" : "unknown"});
  }
  std::string text = table.text();
  if (left_out > 0) text += counted(left_out, "component") + " of one sample left out, --json has all\n";
  return text;
}

std::string solutions_text(const AssemblySurvey& survey) {
  PosesBySolutions in_aspect;
  std::size_t unknown = 0;
  for (const ComponentSurvey& component : survey.components) {
    unknown += component.unknown;
    for (const auto& [solutions, poses] : component.in_aspect) in_aspect[solutions] += poses;
  }
  std::string text =
      "\nconfigurations by their number of direct solutions in the same aspect: " + counts_text(in_aspect) +
      "\nby that in all aspects: " + counts_text(survey.solutions) +
      "\nThese numbers are lower bounds: every solution that is counted is proved, and the direct solver is "
      "numerical; ";
  text += survey.incomplete == 0
              ? "it says of each of its lists that it is complete.\n"
              : "it says of " + counted(survey.incomplete, "list") + " that solutions may be missing.\n";
  return text + counted(unknown, "further solution") +
         " may lie in the same aspect: no path to them was proved, or not they themselves.\n";
}

std::string changes_text(const Manipulator& robot, const AssemblySurvey& survey) {
  std::string text;
  std::size_t shown_changes = 0;
  for (const ComponentSurvey& component : survey.components) {
    if (!component.change || shown_changes == changes_in_text) continue;
    ++shown_changes;
    const AssemblyChange& change = *component.change;
    text += to_string(component.mode) + " " + shown_sign(component.determinant_sign) + " component " +
            std::to_string(component.component + 1) + ", actuated " + shown(change.actuated) + "\n";
    for (const Pose& pose : change.path) text += "  " + to_string(robot.task_space(), pose) + "\n";
  }
  if (text.empty()) return "";
  const std::size_t all = count_changes(survey);
  return "\nchanges of the assembly mode without a singularity: paths whose ends have the same actuated "
         "values, proved\n" +
         text + (all > shown_changes ? counted(all - shown_changes, "more such path") + " in --json\n" : "");
}

}  // namespace

std::string uniqueness_text(const Manipulator& robot, const ask::SurveyOfRoadmap& answer) {
  const PoseRoadmap& roadmap = *answer.roadmap;
  return headline(roadmap, answer.survey) + '\n' + components_text(answer.survey) +
         solutions_text(answer.survey) + changes_text(robot, answer.survey);
}

}  // namespace parallel_aspects::tools
