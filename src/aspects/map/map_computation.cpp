// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_computation.h"

#include "aspects/components/components.h"
#include "aspects/components/leaf_completion.h"
#include "aspects/components/leaf_refinement.h"
#include "aspects/map/deepest_point.h"
#include "aspects/map/map_contents.h"
#include "aspects/map/map_plan.h"
#include "aspects/simd/box_requests.h"
#include "aspects/star_sets/star_finder.h"
#include "aspects/symmetry/map_symmetry.h"
#include "aspects/tree/joint_progress.h"
#include "interval/interval.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

// Between two blocks progress is reported and cancelling is possible; a block takes some ten milliseconds.
constexpr NodeIndex nodes_per_block = 4096;
constexpr NodeIndex nodes_per_task = 128;

void classify_block(PoseTree& tree, const BoxClassifier& classifier, const LevelSymmetry& symmetry,
                    Detail detail, NodeIndex begin, NodeIndex end) {
  tbb::parallel_for(tbb::blocked_range<NodeIndex>(begin, end, nodes_per_task), [&](const auto& range) {
    const RoundingUpward rounding;
    BoxRequests requests;
    requests.reserve(range.size());
    for (NodeIndex node = range.begin(); node != range.end(); ++node)
      if (const ModeSet modes = symmetry.own_modes(tree, node); modes != 0)
        requests.push_back({tree.place(node).root, tree.box(node), modes, tree.states(node)});
    classify(classifier, requests, detail);
  });
}

bool is_undecided(const PoseTree& tree, NodeIndex node) {
  for (std::size_t mode = 0; mode < tree.mode_count(); ++mode)
    if (tree.state(node, mode).is_undecided()) return true;
  return false;
}

/// Ends early when cancelled.
void divide_undecided(PoseTree& tree, NodeIndex begin, NodeIndex end, const MapControl& control) {
  const auto is_time_to_look = [](std::size_t done) { return done % nodes_per_block == 0; };
  std::vector<NodeIndex> undecided;
  for (NodeIndex node = begin; node != end; ++node) {
    if (is_time_to_look(node - begin) && is_cancelled(control)) return;
    if (is_undecided(tree, node)) undecided.push_back(node);
  }
  tree.reserve_families(undecided.size());
  for (std::size_t i = 0; i < undecided.size(); ++i) {
    if (is_time_to_look(i) && is_cancelled(control)) return;
    tree.divide(undecided[i], [](std::size_t) { return true; });
  }
}

/// Nodes lie along curves and surfaces, so each level costs 2^(d-1) times the one before.
class Progress {
 public:
  Progress(const MapControl& control, std::size_t dimension, std::uint32_t depth)
      : control_(control), growth_(std::ldexp(1.0, static_cast<int>(dimension) - 1)), depth_(depth) {}

  void tell(std::uint32_t level, double share_of_level) const {
    if (!control_.progress) return;
    const double cost_after = std::pow(growth_, static_cast<double>(level) - depth_);
    const double cost_before = level == 0 ? 0.0 : cost_after / growth_;
    control_.progress(cost_before + (cost_after - cost_before) * share_of_level);
  }

 private:
  const MapControl& control_;
  double growth_;
  std::uint32_t depth_;
};

}  // namespace

BaseMapStatus grow_base_map(PoseTree& tree, const BoxClassifier& classifier, std::uint32_t depth,
                            Detail detail, const MapControl& control,
                            const std::vector<MapSymmetry>& symmetries) {
  LevelSymmetry symmetry(tree, symmetries);
  const Progress progress(control, tree.dimension(), depth);
  NodeIndex begin = 0;
  for (std::uint32_t level = 0; level <= depth; ++level) {
    const auto end = static_cast<NodeIndex>(tree.node_count());
    for (NodeIndex block = begin; block < end; block += nodes_per_block) {
      if (is_cancelled(control)) return BaseMapStatus::cancelled;
      const NodeIndex block_end = std::min(end, block + nodes_per_block);
      classify_block(tree, classifier, symmetry, level < depth ? Detail::states : detail, block, block_end);
      progress.tell(level, static_cast<double>(block_end - begin) / (end - begin));
    }
    symmetry.tell(tree);
    if (level < depth) divide_undecided(tree, begin, end, control);
    if (is_cancelled(control)) return BaseMapStatus::cancelled;
    symmetry.descend(tree);
    if (tree.node_count() > max_nodes) return BaseMapStatus::too_large;
    begin = end;
  }
  return BaseMapStatus::complete;
}

