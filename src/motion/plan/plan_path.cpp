// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/plan_path.h"

#include "aspects/constraints/serial_margin.h"
#include "aspects/map/map_contents.h"
#include "motion/plan/aspect_paths.h"
#include "motion/plan/end_aspects.h"
#include "motion/plan/gate_route.h"
#include "motion/plan/leaf_path.h"
#include "motion/plan/path_builder.h"
#include "motion/plan/unresolved_text.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int max_routes = 10;  // that are followed, of which a part is not found

PlannedPath not_in_aspect(const std::string& which, const EndAspects& end) {
  return without_path(end.all_known ? SameAspect::no : SameAspect::unknown,
                      "No aspect of the map holds the " + which + ": " + end.reasons.text() + ".");
}

const Aspect& aspect_of(const AspectMap& map, int id) {
  return map.aspects()[static_cast<std::size_t>(id - 1)];
}

/// Whether some pair of ends fulfils a condition on two aspects.
template <class Condition>
bool any_pair(const EndAspects& starts, const EndAspects& goals, const Condition& condition) {
  return std::any_of(starts.found.begin(), starts.found.end(), [&](const PoseInAspect& start) {
    return std::any_of(goals.found.begin(), goals.found.end(),
                       [&](const PoseInAspect& goal) { return condition(start.aspect, goal.aspect); });
  });
}

}  // namespace

struct PathPlanner::Parts {
  explicit Parts(std::shared_ptr<const AspectMap> aspect_map) : map(std::move(aspect_map)), paths(map) {}

  std::shared_ptr<const AspectMap> map;
  AspectPaths paths;
  std::shared_ptr<const AspectGraph> graph;
  std::map<std::pair<int, int>, std::string> unresolved;  // the message about two aspects that may be one
};

/// The answer to one question.
class PathPlanner::Search {
 public:
  Search(PathPlanner& planner, const PathWish& wish, const MapControl& control)
      : planner_(planner),
        map_(*planner.parts_->map),
        paths_(planner.parts_->paths),
        wish_(wish),
        control_(control) {}

  PlannedPath run(const PathEnd& from, const PathEnd& to) {
    const EndAspects starts = find_aspects(map_, paths_.segments(), from),
                     goals = find_aspects(map_, paths_.segments(), to);
    if (starts.found.empty()) return not_in_aspect("start", starts);
    if (goals.found.empty()) return not_in_aspect("goal", goals);
    BestPath choice(*map_.manipulator(), wish_);
    paths_.forget_wide_paths();
    for (const PathShape& shape : shapes_for(wish_.prefer)) {
      shape_ = shape;
      PlannedPath found = find(starts, goals);
      if (is_cancelled(control_)) return without_path(SameAspect::unknown, "Cancelled.");
      if (!found && !choice.has_path()) return found;
      const bool is_best = wish_.prefer == PathPreference::shortest && is_straight(found);
      choice.offer(std::move(found));
      if (is_best) break;
    }
    return choice.take();
  }

 private:
  PlannedPath find(const EndAspects& starts, const EndAspects& goals) {
    PlannedPath found = stay(starts, goals);
    if (found || wish_.policy == PathPolicy::stay) return found;
    if (wish_.policy == PathPolicy::serial && has_serial_margin(*map_.manipulator())) {
      found.message += " The serial margin shuts out all gates of B_jj = 0.";
      return found;
    }
    return pass_gates(starts, goals, wish_.policy);
  }

  PlannedPath stay(const EndAspects& starts, const EndAspects& goals) {
    BestPath best(*map_.manipulator(), wish_);
    bool any_common = false;
    GateRoute direct;
    direct.stretches.emplace_back();
    for (const PoseInAspect& start : starts.found)
      for (const PoseInAspect& goal : goals.found) {
        if (start.aspect != goal.aspect) continue;
        any_common = true;
        BarredStretches barred;
        best.offer(follow(direct, start, goal, barred));
      }
    if (best.has_path()) return best.take();
    return any_common
               ? without_path(SameAspect::unknown, "The ends lie in one aspect, but no path was found.")
               : no_common_aspect(starts, goals);
  }

