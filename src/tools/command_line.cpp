// SPDX-License-Identifier: BSD-3-Clause
#include "tools/command_line.h"

#include "tools/report/text_table.h"
#include "urdf/description/nearest_name.h"

#include <cstddef>

namespace parallel_aspects::tools {
namespace {

bool is_named(const std::string& argument) { return argument.size() > 1 && argument.front() == '-'; }

constexpr const char* given_twice = ": it is given twice; give it once";

class Parser {
 public:
  Parser(const Subcommand& subcommand, const std::vector<std::string>& arguments)
      : subcommand_(subcommand), arguments_(arguments), given_(subcommand.options.size(), false) {}

  /// False where help is asked for.
  bool run() {
    while (next_ < arguments_.size()) {
      const std::string& argument = arguments_[next_++];
      if (asks_for_help(argument)) return false;
      is_named(argument) ? take_named(argument) : take_positional(argument);
    }
    for (std::size_t i = 0; i < given_.size(); ++i)
      if (subcommand_.options[i].required && !given_[i])
        throw UsageError(subcommand_.options[i].name + ": it is required; give a value");
    return true;
  }

 private:
  void take_named(const std::string& argument) {
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    for (std::size_t i = 0; i < given_.size(); ++i)
      if (subcommand_.options[i].name == name)
        return set(i, equals == std::string::npos ? next_value(name) : argument.substr(equals + 1));
    for (const Flag& flag : subcommand_.flags) {
      if (flag.name != name) continue;
      if (equals != std::string::npos) throw UsageError(name + ": it takes no value; leave it out");
      if (*flag.value) throw UsageError(name + given_twice);
      *flag.value = true;
      return;
    }
    throw UsageError(name + ": there is no such option" + meant(name));
  }

  std::string meant(const std::string& name) const {
    std::vector<std::string> known{"--help"};
    for (const Option& option : subcommand_.options)
      if (is_named(option.name)) known.push_back(option.name);
    for (const Flag& flag : subcommand_.flags) known.push_back(flag.name);
    return did_you_mean(name, known);
  }

  void take_positional(const std::string& argument) {
    for (std::size_t i = 0; i < given_.size(); ++i)
      if (!is_named(subcommand_.options[i].name) && !given_[i]) return set(i, argument);
    throw UsageError("'" + argument + "': there is no place for it; values of several words are quoted");
  }

  const std::string& next_value(const std::string& name) {
    if (next_ == arguments_.size()) throw UsageError(name + ": its value is missing");
    return arguments_[next_++];
  }

  void set(std::size_t option, const std::string& value) {
    const std::string& name = subcommand_.options[option].name;
    if (given_[option]) throw UsageError(name + given_twice);
    // A variable of a script that is not set is no value.
    if (value.empty()) throw UsageError(name + ": it is empty; give a value, or leave the option out");
    *subcommand_.options[option].value = value;
    given_[option] = true;
  }

  const Subcommand& subcommand_;
  const std::vector<std::string>& arguments_;
  std::size_t next_ = 0;
  std::vector<bool> given_;  // by option
};

}  // namespace

bool parse_arguments(const Subcommand& subcommand, const std::vector<std::string>& arguments) {
  return Parser(subcommand, arguments).run();
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = similar_name(word, known);
  return near.empty() ? "" : "; did you mean " + near + "?";
}

bool asks_for_help(const std::string& argument) { return argument == "-h" || argument == "--help"; }

std::string help_of(const std::string& program, const Subcommand& subcommand) {
  TextTable table({"Options:", ""});
  std::string usage = "Usage: " + program + " " + subcommand.name;
  for (const Option& option : subcommand.options) {
    const bool named = is_named(option.name);
    const std::string shown = named ? option.name + " " + option.placeholder : option.name;
    if (option.required || !named) usage += option.required ? " " + shown : " [" + shown + "]";
    table.add({"  " + shown, option.help});
  }
  for (const Flag& flag : subcommand.flags) table.add({"  " + flag.name, flag.help});
  table.add({"  -h, --help", "Print this help and exit"});
  return subcommand.help + "\n\n" + usage + " [OPTIONS]\n\n" + table.text();
}

}  // namespace parallel_aspects::tools
