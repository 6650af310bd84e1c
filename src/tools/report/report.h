// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_REPORT_H

#include "ask/question_parts.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "urdf/description/messages.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// What a command has to say, for programs and for people.
struct Report {
  nlohmann::json json;
  std::string text;
  int exit_code = 0;  ///< of the command
};

/// A number as JSON: null where it is infinite or not a number, which JSON does not have.
nlohmann::json json_number(double value);

/// An array of such numbers.
nlohmann::json json_numbers(const TaskVector& values);

/// {"x": 4.5, "y": 8} and so on, by `coordinate_names(space)`.
nlohmann::json json_pose(TaskSpace space, const Pose& pose);

/// {"mechanism", "actuated_joints", "units"} of these.
nlohmann::json json_joints(const Manipulator& manipulator);

/// Six significant digits; "-" where the value is not a number.
std::string shown(double value);

/// Four significant digits.
std::string shown_briefly(double value);

/// On which side of a number what is shown of it may lie.
enum class Side { below, above };

/// The same for a bound that is proved: rounded to this side, so that what is shown is proved as well.
std::string shown_bound(double value, Side side);

/// Several numbers, separated by ", ".
std::string shown(const TaskVector& values);

/// "+" or "-".
std::string shown_sign(double value);

/// "rad" or "m": the unit of a leg's joint value.
std::string joint_unit(const Leg& leg);

/// Unit of det A: "m^2", "m^4" and so on, as in `direct_determinant`; empty where distances are angles.
std::string determinant_unit(const Manipulator& manipulator);

/// "det A [m^2]", for columns.
std::string determinant_heading(const Manipulator& manipulator);

/// A line that says for which robots something is proved; empty without a tolerance.
std::string tolerance_text(const Manipulator& manipulator);

using ask::counted;

/// "70 deg (1.22173 rad)".
std::string shown_angle(double radians);

/// A note for people: where it names more than four joints or links in a row, the first three and how many
/// more there are.
std::string shortened(const Note& note);

/// Each note on a line of its own; unless `verbose` shortened, and then where the rest is found.
std::string notes_text(const Notes& notes, bool verbose);

/// JSON as text: indented, valid UTF-8 whatever is in the names, with a line end.
std::string to_text(const nlohmann::json& json);

/// The words one after another, with `between` them.
std::string joined(const std::vector<std::string>& words, const std::string& between);

/// Columns of text, each as wide as its longest cell.
class TextTable {
 public:
  /// One title a column; a title that starts with '>' (not shown) makes its column right-aligned.
  explicit TextTable(const std::vector<std::string>& titles);

  /// Adds a row with one cell a column.
  void add(std::vector<std::string> cells);

  /// Titles and rows, two blanks between columns, no blanks at the ends of lines.
  std::string text() const;

 private:
  std::vector<bool> right_aligned_;
  std::vector<std::vector<std::string>> rows_;
};

/// {"held", "axis", "free"}: what is held and what is free; null where there is no slice.
nlohmann::json json_slice(const std::optional<MapSlice>& slice);

/// The option of a field: "around_cusp" is --around-cusp. The ends of a path are --from and --to, of which
/// the first is no name in Python.
std::string option_name(const std::string& field);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_REPORT_H
