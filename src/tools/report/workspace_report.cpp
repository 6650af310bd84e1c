// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/workspace_report.h"

#include "tools/report/bounds_report.h"
#include "tools/report/reports.h"
#include "tools/report/slice_report.h"
#include "tools/report/text_table.h"

#include <algorithm>
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

const Aspect& aspect_of(const AspectMap& map, const RegularWorkspace& workspace) {
  return map.aspects()[static_cast<std::size_t>(workspace.aspect - 1)];
}

json json_center(const AspectMap& map, const RegularWorkspace& workspace) {
  if (workspace.lower <= 0.0) return nullptr;
  json center = json::object();
  const std::vector<std::string> names = map.coordinates();
  for (std::size_t i = 0; i < free_positions(*map.manipulator(), map.slice()); ++i)
    center[names[i]] = json_number(workspace.center[i]);
  return center;
}

json json_workspace(const AspectMap& map, const WorkspaceQuestion& question,
                    const RegularWorkspace& workspace) {
  json size = json::object();
  for (const auto& [what, length] : lengths_of(map, question, workspace.lower))
    size[what] = json_number(length);
  const Aspect& aspect = aspect_of(map, workspace);
  return {{"aspect", workspace.aspect},
          {"working_mode", aspect.mode.signs()},
          {"det_a_sign", aspect.determinant_sign},
          {"shape", name(question.shape)},
          {"center", json_center(map, workspace)},
          {"size", std::move(size)},
          {"lower", json_number(workspace.lower)},
          {"upper", json_number(workspace.upper)},
          {"proved", workspace.proved}};
}

std::string center_text(const AspectMap& map, const RegularWorkspace& workspace) {
  if (workspace.lower <= 0.0) return "-";
  std::string text = "(";
  for (std::size_t i = 0; i < free_positions(*map.manipulator(), map.slice()); ++i)
    text += (i == 0 ? "" : ", ") + shown(workspace.center[i]);
  return text + ")";
}

/// What `lower` and `upper` are the length of.
std::string size_name(const AspectMap& map, const WorkspaceQuestion& question) {
  return lengths_of(map, question, 1.0).front().first;
}

std::string table_of(const AspectMap& map, const WorkspaceQuestion& question,
                     const std::vector<RegularWorkspace>& workspaces) {
  TextTable table({">aspect", "working mode", "det A", ">" + size_name(map, question) + " [m]", ">at most",
                   "center [m]", "gap closed"});
  for (const RegularWorkspace& workspace : workspaces) {
    const Aspect& aspect = aspect_of(map, workspace);
    table.add({std::to_string(workspace.aspect), to_string(aspect.mode), shown_sign(aspect.determinant_sign),
               shown_bound(workspace.lower, Side::below), shown_bound(workspace.upper, Side::above),
               center_text(map, workspace), workspace.proved ? "yes" : "no"});
  }
  return table.text();
}

std::string best_text(const AspectMap& map, const WorkspaceQuestion& question,
                      const std::vector<RegularWorkspace>& workspaces) {
  const RegularWorkspace* best = best_of(workspaces);
  if (best == nullptr) return "No " + std::string(name(question.shape)) + " is proved to lie in an aspect.\n";
  std::vector<std::string> lengths;
  for (const auto& [what, length] : lengths_of(map, question, best->lower))
    lengths.push_back(what + " " + shown_bound(length, Side::below) + " m");
  return "The largest " + std::string(name(question.shape)) + " lies in aspect " +
         std::to_string(best->aspect) + ": " + joined(lengths, ", ") + ", center " + center_text(map, *best) +
         ".\nProved: each shape lies in its aspect, and none in it is larger than `at most`.\n";
}

}  // namespace

const RegularWorkspace* best_of(const std::vector<RegularWorkspace>& workspaces) {
  const auto best = std::max_element(
      workspaces.begin(), workspaces.end(),
      [](const RegularWorkspace& a, const RegularWorkspace& b) { return a.lower < b.lower; });
  return best == workspaces.end() || best->lower <= 0.0 ? nullptr : &*best;
}

Report report_workspaces(const AspectMap& map, const WorkspaceQuestion& question,
                         const std::vector<RegularWorkspace>& workspaces, double gap) {
  Report report;
  const RegularWorkspace* best = best_of(workspaces);
  report.json = {{"mechanism", map.manipulator()->name()},
                 {"task_space", std::string(name(map.manipulator()->task_space()))},
                 {"slice", json_slice(map.slice())},
                 {"shape", name(question.shape)},
                 {"ratio", question.ratio},
                 {"angle", nullptr},
                 {"gap", gap},
                 {"best", best == nullptr ? json() : json(best->aspect)},
                 {"workspaces", json::array()},
                 {"margins", json_margins(map.manipulator()->constraints().margins)},
                 {"tolerance", json_number(map.manipulator()->tolerance())}};
  if (question.angle)
    report.json["angle"] = {{"lower", question.angle->lower}, {"upper", question.angle->upper}};
  for (const RegularWorkspace& workspace : workspaces)
    report.json["workspaces"].push_back(json_workspace(map, question, workspace));
  const Report bounds = report_constraints(*map.manipulator());
  report.json.update(bounds.json);
  report.text = map.manipulator()->name() + ": the largest " + std::string(name(question.shape)) +
                " in each aspect" + (map.slice() ? " of the slice " + to_string(*map.slice()) : "") + "\n\n" +
                table_of(map, question, workspaces) + "\n" + best_text(map, question, workspaces) +
                bounds.text;
  return report;
}

}  // namespace parallel_aspects::tools