  PlannedPath no_common_aspect(const EndAspects& starts, const EndAspects& goals) const {
    const bool may_share =
        any_pair(starts, goals, [this](int first, int second) { return may_be_one(map_, first, second); });
    if (may_share) return without_path(SameAspect::unknown, shared_text(starts, goals));
    if (!starts.all_known || !goals.all_known)
      return without_path(SameAspect::unknown, "No aspect of the map is known to hold both ends.");
    std::set<std::string> reasons;
    any_pair(starts, goals, [&](int first, int second) {
      reasons.insert(difference(aspect_of(map_, first), aspect_of(map_, second)));
      return false;
    });
    std::string text;
    for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
    return without_path(SameAspect::no, "Proved: no aspect holds both ends: " + text + ".");
  }

  /// Of the first two aspects that may be one.
  std::string shared_text(const EndAspects& starts, const EndAspects& goals) const {
    std::pair<int, int> pair;
    any_pair(starts, goals, [&](int first, int second) {
      pair = std::minmax(first, second);
      return may_be_one(map_, first, second);
    });
    std::string& text = planner_.parts_->unresolved[pair];
    if (text.empty()) text = unresolved_text(map_, pair.first, pair.second, control_);
    return "No aspect of the map is known to hold both ends: " + text;
  }

  /// A note on proofs by leaves of a slice: a path that leaves the slice is not excluded.
  std::string within_slice() const { return map_.slice() ? " within the slice" : ""; }

  std::string difference(const Aspect& one, const Aspect& other) const {
    if (one.mode != other.mode)
      return "the working modes are " + to_string(one.mode) + " and " + to_string(other.mode);
    const std::string in_mode = "in " + to_string(one.mode);
    return one.determinant_sign != other.determinant_sign
               ? in_mode + " the sign of det A differs"
               : in_mode + " the map proves aspects " + std::to_string(one.id) + " and " +
                     std::to_string(other.id) + " apart within its region" + within_slice();
  }

  PlannedPath pass_gates(const EndAspects& starts, const EndAspects& goals, PathPolicy policy) {
    const AspectGraph* graph = planner_.graph(control_);
    if (graph == nullptr) return without_path(SameAspect::unknown, "Cancelled.");
    BarredStretches barred;
    bool has_route = false;
    for (int i = 0; i < max_routes && !is_cancelled(control_); ++i) {
      const auto route =
          find_gate_route(map_, *graph, starts.found, goals.found, {policy, shape_.is_wide}, barred);
      if (!route) break;
      has_route = true;
      PlannedPath path = follow(*route, starts.found[route->start], goals.found[route->goal], barred);
      if (path) return path;
    }
    if (has_route)
      return without_path(SameAspect::unknown, "The ends are proved to be joined, but no path was found.");
    if (policy == PathPolicy::any)
      return without_path(SameAspect::unknown, "No gates that are proved join the ends; others may.");
    return no_route(*graph, starts, goals);
  }

  PlannedPath no_route(const AspectGraph& graph, const EndAspects& starts, const EndAspects& goals) const {
    const bool same_sign = any_pair(starts, goals, [this](int first, int second) {
      return aspect_of(map_, first).determinant_sign == aspect_of(map_, second).determinant_sign;
    });
    const bool may_be_joined = any_pair(starts, goals, [&graph](int first, int second) {
      return graph.set_group[graph.set_of(first)] == graph.set_group[graph.set_of(second)];
    });
    if (may_be_joined || !starts.all_known || !goals.all_known)
      return without_path(SameAspect::unknown, "No serial gates that are proved join the ends; others may.");
    return without_path(
        SameAspect::no,
        same_sign
            ? "Proved: no serial gates within the region of the map join the ends" + within_slice() + "."
            : "Proved: det A differs in sign, and no path through serial gates changes it.");
  }

