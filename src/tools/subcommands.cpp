// SPDX-License-Identifier: BSD-3-Clause
#include "tools/subcommands.h"

#include "tools/numbers.h"
#include "tools/report/report.h"
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace parallel_aspects::tools {
namespace {

constexpr const char* given_twice = ": it is given twice; give it once";
constexpr const char *options_end = "--", *short_output = "-o", *long_output = "--output";

/// Options of different subcommands for one thing.
const std::array<std::vector<std::string>, 6>& same_options() {
  static const std::array<std::vector<std::string>, 6> groups{{{"--slice", "--hold"},
                                                               {"--load", "--map"},
                                                               {"--picture", long_output, short_output},
                                                               {"--pose", "--from", "--start-pose"},
                                                               {"--mode", "--from-mode"},
                                                               {"--joints", "--from-joints"}}};
  return groups;
}

bool is_named(const std::string& argument) { return argument.size() > 1 && argument.front() == '-'; }

/// `--`, or one or two dashes and a letter: not the next word of a list. "-1" and "-+" may be one.
bool ends_list(const std::string& word) {
  const std::size_t start = word.find_first_not_of('-');
  if (start == std::string::npos) return word == options_end;
  return (start == 1 || start == 2) && std::isalpha(static_cast<unsigned char>(word[start])) != 0;
}

bool holds_signs(const std::string& word) {
  return !word.empty() && word.find_first_not_of("+-(), ") == std::string::npos;
}

bool is_called(const Option& option, const std::string& name) {
  return option.name == name || (option.name == short_output && name == long_output);
}

class Parser {
 public:
  Parser(const Subcommand& subcommand, const std::vector<std::string>& arguments)
      : subcommand_(subcommand), arguments_(arguments), given_(subcommand.options.size(), false) {}

  /// False where help is asked for.
  bool run() {
    while (next_ < arguments_.size()) {
      const std::string& argument = arguments_[next_++];
      if (only_positional_ || !is_named(argument))
        take_positional(argument);
      else if (asks_for_help(argument))
        return false;
      else if (argument == options_end)
        only_positional_ = true;
      else
        take_named(argument);
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
      if (is_called(subcommand_.options[i], name)) {
        set(i, equals == std::string::npos ? next_value(name) : argument.substr(equals + 1));
        return go_on(subcommand_.options[i]);
      }
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
    const std::vector<std::string> known = names();
    for (const std::vector<std::string>& group : same_options()) {
      if (!contains(group, name)) continue;
      for (const std::string& same : group)
        if (contains(known, same)) return "; did you mean " + same + "?";
    }
    return did_you_mean(name, known);
  }

  std::vector<std::string> names() const {
    std::vector<std::string> known{"--help"};
    for (const Option& option : subcommand_.options) {
      if (is_named(option.name)) known.push_back(option.name);
      if (option.name == short_output) known.emplace_back(long_output);
    }
    for (const Flag& flag : subcommand_.flags) known.push_back(flag.name);
    return known;
  }

  void take_positional(const std::string& argument) {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      const Option& option = subcommand_.options[i];
      if (is_named(option.name)) continue;
      if (!given_[i]) return set(i, argument);
      if (option.words == Words::files) return add(option, '\n', argument);
    }
    throw UsageError("'" + argument + "': there is no place for it");
  }

  /// Takes the words that the list of this option goes on with.
  void go_on(const Option& option) {
    while (next_ < arguments_.size() && !ends_list(arguments_[next_]) &&
           is_more_of(option.words, arguments_[next_]))
      add(option, ' ', arguments_[next_++]);
  }

  bool is_more_of(Words words, const std::string& word) const {
    if (words == Words::numbers) return holds_numbers(word);
    if (words == Words::assignments) return word.find('=') != std::string::npos;
    if (words == Words::signs) return holds_signs(word);
    return words == Words::names && places_are_taken();
  }

  bool places_are_taken() const {
    for (std::size_t i = 0; i < given_.size(); ++i)
      if (!is_named(subcommand_.options[i].name) && !given_[i]) return false;
    return true;
  }

  const std::string& next_value(const std::string& name) {
    if (next_ == arguments_.size()) throw UsageError(name + ": its value is missing");
    return arguments_[next_++];
  }

  void set(std::size_t index, const std::string& value) {
    const Option& option = subcommand_.options[index];
    if (given_[index]) throw UsageError(option.name + given_twice);
    check_given(option, value);
    *option.value = value;
    given_[index] = true;
  }

  static void add(const Option& option, char separator, const std::string& word) {
    check_given(option, word);
    *option.value += separator + word;
  }

  // A variable of a script that is not set is no value.
  static void check_given(const Option& option, const std::string& word) {
    if (word.empty()) throw UsageError(option.name + ": it is empty; give a value, or leave the option out");
  }

  const Subcommand& subcommand_;
  const std::vector<std::string>& arguments_;
  std::size_t next_ = 0;
  bool only_positional_ = false;
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
    const std::string long_form = option.name == short_output ? std::string(", ") + long_output : "";
    table.add({"  " + option.name + long_form + shown.substr(option.name.size()), option.help});
  }
  for (const Flag& flag : subcommand.flags) table.add({"  " + flag.name, flag.help});
  table.add({"  -h, --help", "Print this help and exit"});
  return subcommand.help + "\n\n" + usage + " [OPTIONS]\n\n" + table.text();
}

}  // namespace parallel_aspects::tools
