// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/design.h"
#include "tools/numbers.h"
#include "tools/sweep/sweep_chart.h"
#include "tools/sweep/sweep_file.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>

namespace parallel_aspects::tools {
namespace {

constexpr const char* header_format = "# aspects sweep 1, fingerprint %08x, %zu designs, shard %zu/%zu";

/// A file of rows, as lines.
struct Part {
  std::string file;
  SweepHeader header;
  std::string columns;
  std::vector<std::string> rows;
};

std::optional<SweepHeader> parse_header(const std::string& line) {
  SweepHeader header;
  unsigned checksum = 0;
  if (std::sscanf(line.c_str(), header_format, &checksum, &header.designs, &header.shard.index,
                  &header.shard.count) != 4)
    return std::nullopt;
  header.fingerprint = checksum;
  const Shard& shard = header.shard;
  const bool is_sound = shard.index >= 1 && shard.index <= shard.count && header.designs <= most_designs &&
                        header_line(header) == line;
  return is_sound ? std::optional<SweepHeader>(header) : std::nullopt;
}

std::vector<std::string> cells_of(const std::string& line) { return split_at(',', line); }

bool is_status(const std::string& cell) {
  for (const DesignStatus status :
       {DesignStatus::mapped, DesignStatus::unassembled, DesignStatus::refused, DesignStatus::not_mapped})
    if (cell == name(status)) return true;
  return false;
}

bool is_number(const std::string& cell) {
  char* end = nullptr;
  return !std::isnan(std::strtod(cell.c_str(), &end)) && end == cell.c_str() + cell.size();
}

void check_rows(const Part& part, Problems& problems) {
  const Shard& shard = part.header.shard;
  const std::size_t wanted = shard.rows(part.header.designs);
  if (part.rows.size() != wanted)
    problems.push_back("'" + part.file + "' has " + std::to_string(part.rows.size()) + " of its " +
                       std::to_string(wanted) + " rows; let its sweep go on to its end.");
  for (std::size_t i = 0; i < part.rows.size(); ++i) {
    const std::string start = std::to_string(shard.design(i) + 1) + ",";
    if (part.rows[i].compare(0, start.size(), start) == 0 && is_row_of(part.columns, part.rows[i])) continue;
    problems.push_back("'" + part.file + "' is damaged at its row " + std::to_string(i + 1) +
                       "; remove it, and run its sweep anew.");
    return;
  }
}

std::optional<Part> read_part(const std::string& file, Problems& problems) {
  std::ifstream stream(file, std::ios::binary);
  Part part;
  part.file = file;
  std::string line;
  const std::optional<SweepHeader> header =
      std::getline(stream, line) ? parse_header(line) : std::optional<SweepHeader>();
  if (!header || !std::getline(stream, part.columns)) {
    problems.push_back("'" + file +
                       "' cannot be read as the file of a sweep; give files that `aspects sweep` wrote.");
    return std::nullopt;
  }
  part.header = *header;
  while (std::getline(stream, line)) {
    if (stream.eof()) line.insert(0, "?");  // a row without its end
    part.rows.push_back(line);
  }
  check_rows(part, problems);
  return part;
}

void check_same_sweep(const Part& first, const Part& other, Problems& problems) {
  const bool is_same = first.header.fingerprint == other.header.fingerprint &&
                       first.header.designs == other.header.designs &&
                       first.header.shard.count == other.header.shard.count && first.columns == other.columns;
  if (!is_same)
    problems.push_back("'" + other.file + "' is of another sweep than '" + first.file +
                       "'; give the parts of one sweep.");
}

/// By index of the shard, from 0.
std::vector<const Part*> in_order(const std::vector<Part>& parts, Problems& problems) {
  std::vector<const Part*> order(parts.front().header.shard.count, nullptr);
  for (const Part& part : parts) {
    const Part*& place = order[part.header.shard.index - 1];
    if (place != nullptr)
      problems.push_back("'" + part.file + "' and '" + place->file + "' are the same shard; give each once.");
    place = &part;
  }
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] == nullptr)
      problems.push_back("Shard " + std::to_string(i + 1) + "/" + std::to_string(order.size()) +
                         " is missing; give its file, too.");
  return order;
}

}  // namespace

bool is_row_of(const std::string& columns, const std::string& row) {
  const std::vector<std::string> names = cells_of(columns), cells = cells_of(row);
  if (cells.size() != names.size()) return false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_sound =
        names[i] == "status" ? is_status(cells[i]) : cells[i].empty() || is_number(cells[i]);
    if (!is_sound) return false;
  }
  return true;
}

SweepTable read_sweep_table(const std::string& file) {
  Problems problems;
  const std::optional<Part> part = read_part(file, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  SweepTable table{cells_of(part->columns), {}};
  for (const std::string& row : part->rows) table.rows.push_back(cells_of(row));
  return table;
}

std::string header_line(const SweepHeader& header) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), header_format, header.fingerprint, header.designs,
                header.shard.index, header.shard.count);
  return text.data();
}

std::string merged_parts(const std::vector<std::string>& files) {
  Problems problems;
  std::vector<Part> parts;
  for (const std::string& file : files)
    if (auto part = read_part(file, problems)) parts.push_back(std::move(*part));
  for (const Part& part : parts) check_same_sweep(parts.front(), part, problems);
  if (parts.empty() && problems.empty())
    problems.emplace_back("No part is given; name the files of all shards.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const std::vector<const Part*> order = in_order(parts, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  SweepHeader header = parts.front().header;
  header.shard = {};
  std::string text = header_line(header) + "\n" + parts.front().columns + "\n";
  for (std::size_t design = 0; design < header.designs; ++design)
    text += order[design % order.size()]->rows[design / order.size()] + "\n";
  return text;
}

}  // namespace parallel_aspects::tools
