// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/question_options.h"
#include "tools/subcommands.h"
#include "tools/sweep/sweep_arguments.h"
#include "tools/sweep/sweep_file.h"
#include "tools/sweep/sweep_plan.h"

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

constexpr unsigned most_threads = 1024;

struct SweepChoice : QuestionArguments {
  std::string threads, file;  // empty where not given
};

struct MergeArguments {
  std::string parts, file;
};

Report report_sweep(const SweepPlan& plan, const Shard& shard, std::size_t before, const SweepFile& rows,
                    const std::string& file) {
  Report report;
  report.json = {{"file", file},          {"mechanism", plan.robot->name()},
                 {"designs", plan.count}, {"shard", {{"index", shard.index}, {"count", shard.count}}},
                 {"rows", rows.rows()},   {"rows_before", before}};
  report.text =
      file + ": " + std::to_string(rows.rows()) + " of " + counted(plan.count, "design") +
      (shard.count > 1 ? ", shard " + std::to_string(shard.index) + "/" + std::to_string(shard.count) : "") +
      (before > 0 ? ", " + std::to_string(before) + " of them from before" : "") + "\n";
  return report;
}

Report sweep(const SweepPlan& plan, const Shard& shard, const std::string& name, unsigned threads,
             const Surroundings& surroundings) {
  SweepFile file(plan, shard, name);
  const std::size_t before = file.rows();
  std::optional<ProgressBar> bar;
  if (surroundings.messages_on_terminal) bar.emplace(surroundings.messages);
  const auto start = std::chrono::steady_clock::now();
  const MapControl control = control_of(surroundings);
  const auto progress = [&](std::size_t rows, std::size_t of) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    const auto share = [of](std::size_t n) { return static_cast<double>(n) / static_cast<double>(of); };
    if (bar && of > 0) bar->show(share(rows), share(before), taken.count());
  };
  run_sweep(plan, shard, threads, control, progress, file);
  if (is_cancelled(control)) throw Interrupted{};
  return report_sweep(plan, shard, before, file, name);
}

Report report_of(const SweepChoice& choice, const Surroundings& surroundings) {
  Problems problems;
  const unsigned threads =
      choice.threads.empty() ? 0 : parse_count("--threads", choice.threads, most_threads, problems);
  check_output_file("-o", choice.file, problems);
  const auto mechanism = load_robot(choice.robot, std::move(problems));
  problems.clear();
  const auto robot = choose_constraints(mechanism->mapped_manipulator(), choice.constraints);
  const auto arguments = read_question<SweepArguments>(*robot, choice.texts, problems, choice.flags);
  Shard shard;
  Problems more;
  const SweepPlan plan = plan_sweep(robot, arguments, option_name, shard, more);
  problems.insert(problems.end(), more.begin(), more.end());
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return sweep(plan, shard, choice.file, threads, surroundings);
}

/// A file a line, with the blanks in its name; or one line of files.
std::vector<std::string> files_of(const std::string& text) {
  return text.find('\n') == std::string::npos ? words_of_list(text) : split_at('\n', text);
}

Report report_of(const MergeArguments& arguments) {
  Problems problems;
  const std::vector<std::string> files = files_of(arguments.parts);
  check_output_file("-o", arguments.file, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  write_output_file("The merged file", arguments.file, merged_parts(files));
  Report report;
  report.json = {{"file", arguments.file}, {"parts", files}};
  report.text = arguments.file + ": merged from " + counted(files.size(), "part") + "\n";
  return report;
}

}  // namespace

Subcommand sweep_subcommand() {
  const auto choice = std::make_shared<SweepChoice>();
  Subcommand made = question_subcommand<SweepArguments>(
      "sweep", "Map many designs, with other lengths of links and places of joints, a row each", choice,
      report_of,
      {{"-o", "FILE", "Rows as CSV; where it is there, the same command goes on with it", &choice->file, true,
        Words::one, FileUse::written}},
      {{"--threads", "N", "Designs at a time; by default one a core", &choice->threads}});
  for (Option& option : made.options) option.required = option.required || option.name == "--vary";
  return made;
}

Subcommand merge_subcommand() {
  const auto arguments = std::make_shared<MergeArguments>();
  return {"merge",
          "Join the parts of a sweep that was computed in shards",
          {{"PARTS", "", "Files of all shards", &arguments->parts, true, Words::files, FileUse::read},
           {"-o", "FILE", "The whole sweep", &arguments->file, true, Words::one, FileUse::written}},
          [arguments](const Surroundings&) { return report_of(*arguments); }};
}

}  // namespace parallel_aspects::tools
