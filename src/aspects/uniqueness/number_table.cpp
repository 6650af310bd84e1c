// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/number_table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace parallel_aspects {

int aspect_at(const AspectMap& map, const Pose& pose, const WorkingMode& mode) {
  const int id = map.locate(pose, mode).aspect;
  if (id == 0) return 0;
  return map.aspects()[static_cast<std::size_t>(id - 1)].unresolved_with.empty() ? id : 0;
}

void add_component(BasicComponent component, SolutionNumbers& result) {
  const std::size_t solutions = component.solutions.size();
  auto region = std::find_if(result.regions.begin(), result.regions.end(),
                             [&](const SolutionRegion& each) { return each.solutions >= solutions; });
  if (region == result.regions.end() || region->solutions != solutions)
    region = result.regions.insert(region, {{}, solutions, 0.0, 0.0, 0.0});
  region->measure += component.measure;
  region->measure_lower += component.measure_lower;
  result.basic_components.push_back(std::move(component));
}

void set_unknown(double unknown, SolutionNumbers& result) {
  result.measure_unknown = unknown * rounded_up;
  for (SolutionRegion& region : result.regions)
    region.measure_upper = (region.measure_lower + unknown) * rounded_up;
}

void add_domains(FoundDomains domains, Uniqueness& result) {
  result.domains_complete = domains.complete;
  for (auto& each : domains.domains) {
    UniquenessDomain domain{result.basic_regions[each.front()].aspect, false, std::move(each), 0.0};
    for (const std::size_t region : domain.basic_regions)
      domain.measure_lower += result.basic_regions[region].measure_lower * rounded_down;
    result.domains.push_back(std::move(domain));
  }
}

}  // namespace parallel_aspects
