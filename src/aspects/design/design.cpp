// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/design.h"

#include "aspects/map/map_plan.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

using Values = std::vector<std::optional<double>>;

const std::vector<std::string>& names_of_counts() {
  static const std::vector<std::string> names{"aspects_at_least", "aspects_at_most", "components"};
  return names;
}

void add_counts(const AspectMap& map, Values& values) {
  values.emplace_back(static_cast<double>(map.proved_count()));
  values.emplace_back();
  if (const auto most = map.count_at_most()) values.back() = static_cast<double>(*most);
  values.emplace_back(static_cast<double>(map.aspects().size()));
}

void add_measures(const AspectMap& map, Values& values) {
  double sum = 0.0, largest_lower = 0.0, largest_upper = 0.0;
  for (const Aspect& aspect : map.aspects()) {
    sum += aspect.measure_lower;
    largest_lower = std::max(largest_lower, aspect.measure_lower);
    largest_upper = std::max(largest_upper, aspect.measure_upper);
  }
  for (const double value : {sum, map.measure_undecided(), largest_lower, largest_upper})
    values.emplace_back(value);
}

void add_clearance(const AspectMap& map, Values& values) {
  double clearance = 0.0;
  for (const Aspect& aspect : map.aspects()) clearance = std::max(clearance, aspect.deepest_clearance);
  values.emplace_back(clearance);
}

/// False when cancelled.
bool add_workspace(const AspectMap& map, const DesignQuestion& question, const MapControl& control,
                   Values& values) {
  WorkspaceOptions options;
  options.gap = question.gap;
  options.threads = question.map.threads;
  options.control = control;
  std::vector<int> ids;
  for (const Aspect& aspect : map.aspects()) ids.push_back(aspect.id);
  const auto found = find_regular_workspaces(map, ids, *question.workspace, options);
  if (!found) return false;
  double lower = 0.0, upper = 0.0;
  for (const RegularWorkspace& each : *found) {
    lower = std::max(lower, each.lower);
    upper = std::max(upper, each.upper);
  }
  values.emplace_back(lower);
  values.emplace_back(upper);
  return true;
}

/// Proved: the legs have no position in common.
bool reaches_nothing(const MapPlan& plan) {
  if (!plan.classifier) return false;
  const std::optional<Box> reachable = plan.classifier->reachable_positions();
  if (!reachable) return false;
  for (std::size_t i = 0; i < reachable->dimension; ++i)
    if (reachable->lower[i] > reachable->upper[i]) return true;
  return false;
}

DesignFigures without_map(const Manipulator& manipulator, const DesignQuestion& question,
                          const std::string& message) {
  MapPlan plan;
  const bool is_planned = make_map_plan(manipulator, question.map, plan).empty();
  if (!is_planned && reaches_nothing(plan))
    return {DesignStatus::unassembled, "The legs reach no common pose.", {}};
  return {DesignStatus::not_mapped, message, {}};
}

}  // namespace

std::vector<std::string> figure_names(const DesignQuestion& question) {
  std::vector<std::string> names;
  const auto add = [&names](bool asked, const std::vector<std::string>& more) {
    if (asked) names.insert(names.end(), more.begin(), more.end());
  };
  add(question.count, names_of_counts());
  add(question.measures, {"measure_lower", "measure_undecided", "largest_lower", "largest_upper"});
  add(question.clearance, {"clearance"});
  add(question.workspace.has_value(), {"workspace_lower", "workspace_upper"});
  return names;
}

DesignFigures figures_of(const std::shared_ptr<const Manipulator>& manipulator,
                         const DesignQuestion& question, const MapControl& control) {
  const MapResult result = compute_aspect_map(manipulator, question.map, control);
  if (result.status == MapStatus::cancelled) return {};
  if (result.status == MapStatus::refused) return without_map(*manipulator, question, result.message);
  if (result.map->aspects().empty() && result.map->measure_undecided() == 0.0)
    return {DesignStatus::unassembled, "No pose of the region is in an aspect.", {}};
  DesignFigures figures{DesignStatus::mapped, "", {}};
  if (question.count) add_counts(*result.map, figures.values);
  if (question.measures) add_measures(*result.map, figures.values);
  if (question.clearance) add_clearance(*result.map, figures.values);
  if (question.workspace && !add_workspace(*result.map, question, control, figures.values)) return {};
  return figures;
}

const char* name(DesignStatus status) noexcept {
  switch (status) {
    case DesignStatus::mapped:
      return "mapped";
    case DesignStatus::refused:
      return "refused";
    case DesignStatus::unassembled:
      return "unassembled";
    case DesignStatus::not_mapped:
      return "not_mapped";
    case DesignStatus::cancelled:
      return "cancelled";
  }
  return "";
}

}  // namespace parallel_aspects
