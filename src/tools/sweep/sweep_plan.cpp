// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_plan.h"

#include "aspects/file/map_key.h"
#include "aspects/map/proof_revision.h"
#include "model/message_text.h"
#include "tools/numbers.h"

#include <boost/random/sobol.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <zlib.h>

namespace parallel_aspects::tools {
namespace {

// Raised with every change of what rows hold.
constexpr int row_revision = 1;

constexpr int row_digits = 12;

std::optional<VariedParameter> parse_word(const std::string& option, const std::string& word,
                                          SweepSample sample, Problems& problems) {
  const std::size_t equals = word.find('=');
  const std::vector<std::string> parts =
      equals == std::string::npos ? std::vector<std::string>() : split_at(':', word.substr(equals + 1));
  const std::size_t most = sample == SweepSample::grid ? 3 : 2;
  if (equals == 0 || parts.empty() || parts.size() > most || (parts.size() == 2 && most == 3)) {
    problems.push_back(option + " has '" + word +
                       "'; give a parameter with a value, such as rod=1, or a range, " +
                       (most == 3 ? "with the number of its values, such as crank_1=0.2:0.4:21."
                                  : "such as crank_1=0.2:0.4."));
    return std::nullopt;
  }
  VariedParameter varied;
  varied.name = word.substr(0, equals);
  const std::string named = option + " " + varied.name;
  const std::size_t known = problems.size();
  const auto number = [&](const std::string& text) {
    const auto values = parse_numbers(named, text, {"value"}, problems);
    return values.empty() ? 0.0 : values.front();
  };
  varied.lower = number(parts.front());
  varied.upper = parts.size() > 1 ? number(parts[1]) : varied.lower;
  if (parts.size() > 2) varied.count = parse_count(named, parts[2], most_designs, problems);
  const bool is_single = sample == SweepSample::grid && varied.count == 1 && varied.upper > varied.lower;
  if (problems.size() == known && (varied.upper < varied.lower || varied.count == 0 || is_single))
    problems.push_back(option + " has '" + word +
                       "'; the lower end comes first, and a range has two values or more.");
  return varied;
}

double value_at(const VariedParameter& varied, std::size_t step) {
  if (step + 1 == varied.count) return varied.upper;
  return varied.lower +
         (varied.upper - varied.lower) * static_cast<double>(step) / static_cast<double>(varied.count - 1);
}

/// Shares from 0 to below 1.
std::vector<double> sobol_point(std::size_t dimension, std::size_t design) {
  boost::random::sobol sequence(dimension);
  sequence.seed(static_cast<std::uint64_t>(design));
  std::vector<double> shares(dimension);
  for (double& share : shares) share = std::ldexp(static_cast<double>(sequence() >> 11U), -53);
  return shares;
}

std::string number_cell(double value) { return number_text(value + 0.0, row_digits); }

std::string text_of(const DesignQuestion& question) {
  std::ostringstream text;
  for (const std::string& name : figure_names(question)) text << name << ' ';
  const auto exact = [](double value) { return number_text(value, exact_digits); };
  if (question.map.resolution) text << "resolution " << exact(*question.map.resolution);
  text << " levels " << question.map.extra_levels << " gap " << exact(question.gap);
  if (const auto& region = question.map.region)
    for (std::size_t i = 0; i < region->dimension; ++i)
      text << " region " << exact(region->lower[i]) << ' ' << exact(region->upper[i]);
  text << coverage_key(question.map.slice, question.map.modes);
  if (!question.workspace) return text.str();
  text << name(question.workspace->shape);
  for (const double part : question.workspace->ratio) text << ' ' << exact(part);
  if (question.workspace->angle)
    text << " angle " << exact(question.workspace->angle->lower) << ' '
         << exact(question.workspace->angle->upper);
  return text.str();
}

}  // namespace

std::vector<VariedParameter> parse_varied(const std::string& option, const std::string& text,
                                          SweepSample sample, Problems& problems) {
  std::vector<VariedParameter> varied;
  for (const std::string& word : words_of_list(text))
    if (const auto parameter = parse_word(option, word, sample, problems)) varied.push_back(*parameter);
  if (varied.empty() && problems.empty())
    problems.push_back(option + " names no parameter; `aspects describe` lists them.");
  return varied;
}

std::size_t grid_size(const std::vector<VariedParameter>& varied) {
  std::size_t size = 1;
  for (const VariedParameter& each : varied) {
    if (each.count > most_designs / size) return 0;
    size *= each.count;
  }
  return size;
}

DesignValues values_of(const SweepPlan& plan, std::size_t design) {
  DesignValues values;
  if (plan.sample == SweepSample::sobol) {
    const std::vector<double> shares = sobol_point(plan.varied.size(), design);
    for (std::size_t i = 0; i < plan.varied.size(); ++i) {
      const VariedParameter& varied = plan.varied[i];
      values.emplace_back(varied.name, varied.lower + (varied.upper - varied.lower) * shares[i]);
    }
    return values;
  }
  for (std::size_t i = plan.varied.size(); i-- > 0; design /= plan.varied[i].count)
    values.emplace_back(plan.varied[i].name, value_at(plan.varied[i], design % plan.varied[i].count));
  std::reverse(values.begin(), values.end());
  return values;
}

std::string column_line(const SweepPlan& plan) {
  std::string line = "design";
  for (const VariedParameter& each : plan.varied) line += "," + each.name;
  line += ",status";
  for (const std::string& name : figure_names(plan.question)) line += "," + name;
  return line;
}

std::string row_start(const SweepPlan& plan, std::size_t design) {
  std::string row = std::to_string(design + 1);
  for (const auto& [name, value] : values_of(plan, design)) row += "," + number_cell(value);
  return row + ",";
}

std::string row_of(const SweepPlan& plan, std::size_t design, const MapControl& control) {
  DesignFigures figures;
  try {
    figures =
        figures_of(with_design(*plan.robot, values_of(plan, design), plan.keep_ties), plan.question, control);
  } catch (const InvalidDescription& invalid) {
    figures = {DesignStatus::refused, invalid.what(), {}};
  }
  if (figures.status == DesignStatus::cancelled) return "";
  figures.values.resize(figure_names(plan.question).size());
  std::string row = row_start(plan, design) + name(figures.status);
  for (const auto& value : figures.values) row += "," + (value ? number_cell(*value) : "");
  return row;
}

std::uint32_t fingerprint(const SweepPlan& plan) {
  std::ostringstream text;
  text << row_revision << ' ' << proof_revision << '\n'
       << map_key(*plan.robot, Box{}, 0.0, 0, 0) << text_of(plan.question) << '\n'
       << (plan.sample == SweepSample::grid ? "grid " : "sobol ") << plan.count << ' ' << plan.keep_ties
       << '\n';
  for (const VariedParameter& each : plan.varied)
    text << each.name << ' ' << number_text(each.lower, exact_digits) << ' '
         << number_text(each.upper, exact_digits) << ' ' << each.count << '\n';
  const std::string bytes = text.str();
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace parallel_aspects::tools
