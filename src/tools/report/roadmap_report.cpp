// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/report/reports.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

std::size_t mode_count(const std::vector<ask::SampledSide>& sides) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) count += i == 0 || sides[i].mode != sides[i - 1].mode;
  return count;
}

std::string side_table(const std::vector<ask::SampledSide>& sides) {
  TextTable table({"working mode", "det A", ">samples", ">components, at most", ">share of the largest [%]",
                   ">its largest index"});
  for (const ask::SampledSide& side : sides)
    table.add({to_string(side.mode), shown_sign(side.determinant_sign), std::to_string(side.samples),
               std::to_string(side.component_sizes.size()), shown_briefly(100.0 * side.largest_share()),
               shown_briefly(side.largest_indices.front())});
  return table.text();
}

std::string roadmap_text(const ask::SampledAspects& sampled) {
  const PoseRoadmap& roadmap = *sampled.roadmap;
  const Manipulator& manipulator = *roadmap.certifier().manipulator();
  std::string text = manipulator.name() + ": at least " + counted(roadmap.proved_count(), "aspect") + " in " +
                     counted(mode_count(sampled.sides), "working mode") + ", proved\n" +
                     tolerance_text(manipulator);
  text += "task space " + std::string(name(manipulator.task_space())) + ", a certified roadmap of " +
          counted(roadmap.poses().size(), "sampled pose") + ", seed " +
          std::to_string(roadmap.options().seed) + ", " + shown(roadmap.seconds()) + " s\n\n";
  text += side_table(sampled.sides);
  text += "\nThe samples lie in at most " + counted(roadmap.component_count(), "aspect") +
          ": segments proved free of singularities join them.\n"
          "More samples can only join more of these; aspects that no sample meets are not seen. Indices are "
          "those of samples, so that larger ones may be near by.\n";
  return text;
}

}  // namespace

Report report_roadmap(const Manipulator& robot, const ask::MapAnswer& answer, bool verbose) {
  return constrained_report(robot, answer, roadmap_text(*answer.sampled), verbose);
}

}  // namespace parallel_aspects::tools
