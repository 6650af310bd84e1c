// SPDX-License-Identifier: BSD-3-Clause
#include "tools/subcommands.h"

#include "tools/numbers.h"
#include "tools/report/report.h"
#include "urdf/description/nearest_name.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace parallel_aspects::tools {
namespace {

namespace po = boost::program_options;
namespace style = po::command_line_style;

constexpr std::size_t dashes = 2;  // before a name
constexpr const char *given_twice = ": it is given twice; give it once",
                     *empty_value = ": it is empty; give a value, or leave the option out",
                     *no_value = ": its value is missing",
                     *takes_no_value = ": it takes no value; leave it out",
                     *no_such_option = ": there is no such option";
const std::string options_end = "--", short_output = "-o", long_output = "--output";

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

std::string name_of(const Option& option) {
  return (option.name == short_output ? long_output : option.name).substr(dashes);
}

po::options_description described(const Subcommand& subcommand) {
  po::options_description options;
  options.add_options()("help", "");
  for (const Option& option : subcommand.options)
    if (is_named(option.name)) options.add_options()(name_of(option).c_str(), po::value<std::string>(), "");
  for (const Flag& flag : subcommand.flags) options.add_options()(flag.name.substr(dashes).c_str(), "");
  return options;
}

/// Puts what Boost.Program_options understood into the values and flags of a subcommand. Where a list goes on
/// over several words, as Boost has them for options alone that stand behind all others, is decided here.
class Filling {
 public:
  explicit Filling(const Subcommand& subcommand)
      : subcommand_(subcommand), given_(subcommand.options.size(), false) {}

  /// False where help is asked for.
  bool run(const std::vector<std::string>& arguments) {
    const po::options_description options = described(subcommand_);
    const auto parsed =
        po::command_line_parser(arguments)
            .options(options)
            .style(style::allow_long | style::long_allow_adjacent | style::long_allow_next)
            .extra_style_parser([this](std::vector<std::string>& words) { return look(words); })
            .allow_unregistered()
            .run()
            .options;
    for (std::size_t i = 0; i < parsed.size(); ++i) {
      const bool only_positional = i + behind_options_end_ >= parsed.size();
      if (!only_positional && parsed[i].string_key == "help") return false;
      take(parsed[i], only_positional);
    }
    for (std::size_t i = 0; i < given_.size(); ++i)
      if (subcommand_.options[i].required && !given_[i])
        throw UsageError(subcommand_.options[i].name + ": it is required; give a value");
    return true;
  }

  [[noreturn]] void refuse(const po::invalid_command_line_syntax& wrong) const {
    const std::string name = wrong.get_option_name();
    if (!contains(names(), name)) throw unknown(name);
    for (const Option& option : subcommand_.options)
      if (is_named(option.name) && name == "--" + name_of(option))
        throw UsageError(option.name + (wrong.kind() == wrong.missing_parameter ? no_value : empty_value));
    throw UsageError(name + takes_no_value);
  }

 private:
  /// The words that are left, before the first is understood: forms of names that Boost does not have.
  std::vector<po::option> look(std::vector<std::string>& words) {
    std::string& word = words.front();
    if (word == options_end) behind_options_end_ = words.size() - 1;
    if (asks_for_help(word)) {
      word = "--help";
      words.resize(1);  // the rest is not examined
    } else if ((word == short_output || word.rfind(short_output + "=", 0) == 0) &&
               contains(names(), long_output)) {
      word.replace(0, short_output.size(), long_output);
    }
    return {};
  }

  void take(const po::option& parsed, bool only_positional) {
    const std::string& word = parsed.original_tokens.front();
    if (!parsed.string_key.empty() && !parsed.unregistered) return take_named(parsed);
    if (list_ != nullptr && !only_positional && !ends_list(word) && is_more_of(list_->words, word))
      return add(*list_, ' ', word);
    list_ = nullptr;
    if (!only_positional && is_named(word)) throw unknown(word.substr(0, word.find('=')));
    take_positional(word);
  }

  void take_named(const po::option& parsed) {
    list_ = nullptr;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_named(subcommand_.options[i].name) || name_of(subcommand_.options[i]) != parsed.string_key)
        continue;
      list_ = &subcommand_.options[i];
      return set(i, parsed.value.front());
    }
    for (const Flag& flag : subcommand_.flags) {
      if (flag.name.substr(dashes) != parsed.string_key) continue;
      if (*flag.value) throw UsageError(flag.name + given_twice);
      *flag.value = true;
    }
  }

  UsageError unknown(const std::string& name) const {
    const std::vector<std::string> known = names();
    for (const std::vector<std::string>& group : same_options()) {
      if (!contains(group, name)) continue;
      for (const std::string& same : group)
        if (contains(known, same)) return UsageError(name + no_such_option + "; did you mean " + same + "?");
    }
    return UsageError(name + no_such_option + did_you_mean(name, known));
  }

  std::vector<std::string> names() const {
    std::vector<std::string> known{"--help"};
    for (const Option& option : subcommand_.options) {
      if (is_named(option.name)) known.push_back(option.name);
      if (option.name == short_output) known.push_back(long_output);
    }
    for (const Flag& flag : subcommand_.flags) known.push_back(flag.name);
    return known;
  }

  void take_positional(const std::string& word) {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      const Option& option = subcommand_.options[i];
      if (is_named(option.name)) continue;
      if (!given_[i]) return set(i, word);
      if (option.words == Words::files) return add(option, '\n', word);
    }
    throw UsageError("'" + word + "': there is no place for it");
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
    if (word.empty()) throw UsageError(option.name + empty_value);
  }

  const Subcommand& subcommand_;
  std::vector<bool> given_;             // by option
  const Option* list_ = nullptr;        // which the next word may go on with
  std::size_t behind_options_end_ = 0;  // words
};

}  // namespace

bool parse_arguments(const Subcommand& subcommand, const std::vector<std::string>& arguments) {
  Filling filling(subcommand);
  try {
    return filling.run(arguments);
  } catch (const po::invalid_command_line_syntax& wrong) {
    filling.refuse(wrong);
  }
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
