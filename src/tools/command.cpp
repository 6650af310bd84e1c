// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command.h"

#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/model/version.h"
#include "parallel_aspects/model/wings.h"
#include "tools/output_file.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

constexpr const char* description =
    "Working modes, aspects and singularities of fully parallel manipulators.\n"
    "Lengths in metres, angles in radians.";

constexpr const char* footer =
    "\nExit codes: 0 done, 1 the robot, a file or a value was refused, 2 an argument is missing or not "
    "understood,\n"
    "3 a question is open that only you can answer, or `check`, `choose` or `plan` proved that the answer is "
    "no (`check`: or too fast), 4 neither is "
    "proved, 130 ended by Ctrl-C. Results go to the standard output, "
    "problems to the standard error, one a line.\n";

bool is_interrupted(const Surroundings& surroundings) {
  return surroundings.interrupted != nullptr && *surroundings.interrupted;
}

int print(const std::string& text, const Surroundings& surroundings) {
  surroundings.output << text << std::flush;
  if (surroundings.output.good()) return exit_code::ok;
  surroundings.messages << "The result could not be written to the standard output; check where it goes.\n";
  return exit_code::bad_input;
}

// Programs read the question from the standard output, as all JSON.
int ask(const Report& question, const Surroundings& surroundings) {
  (surroundings.json ? surroundings.output : surroundings.messages)
      << (surroundings.json ? to_text(question.json) : question.text) << std::flush;
  return exit_code::needs_answer;
}

int perform(const Subcommand& subcommand, const Surroundings& surroundings) {
  try {
    check_option_files(subcommand);
    const Report report = subcommand.run(surroundings);
    if (is_interrupted(surroundings)) return exit_code::interrupted;
    const int printed = print(surroundings.json ? to_text(report.json) : report.text, surroundings);
    return printed == exit_code::ok ? report.exit_code : printed;
  } catch (const Interrupted&) {
    return exit_code::interrupted;
  } catch (const Unanswered& question) {
    return ask(question.report, surroundings);
  } catch (const InvalidDescription& invalid) {
    surroundings.messages << invalid.what() << std::endl;
    return exit_code::bad_input;
  }
}

std::string help_of(const Program& program) {
  TextTable table({"Subcommands:", ""});
  for (const Subcommand& subcommand : program.subcommands)
    table.add({"  " + subcommand.name, subcommand.help});
  return program.description + "\n\nUsage: " + program.name + " SUBCOMMAND [OPTIONS]\n       " +
         program.name + " SUBCOMMAND --help\n       " + program.name + " --version\n\n" + table.text() +
         program.footer;
}

const Subcommand& find_subcommand(const Program& program, const std::string& name) {
  std::vector<std::string> names;
  for (const Subcommand& subcommand : program.subcommands) {
    if (subcommand.name == name) return subcommand;
    names.push_back(subcommand.name);
  }
  throw UsageError("'" + name + "': there is no such subcommand" + did_you_mean(name, names));
}

int run(Program& program, const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  if (arguments.empty()) {
    surroundings.messages << help_of(program);
    return exit_code::bad_usage;
  }
  if (asks_for_help(arguments.front())) return print(help_of(program), surroundings);
  if (arguments.front() == "--version")
    return print(program.name + " " + std::string(package_version) + "\n", surroundings);
  Surroundings chosen = surroundings;
  for (Subcommand& subcommand : program.subcommands)
    subcommand.flags.push_back({"--json", "Print JSON; `aspects fields` lists its fields", &chosen.json});
  const Subcommand& subcommand = find_subcommand(program, arguments.front());
  if (!parse_arguments(subcommand, {arguments.begin() + 1, arguments.end()}))
    return print(help_of(program.name, subcommand), surroundings);
  return perform(subcommand, chosen);
}

Program aspects_program() {
  Program program{"aspects", description, {}, footer};
  const auto add = [&list = program.subcommands](const std::vector<Subcommand>& more) {
    list.insert(list.end(), more.begin(), more.end());
  };
  if constexpr (wings::setup) add({setup_subcommand()});
  add({arm_map(map_subcommand()), arm_locate(locate_subcommand()), arm_refused(graph_subcommand()),
       arm_connect(connect_subcommand()), arm_refused(plan_subcommand()), arm_refused(check_subcommand()),
       arm_refused(choose_subcommand()), arm_refused(workspace_subcommand())});
  if constexpr (wings::sweep) add({arm_refused(sweep_subcommand()), merge_subcommand(), chart_subcommand()});
  add({arm_describe(describe_subcommand()), arm_refused(distance_subcommand()),
       arm_inverse(inverse_subcommand()), arm_direct(direct_subcommand()), arm_refused(jacobian_subcommand()),
       arm_refused(plot_subcommand()), robots_subcommand(), arm_uniqueness(uniqueness_subcommand()),
       fields_subcommand()});
  return program;
}

}  // namespace

int run_program(Program program, int argc, const char* const* argv,
                const Surroundings& surroundings) noexcept {
  try {
    return run(program, {argv + std::min(argc, 1), argv + argc}, surroundings);
  } catch (const UsageError& error) {
    const std::string text = error.what();
    surroundings.messages << text << (text.back() == '?' ? "" : ".") << " `" << program.name
                          << " --help` and `" << program.name << " SUBCOMMAND --help` say more." << std::endl;
    return exit_code::bad_usage;
  } catch (const std::exception& error) {
    surroundings.messages << "The command failed: " << error.what() << std::endl;
    return exit_code::bad_input;
  }
}

int run_command(int argc, const char* const* argv, const Surroundings& surroundings) noexcept {
  try {
    return run_program(aspects_program(), argc, argv, surroundings);
  } catch (const std::bad_alloc&) {
    return exit_code::bad_input;
  }
}

std::vector<Option> robot_options(RobotChoice& choice) {
  return {
      {"ROBOT", "",
       "Name of a shipped robot, of which `aspects robots` lists all; or the URDF of another, and behind "
       "it the YAML with its loop closures and actuated joints",
       &choice.words, false, Words::files, FileUse::robot},
      {"--urdf", "FILE", "That URDF, by an option", &choice.urdf_option, false, Words::one, FileUse::read},
      {"--config", "FILE", "That YAML, by an option", &choice.config_option, false, Words::one,
       FileUse::read}};
}

}  // namespace parallel_aspects::tools
