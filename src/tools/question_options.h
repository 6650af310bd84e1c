// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_QUESTION_OPTIONS_H
#define PARALLEL_ASPECTS_TOOLS_QUESTION_OPTIONS_H

#include "ask/constraint_choice.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/numbers.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {

/// The texts of the options of a question, by field; empty where not given.
using QuestionTexts = std::map<std::string, std::string>;

/// Which of its flags are given.
using QuestionFlags = std::map<std::string, bool>;

/// Lists the fields of a question as options, which fill `texts`.
class OptionList {
 public:
  explicit OptionList(QuestionTexts& texts) : texts_(texts) {}

  template <class Value>
  void operator()(const ask::Field& field, const Value& value) {
    options_.push_back({option_name(field.name), field.value, ask::with_names(field.help, option_name),
                        &texts_[field.name], false, words_of(field, value), file_use(field)});
  }

  void operator()(const ask::Field& /*field*/, const bool& /*a flag*/) {}

  const std::vector<Option>& options() const noexcept { return options_; }

 private:
  static FileUse file_use(const ask::Field& field) {
    if (field.value != "FILE") return FileUse::none;
    return field.name == "save" ? FileUse::saved : FileUse::loaded;
  }

  // Of which words the text of such a value is made.
  template <class Value>
  static Words words_of(const ask::Field& field, const Value& value) {
    if (std::is_same_v<Value, std::string> && field.value == "LIST") return Words::names;
    return field.value.find('=') == std::string::npos ? words_of(value) : Words::assignments;
  }
  static Words words_of(const std::vector<HeldCoordinate>& /*value*/) { return Words::assignments; }
  template <class Value>
  static Words words_of(const Value& /*value*/) {
    return Words::one;
  }
  static Words words_of(const std::optional<Pose>& /*value*/) { return Words::numbers; }
  static Words words_of(const std::optional<JointVector>& /*value*/) { return Words::numbers; }
  static Words words_of(const std::optional<WorkingMode>& /*value*/) { return Words::signs; }
  static Words words_of(const std::vector<WorkingMode>& /*value*/) { return Words::signs; }
  static Words words_of(const std::vector<double>& /*value*/) { return Words::numbers; }
  template <unsigned least, unsigned largest>
  static Words words_of(const std::vector<ask::Count<least, largest>>& /*value*/) {
    return Words::numbers;
  }

  QuestionTexts& texts_;
  std::vector<Option> options_;
};

/// Lists the fields of a question that are flags, which fill `flags`.
class FlagList {
 public:
  explicit FlagList(QuestionFlags& flags) : given_(flags) {}

  template <class Value>
  void operator()(const ask::Field& /*field*/, const Value& /*an option*/) {}
  void operator()(const ask::Field& field, const bool& /*value*/) {
    flags_.push_back(
        {option_name(field.name), ask::with_names(field.help, option_name), &given_[field.name]});
  }

  const std::vector<Flag>& flags() const noexcept { return flags_; }

 private:
  QuestionFlags& given_;
  std::vector<Flag> flags_;
};

/// The flags of a question.
template <class Question>
std::vector<Flag> question_flags(QuestionFlags& flags) {
  FlagList list(flags);
  Question question;
  describe(list, question);
  return list.flags();
}

/// The options of a question.
template <class Question>
std::vector<Option> question_options(QuestionTexts& texts) {
  OptionList list(texts);
  Question question;
  describe(list, question);
  return list.options();
}

/// Reads the fields of a question from their texts; what is wrong with these is added to the problems.
class TextReader {
 public:
  /// Without a robot it reads what needs none.
  TextReader(const Manipulator* robot, const QuestionTexts& texts, const QuestionFlags& flags,
             Problems& problems)
      : robot_(robot), texts_(texts), flags_(flags), problems_(problems) {}

  template <class Value>
  void operator()(const ask::Field& field, Value& value) {
    const auto text = texts_.find(field.name);
    example_ = field.value;
    if (text != texts_.end() && !text->second.empty()) read(option_name(field.name), text->second, value);
  }
  void operator()(const ask::Field& field, bool& value) {
    const auto flag = flags_.find(field.name);
    value = flag != flags_.end() && flag->second;
  }

