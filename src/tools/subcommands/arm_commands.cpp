// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/arm.h"
#include "parallel_aspects/ask/robot_description.h"
#include "tools/question_options.h"
#include "tools/report/answer_json.h"
#include "tools/report/arm_report.h"
#include "tools/shipped_robots.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <memory>
#include <utility>

// The subcommands that serial arms share with parallel robots. An option that both have is read as that of an
// arm where the robot is one.
namespace parallel_aspects::tools {
namespace {

const Option* option_of(const Subcommand& subcommand, const std::string& name) {
  const auto found = std::find_if(subcommand.options.begin(), subcommand.options.end(),
                                  [&](const Option& each) { return each.name == name; });
  return found == subcommand.options.end() ? nullptr : &*found;
}

std::string text_given(const Subcommand& subcommand, const std::string& name) {
  const Option* option = option_of(subcommand, name);
  return option == nullptr ? "" : *option->value;
}

std::shared_ptr<const SerialArm> chosen_arm(const Subcommand& subcommand) {
  return load_arm({text_given(subcommand, "ROBOT"), text_given(subcommand, "--urdf"),
                   text_given(subcommand, "--config")});
}

bool is_of_robot(const std::string& option) {
  return option == "ROBOT" || option == "--urdf" || option == "--config";
}

// Options and flags that are given, and mean nothing for an arm.
Problems problems_of_others(const Subcommand& subcommand, const QuestionTexts& fields, const SerialArm& arm) {
  Problems problems;
  const auto refuse_option = [&](const std::string& option) {
    problems.push_back(option + " is of parallel robots, and '" + arm.name() +
                       "' is a serial arm; leave it out.");
  };
  for (const Option& option : subcommand.options) {
    const bool is_field = std::any_of(fields.begin(), fields.end(), [&](const auto& field) {
      return option_name(field.first) == option.name;
    });
    if (!is_field && !is_of_robot(option.name) && !option.value->empty()) refuse_option(option.name);
  }
  for (const Flag& flag : subcommand.flags)
    if (*flag.value && flag.name != "--all" && flag.name != "--verbose") refuse_option(flag.name);
  return problems;
}

// The subcommand with the fields of the question of arms, whose texts are kept in `texts` where it has no
// such option itself.
template <class Question>
Subcommand with_fields(Subcommand made, QuestionTexts& texts) {
  for (const Option& option : question_options<Question>(texts))
    if (option_of(made, option.name) == nullptr) made.options.push_back(option);
  return made;
}

template <class Question>
Report arm_report(const Subcommand& made, QuestionTexts texts, const std::shared_ptr<const SerialArm>& arm,
                  const Surroundings& surroundings) {
  Problems problems = problems_of_others(made, texts, *arm);
  for (auto& [field, text] : texts) {
    const std::string shared = text_given(made, option_name(field));
    if (!shared.empty()) text = shared;
  }
  Question question;
  const QuestionFlags no_flags;
  TextReader reader(nullptr, texts, no_flags, problems);
  describe(reader, question);
  if (!problems.empty()) throw InvalidDescription(problems);
  ask::ArmSession session(arm);
  const auto answer = required(ask::answer(session, question, ShownAnswering(surroundings).control()));
  JsonWriter writer;
  describe(writer, answer);
  nlohmann::json object = writer.take();
  object["mechanism"] = arm->name();
  return {std::move(object), arm_text(session, answer)};
}

template <class Question>
Subcommand with_arms(Subcommand made) {
  const auto texts = std::make_shared<QuestionTexts>();
  const Subcommand before = made;
  made = with_fields<Question>(std::move(made), *texts);
  made.run = [before, texts](const Surroundings& surroundings) {
    if (const auto arm = chosen_arm(before)) return arm_report<Question>(before, *texts, arm, surroundings);
    Problems problems;
    for (const auto& [field, text] : *texts)
      if (!text.empty()) problems.push_back(option_name(field) + " is of serial arms; leave it out.");
    if (!problems.empty()) throw InvalidDescription(problems);
    return before.run(surroundings);
  };
  return made;
}

}  // namespace

Subcommand arm_describe(Subcommand made) { return with_arms<ask::ArmDescribeQuestion>(std::move(made)); }
Subcommand arm_map(Subcommand made) { return with_arms<ask::ArmMapQuestion>(std::move(made)); }
Subcommand arm_locate(Subcommand made) { return with_arms<ask::ArmLocateQuestion>(std::move(made)); }
Subcommand arm_connect(Subcommand made) { return with_arms<ask::ArmConnectQuestion>(std::move(made)); }
Subcommand arm_inverse(Subcommand made) { return with_arms<ask::ArmInverseQuestion>(std::move(made)); }
Subcommand arm_direct(Subcommand made) { return with_arms<ask::ArmDirectQuestion>(std::move(made)); }
Subcommand arm_uniqueness(Subcommand made) { return with_arms<ask::ArmUniquenessQuestion>(std::move(made)); }

Subcommand arm_refused(Subcommand made) {
  const Subcommand before = made;
  made.run = [before](const Surroundings& surroundings) {
    if (const auto arm = chosen_arm(before))
      throw InvalidDescription(
          {"'" + arm->name() + "' is a serial arm, which " + before.name +
           " is not asked of; ask describe, map, locate, connect, ik, fk or uniqueness."});
    return before.run(surroundings);
  };
  return made;
}

}  // namespace parallel_aspects::tools
