// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/aspect_paths.h"

#include "aspects/map/map_contents.h"
#include "aspects/roadmap/roadmap_growth.h"
#include "motion/plan/end_aspects.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int max_leaf_paths = 30;  // that are tried, of which a segment is not proved

bool is_same(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

}  // namespace

AspectPaths::AspectPaths(std::shared_ptr<const AspectMap> map) : map_(std::move(map)), segments_(map_) {}

bool AspectPaths::is_free(const Pose& from, const Pose& to, const Aspect& aspect) const {
  return segments_.is_free(from, to, aspect.mode, aspect.determinant_sign);
}

SegmentsInMode AspectPaths::segments_of(const Aspect& aspect) const {
  return {[this, &aspect](const Pose& from, const Pose& to) { return is_free(from, to, aspect); },
          [this](const Pose& from, const Pose& to, double t) { return segments_.between(from, to, t); },
          [this](const Pose& from, const Pose& to) { return segments_.turn(from, to); }, *map_->manipulator(),
          aspect.mode};
}

/// No path keeps an index that is larger than those of its ends.
std::vector<Pose> AspectPaths::find(int aspect, const Pose& from, const Pose& to, const PathShape& shape,
                                    const MapControl& control) {
  control_.cancelled = control.cancelled;
  const Aspect& in = map_->aspects()[static_cast<std::size_t>(aspect - 1)];
  const SegmentsInMode segments = segments_of(in);
  const Manipulator& robot = *map_->manipulator();
  const double wanted =
      shape.is_wide ? std::min(index_at(robot, from, in.mode), index_at(robot, to, in.mode)) : 0.0;
  if (segments.is_free(from, to) &&
      (!shape.is_wide || least_index_along({from, to}, segments) >= shape.kept_share * wanted))
    if (std::vector<Pose> straight = with_short_turns({from, to}, segments); !straight.empty())
      return straight;
  const std::vector<Pose> path =
      shape.is_wide ? find_wide(in, from, to, wanted) : find_any(in, from, to, wanted);
  if (path.empty() || is_cancelled(control_)) return {};
  const double kept = shape.is_wide ? shape.kept_share * least_index_along(path, segments) : 0.0;
  std::vector<Pose> best = with_short_turns(shortened(path, segments, kept), segments);
  return best.empty() ? with_short_turns(path, segments) : best;
}

std::vector<Pose> AspectPaths::find_any(const Aspect& aspect, const Pose& from, const Pose& to,
                                        double wanted_index) {
  std::vector<Pose> path = find_through_leaves(aspect, from, to, Beside::nothing, wanted_index);
  return path.empty() ? find_between_parts(aspect, from, to) : path;
}

std::vector<Pose> AspectPaths::find_wide(const Aspect& aspect, const Pose& from, const Pose& to,
                                         double wanted_index) {
  const auto known = std::find_if(wide_paths_.begin(), wide_paths_.end(), [&](const WidePath& each) {
    return each.aspect == aspect.id && is_same(each.from, from) && is_same(each.to, to);
  });
  if (known != wide_paths_.end()) return known->poses;
  std::vector<Pose> path = find_any(aspect, from, to, wanted_index);
  if (!is_cancelled(control_)) wide_paths_.push_back({aspect.id, from, to, path});
  return path;
}

/// From one part to another the way is searched for once: what is found leads on from all poses of the one to
/// all of the other, since inside leaves connect each of them with its part.
std::vector<Pose> AspectPaths::find_between_parts(const Aspect& aspect, const Pose& from, const Pose& to) {
  const std::optional<Parts> key = parts(aspect, from, to);
  if (!key) return search_between_parts(aspect, from, to);
  const auto known = links_.find(*key);
  if (known == links_.end()) {
    const std::vector<Pose> link = search_between_parts(aspect, from, to);
    if (is_cancelled(control_)) return {};
    links_[*key] = link;
    const auto [id, one, other] = *key;
    links_[{id, other, one}].assign(link.rbegin(), link.rend());
    return link;
  }
  const std::vector<Pose>& link = known->second;
  if (link.empty()) return {};
  std::vector<Pose> path = find_through_leaves(aspect, from, link.front(), Beside::nothing);
  const std::vector<Pose> rest = find_through_leaves(aspect, link.back(), to, Beside::nothing);
  if (path.empty() || rest.empty()) return {};
  path.insert(path.end(), link.begin() + 1, link.end());
  path.insert(path.end(), rest.begin() + 1, rest.end());
  return path;
}

/// Nothing where it is one, or an end is not proved to lie in one.
std::optional<AspectPaths::Parts> AspectPaths::parts(const Aspect& aspect, const Pose& from, const Pose& to) {
  const std::vector<NodeIndex> first = proved_leaves(aspect, from), last = proved_leaves(aspect, to);
  if (first.empty() || last.empty()) return std::nullopt;
  FaceComponents& connected = components(aspect);
  const NodeIndex one = connected.part_of(first.front()), other = connected.part_of(last.front());
  if (one == other) return std::nullopt;
  return Parts{aspect.id, one, other};
}