 private:
  template <class Value>
  void read(const std::string& option, const std::string& text, std::optional<Value>& value) {
    read(option, text, value.emplace());
  }
  template <unsigned least, unsigned largest>
  void read(const std::string& option, const std::string& text, ask::Count<least, largest>& value) {
    value.value = parse_count(option, text, largest, problems_, least);
  }
  template <class Choice, class = std::enable_if_t<std::is_enum_v<Choice>>>
  void read(const std::string& option, const std::string& text, Choice& value) {
    std::string names;
    if (const auto found = ask::choice_named<Choice>(text, names))
      value = *found;
    else
      problems_.push_back(option + " is '" + text + "'; give " + names + ".");
  }
  template <unsigned least, unsigned largest>
  void read(const std::string& option, const std::string& text,
            std::vector<ask::Count<least, largest>>& values) {
    for (const std::string& word : split_words(text)) read(option, word, values.emplace_back());
  }
  void read(const std::string& option, const std::string& text, std::string& value);
  void read(const std::string& option, const std::string& text, double& value);
  void read(const std::string& option, const std::string& text, Pose& value);
  void read(const std::string& option, const std::string& text, WorkingMode& value);
  void read(const std::string& option, const std::string& text, JointVector& value);
  void read(const std::string& option, const std::string& text, MapSlice& value);
  void read(const std::string& option, const std::string& text, HeldJoint& value);
  void read(const std::string& option, const std::string& text, HeldRange& value);
  void read(const std::string& option, const std::string& text, std::vector<double>& values);
  void read(const std::string& option, const std::string& text, std::vector<WorkingMode>& values);
  void read(const std::string& option, const std::string& text, std::vector<HeldCoordinate>& values);
  void read(const std::string& option, const std::string& text, std::vector<ask::NamedRange>& values);
  std::string example_of_ranges() const;

  const Manipulator* robot_;
  const QuestionTexts& texts_;
  const QuestionFlags& flags_;
  Problems& problems_;
  std::string example_;  // of the value
};

/// What is asked.
template <class Question>
Question read_question(const Manipulator& robot, const QuestionTexts& texts, Problems& problems,
                       const QuestionFlags& flags = {}) {
  Question question;
  TextReader reader(&robot, texts, flags, problems);
  describe(reader, question);
  return question;
}

/// What is wrong with those of the texts that need no robot, to be told with what is wrong with its files.
template <class Question>
void check_texts(const QuestionTexts& texts, Problems& problems) {
  Question question;
  const QuestionFlags none;
  TextReader reader(nullptr, texts, none, problems);
  describe(reader, question);
}

/// Ends with an answer by Ctrl-C, and shows its progress on a terminal; notes are messages.
class ShownAnswering {
 public:
  explicit ShownAnswering(const Surroundings& surroundings);
  const ask::Control& control() const noexcept { return control_; }

 private:
  ShownComputation shown_;
  ask::Control control_;
};

/// Throws `UsageError` where a field is missing, else `InvalidDescription`.
[[noreturn]] void refuse(const ask::ProblemList& problems);

/// The answer. Throws `Interrupted`, or what `refuse` does.
template <class Answer>
Answer required(ask::Outcome<Answer> outcome) {
  if (outcome.status == MapStatus::cancelled) throw Interrupted{};
  if (outcome.status == MapStatus::refused) refuse(outcome.problems);
  return std::move(outcome.answer);
}

/// The map that is asked for. Throws `Interrupted`, or what `refuse` does.
std::shared_ptr<const AspectMap> map_of(const std::shared_ptr<const Manipulator>& robot,
                                        const ask::MapSource& source, const Surroundings& surroundings);

/// Where the map is from, a line where a file was named.
std::string source_text(const ask::MapSource& source, bool loaded);

