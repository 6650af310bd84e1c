// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/setup_report.h"

#include "tools/report/reports.h"
#include "urdf/description/messages.h"

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

constexpr const char* cut_short = "The search was cut short, so that there may be other candidates.";

json json_candidate(const std::string& key, const SetupCandidate& candidate) {
  return {{"values", candidate.values},
          {"reason", candidate.reason},
          {"option", option_for(key, candidate.values)}};
}

json json_candidates(const std::string& key, const std::vector<SetupCandidate>& candidates) {
  json array = json::array();
  for (const SetupCandidate& candidate : candidates) array.push_back(json_candidate(key, candidate));
  return array;
}

json json_choices(const SetupResult& result) {
  json array = json::array();
  for (const SetupChoice& choice : result.choices)
    array.push_back({{"key", choice.key},
                     {"values", choice.taken.values},
                     {"reason", choice.taken.reason},
                     {"others", json_candidates(choice.key, choice.others)}});
  return array;
}

json json_result(const std::string& status, const SetupResult& result) {
  return {{"status", status},
          {"robot", result.robot},
          {"choices", json_choices(result)},
          {"notes", result.notes},
          {"cut_short", result.cut_short}};
}

std::string next_command(const std::string& urdf_file, const std::string& config) {
  if (config.empty()) return "aspects setup " + shell_word(urdf_file);
  return "aspects map " + shell_word(urdf_file) + " " + shell_word(config);
}

// As each can be pasted.
std::string next_text(const std::string& urdf_file, const SetupFiles& written) {
  const std::string command = "  " + next_command(urdf_file, written.config) + "\n";
  if (written.config.empty()) return "Nothing is written. Next:\n" + command;
  if (written.launch.empty())
    return written.config + " is written; comments in it say what is a guess. Next:\n" + command;
  const std::string launch = "  roslaunch " + shell_word(written.launch);
  return written.config + " and " + written.launch +
         " are written; comments in the YAML say what is a guess. Next:\n" + command +
         "With ROS, the monitor in rviz, where a motion is played in place of the robot:\n" + launch +
         " simulated:=true\n" + "and with the robot, whose driver publishes joint_states:\n" + launch + "\n";
}

// Lists of joints and closures are long.
std::string choices_text(const SetupResult& result) {
  std::string text;
  for (const SetupChoice& choice : result.choices) {
    const bool stated = choice.taken.values.empty();
    text += choice.key + ": " + (stated ? "not needed" : joined(choice.taken.values, " ")) + "\n    " +
            choice.taken.reason + "\n";
    for (const SetupCandidate& other : choice.others)
      text += "    would load too: " + joined(other.values, " ") + " (" + other.reason + ")\n";
  }
  for (const std::string& note : result.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace

Report report_question(const SetupResult& result, const std::string& urdf_file) {
  const SetupQuestion& question = *result.question;
  json object = json_result("undecided", result);
  object["question"] = {{"key", question.key},
                        {"text", question.text + "."},
                        {"candidates", json_candidates(question.key, question.candidates)}};
  std::string text = question.text + ".\n";
  for (std::size_t k = 0; k < question.candidates.size(); ++k)
    text += "  " + std::to_string(k + 1) + ". " + joined(question.candidates[k].values, " ") + " (" +
            question.candidates[k].reason + ")\n";
  for (const std::string& note : result.notes) text += "note: " + note + "\n";
  if (result.cut_short) text += std::string(cut_short) + "\n";
  const std::vector<std::string>& example =
      question.candidates.empty() ? question.example : question.candidates.front().values;
  text += "Nothing is written. Answer with an option, as in: aspects setup " + shell_word(urdf_file) + " " +
          option_for(question.key, example) + "\n";
  return {object, text};
}

Report report_setup(const SetupResult& result, const std::string& urdf_file, const SetupFiles& written) {
  json object = json_result("found", result);
  const Report mechanism = report_mechanism(result.mechanism);
  object["describe"] = mechanism.json;
  object["config"] = result.config;
  object["written"] = written.config.empty() ? json(nullptr) : json(written.config);
  object["launch"] = written.launch.empty() ? json(nullptr) : json(written.launch);
  object["next"] = next_command(urdf_file, written.config);
  std::string text = choices_text(result) + "\n" + mechanism.text + "\n";
  if (result.cut_short) text += std::string(cut_short) + "\n";
  return {object, text + next_text(urdf_file, written)};
}

}  // namespace parallel_aspects::tools
