// SPDX-License-Identifier: BSD-3-Clause
#include "tools/numbers.h"
#include "tools/report/setup_report.h"
#include "tools/shipped_robots.h"
#include "tools/subcommands.h"
#include "urdf/description/text_file.h"
#include "urdf/setup/setup.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace parallel_aspects::tools {
namespace {

namespace fs = std::filesystem;

// Of ten seconds of processor time; the rest is for the attempt to assemble that is under way when the time
// is up. What is found is not to depend on what else runs: by the clock on the wall it is only not to go on
// and on.
constexpr std::chrono::seconds time_to_search{8}, time_to_wait{30};

struct SetupArguments {
  std::string urdf, output, base, platform, actuated, closures;
  bool replace = false;
};

void add_closures(const std::vector<std::string>& pairs, SetupAnswers& answers, Problems& problems) {
  for (const std::string& pair : pairs) {
    const std::size_t middle = pair.find('=');
    if (middle == std::string::npos || middle == 0 || middle + 1 == pair.size())
      problems.push_back("--closures has '" + pair + "'; write the two links of each closure as LINK=LINK.");
    else
      answers.closures.push_back({pair.substr(0, middle), pair.substr(middle + 1)});
  }
}

SetupAnswers parse_answers(const SetupArguments& arguments) {
  Problems problems;
  SetupAnswers answers{arguments.base, arguments.platform, split_words(arguments.actuated), {}};
  add_closures(split_words(arguments.closures), answers, problems);
  if (!problems.empty()) throw InvalidDescription(problems);
  return answers;
}

bool can_ask(const Surroundings& surroundings) {
  return surroundings.answers != nullptr && !surroundings.json;
}

// A line from the terminal, which may be the end of it.
std::string answer_to(const std::string& question, const Surroundings& surroundings) {
  surroundings.messages << question << std::flush;
  std::string line;
  std::getline(*surroundings.answers, line);
  if (surroundings.interrupted != nullptr && *surroundings.interrupted) throw Interrupted{};
  return line;
}

void take_answer(const std::string& key, const std::vector<std::string>& values, SetupAnswers& answers) {
  Problems none;
  if (key == "actuated_joints") answers.actuated_joints = values;
  if (key == "closures") add_closures(values, answers, none);
  if (key == "base_link") answers.base_link = values.front();
  if (key == "operational_point") answers.operational_point = values.front();
}

// Throws where there is no answer among the candidates.
void ask(const SetupResult& result, const std::string& urdf_file, const Surroundings& surroundings,
         SetupAnswers& answers) {
  const Report question = report_question(result, urdf_file);
  const std::vector<SetupCandidate>& candidates = result.question->candidates;
  if (!can_ask(surroundings) || candidates.empty()) throw Unanswered{question};
  std::string text = result.question->text + ".\n";
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    text += "  " + std::to_string(k + 1) + ".";
    for (const std::string& value : candidates[k].values) text += " " + value;
    text += " (" + candidates[k].reason + ")\n";
  }
  std::istringstream line(
      answer_to(text + "Which one, 1 to " + std::to_string(candidates.size()) + "? ", surroundings));
  std::size_t number = 0;
  if (!(line >> number) || number < 1 || number > candidates.size()) throw Unanswered{question};
  take_answer(result.question->key, candidates[number - 1].values, answers);
}

// Asks, where that can be done, until a mechanism is found.
SetupResult found(const std::string& urdf_file, const std::string& config_file, SetupAnswers answers,
                  const Surroundings& surroundings) {
  Problems problems;
  const auto text = read_text_file(urdf_file, problems);
  if (!text) throw InvalidDescription(problems);
  for (;;) {
    SetupControl control{ProcessorClock::now() + time_to_search};
    control.latest = std::chrono::steady_clock::now() + time_to_wait;
    control.cancelled = [&] { return surroundings.interrupted != nullptr && *surroundings.interrupted; };
    SetupResult result = set_up(*text, urdf_file, config_file, answers, control);
    if (control.cancelled()) throw Interrupted{};
    if (!result.problems.empty()) throw InvalidDescription(result.problems);
    if (!result.question) return result;
    ask(result, urdf_file, surroundings, answers);
  }
}

bool exists(const std::string& file) {
  std::error_code error;
  return fs::exists(file, error);
}

// Throws where a file would be lost.
void check_output(const SetupArguments& arguments, const std::string& output,
                  const Surroundings& surroundings) {
  std::error_code none;
  if (fs::equivalent(output, arguments.urdf, none))
    throw InvalidDescription(
        {"File '" + output + "' is the URDF itself; give another one for the YAML with -o."});
  if (!exists(output) || arguments.replace) return;
  if (can_ask(surroundings)) {
    const std::string answer = answer_to(output + " exists. Replace it (y/n)? ", surroundings);
    if (answer == "y" || answer == "yes") return;
  }
  throw InvalidDescription(
      {"File '" + output + "' exists, and is left as it is; give another one with -o, or add --replace."});
}

void write(const std::string& text, const std::string& output) {
  std::ofstream stream(output, std::ios::binary);
  stream << text << std::flush;
  if (!stream)
    throw InvalidDescription(
        {"File '" + output + "' cannot be written; give one in a folder that can be written, with -o."});
}

// Lists with --json, and writes then only where a file is named.
Report run(const SetupArguments& arguments, const Surroundings& surroundings) {
  const SetupAnswers answers = parse_answers(arguments);
  const bool writes = !surroundings.json || !arguments.output.empty();
  const std::string output =
      arguments.output.empty() ? fs::path(arguments.urdf).stem().string() + ".yaml" : arguments.output;
  const SetupResult result = found(arguments.urdf, output, answers, surroundings);
  if (writes) check_output(arguments, output, surroundings);
  if (writes) write(result.config, output);
  return report_setup(result, arguments.urdf, writes ? output : "");
}

}  // namespace

Report describe_bare(const std::string& urdf_file, const Surroundings& surroundings) {
  Surroundings without_terminal = surroundings;
  without_terminal.answers = nullptr;
  return report_setup(found(urdf_file, fs::path(urdf_file).stem().string() + ".yaml", {}, without_terminal),
                      urdf_file, "");
}

Subcommand setup_subcommand() {
  const auto arguments = std::make_shared<SetupArguments>();
  return {
      "setup",
      "Find base, loop closures, platform and actuated joints of a URDF, and write the YAML",
      {{"URDF", "", "URDF of the robot", &arguments->urdf, true},
       {"-o", "FILE", "YAML to write; by default NAME.yaml in the present folder for NAME.urdf",
        &arguments->output},
       {"--closures", "PAIRS",
        "What is held together, as \"tool=rod_2_tip\" or \"tool=rod_2@0.4:0:0\" [m], where known; added to "
        "what the URDF closes",
        &arguments->closures},
       {"--actuated", "JOINTS", "Actuated joints, one a leg, such as \"motor_1 motor_2\", where known",
        &arguments->actuated},
       {"--platform", "LINK", "Link whose origin is the operational point, where known",
        &arguments->platform},
       {"--base", "LINK", "Link that carries the base, where known", &arguments->base}},
      [arguments](const Surroundings& surroundings) { return run(*arguments, surroundings); },
      {{"--replace", "Replace the YAML where it exists", &arguments->replace}}};
}

}  // namespace parallel_aspects::tools
