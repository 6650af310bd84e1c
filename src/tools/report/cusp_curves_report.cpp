// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "tools/report/report.h"
#include "tools/report/uniqueness_report.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

/// Where the curve goes: "10 (end of the range), 26.7864 (turn), 26.8002 (limit)".
std::string course(const CuspCurve& curve) {
  std::string text;
  for (const CuspEvent& event : curve.events)
    text += (text.empty() ? "" : ", ") + number_text(0.5 * (event.lower + event.upper), 7) + " (" +
            name(event.kind) + ")";
  return text;
}

std::string curves_text(const Manipulator& robot, const CuspCurves& found, const std::string& held) {
  if (found.curves.empty()) return "";
  const bool has_modes = working_modes(robot).size() > 1;
  std::vector<std::string> titles{">curve", "closed"};
  if (has_modes) titles.emplace_back("working mode");
  titles.push_back(held);
  TextTable table(titles);
  for (std::size_t i = 0; i < found.curves.size(); ++i) {
    const CuspCurve& curve = found.curves[i];
    std::vector<std::string> cells{std::to_string(i + 1), curve.closed ? "yes" : "no"};
    if (has_modes) cells.push_back(curve.points.empty() ? "" : to_string(curve.points.front().mode));
    cells.push_back(course(curve));
    table.add(std::move(cells));
  }
  return '\n' + table.text();
}

std::string counts_text(const CuspCurves& found, const std::string& held) {
  if (found.counts.empty()) return "";
  TextTable table({">from " + held, ">to", ">cusps"});
  for (const CuspCount& each : found.counts)
    table.add({number_text(each.lower, 9), number_text(each.upper, 9), std::to_string(each.cusps)});
  return "\nnumber of cusps of each slice, proved\n" + table.text();
}

/// With what to ask about values that are not decided.
std::string undecided_text(const CuspCurves& found, const std::string& joint) {
  if (found.undecided.empty()) return "";
  std::string text = "\n";
  for (const CuspEvent& each : found.undecided)
    text += "not decided: " + number_text(each.lower, 9) + " to " + number_text(each.upper, 9) + "\n";
  const CuspEvent& first = found.undecided.front();
  return text + "A shorter range is divided further; --slice " + joint + "=" +
         number_text(0.5 * (first.lower + first.upper)) + " lists the cusps at one value.\n";
}

}  // namespace

std::string uniqueness_text(const Manipulator& robot, const ask::CuspsOverJoint& answer) {
  const CuspCurves& found = answer.found;
  const std::string held = answer.joint + " [" + answer.unit + "]";
  return robot.name() + ", " + answer.joint + " from " + number_text(found.range.lower) + " to " +
         number_text(found.range.upper) + " " + answer.unit + ": " + counted(found.curves.size(), "curve") +
         " of cusps, " + (found.complete ? "proved to be all" : "there may be more") + "\n" +
         curves_text(robot, found, held) + counts_text(found, held) + undecided_text(found, answer.joint);
}

}  // namespace parallel_aspects::tools
