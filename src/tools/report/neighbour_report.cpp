// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/reports.h"
#include "tools/report/text_table.h"

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

std::string leg_name(const AspectMap& map, const Neighbours& pair) {
  return map.manipulator()->leg(pair.leg).name;
}

json json_neighbours(const AspectMap& map, const Neighbours& pair) {
  const bool serial = pair.crossing == Crossing::serial;
  return {{"aspects", {pair.first, pair.second}},
          {"crossing", name(pair.crossing)},
          {"leg", serial ? json(leg_name(map, pair)) : json(nullptr)},
          {"proved", pair.proved},
          {"pose", json_pose(map.manipulator()->task_space(), pair.pose)}};
}

std::string neighbours_text(const AspectMap& map, const std::vector<Neighbours>& neighbours) {
  if (neighbours.empty()) return "\naspects that touch: none were found\n";
  TextTable table({">aspect", ">touches", "through", "", "near"});
  for (const Neighbours& pair : neighbours)
    table.add({std::to_string(pair.first), std::to_string(pair.second),
               pair.crossing == Crossing::serial ? "B_jj = 0 of " + leg_name(map, pair) : "det A = 0",
               pair.proved ? "proved" : "possible", to_string(map.manipulator()->task_space(), pair.pose)});
  return "\naspects that touch:\n" + table.text();
}

/// The leg across whose singularity no neighbours are looked for, since its joint is held; null without one.
json held_leg(const AspectMap& map) {
  if (!map.slice() || !map.slice()->joint) return nullptr;
  const Leg& leg = map.manipulator()->leg(map.slice()->joint->leg);
  return leg.kind().moves_proximal_point ? json(leg.name) : json(nullptr);
}

}  // namespace

void add_neighbours(const AspectMap& map, const std::vector<Neighbours>& neighbours, Report& report) {
  report.json["neighbours"] = json::array();
  for (const Neighbours& pair : neighbours) report.json["neighbours"].push_back(json_neighbours(map, pair));
  report.text += neighbours_text(map, neighbours);
  report.json["neighbours_not_across"] = held_leg(map);
  if (!held_leg(map).is_null())
    report.text += "those across B_jj = 0 of " + held_leg(map).get<std::string>() +
                   ", whose joint is held, are not looked for\n";
}

}  // namespace parallel_aspects::tools