namespace {

// Shares of the progress that is shown, about those of the time: of a map without a search for small aspects,
// and of one with it where there are three degrees of freedom.
constexpr double share_of_base_map = 0.9, share_of_complete_base_map = 0.1;

// Graphs of leaves take most of the memory. Those of a large map are in it for so many working modes at a
// time; not for as many as there are threads, so that the same nodes come of any number of these.
constexpr std::size_t nodes_of_a_large_map = 500'000, modes_at_once = 2;

MapResult refused(const std::string& message) { return {MapStatus::refused, message, nullptr}; }

Aspect make_aspect(const WorkingMode& mode, const Component& component) {
  Aspect aspect;
  aspect.mode = mode;
  aspect.determinant_sign = component.determinant_sign;
  aspect.measure = component.measure_estimated;
  aspect.measure_lower = component.measure_inside;
  aspect.measure_upper = component.measure_cluster;
  aspect.inside_leaves = component.leaves.size();
  return aspect;
}

/// Ids of aspects, by mode and by index of the component.
using ComponentIds = std::vector<std::vector<int>>;

/// Positive before negative, and the larger first.
std::vector<std::size_t> order_of(const std::vector<Component>& components) {
  std::vector<std::size_t> order(components.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&components](std::size_t a, std::size_t b) {
    const Component &one = components[a], &other = components[b];
    return std::make_pair(one.determinant_sign, one.measure_estimated) >
           std::make_pair(other.determinant_sign, other.measure_estimated);
  });
  return order;
}

/// The components of one mode become aspects with the next ids, which are returned.
std::vector<int> add_mode(AspectMap::Contents& map, std::size_t mode, const ModeComponents& found) {
  const auto first_id = static_cast<int>(map.aspects.size()) + 1;
  const std::vector<std::size_t> order = order_of(found.components);
  std::vector<int> id(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const Component& component = found.components[order[rank]];
    id[order[rank]] = first_id + static_cast<int>(rank);
    map.aspects.push_back(make_aspect(map.modes[mode], component));
    map.aspects.back().id = id[order[rank]];
    map.aspects.back().bounds = map.tree.space().shown(component.bounds.front());
    map.aspect_bounds.push_back(component.bounds);
    for (const NodeIndex leaf : component.leaves)
      map.leaf_aspects[mode].set(leaf, static_cast<std::uint32_t>(id[order[rank]]));
  }
  for (std::size_t a = 0; a < id.size(); ++a)
    for (std::size_t b = 0; b < id.size(); ++b)
      if (a != b && found.components[a].cluster == found.components[b].cluster)
        map.aspects[static_cast<std::size_t>(id[a] - 1)].unresolved_with.push_back(id[b]);
  for (const auto& [a, b] : found.unresolved)
    map.unresolved.emplace_back(std::min(id[a], id[b]), std::max(id[a], id[b]));
  map.proved_count += found.cluster_count;
  map.indeterminate_leaves += found.indeterminate_leaves;
  map.bound += found.bound;
  map.measure_undecided += found.measure_undecided;
  if (!found.components.empty()) map.existing_modes.push_back(map.modes[mode]);
  return id;
}

/// By id - 1: of the modes that have no representative.
std::vector<ClearPoint> find_deepest_points(const AspectMap::Contents& map,
                                            const std::vector<ModeSource>& sources, const ComponentIds& ids,
                                            const MapControl& control) {
  std::vector<std::pair<std::size_t, int>> tasks;  // mode and id
  for (std::size_t mode = 0; mode < sources.size(); ++mode)
    if (sources[mode].symmetry == nullptr)
      for (const int id : ids[mode]) tasks.emplace_back(mode, id);
  std::vector<ClearPoint> deepest(map.aspects.size());
  tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
    const auto [mode, id] = tasks[i];
    const auto index = static_cast<std::size_t>(id - 1);
    deepest[index] = deepest_point(map, map.aspects[index], mode, control);
  });
  return deepest;
}

