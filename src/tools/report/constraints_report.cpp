// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/constraints_report.h"

#include "parallel_aspects/ask/robot_description.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
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
  report.text += notes_text({"The limits of " + std::string(one ? "joint " : "joints ") +
                             listed_names(missing) + " do not bound the " + what +
                             ", since distances do not determine where " + (one ? "it is." : "they are.")},
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

namespace {

/// What the axes are fixed in, and whether the cones are stated: what one line may say of several.
using Kind = std::pair<std::string, bool>;

class ConesReport {
 public:
  explicit ConesReport(const Manipulator& manipulator)
      : manipulator_(manipulator), cones_(ask::cones_of(manipulator)) {}

  std::string lines() const {
    std::string text;
    for (const ask::ConeOfRod& one : cones_) text += line(one);
    return text;
  }

  /// One line for all of a kind.
  std::string text() const {
    std::map<Kind, std::vector<const ask::ConeOfRod*>> kinds;
    for (const ask::ConeOfRod& one : cones_) kinds[kind_of(one)].push_back(&one);
    std::string text;
    for (const auto& [kind, cones] : kinds)
      text += cones.size() == 1 ? line(*cones.front()) : line(kind, cones);
    return text;
  }

 private:
  const std::string& leg_of(const BallJointCone& cone) const { return manipulator_.leg(cone.leg).name; }

  Kind kind_of(const ask::ConeOfRod& one) const { return {one.fixed_in, one.joint.empty()}; }

  std::string line(const ask::ConeOfRod& one) const {
    const Eigen::Vector3d& axis = one.cone.axis;
    return "cone: the rod of " + leg_of(one.cone) + " is at most " + shown(one.cone.angle) + " rad from (" +
           shown(axis.x()) + ", " + shown(axis.y()) + ", " + shown(axis.z()) + ") of the " + one.fixed_in +
           (one.joint.empty() ? "" : ", for a limit of " + one.joint) + "\n";
  }

  std::string line(const Kind& kind, const std::vector<const ask::ConeOfRod*>& cones) const {
    std::set<std::string> joints;
    std::vector<std::string> legs;
    std::string names;
    double narrowest = cones.front()->cone.angle, widest = narrowest;
    for (const ask::ConeOfRod* one : cones) {
      narrowest = std::min(narrowest, one->cone.angle);
      widest = std::max(widest, one->cone.angle);
      joints.insert(one->joint);
      const std::string& leg = leg_of(one->cone);
      if (std::find(legs.begin(), legs.end(), leg) != legs.end()) continue;
      legs.push_back(leg);
      names += (names.empty() ? "" : ", ") + leg;
    }
    const auto& [fixed_in, is_stated] = kind;
    const std::string one = shown(narrowest), other = shown(widest);
    return "cones: the " + std::string(legs.size() == 1 ? "rod of " : "rods of ") + names +
           (legs.size() == 1 ? " is" : " are") + " at most " + one + (one == other ? "" : " to " + other) +
           " rad from " + std::to_string(cones.size()) + " axes of the " + fixed_in +
           (is_stated ? ""
                      : ", for limits of " + std::to_string(joints.size()) +
                            (joints.size() == 1 ? " joint" : " joints")) +
           "; --verbose lists them\n";
  }

  const Manipulator& manipulator_;
  std::vector<ask::ConeOfRod> cones_;
};

}  // namespace

std::string cones_text(const Manipulator& manipulator, bool verbose) {
  const ConesReport report(manipulator);
  return verbose ? report.lines() : report.text();
}

}  // namespace parallel_aspects::tools
