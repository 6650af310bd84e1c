// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_plan.h"

#include "aspects/map/empty_map.h"
#include "aspects/symmetry/robot_symmetry.h"
#include "aspects/tree/pose_tree.h"
#include "aspects/tree/slice_space.h"
#include "model/message_text.h"
#include "model/task_space_traits.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr double most_units_wider = 8.0;

// Twice the middle of the base points: a motion that reverses a coordinate takes the first of them to the
// last.
double twice_the_middle(const Manipulator& manipulator, std::size_t coordinate) {
  const auto i = static_cast<Eigen::Index>(coordinate);
  double first = manipulator.leg(0).base_point()[i], last = first;
  for (const Leg& leg : manipulator.legs()) {
    first = std::min(first, leg.base_point()[i]);
    last = std::max(last, leg.base_point()[i]);
  }
  return first + last;
}

double farthest_of(const Box& box) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < box.dimension; ++i)
    farthest = std::max({farthest, std::abs(box.lower[i]), std::abs(box.upper[i])});
  return farthest;
}

// `box` widened in one coordinate to be its own mirror image, `lower + upper` being `sum` with no rounding.
std::optional<Box> mirrored(Box box, std::size_t i, double sum, double unit) {
  const double half = std::max(box.upper[i] - 0.5 * sum, 0.5 * sum - box.lower[i]);
  const double width = std::ceil(2.0 * half / unit) * unit;
  if (!(width <= box.width(i) + most_units_wider * unit)) return std::nullopt;
  box.lower[i] = 0.5 * (sum - width);
  box.upper[i] = 0.5 * (sum + width);
  if (!is_exact_sum(box.lower[i], box.upper[i], sum) || !has_exact_corners(box.lower[i], box.upper[i]))
    return std::nullopt;
  return box;
}

}  // namespace

Box symmetric_region(const Manipulator& manipulator, const Box& positions, const Box& exact) {
  // Twice as coarse, so that what is added here does not ask for a coarser one.
  const double unit = 2.0 * unit_of_corners(farthest_of(exact));
  Box region = exact;
  for (std::size_t i = 0; i < exact.dimension; ++i) {
    Box widened = exact;
    widened.lower[i] = positions.lower[i];
    widened.upper[i] = positions.upper[i];
    const auto about = mirrored(widened, i, twice_the_middle(manipulator, i), unit);
    if (!about) continue;
    region.lower[i] = about->lower[i];
    region.upper[i] = about->upper[i];
  }
  const auto symmetries = [&manipulator](const Box& of) {
    return find_robot_symmetries(manipulator, of).size();
  };
  return symmetries(region) > symmetries(exact) ? region : exact;
}

namespace {

constexpr int max_extra_levels = 20;

Box at_level(Box box, std::uint32_t level) {
  for (std::size_t i = 0; i < box.dimension; ++i)
    box.upper[i] = box.lower[i] + std::ldexp(box.width(i), -static_cast<int>(level));
  return box;
}

Box unbounded(std::size_t dimension) {
  Box box{dimension, {}, {}};
  box.lower.fill(-HUGE_VAL);
  box.upper.fill(HUGE_VAL);
  return box;
}

/// Longest edge of an angle beside positions where no resolution is given [rad].
double default_angle(std::size_t dimension) { return dimension < 3 ? 0.025 : 0.1; }

double longest_edge(const MapPlan& plan, std::uint32_t level) {
  return plan.space->longest_edge(at_level(plan.space->region(), level));
}

/// Which of x, y and z the coordinates of a map are, in order.
std::vector<Eigen::Index> mapped_positions(const Manipulator& manipulator,
                                           const std::optional<MapSlice>& slice) {
  std::vector<Eigen::Index> result;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(directions(manipulator.task_space())); ++i)
    if (!slice || slice->moves[static_cast<std::size_t>(i)]) result.push_back(i);
  return result;
}

/// Why the workspace holds no pose of the slice; empty otherwise.
std::string find_workspace_problem(const Manipulator& manipulator, const MapPlan& plan) {
  const auto& workspace = manipulator.constraints().workspace;
  if (!workspace || !plan.slice || plan.slice->joint) return "";
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(directions(manipulator.task_space())); ++i) {
    const double held = plan.slice->held.position[i];
    if (!plan.slice->moves[static_cast<std::size_t>(i)] &&
        !(workspace->lower[i] < held && held < workspace->upper[i]))
      return "The slice holds a position outside of the workspace that the constraints of '" +
             manipulator.name() + "' name; hold it inside, or leave the constraint out.";
  }
  return "";
}

/// The coordinate in which a region lies farthest from zero for its width.
struct Farthest {
  std::size_t coordinate = 0;
  double width = 0.0, distance = 0.0;  // [m]
};

