// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/report.h"

#include "model/linear_algebra.h"
#include "model/spherical_links.h"
#include "model/task_space_traits.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

constexpr std::size_t max_names = 4;  // that a note lists
constexpr std::size_t shown_names = max_names - 1;
constexpr double degrees_in_radian = 180.0 / EIGEN_PI;

std::string with_digits(double value, int digits) {
  if (std::isnan(value)) return "-";
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

}  // namespace

nlohmann::json json_number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json json_numbers(const TaskVector& values) {
  nlohmann::json array = nlohmann::json::array();
  for (const double value : coefficients_of(values)) array.push_back(json_number(value));
  return array;
}

nlohmann::json json_pose(TaskSpace space, const Pose& pose) {
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  const auto& names = coordinate_names(space);
  nlohmann::json object = nlohmann::json::object();
  for (std::size_t i = 0; i < names.size(); ++i)
    object[names[i]] = json_number(coordinates[static_cast<Eigen::Index>(i)]);
  return object;
}

nlohmann::json json_joints(const Manipulator& manipulator) {
  nlohmann::json object = {{"mechanism", manipulator.name()}};
  for (const Leg& leg : manipulator.legs()) {
    object["actuated_joints"].push_back(leg.actuated_joint);
    object["units"].push_back(joint_unit(leg));
  }
  return object;
}

std::string shown(double value) { return with_digits(value, 6); }

std::string shown_briefly(double value) { return with_digits(value, 4); }

std::string shown_bound(double value, Side side) {
  const std::string text = shown_briefly(value);
  const double rounded = std::strtod(text.c_str(), nullptr);
  if (side == Side::below ? rounded <= value : rounded >= value) return text;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3.0);
  return shown_briefly(side == Side::below ? rounded - unit : rounded + unit);
}

std::string shown(const TaskVector& values) {
  std::string text;
  for (const double value : coefficients_of(values)) text += (text.empty() ? "" : ", ") + shown(value);
  return text;
}

std::string shown_sign(double value) { return value > 0.0 ? "+" : value < 0.0 ? "-" : "0"; }

std::string tolerance_text(const Manipulator& manipulator) {
  if (manipulator.tolerance() == 0.0) return "";
  return "for every robot whose points and lengths are within " + shown(manipulator.tolerance()) +
         " m of those of the description\n";
}

std::string joint_unit(const Leg& leg) { return leg.actuated_by_angle() ? "rad" : "m"; }

std::string determinant_unit(const Manipulator& manipulator) {
  return moves_on_unit_sphere(manipulator) ? ""
                                           : std::string(traits(manipulator.task_space()).determinant_unit);
}

std::string determinant_heading(const Manipulator& manipulator) {
  const std::string unit = determinant_unit(manipulator);
  return "det A" + (unit.empty() ? unit : " [" + unit + "]");
}

std::string shown_angle(double radians) {
  return shown(degrees_in_radian * radians) + " deg (" + shown(radians) + " rad)";
}

std::string shortened(const Note& note) {
  std::string text;
  for (const Note::Piece& piece : note.pieces()) {
    const std::vector<std::string>& items = piece.items;
    if (piece.kind != Note::Piece::Kind::names || items.size() <= max_names)
      text += piece.text();
    else
      text += listed_names({items.begin(), items.begin() + shown_names}).text() + " and " +
              std::to_string(items.size() - shown_names) + " more";
  }
  return text;
}

std::string notes_text(const Notes& notes, bool verbose) {
  std::string text;
  bool whole = true;
  for (const Note& note : notes) {
    const std::string line = verbose ? note.text() : shortened(note);
    whole = whole && line == note.text();
    text += "note: " + line + '\n';
  }
  return text + (whole ? "" : "--verbose lists all names of these notes.\n");
}

std::string to_text(const nlohmann::json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

TextTable::TextTable(const std::vector<std::string>& titles) {
  rows_.emplace_back();
  for (const std::string& title : titles) {
    const bool right = !title.empty() && title.front() == '>';
    right_aligned_.push_back(right);
    rows_.front().push_back(right ? title.substr(1) : title);
  }
}

void TextTable::add(std::vector<std::string> cells) {
  cells.resize(right_aligned_.size());
  rows_.push_back(std::move(cells));
}

std::string TextTable::text() const {
  std::vector<std::size_t> widths(right_aligned_.size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string result;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - row[i].size(), ' ');
      line += (i == 0 ? "" : "  ") + (right_aligned_[i] ? blanks + row[i] : row[i] + blanks);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  }
  return result;
}

nlohmann::json json_slice(const std::optional<MapSlice>& slice) {
  using nlohmann::json;
  if (!slice) return nullptr;
  json held = json::object();
  for (const HeldCoordinate& each : slice->held_coordinates) held[each.name] = json_number(each.value);
  json axis = nullptr;
  if (slice->rotation == MapSlice::Rotation::about_axis)
    axis = {slice->axis.x(), slice->axis.y(), slice->axis.z()};
  const bool freely = slice->rotation == MapSlice::Rotation::freely;
  return {{"held", held},
          {"axis", axis},
          {"free", freely ? std::vector<std::string>{"roll", "pitch", "yaw"} : coordinate_names(*slice)}};
}

namespace {

/// A trajectory starts, but has no goal.
bool is_start_of_trajectory(const std::string& field) {
  return field.rfind("start_pose", 0) == 0 || field.rfind("start_sign", 0) == 0;
}

}  // namespace

std::string option_name(const std::string& field) {
  std::string words = field;
  for (const auto& [end, word] : {std::pair{"start", "from"}, std::pair{"goal", "to"}}) {
    const std::string name = end;
    const bool is_end = words == name || words.rfind(name + "_", 0) == 0;
    if (is_end && !is_start_of_trajectory(field)) words.replace(0, name.size(), word);
  }
  std::replace(words.begin(), words.end(), '_', '-');
  return "--" + words;
}

}  // namespace parallel_aspects::tools
