// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/bounds_report.h"

#include "parallel_aspects/aspects/constraint_boundaries.h"
#include "parallel_aspects/singularity/margins.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

json json_modes(const std::vector<WorkingMode>& modes) {
  json array = json::array();
  for (const WorkingMode& mode : modes) array.push_back(mode.signs());
  return array;
}

std::string modes_text(const std::string& what, const std::vector<WorkingMode>& modes) {
  if (modes.empty()) return "";
  std::string text;
  for (const WorkingMode& mode : modes) text += " " + to_string(mode);
  return what + text + "\n";
}

/// The name of a constraint, of margins with their values.
std::string constraint_text(const Manipulator& manipulator, ConstraintKind kind) {
  const std::string text(name(kind));
  return kind == ConstraintKind::margins ? text + " (" + to_string(manipulator.constraints().margins) + ")"
                                         : text;
}

/// Which limits do not count.
void add_missing_joints(const Manipulator& manipulator, const std::string& what, bool verbose,
                        Report& report) {
  const std::vector<std::string>& missing = manipulator.constraints().missing_joints;
  report.json["joints_not_limited"] = missing;
  if (missing.empty()) return;
  const bool one = missing.size() == 1;
  report.text += notes_text(
      {"The limits of " + std::string(one ? "joint " : "joints ") + listed_names(missing) +
       " do not bound the " + what + ", since distances do not tell where " + (one ? "it is." : "they are.")},
      verbose);
}

}  // namespace

Report report_constraints(const Manipulator& manipulator, bool verbose) {
  Report report;
  report.json["constraints"] = json::array();
  std::string list;
  for (const ConstraintKind kind : all_constraint_kinds) {
    if (!manipulator.constraint_kinds()[index_of(kind)]) continue;
    report.json["constraints"].push_back(name(kind));
    list += (list.empty() ? "" : ", ") + constraint_text(manipulator, kind);
  }
  report.text = "constraints: " + (list.empty() ? "none" : list) + "\n";
  add_missing_joints(manipulator, "aspects", verbose, report);
  return report;
}

Report report_bounds(const AspectMap& map, bool verbose) {
  Report report;
  report.json["constraints"] = json::array();
  std::string list;
  for (const ConstraintBoundary& boundary : constraint_boundaries(map)) {
    report.json["constraints"].push_back({{"name", name(boundary.kind)},
                                          {"undecided_leaves", boundary.leaves},
                                          {"measure_undecided", json_number(boundary.measure)}});
    list += (list.empty() ? "" : "; ") + constraint_text(*map.manipulator(), boundary.kind) +
            ", undecided in " + counted(boundary.leaves, "leaf", "leaves") + " of " +
            shown_briefly(boundary.measure) + " " + map.unit();
  }
  report.text = "constraints: " + (list.empty() ? "none" : list) + "\n";
  add_missing_joints(*map.manipulator(), "map", verbose, report);
  const MissingModes missing = missing_modes(map);
  report.json["empty_working_modes"] = json_modes(missing.empty);
  report.json["undecided_working_modes"] = json_modes(missing.unknown);
  report.text += modes_text("working modes proved empty:", missing.empty) +
                 modes_text("working modes in which no pose was found:", missing.unknown);
  return report;
}

}  // namespace parallel_aspects::tools