Farthest farthest_in_widths(const Box& region) {
  Farthest worst;
  for (std::size_t i = 0; i < region.dimension; ++i) {
    const double distance = std::max(std::abs(region.lower[i]), std::abs(region.upper[i]));
    if (i == 0 || distance * worst.width > worst.distance * region.width(i))
      worst = {i, region.width(i), distance};
  }
  return worst;
}

/// Why these positions, of which all that the workspace leaves is empty or has no `exact_region`, make no
/// map.
std::string why_not_exact(const Manipulator& manipulator, const MapOptions& options, const MapPlan& plan,
                          const Box& region) {
  constexpr double widths_away = 500.0;  // as far as every region may lie
  std::vector<std::string> names;
  for (const Eigen::Index i : mapped_positions(manipulator, plan.slice)) names.emplace_back(1, "xyz"[i]);
  for (std::size_t i = 0; i < region.dimension; ++i)
    if (!std::isfinite(region.lower[i]) || !std::isfinite(region.upper[i]))
      return "The region is not finite in " + names[i] + "; give one that is.";
  for (std::size_t i = 0; i < region.dimension; ++i)
    if (!(region.lower[i] < region.upper[i]))
      return options.region ? "The region is empty in " + names[i] + "; give its lower end first."
                            : "The legs of '" + manipulator.name() +
                                  "' reach no common pose; correct their lengths or limits.";
  if (options.region) {
    const std::string text = why_out_of_reach(region, plan.classifier->reachable_positions(), names);
    if (!text.empty()) return text;
  }
  const Farthest at = farthest_in_widths(region);
  return "The region is " + number_text(at.width, 3) + " m wide in " + names[at.coordinate] + " and " +
         number_text(at.distance, 4) + " m from the origin of the frame '" + manipulator.base_frame() +
         "', which is too far for exact boxes; put the origin of that frame within " +
         number_text(widths_away * at.width, 2) +
         " m of the robot, or name a link that is so near as base_link.";
}

/// The positions that the map covers; the message says why there are none, and is empty otherwise.
std::string find_positions(const Manipulator& manipulator, const MapOptions& options, const MapPlan& plan,
                           Box& positions) {
  const std::size_t free = mapped_positions(manipulator, plan.slice).size();
  if (options.region && options.region->dimension != free && (plan.slice || free > 0))
    return "The region of the map has " + std::to_string(options.region->dimension) +
           " coordinates; give one for each position that is free, which are " + std::to_string(free) + ".";
  if (const std::string problem = find_workspace_problem(manipulator, plan); !problem.empty()) return problem;
  const std::optional<Box> region = within_workspace(
      options.region ? options.region : plan.classifier->reachable_positions(), manipulator, plan.slice);
  if (!region)
    return "The legs of '" + manipulator.name() +
           "' have no limits that bound the workspace; limit the actuated joints in the URDF, leave these "
           "limits in "
           "(actuated_limits), or give a region or a workspace.";
  const std::optional<Box> exact = exact_region(*region);
  if (!exact && manipulator.constraints().workspace && (!options.region || exact_region(*options.region)))
    return "The workspace that the constraints of '" + manipulator.name() + "' name holds no " +
           (options.region ? "position of the region" : "reachable position") +
           ", or is too thin for a map; correct constraints.workspace, or leave it out.";
  if (!exact) return why_not_exact(manipulator, options, plan, *region);
  positions = plan.slice || free == 0 ? *exact : symmetric_region(manipulator, *region, *exact);
  return "";
}

/// The working modes that are mapped, in the order of `working_modes`.
std::string find_modes(const Manipulator& manipulator, const MapOptions& options, MapPlan& plan) {
  const std::vector<WorkingMode> all = working_modes(manipulator);
  const auto holds = [](const std::vector<WorkingMode>& modes, const WorkingMode& mode) {
    return std::find(modes.begin(), modes.end(), mode) != modes.end();
  };
  for (const WorkingMode& mode : options.modes)
    if (!holds(all, mode))
      return "'" + manipulator.name() + "' has no working mode " + to_string(mode) + "; its first is " +
             to_string(all.front()) + ".";
  for (const WorkingMode& mode : all)
    if (options.modes.empty() || holds(options.modes, mode)) plan.modes.push_back(mode);
  return "";
}

