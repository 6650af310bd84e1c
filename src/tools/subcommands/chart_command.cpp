// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"
#include "tools/sweep/sweep_chart.h"

#include <memory>
#include <utility>

namespace parallel_aspects::tools {
namespace {

struct ChartArguments {
  std::string file, picture, column, over, at;  // empty where not given
};

std::vector<std::pair<std::string, double>> parse_fixed(const std::string& text, Problems& problems) {
  std::vector<std::pair<std::string, double>> fixed;
  for (const std::string& word : words_of_list(text)) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) {
      problems.push_back("--at has '" + word + "'; give parameters with their values, such as \"rod_1=5\".");
      continue;
    }
    const std::string name = word.substr(0, equals);
    const auto values = parse_numbers("--at", word.substr(equals + 1), {name}, problems);
    if (!values.empty()) fixed.emplace_back(name, values.front());
  }
  return fixed;
}

Report report_of(const ChartArguments& arguments) {
  Problems problems;
  ChartQuestion question;
  question.column = arguments.column;
  question.over = words_of_list(arguments.over);
  question.fixed = parse_fixed(arguments.at, problems);
  check_picture_file("-o", arguments.picture, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const SweepChart chart = chart_of(read_sweep_table(arguments.file), question);
  std::string title = chart.column;
  for (const auto& [name, value] : question.fixed) title += ", " + name + " = " + shown(value) + " m";
  write_picture_file(arguments.picture, draw_chart(chart, title));
  Report report;
  report.json = {{"file", arguments.picture},
                 {"column", chart.column},
                 {"over", chart.over},
                 {"designs", chart.points.size()}};
  report.text = arguments.picture + ": " + chart.column + " of " + counted(chart.points.size(), "design") +
                " over " + joined(chart.over, " and ") + "\n";
  return report;
}

}  // namespace

Subcommand chart_subcommand() {
  const auto arguments = std::make_shared<ChartArguments>();
  return {
      "chart",
      "Draw a column of a sweep over one or two parameters, with lines where the number of aspects changes",
      {{"FILE", "", "That `aspects sweep` or `aspects merge` wrote", &arguments->file, true, Words::one,
        FileUse::read},
       {"--column", "NAME", "What is drawn, such as largest_lower", &arguments->column, true},
       {"-o", "FILE", "The picture, as SVG or PNG", &arguments->picture, true, Words::one, FileUse::written},
       {"--over", "\"crank_1 rod_2\"", "One or two parameters; by default those that vary", &arguments->over,
        false, Words::names},
       {"--at", "\"rod_1=5\"", "Rows with these values alone [m]", &arguments->at, false,
        Words::assignments}},
      [arguments](const Surroundings&) { return report_of(*arguments); }};
}

}  // namespace parallel_aspects::tools