  /// Empty-handed where a part of the path is not found; that stretch is barred then.
  PlannedPath follow(const GateRoute& route, const PoseInAspect& start, const PoseInAspect& goal,
                     BarredStretches& barred) {
    PathBuilder builder(*map_.manipulator(), [this](const Pose& from, const Pose& to, double t) {
      return paths_.segments().between(from, to, t);
    });
    PoseInAspect at = start;
    builder.go(start.lead, aspect_of(map_, start.aspect).mode);
    for (std::size_t i = 0; i < route.steps.size(); ++i) {
      const Neighbours& gate = planner_.parts_->graph->gates[route.steps[i].gate];
      std::vector<Pose> segment = gate.crossings[route.steps[i].crossing].segment;
      const int next = gate.first == at.aspect ? gate.second : gate.first;
      const bool serial = gate.crossing == Crossing::serial;
      if (!serial && aspect_of(map_, at.aspect).determinant_sign < 0)
        std::reverse(segment.begin(), segment.end());
      if (!go(builder, at, segment.front()) ||
          (serial && !pass_serial(builder, gate.leg, segment, at.aspect, next))) {
        barred.insert(route.stretches[i]);
        return {};
      }
      if (!serial) builder.cross_parallel(segment, aspect_of(map_, at.aspect).mode, at.aspect, next);
      at = {serial ? segment.front() : segment.back(), next};
    }
    if (!go(builder, at, goal.pose)) {
      barred.insert(route.stretches.back());
      return {};
    }
    builder.go({goal.lead.rbegin(), goal.lead.rend()}, aspect_of(map_, goal.aspect).mode);
    return builder.take(route.steps.empty()
                            ? "Every segment is proved free of singularities, in the working mode " +
                                  to_string(aspect_of(map_, start.aspect).mode) + "."
                            : "Every segment and every crossing is proved.");
  }

  bool go(PathBuilder& builder, const PoseInAspect& from, const Pose& to) {
    const std::vector<Pose> poses = paths_.find(from.aspect, from.pose, to, shape_, control_);
    builder.go(poses, aspect_of(map_, from.aspect).mode);
    return !poses.empty();
  }

  /// To where B_jj is nearly zero in either mode, and back; false where not even the start of the segment is
  /// proved.
  bool pass_serial(PathBuilder& builder, std::size_t leg, const std::vector<Pose>& segment, int from,
                   int to) const {
    const WorkingMode before = aspect_of(map_, from).mode, after = aspect_of(map_, to).mode;
    const int sign = aspect_of(map_, from).determinant_sign;
    const MapSegments& segments = paths_.segments();
    std::vector<Pose> poses{segment.front()};
    for (std::size_t i = 0; i + 1 < segment.size(); ++i) {
      const Pose &start = segment[i], &end = segment[i + 1];
      const double share = std::min(segments.free_share(start, end, before, sign),
                                    segments.free_share(start, end, after, sign));
      if (share > 0.0) poses.push_back(segments.between(start, end, share));
      if (share < 1.0) break;
    }
    if (poses.size() == 1) return false;
    builder.go(poses, before);
    builder.cross_serial(leg, from, to);
    std::reverse(poses.begin(), poses.end());
    builder.go(poses, after);
    return true;
  }

  PathPlanner& planner_;
  const AspectMap& map_;
  AspectPaths& paths_;
  const PathWish& wish_;
  const MapControl& control_;
  PathShape shape_;  // that is searched for now
};

PathPlanner::PathPlanner(std::shared_ptr<const AspectMap> map)
    : parts_(std::make_unique<Parts>(std::move(map))) {}
PathPlanner::~PathPlanner() = default;
PathPlanner::PathPlanner(PathPlanner&&) noexcept = default;
PathPlanner& PathPlanner::operator=(PathPlanner&&) noexcept = default;

PlannedPath PathPlanner::plan(const PathEnd& from, const PathEnd& to, const PathWish& wish,
                              const MapControl& control) {
  return begun_at(from.q, *parts_->map->manipulator(), Search(*this, wish, control).run(from, to));
}

PlannedPath PathPlanner::plan(const PathEnd& from, const PathEnd& to, PathPolicy policy,
                              const MapControl& control) {
  return plan(from, to, PathWish{policy}, control);
}

Pose PathPlanner::between(const Pose& from, const Pose& to, double t) const {
  return parts_->paths.segments().between(from, to, t);
}

const AspectGraph* PathPlanner::graph(const MapControl& control) {
  if (!parts_->graph) parts_->graph = compute_aspect_graph(*parts_->map, control);
  return parts_->graph.get();
}

const char* name(PathPolicy policy) noexcept {
  switch (policy) {
    case PathPolicy::stay:
      return "stay";
    case PathPolicy::serial:
      return "serial";
    case PathPolicy::any:
      break;
  }
  return "any";
}

const char* name(PathPreference preference) noexcept {
  switch (preference) {
    case PathPreference::shortest:
      return "short";
    case PathPreference::clear:
      return "clear";
    case PathPreference::fast:
      return "fast";
    case PathPreference::quick:
      break;
  }
  return "quick";
}

}  // namespace parallel_aspects
