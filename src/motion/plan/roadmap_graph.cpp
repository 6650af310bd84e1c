// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/serial_margin.h"
#include "aspects/graph/joined_sets.h"
#include "aspects/map/gate_crossings.h"
#include "aspects/roadmap/pose_sampler.h"
#include "motion/plan/roadmap_paths.h"
#include "parallel_aspects/motion/plan_path.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

// Of each part: poses that it is looked from, and those that it is looked towards, over all of these.
constexpr std::size_t bases_of_a_part = 12, targets_of_a_part = 240;
constexpr std::size_t proofs_of_a_pair = 8, crossings_from_a_side = 3;
constexpr std::size_t crossings_of_a_gate = 6;

using Key = std::tuple<int, int, std::size_t>;  // the lower id, the higher one, the leg

/// Which part of each side a pose belongs to.
class Parts {
 public:
  explicit Parts(const PoseRoadmap& roadmap) : roadmap_(roadmap) {
    int next = 1;
    for (const RoadmapSide& side : roadmap.sides()) {
      first_.push_back(next);
      for (const std::size_t size : side.component_sizes)
        list_.push_back({next++, side.mode, side.determinant_sign, size});
    }
  }

  const std::vector<RoadmapPart>& list() const noexcept { return list_; }

  /// The id; 0 where the pose is not one of that mode and sign.
  int of(std::uint32_t pose, const WorkingMode& mode, int sign) const {
    const RoadmapSide* side = roadmap_.side(mode, sign);
    if (side == nullptr) return 0;
    const auto found = std::lower_bound(side->poses.begin(), side->poses.end(), pose);
    if (found == side->poses.end() || *found != pose) return 0;
    return id(static_cast<std::size_t>(side - roadmap_.sides().data()),
              static_cast<std::size_t>(found - side->poses.begin()));
  }

  /// Of a pose by its place in the side.
  int id(std::size_t side, std::size_t place) const {
    return first_[side] + static_cast<int>(roadmap_.sides()[side].component[place]);
  }

 private:
  const PoseRoadmap& roadmap_;
  std::vector<int> first_;  // id, by side
  std::vector<RoadmapPart> list_;
};

/// Gates that lead out of one side.
class SideSearch {
 public:
  SideSearch(const PoseRoadmap& roadmap, const Parts& parts, std::size_t side, const MapControl& control)
      : roadmap_(roadmap),
        parts_(parts),
        index_(side),
        side_(roadmap.sides()[side]),
        gates_(roadmap),
        sampler_(roadmap.certifier().manipulator(), roadmap.options().seed + 3 + side,
                 roadmap.options().region, roadmap.options().largest_rotation),
        control_(control) {}

  std::map<Key, std::vector<GateCrossing>> run() {
    const std::vector<std::size_t> places = bases();
    std::vector<std::size_t> count(side_.component_sizes.size());
    for (const std::size_t place : places) ++count[side_.component[place]];
    for (const std::size_t place : places)
      for (std::size_t i = 0; i < targets_of_a_part / count[side_.component[place]]; ++i) {
        if (is_cancelled(control_)) return {};
        if (const auto target = sampler_.draw()) look(place, *target);
      }
    return std::move(found_);
  }

 private:
  /// Places in the side, some of each part, spread over the order in which they were sampled.
  std::vector<std::size_t> bases() const {
    std::vector<std::size_t> seen(side_.component_sizes.size()), result;
    for (std::size_t place = 0; place < side_.poses.size(); ++place) {
      const std::size_t size = side_.component_sizes[side_.component[place]];
      const std::size_t step = std::max<std::size_t>(1, size / bases_of_a_part);
      if (seen[side_.component[place]]++ % step == 0) result.push_back(place);
    }
    return result;
  }

  void look(std::size_t place, const Pose& target) {
    const std::uint32_t pose = side_.poses[place];
    const Pose& base = roadmap_.poses()[pose];
    RoadmapGates::Candidate candidate;
    if (!gates_.find_end({base, side_.mode}, target, side_.determinant_sign, candidate)) return;
    const WorkingMode other = with_other_posture(side_.mode, candidate.leg);
    const int here = parts_.id(index_, place), there = parts_.of(pose, other, side_.determinant_sign);
    if (there == 0) return;
    const Key key{std::min(here, there), std::max(here, there), candidate.leg};
    if (found_[key].size() >= crossings_from_a_side || tried_[key]++ >= proofs_of_a_pair) return;
    RoadmapGate gate;
    if (!is_free(base, candidate.outer, side_.mode) || !is_free(base, candidate.outer, other) ||
        !gates_.prove(candidate, side_.mode, gate))
      return;
    const double index = crossing_index(*roadmap_.certifier().manipulator(), gate.outer, side_.mode,
                                        Crossing::serial, candidate.leg);
    found_[key].push_back({{base, gate.outer, gate.inner}, gate.inner, index});
  }

  bool is_free(const Pose& from, const Pose& to, const WorkingMode& mode) const {
    return roadmap_.certifier().prove(from, to, mode).verdict == SegmentVerdict::free;
  }

  const PoseRoadmap& roadmap_;
  const Parts& parts_;
  std::size_t index_;
  const RoadmapSide& side_;
  RoadmapGates gates_;
  PoseSampler sampler_;
  const MapControl& control_;
  std::map<Key, std::vector<GateCrossing>> found_;
  std::map<Key, std::size_t> tried_;
};

Neighbours gate_of(const Key& key, std::vector<GateCrossing> crossings) {
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const GateCrossing& a, const GateCrossing& b) { return a.index > b.index; });
  if (crossings.size() > crossings_of_a_gate) crossings.resize(crossings_of_a_gate);
  const auto [first, second, leg] = key;
  const Pose pose = crossings.front().pose;
  return {first, second, Crossing::serial, leg, true, pose, std::move(crossings)};
}

/// Of all sides, with both directions of a gate together.
std::vector<Neighbours> find_gates(const PoseRoadmap& roadmap, const Parts& parts,
                                   const MapControl& control) {
  const std::size_t count = roadmap.sides().size();
  std::map<Key, std::vector<GateCrossing>> all;
  for (std::size_t side = 0; side < count && !is_cancelled(control); ++side) {
    for (auto& [key, crossings] : SideSearch(roadmap, parts, side, control).run())
      for (const GateCrossing& crossing : crossings) all[key].push_back(crossing);
    if (control.progress) control.progress(static_cast<double>(side + 1) / static_cast<double>(count));
  }
  std::vector<Neighbours> gates;
  for (auto& [key, crossings] : all) gates.push_back(gate_of(key, std::move(crossings)));
  return gates;
}

}  // namespace

std::optional<RoadmapGraph> compute_roadmap_graph(const PoseRoadmap& roadmap, const MapControl& control) {
  const Parts parts(roadmap);
  RoadmapGraph result;
  result.parts = parts.list();
  const Manipulator& robot = *roadmap.certifier().manipulator();
  if (!has_serial_margin(robot) && working_modes(robot).size() > 1)
    result.graph.gates = find_gates(roadmap, parts, control);
  if (is_cancelled(control)) return std::nullopt;
  std::vector<int> signs;
  for (const RoadmapPart& part : result.parts) signs.push_back(part.determinant_sign);
  result.graph.sets = joined_sets(signs, result.graph.gates);
  group_sets([](int, int) { return true; }, result.graph);
  return result;
}

}  // namespace parallel_aspects