void find_deepest_poses(AspectMap::Contents& map, const std::vector<ModeSource>& sources,
                        const ComponentIds& ids, const MapControl& control) {
  const std::vector<ClearPoint> deepest = find_deepest_points(map, sources, ids, control);
  for (std::size_t mode = 0; mode < sources.size(); ++mode) {
    const auto [representative, symmetry] = sources[mode];
    for (std::size_t i = 0; i < ids[mode].size(); ++i) {
      const ClearPoint& point = deepest[static_cast<std::size_t>(ids[representative][i] - 1)];
      const MapPosition at = symmetry == nullptr ? point.position : symmetry->poses.image(point.position);
      Aspect& aspect = map.aspects[static_cast<std::size_t>(ids[mode][i] - 1)];
      aspect.deepest = map.tree.space().pose(at);
      aspect.deepest_clearance = map.tree.space().proved_radius(at.point, point.clearance);
    }
  }
}

/// Components of these modes, with contested leaves refined. False when cancelled.
bool find_components_of(const std::vector<std::size_t>& modes, AspectMap::Contents& map, const MapPlan& plan,
                        const MapControl& control, const ComponentPolicy& policy,
                        std::vector<ModeComponents>& found) {
  std::vector<std::unique_ptr<LeafGraph>> graphs(modes.size());
  tbb::parallel_for(std::size_t{0}, graphs.size(), [&](std::size_t i) {
    const bool everywhere = looks_everywhere(map.tree, modes[i], policy);
    if (everywhere) look_into_leaves(map.tree, *map.classifier, modes[i], control);
    graphs[i] = std::make_unique<LeafGraph>(map.tree, modes[i], everywhere, control, policy);
  });
  if (!refine_contested(map.tree, *map.classifier, graphs, plan.depth, plan.deepest_level, control, policy))
    return false;
  const bool is_cheap = map.tree.dimension() <= policy.max_degrees_of_freedom_to_look_everywhere;
  const bool has_stars = (map.complete || is_cheap) && !map.slice;
  const auto stars = has_stars ? make_star_finder(*map.manipulator, map.modes) : nullptr;
  const std::size_t boxes =
      map.complete ? std::numeric_limits<std::size_t>::max() : policy.max_boxes_for_stars;
  JointProgress progress(control, graphs.size());
  tbb::parallel_for(std::size_t{0}, graphs.size(), [&](std::size_t i) {
    if (stars) complete_leaves(map.tree, *map.classifier, *stars, boxes, *graphs[i], progress.of(i), policy);
    found[modes[i]] = find_components(map.tree, modes[i], *graphs[i], control);
    graphs[i].reset();
  });
  return true;
}

/// Components of every mode. Nothing when cancelled.
std::vector<ModeComponents> find_all_components(AspectMap::Contents& map, const MapPlan& plan,
                                                const std::vector<ModeSource>& sources,
                                                const MapControl& control, const ComponentPolicy& policy) {
  std::vector<std::size_t> representatives;
  for (std::size_t mode = 0; mode < sources.size(); ++mode)
    if (sources[mode].symmetry == nullptr) representatives.push_back(mode);
  const std::size_t at_once =
      map.tree.node_count() > nodes_of_a_large_map ? modes_at_once : representatives.size();
  std::vector<ModeComponents> found(sources.size());
  for (std::size_t first = 0; first < representatives.size(); first += at_once) {
    const std::size_t last = std::min(first + at_once, representatives.size());
    const std::vector<std::size_t> modes(representatives.begin() + static_cast<std::ptrdiff_t>(first),
                                         representatives.begin() + static_cast<std::ptrdiff_t>(last));
    const auto share = [&](std::size_t done) {
      return static_cast<double>(done) / static_cast<double>(representatives.size());
    };
    const MapControl part = part_of(control, share(first), share(last));
    if (!find_components_of(modes, map, plan, part, policy, found)) return {};
  }
  mirror_modes(map.tree, plan.symmetries, sources, found);
  return found;
}

