// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tools/command.h"

#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/tools/subcommands.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

constexpr const char* description =
    "Working modes, aspects and singularities of fully parallel manipulators.\n"
    "Lengths in metres, angles in radians.";

constexpr const char* footer =
    "\nExit codes: 0 done, 1 the robot, a file or a number was refused, 2 the command line was not "
    "understood,\n"
    "130 ended by Ctrl-C. Results go to the standard output, problems to the standard error, one a line.";

bool is_interrupted(const Surroundings& surroundings) {
  return surroundings.interrupted != nullptr && *surroundings.interrupted;
}

int print(const std::string& text, const Surroundings& surroundings) {
  surroundings.output << text << std::flush;
  if (surroundings.output.good()) return exit_code::ok;
  surroundings.messages << "The result could not be written to the standard output; check where it goes.\n";
  return exit_code::bad_input;
}

int perform(const Subcommand& subcommand, bool json, const Surroundings& surroundings) {
  try {
    const Report report = subcommand.run(surroundings);
    if (is_interrupted(surroundings)) return exit_code::interrupted;
    return print(json ? to_text(report.json) : report.text, surroundings);
  } catch (const Interrupted&) {
    return exit_code::interrupted;
  } catch (const InvalidDescription& invalid) {
    surroundings.messages << invalid.what() << std::endl;
    return exit_code::bad_input;
  }
}

/// A variable of a script that is not set is no value.
CLI::Validator not_empty() {
  const auto problem = [](const std::string& value) {
    return value.empty() ? std::string("it is empty; give a value, or leave the option out") : std::string();
  };
  return CLI::Validator(problem, "");
}

class CommandLine {
 public:
  CommandLine() : app_(description, "aspects") {
    app_.footer(footer);
    app_.require_subcommand(0, 1);
    app_.add_flag("--version", version_, "Print the version and exit");
    for (const Subcommand& subcommand : subcommands_) add(subcommand);
  }

  int run(int argc, const char* const* argv, const Surroundings& surroundings) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& end) {
      return app_.exit(end, surroundings.output, surroundings.messages) == 0 ? exit_code::ok
                                                                             : exit_code::bad_usage;
    }
    if (version_) return print("aspects " PARALLEL_ASPECTS_VERSION "\n", surroundings);
    for (const Subcommand& subcommand : subcommands_)
      if (app_.got_subcommand(subcommand.name)) return perform(subcommand, json_, surroundings);
    surroundings.messages << app_.help();
    return exit_code::bad_usage;
  }

 private:
  void add(const Subcommand& subcommand) {
    CLI::App* app = app_.add_subcommand(subcommand.name, subcommand.help);
    for (const Option& option : subcommand.options)
      app->add_option(option.name, *option.value, option.help)
          ->type_name(option.placeholder)
          ->required(option.required)
          ->check(not_empty());
    for (const Flag& flag : subcommand.flags) app->add_flag(flag.name, *flag.value, flag.help);
    app->add_flag("--json", json_, "Print JSON, as documented in docs/command.md");
  }

  CLI::App app_;
  bool version_ = false;
  bool json_ = false;
  const std::vector<Subcommand> subcommands_{
      map_subcommand(),     connect_subcommand(), describe_subcommand(), distance_subcommand(),
      inverse_subcommand(), direct_subcommand(),  robots_subcommand()};
};

}  // namespace

int run_command(int argc, const char* const* argv, const Surroundings& surroundings) noexcept {
  try {
    return CommandLine().run(argc, argv, surroundings);
  } catch (const std::exception& error) {
    surroundings.messages << "The command failed: " << error.what() << std::endl;
    return exit_code::bad_input;
  }
}

std::vector<Option> robot_options(RobotChoice& choice) {
  return {{"ROBOT", "", "Name of a shipped robot; `aspects robots` lists them", &choice.name},
          {"--urdf", "FILE", "URDF of another robot, together with --config", &choice.urdf_file},
          {"--config", "FILE", "YAML with its loop closures and drives", &choice.config_file}};
}

}  // namespace parallel_aspects::tools
