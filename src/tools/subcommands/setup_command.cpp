// SPDX-License-Identifier: BSD-3-Clause
#include "tools/numbers.h"
#include "tools/report/setup_report.h"
#include "tools/shipped_robots.h"
#include "tools/subcommands.h"
#include "urdf/arm_reading.h"
#include "urdf/reading/description_file.h"
#include "urdf/setup/setup.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace parallel_aspects::tools {
namespace {

namespace fs = std::filesystem;

// About two seconds of a processor: so many attempts, each times the square of the number of joints in the
// loops. By the clock on the wall a search is only not to go on and on.
constexpr std::size_t work_to_search = 25000;
constexpr std::chrono::seconds time_to_wait{30};

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
  const auto text = read_description_file(urdf_file, problems);
  if (!text) throw InvalidDescription(problems);
  for (;;) {
    SetupControl control{work_to_search};
    control.latest = std::chrono::steady_clock::now() + time_to_wait;
    control.cancelled = [&] { return surroundings.interrupted != nullptr && *surroundings.interrupted; };
    SetupResult result = set_up(*text, urdf_file, config_file, answers, control);
    if (control.cancelled()) throw Interrupted{};
    if (result.is_serial_arm && answers.closures.empty()) return result;
    if (!result.problems.empty()) throw InvalidDescription(result.problems);
    if (!result.question) return result;
    ask(result, urdf_file, surroundings, answers);
  }
}

bool exists(const std::string& file) {
  std::error_code error;
  return fs::exists(file, error);
}

// Those that are there, "robot.yaml and robot.launch"; throws where one is the URDF.
std::string existing_of(const SetupFiles& output, const std::string& urdf) {
  std::string existing;
  for (const std::string& file : {output.config, output.launch}) {
    if (file.empty()) continue;
    std::error_code none;
    if (fs::equivalent(file, urdf, none))
      throw InvalidDescription(
          {"File '" + file + "' is the URDF itself; give another one for the YAML with -o."});
    if (exists(file)) existing += (existing.empty() ? "" : " and ") + file;
  }
  return existing;
}

// Throws where a file would be lost.
void check_output(const SetupArguments& arguments, const SetupFiles& output,
                  const Surroundings& surroundings) {
  if (output.config == output.launch)
    throw InvalidDescription({"-o is '" + output.config +
                              "', as the launch file would be called; give a name that ends with .yaml."});
  const std::string existing = existing_of(output, arguments.urdf);
  if (existing.empty() || arguments.replace) return;
  if (can_ask(surroundings)) {
    const std::string answer = answer_to("Replace " + existing + " (y/n)? ", surroundings);
    if (answer == "y" || answer == "yes") return;
  }
  throw InvalidDescription(
      {"What exists is left as it is: " + existing + "; give another name with -o, or add --replace."});
}

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    const std::size_t kind = std::string("&<>\"").find(letter);
    escaped += kind == std::string::npos ? std::string(1, letter)
                                         : std::array{"&amp;", "&lt;", "&gt;", "&quot;"}[kind];
  }
  return escaped;
}

// Beside the launch file or below it, so that they may be moved together; else where it is.
std::string path_in_launch(const std::string& file, const std::string& launch) {
  // Made absolute first, as what is not there yet stays relative.
  const fs::path whole = fs::weakly_canonical(fs::absolute(file)),
                 folder = fs::weakly_canonical(fs::absolute(launch)).parent_path(),
                 relative = whole.lexically_relative(folder);
  const bool is_beside = !relative.empty() && *relative.begin() != "..";
  return xml_text(is_beside ? "$(dirname)/" + relative.string() : whole.string());
}

std::string launch_text(const std::string& urdf, const SetupFiles& output) {
  return R"xml(<!-- The monitor of this robot in rviz, written by `aspects setup`. It expects the joint states of the actuated joints on
     joint_states. -->
<launch>
  <arg name="rviz" default="true" doc="whether to open rviz"/>
  <arg name="simulated" default="false" doc="whether a motion is played in place of the robot's own joint states"/>

  <include file="$(find parallel_aspects)/launch/aspects.launch">
    <arg name="urdf" value=")xml" +
         path_in_launch(urdf, output.launch) + R"xml("/>
    <arg name="config" value=")xml" +
         path_in_launch(output.config, output.launch) + R"xml("/>
    <arg name="rviz" value="$(arg rviz)"/>
    <arg name="straight" value="$(arg simulated)"/>
  </include>

  <node if="$(arg simulated)" pkg="parallel_aspects" type="demo_motion" name="demo_motion" clear_params="true" output="screen"/>
</launch>
)xml";
}