/// Whether leaves of this level are as fine as is asked for. Where nothing is asked, angles beside positions
/// have a length of their own, since the unit of length of the robot says nothing of them.
bool is_fine_enough(const MapPlan& plan, const MapOptions& options, double resolution, std::uint32_t level) {
  const PoseSpace& space = *plan.space;
  const Box leaf = at_level(space.region(), level);
  const std::size_t last = leaf.dimension - 1;
  if (options.resolution || !space.is_periodic(last) || space.is_periodic(0))
    return space.longest_edge(leaf) <= resolution;
  for (std::size_t i = 0; i < last; ++i)
    if (leaf.width(i) > resolution) return false;
  return EIGEN_PI * leaf.width(last) <= default_angle(leaf.dimension);
}

std::string make_classifier(const Manipulator& manipulator, const MapOptions& options, MapPlan& plan,
                            const BoxPolicy& policy) {
  if (!options.slice) {
    plan.classifier = make_box_classifier(manipulator, plan.modes, policy);
    return plan.classifier ? ""
                           : "All poses of " + std::string(name(manipulator.task_space())) +
                                 " are more than can be mapped; give a slice of them.";
  }
  std::string problem = find_slice_problem(manipulator, *options.slice);
  if (problem.empty())
    plan.classifier = make_slice_classifier(manipulator, plan.modes, *options.slice, policy);
  plan.slice = options.slice;
  return problem;
}

std::shared_ptr<const PoseSpace> make_space(const Manipulator& manipulator, const MapPlan& plan,
                                            const Box& positions) {
  const double length = manipulator.characteristic_length();
  if (plan.slice && plan.slice->joint) return make_held_joint_space(manipulator, *plan.slice);
  if (plan.slice) return make_slice_space(*plan.slice, positions, length);
  return make_pose_space(manipulator.motions(), positions, length);
}

double default_resolution_of_slice(const Manipulator& manipulator, const MapSlice& slice) {
  if (slice.joint) return default_angle(slice.dimension());
  if (slice.free_positions() == 0) return slice.dimension() == 1 ? 0.01 : 0.1;
  return manipulator.size() / (slice.dimension() < 3 ? 200.0 : 50.0);
}

}  // namespace

std::optional<Box> within_workspace(std::optional<Box> positions, const Manipulator& manipulator,
                                    const std::optional<MapSlice>& slice) {
  const auto& workspace = manipulator.constraints().workspace;
  const std::vector<Eigen::Index> mapped = mapped_positions(manipulator, slice);
  if (!workspace || mapped.empty()) return positions;
  if (!positions) positions = unbounded(mapped.size());
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    positions->lower[i] = std::max(positions->lower[i], workspace->lower[mapped[i]]);
    positions->upper[i] = std::min(positions->upper[i], workspace->upper[mapped[i]]);
  }
  return positions;
}

std::string make_map_plan(const Manipulator& manipulator, const MapOptions& options, MapPlan& plan,
                          const BoxPolicy& policy) {
  std::string problem = find_modes(manipulator, options, plan);
  if (problem.empty()) problem = make_classifier(manipulator, options, plan, policy);
  if (!problem.empty()) return problem;
  const double resolution = options.resolution.value_or(default_resolution(manipulator, options.slice));
  if (!std::isfinite(resolution) || resolution <= 0.0)
    return "The resolution is " + std::to_string(resolution) + " m; give a finite and positive one.";
  if (options.extra_levels < 0 || options.extra_levels > max_extra_levels)
    return "The number of extra levels is " + std::to_string(options.extra_levels) + "; give 0 to 20.";

  Box positions;
  problem = find_positions(manipulator, options, plan, positions);
  if (!problem.empty()) return problem;
  plan.space = make_space(manipulator, plan, positions);
  if (options.use_symmetry && !plan.slice)
    plan.symmetries = find_map_symmetries(manipulator, plan.space->region(), plan.modes);
  const auto is_fine = [&] { return is_fine_enough(plan, options, resolution, plan.depth); };
  while (!is_fine() && plan.depth < PoseTree::deepest_level) ++plan.depth;
  if (!is_fine())
    return "The resolution is too fine for the size of the region, where no box has edges below " +
           number_text(longest_edge(plan, plan.depth), 3) + "; give a coarser one, or leave it out.";
  plan.resolution = longest_edge(plan, plan.depth);
  plan.complete = options.complete;
  plan.deepest_level =
      std::min(PoseTree::deepest_level, plan.depth + static_cast<std::uint32_t>(options.extra_levels));
  return "";
}

double default_resolution(const Manipulator& manipulator, const std::optional<MapSlice>& slice) noexcept {
  if (slice) return default_resolution_of_slice(manipulator, *slice);
  if (has_hinges(manipulator.task_space())) return manipulator.leg_count() == 1 ? 0.01 : default_angle(2);
  const double parts = traits(manipulator.task_space()).resolution_parts;
  return parts > 0.0 ? manipulator.size() / parts : 0.1;
}

}  // namespace parallel_aspects
