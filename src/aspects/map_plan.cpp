// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/map_plan.h"

#include "parallel_aspects/aspects/pose_tree.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int most_extra_levels = 20;

Box at_level(Box box, std::uint32_t level) {
  for (std::size_t i = 0; i < box.dimension; ++i)
    box.upper[i] = box.lower[i] + std::ldexp(box.width(i), -static_cast<int>(level));
  return box;
}

double longest_edge(const MapPlan& plan, std::uint32_t level) {
  return plan.space->longest_edge(at_level(plan.space->region(), level));
}

/// The positions that the map covers; the sentence says why there are none, and is empty otherwise.
std::string find_positions(const Manipulator& manipulator, const MapOptions& options, const MapPlan& plan,
                           Box& positions) {
  const std::optional<Box> region = options.region ? options.region : plan.classifier->reachable_positions();
  if (!region)
    return "The legs of '" + manipulator.name() +
           "' have no limits that bound the workspace; limit the drives in the URDF or give a region.";
  const std::optional<Box> exact = exact_region(*region);
  if (!exact)
    return "The region of the map is empty, not finite, or too far from the origin for its size; give "
           "another "
           "region, or mend the lengths of the legs if they cannot reach a common pose.";
  positions = *exact;
  return "";
}

}  // namespace

std::string make_map_plan(const Manipulator& manipulator, const MapOptions& options, MapPlan& plan) {
  plan.modes = working_modes(manipulator);
  plan.classifier = make_box_classifier(manipulator, plan.modes);
  if (!plan.classifier)
    return "Aspects can not be mapped in the task space " + std::string(name(manipulator.task_space())) +
           " yet.";
  const double resolution = options.resolution.value_or(default_resolution(manipulator));
  if (!std::isfinite(resolution) || resolution <= 0.0)
    return "The resolution is " + std::to_string(resolution) + " m; give a finite and positive one.";
  if (options.extra_levels < 0 || options.extra_levels > most_extra_levels)
    return "The number of extra levels is " + std::to_string(options.extra_levels) + "; give 0 to 20.";

  Box positions;
  const std::string problem = find_positions(manipulator, options, plan, positions);
  if (!problem.empty()) return problem;
  plan.space = make_pose_space(manipulator.task_space(), positions, manipulator.characteristic_length());
  while (longest_edge(plan, plan.depth) > resolution && plan.depth < PoseTree::deepest_level) ++plan.depth;
  if (longest_edge(plan, plan.depth) > resolution)
    return "The resolution is too fine for the size of the region; give a coarser one.";
  plan.resolution = longest_edge(plan, plan.depth);
  plan.deepest_level =
      std::min(PoseTree::deepest_level, plan.depth + static_cast<std::uint32_t>(options.extra_levels));
  return "";
}

double default_resolution(const Manipulator& manipulator) noexcept {
  switch (manipulator.task_space()) {
    case TaskSpace::T1:
    case TaskSpace::T2:
      return manipulator.size() / 200.0;
    case TaskSpace::SE2:
    case TaskSpace::T3:
      return manipulator.size() / 50.0;
    case TaskSpace::SO3:
    case TaskSpace::SE3:
      break;
  }
  return 0.1;
}

}  // namespace parallel_aspects