void write(const std::string& text, const std::string& output) {
  std::ofstream stream(output, std::ios::binary);
  stream << text << std::flush;
  if (!stream)
    throw InvalidDescription(
        {"File '" + output + "' cannot be written; give one in a folder that can be written, with -o."});
}

// A serial arm has a YAML alone: the node follows none.
Report run_of_arm(const SetupArguments& arguments, const SetupAnswers& answers, const SetupResult& found,
                  const SetupFiles& output, const Surroundings& surroundings) {
  Problems problems;
  const auto text = read_description_file(arguments.urdf, problems);
  if (!text) throw InvalidDescription(problems);
  const auto arm = set_up_arm(*text, arguments.urdf, output.config,
                              {answers.base_link, answers.operational_point, answers.actuated_joints});
  if (!arm) throw InvalidDescription(found.problems);
  Report report;
  report.json = {{"mechanism", arm->arm->name()},      {"kind", "serial arm"},
                 {"base_link", arm->arm->base_link()}, {"operational_point", arm->arm->tip_link()},
                 {"task", name(arm->arm->task())},     {"config", arm->config}};
  for (const ArmJoint& joint : arm->arm->joints()) report.json["actuated_joints"].push_back(joint.name);
  report.text = arm->arm->name() + " is a serial arm of " + std::to_string(arm->arm->size()) +
                " joints from '" + arm->arm->base_link() + "' to '" + arm->arm->tip_link() + "', task " +
                name(arm->arm->task()) + ".\n";
  if (surroundings.json && arguments.output.empty()) return report;
  check_output(arguments, output, surroundings);
  write(arm->config, output.config);
  report.text +=
      "Written: " + output.config + "\nNext: aspects map " + arguments.urdf + " " + output.config + "\n";
  return report;
}

// Lists with --json, and writes then only where a file is named.
Report run(const SetupArguments& arguments, const Surroundings& surroundings) {
  const SetupAnswers answers = parse_answers(arguments);
  const bool writes = !surroundings.json || !arguments.output.empty();
  const std::string config =
      arguments.output.empty() ? fs::path(arguments.urdf).stem().string() + ".yaml" : arguments.output;
  SetupFiles output{config, fs::path(config).replace_extension(".launch").string()};
  if (!is_urdf_file(arguments.urdf)) output.launch.clear();  // the node and rviz take URDF alone
  const SetupResult result = found(arguments.urdf, config, answers, surroundings);
  if (result.is_serial_arm) {
    output.launch.clear();
    return run_of_arm(arguments, answers, result, output, surroundings);
  }
  if (!writes) return report_setup(result, arguments.urdf, {});
  check_output(arguments, output, surroundings);
  write(result.config, output.config);
  if (!output.launch.empty()) write(launch_text(arguments.urdf, output), output.launch);
  return report_setup(result, arguments.urdf, output);
}

}  // namespace

Report describe_bare(const std::string& urdf_file, const Surroundings& surroundings) {
  Surroundings without_terminal = surroundings;
  without_terminal.answers = nullptr;
  const SetupResult result =
      found(urdf_file, fs::path(urdf_file).stem().string() + ".yaml", {}, without_terminal);
  if (result.is_serial_arm) throw InvalidDescription(result.problems);
  return report_setup(result, urdf_file, {});
}

Subcommand setup_subcommand() {
  const auto arguments = std::make_shared<SetupArguments>();
  return {
      "setup",
      "Find base, loop closures, platform and actuated joints of a URDF, and write the YAML and a launch "
      "file",
      {{"URDF", "", "URDF of the robot, or its SDF or MJCF", &arguments->urdf, true},
       {"-o", "FILE",
        "YAML to write, with a .launch of the same name beside it; by default NAME.yaml in the present "
        "folder "
        "for NAME.urdf",
        &arguments->output},
       {"--closures", "PAIRS",
        "What is held together, as \"tool=rod_2_tip\" or \"tool=rod_2@0.4:0:0\" [m], where known; added to "
        "what the URDF closes",
        &arguments->closures, false, Words::assignments},
       {"--actuated", "JOINTS", "Actuated joints, one a leg, such as \"motor_1 motor_2\", where known",
        &arguments->actuated, false, Words::names},
       {"--platform", "LINK", "Link whose origin is the operational point, where known",
        &arguments->platform},
       {"--base", "LINK", "Link that carries the base, where known", &arguments->base}},
      [arguments](const Surroundings& surroundings) { return run(*arguments, surroundings); },
      {{"--replace", "Replace these files where they exist", &arguments->replace}}};
}

}  // namespace parallel_aspects::tools