std::vector<Pose> AspectPaths::search_between_parts(const Aspect& aspect, const Pose& from, const Pose& to) {
  std::vector<Pose> path = find_by_climbs(aspect, from, to);
  for (const Beside beside : {Beside::passages, Beside::undecided})
    if (path.empty() && !is_cancelled(control_)) path = find_through_leaves(aspect, from, to, beside);
  if (is_cancelled(control_)) return {};
  return path.empty() ? find_in_roadmap(aspect, from, to) : shortened(path, segments_of(aspect), 0.0);
}

FaceComponents& AspectPaths::components(const Aspect& aspect) {
  const std::size_t mode = *mode_index(map_->contents(), aspect.mode);
  return components_.try_emplace(mode, map_->contents(), mode).first->second;
}

/// Null where it is cancelled.
const LeafPassages* AspectPaths::climbs(const Aspect& aspect) {
  auto known = climbs_.find(aspect.id);
  if (known == climbs_.end()) {
    LeafPassages found = climbs_between_parts(map_->contents(), aspect, components(aspect), control_);
    if (is_cancelled(control_)) return nullptr;
    known = climbs_.emplace(aspect.id, std::move(found)).first;
  }
  return &known->second;
}

/// Those near the pose to which a segment is proved: to search for paths to others is in vain.
std::vector<NodeIndex> AspectPaths::proved_leaves(const Aspect& aspect, const Pose& pose) const {
  std::vector<NodeIndex> result;
  for (const NodeIndex leaf : leaves_near(map_->contents(), aspect, pose))
    if (is_free(pose, nearest_in(map_->contents(), leaf, pose), aspect)) result.push_back(leaf);
  return result;
}

/// Where a segment is not proved, the next path goes elsewhere.
std::vector<Pose> AspectPaths::find_through_leaves(const Aspect& aspect, const Pose& from, const Pose& to,
                                                   Beside beside, double wanted_index) {
  const std::size_t mode = *mode_index(map_->contents(), aspect.mode);
  LeafChoice choice{proved_leaves(aspect, from), proved_leaves(aspect, to), beside == Beside::undecided};
  choice.wanted_index = wanted_index;
  choice.control = control_;
  PassageProofs proofs;  // of all rounds
  if (beside == Beside::passages) {
    choice.passages = climbs(aspect);
    if (choice.passages == nullptr) return {};
    choice.proofs = &proofs;
    choice.is_free = [&](const Pose& one, const Pose& other) { return is_free(one, other, aspect); };
  }
  for (int i = 0; i < max_leaf_paths && !is_cancelled(control_); ++i) {
    const std::vector<LeafStep> steps =
        find_leaf_path(map_->contents(), components(aspect), indices_[mode], aspect.id, from, to, choice);
    bool is_proved = true;
    NodeIndex before = no_node;  // the leaf that the path comes from
    for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
      if (steps[k].leaf != steps[k + 1].leaf) before = steps[k].leaf;
      if (is_free(steps[k].pose, steps[k + 1].pose, aspect)) continue;
      is_proved = false;
      choice.barred.insert({before, steps[k + 1].leaf});
    }
    if (!is_proved) continue;
    std::vector<Pose> path;
    for (const LeafStep& step : steps) path.push_back(step.pose);
    return path;
  }
  return {};
}

/// Small parts of an aspect by its boundary that no inside leaves connect with the rest: there a climb leads
/// out, as when the map was computed.
std::vector<Pose> AspectPaths::find_by_climbs(const Aspect& aspect, const Pose& from, const Pose& to) {
  std::vector<Pose> start = climb_to(aspect, from, proved_leaves(aspect, to)), goal{to};
  if (start.empty()) {
    start = {from};
    goal = climb_to(aspect, to, proved_leaves(aspect, from));
  }
  if (goal.empty()) return {};
  std::vector<Pose> path = find_through_leaves(aspect, start.back(), goal.back(), Beside::nothing);
  if (path.empty()) return {};
  path.insert(path.begin(), start.begin(), start.end() - 1);
  path.insert(path.end(), goal.rbegin() + 1, goal.rend());
  return path;
}

/// Up to a pose in a leaf that is connected with one of `leaves`.
std::vector<Pose> AspectPaths::climb_to(const Aspect& aspect, const Pose& from,
                                        const std::vector<NodeIndex>& leaves) {
  FaceComponents& connected = components(aspect);
  return climb(*map_, segments_, from, aspect.mode, aspect.determinant_sign, [&](const Pose& at) {
    const std::vector<NodeIndex> near = leaves_near(map_->contents(), aspect, at);
    return std::any_of(near.begin(), near.end(), [&](NodeIndex one) {
      return std::any_of(leaves.begin(), leaves.end(),
                         [&](NodeIndex other) { return connected.are_connected(one, other); });
    });
  });
}

/// Aspects are joined by more than faces of inside leaves; there poses are sampled.
std::vector<Pose> AspectPaths::find_in_roadmap(const Aspect& aspect, const Pose& from, const Pose& to) {
  if (map_->slice()) return {};
  std::shared_ptr<const PoseRoadmap>& roadmap = roadmaps_[aspect.mode.index()];
  if (!roadmap) {
    RoadmapOptions options;
    options.modes = {aspect.mode};
    roadmap = compute_pose_roadmap(map_->manipulator(), options, control_).roadmap;
  }
  return roadmap
             ? PathSearch(*roadmap, aspect.mode, aspect.determinant_sign).find(from, to, SearchEffort::brief)
             : std::vector<Pose>();
}

}  // namespace parallel_aspects