/// What is asked. Throws `InvalidDescription` where a text cannot be read.
template <class Question>
Question understood(const Manipulator& robot, const QuestionTexts& texts, const QuestionFlags& flags = {}) {
  Problems problems;
  auto question = read_question<Question>(robot, texts, problems, flags);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return question;
}

/// Answers a question in a session of its own. Throws what `required` does.
template <class Question>
auto asked(const std::shared_ptr<const Manipulator>& robot, const Question& question,
           const Surroundings& surroundings) {
  ask::Session session(robot);
  return required(answer(session, question, ShownAnswering(surroundings).control()));
}

/// What the command line says of a question.
struct QuestionArguments {
  RobotChoice robot;
  QuestionTexts texts;
  QuestionFlags flags;
  QuestionTexts constraints;
};

/// The options of a choice of constraints, which fill `texts`.
inline std::vector<Option> constraint_options(QuestionTexts& texts) {
  return question_options<ask::ConstraintChoice>(texts);
}

/// The robot with the constraints and the tolerance that are chosen. Throws `InvalidDescription` with every
/// problem.
std::shared_ptr<const Manipulator> choose_constraints(const std::shared_ptr<const Manipulator>& robot,
                                                      const QuestionTexts& texts);

/// The choice that was made with it.
ask::ConstraintChoice constraint_choice(const Manipulator& robot, const QuestionTexts& texts);

/// The robot that a question is about. Throws `InvalidDescription`, with these problems, too.
inline std::shared_ptr<const Manipulator> robot_of(const QuestionArguments& arguments,
                                                   Problems problems = {}) {
  const auto mechanism = load_robot(arguments.robot, std::move(problems));
  return choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
}

/// A subcommand with the options of a question and of constraints, with others before and behind them.
template <class Question, class Arguments>
Subcommand question_subcommand(const std::string& name, const std::string& help,
                               const std::shared_ptr<Arguments>& arguments,
                               Report (*report_of)(const Arguments&, const Surroundings&),
                               const std::vector<Option>& before, const std::vector<Option>& behind,
                               const std::vector<Flag>& flags = {}) {
  Subcommand made{name, help, robot_options(arguments->robot),
                  [=](const Surroundings& surroundings) { return report_of(*arguments, surroundings); },
                  question_flags<Question>(arguments->flags)};
  for (const auto& more : {before, question_options<Question>(arguments->texts), behind,
                           constraint_options(arguments->constraints)})
    made.options.insert(made.options.end(), more.begin(), more.end());
  made.flags.insert(made.flags.end(), flags.begin(), flags.end());
  return made;
}

/// One without others.
template <class Question, class Answer>
Subcommand question_subcommand(const std::string& name, const std::string& help,
                               Report (*report_of)(const Manipulator&, const Question&, const Answer&)) {
  const auto arguments = std::make_shared<QuestionArguments>();
  Subcommand made = question_subcommand<Question, QuestionArguments>(name, help, arguments, nullptr, {}, {});
  made.run = [arguments, report_of](const Surroundings& surroundings) {
    const auto robot = robot_of(*arguments);
    const auto question = understood<Question>(*robot, arguments->texts, arguments->flags);
    return report_of(*robot, question, asked(robot, question, surroundings));
  };
  return made;
}

/// A subcommand with the options of a question alone.
template <class Question, class Answer>
Subcommand question_subcommand(const std::string& name, const std::string& help,
                               Report (*report_of)(const Mechanism&, const Answer&)) {
  const auto choice = std::make_shared<RobotChoice>();
  const auto texts = std::make_shared<QuestionTexts>();
  std::vector<Option> options = robot_options(*choice);
  for (const Option& option : question_options<Question>(*texts)) options.push_back(option);
  return {name, help, options, [choice, texts, report_of](const Surroundings& surroundings) {
            const auto mechanism = load_robot(*choice);
            const auto& robot = mechanism->manipulator();
            return report_of(*mechanism, asked(robot, understood<Question>(*robot, *texts), surroundings));
          }};
}

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_QUESTION_OPTIONS_H