SymmetryUse symmetry_use(const std::vector<MapSymmetry>& symmetries, const std::vector<ModeSource>& sources) {
  SymmetryUse use;
  for (const MapSymmetry& symmetry : symmetries) use.motions.push_back(symmetry.text);
  for (const ModeSource& source : sources) use.computed_modes += source.symmetry == nullptr;
  return use;
}

/// The aspects, from the base map. False when cancelled.
bool add_aspects(AspectMap::Contents& map, const MapPlan& plan, const MapControl& control,
                 const ComponentPolicy& policy) {
  const std::size_t count = plan.modes.size();
  const std::vector<ModeSource> sources = find_mode_sources(plan.symmetries, count);
  map.symmetry_use = symmetry_use(plan.symmetries, sources);
  const std::vector<ModeComponents> found = find_all_components(map, plan, sources, control, policy);
  if (found.empty() || is_cancelled(control)) return false;
  map.leaf_aspects.resize(count);
  ComponentIds ids;
  for (std::size_t mode = 0; mode < count && !is_cancelled(control); ++mode)
    ids.push_back(add_mode(map, mode, found[mode]));
  if (is_cancelled(control)) return false;
  find_deepest_poses(map, sources, ids, control);
  return !is_cancelled(control);
}

/// A map that is yet to be computed.
std::unique_ptr<AspectMap::Contents> planned(std::shared_ptr<const Manipulator> manipulator, MapPlan& plan) {
  auto map = std::make_unique<AspectMap::Contents>(std::move(manipulator), std::move(plan.classifier),
                                                   PoseTree(plan.space, plan.modes.size()), plan.modes);
  map->slice = plan.slice;
  map->resolution = plan.resolution;
  map->depth = plan.depth;
  map->deepest_level = plan.deepest_level;
  map->complete = plan.complete;
  return map;
}

BaseMapStatus grow(AspectMap::Contents& map, const MapPlan& plan, const MapControl& control,
                   const ComponentPolicy& policy) {
  const bool is_long =
      map.complete && map.tree.dimension() > policy.max_degrees_of_freedom_to_look_everywhere;
  const double share = is_long ? share_of_complete_base_map : share_of_base_map;
  const BaseMapStatus base =
      grow_base_map(map.tree, *map.classifier, plan.depth, detail_of_base_map(map.tree.dimension()),
                    part_of(control, 0.0, share), plan.symmetries);
  if (base != BaseMapStatus::complete) return base;
  const bool is_done = add_aspects(map, plan, part_of(control, share, 1.0), policy);
  return is_done ? BaseMapStatus::complete : BaseMapStatus::cancelled;
}

}  // namespace

MapResult compute_aspect_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                             const MapControl& control) {
  return compute_aspect_map(std::move(manipulator), options, control, ComponentPolicy());
}

MapResult compute_aspect_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                             const MapControl& control, const ComponentPolicy& policy) {
  const auto start = std::chrono::steady_clock::now();
  MapPlan plan;
  const std::string problem = make_map_plan(*manipulator, options, plan, policy.boxes);
  if (!problem.empty()) return refused(problem);

  auto map = planned(std::move(manipulator), plan);
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                             : static_cast<int>(options.threads));
  const BaseMapStatus status = arena.execute([&] { return grow(*map, plan, control, policy); });
  if (status == BaseMapStatus::cancelled)
    return {MapStatus::cancelled, "The computation was cancelled.", nullptr};
  if (status == BaseMapStatus::too_large)
    return refused("The map takes more than " + std::to_string(max_nodes / 1'000'000) +
                   " million boxes at this resolution; give a coarser one or a smaller region.");
  map->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (control.progress) control.progress(1.0);
  return {MapStatus::complete, "", std::make_shared<const AspectMap>(std::move(map))};
}

}  // namespace parallel_aspects
