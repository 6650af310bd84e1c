// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

double largest_share(const RoadmapSide& side) {
  return static_cast<double>(side.component_sizes.front()) / static_cast<double>(side.poses.size());
}

/// The largest parallel index of a sample, by component.
std::vector<double> largest_indices(const PoseRoadmap& roadmap, const RoadmapSide& side) {
  const Manipulator& manipulator = *roadmap.certifier().manipulator();
  std::vector<double> largest(side.component_sizes.size(), 0.0);
  for (std::size_t i = 0; i < side.poses.size(); ++i) {
    const Pose& pose = roadmap.poses()[side.poses[i]];
    double& known = largest[side.component[i]];
    known = std::max(known, parallel_index(manipulator, pose, inverse(manipulator, pose, side.mode).q));
  }
  return largest;
}

json json_roadmap(const PoseRoadmap& roadmap) {
  const Manipulator& manipulator = *roadmap.certifier().manipulator();
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(manipulator.task_space()))},
                 {"samples", roadmap.poses().size()},
                 {"seed", roadmap.options().seed},
                 {"seconds", json_number(roadmap.seconds())},
                 {"proved_count", roadmap.proved_count()},
                 {"components_at_most", roadmap.component_count()},
                 {"sides", json::array()}};
  for (const RoadmapSide& side : roadmap.sides())
    object["sides"].push_back({{"working_mode", side.mode.signs()},
                               {"determinant_sign", side.determinant_sign},
                               {"samples", side.poses.size()},
                               {"component_sizes", side.component_sizes},
                               {"largest_indices", largest_indices(roadmap, side)},
                               {"largest_share", json_number(largest_share(side))}});
  return object;
}

std::size_t mode_count(const PoseRoadmap& roadmap) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < roadmap.sides().size(); ++i)
    count += i == 0 || roadmap.sides()[i].mode != roadmap.sides()[i - 1].mode;
  return count;
}

std::string side_table(const PoseRoadmap& roadmap) {
  TextTable table({"working mode", "det A", ">samples", ">components, at most", ">share of the largest [%]",
                   ">its largest index"});
  for (const RoadmapSide& side : roadmap.sides())
    table.add({to_string(side.mode), shown_sign(side.determinant_sign), std::to_string(side.poses.size()),
               std::to_string(side.component_sizes.size()), shown_briefly(100.0 * largest_share(side)),
               shown_briefly(largest_indices(roadmap, side).front())});
  return table.text();
}

std::string roadmap_text(const PoseRoadmap& roadmap) {
  const Manipulator& manipulator = *roadmap.certifier().manipulator();
  std::string text = manipulator.name() + ": at least " + counted(roadmap.proved_count(), "aspect") + " in " +
                     counted(mode_count(roadmap), "working mode") + ", proved\n" +
                     tolerance_text(manipulator);
  text += "task space " + std::string(name(manipulator.task_space())) + ", a certified roadmap of " +
          counted(roadmap.poses().size(), "sampled pose") + ", seed " +
          std::to_string(roadmap.options().seed) + ", " + shown(roadmap.seconds()) + " s\n\n";
  text += side_table(roadmap);
  text += "\nThe samples lie in at most " + counted(roadmap.component_count(), "aspect") +
          ": segments proved free of singularities join them.\n"
          "More samples can only join more of these; aspects that no sample meets are not seen. Indices are "
          "those of samples, so that larger ones may be near by.\n";
  return text;
}

}  // namespace

Report report_roadmap(const PoseRoadmap& roadmap, bool verbose) {
  Report report{json_roadmap(roadmap), roadmap_text(roadmap)};
  const Report constraints = report_constraints(*roadmap.certifier().manipulator(), verbose);
  report.json.update(constraints.json);
  report.text += constraints.text;
  return report;
}

}  // namespace parallel_aspects::tools
