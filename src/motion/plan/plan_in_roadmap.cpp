// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/serial_margin.h"
#include "motion/plan/end_aspects.h"
#include "motion/plan/path_builder.h"
#include "motion/plan/path_shape.h"
#include "motion/plan/roadmap_paths.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/plan_path.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_mode_pairs = 8;               // between which gates are searched for
constexpr std::array<std::size_t, 2> gates_tried{1, 4};  // of each leg that changes its posture
constexpr std::size_t most_thorough_modes = 4;

/// An end in the working modes in which it lies in some aspect, with the sign of det A there.
struct SignedEnd {
  std::vector<std::pair<PoseInMode, int>> found;
  bool all_known = true;  // whether of every other mode it is proved that no aspect holds it
};

class RoadmapPlanner {
 public:
  RoadmapPlanner(const PoseRoadmap& roadmap, const PathWish& wish, const MapControl& control)
      : roadmap_(roadmap),
        robot_(*roadmap.certifier().manipulator()),
        gates_(roadmap),
        wish_(wish),
        control_(control) {}

  PlannedPath run(const PathEnd& from, const PathEnd& to) {
    for (const PathEnd* end : {&from, &to})
      if (!is_finite(end->pose))
        return without_path(SameAspect::unknown, std::string("The pose of the ") +
                                                     (end == &from ? "start" : "goal") + " is not finite.");
    if (std::optional<PlannedPath> none = excluded_end(roadmap_.certifier(), from, to)) return *none;
    PlannedPath found = stay(from, to, SearchEffort::brief);
    if (found) return found;
    const bool is_shut = wish_.policy != PathPolicy::stay && has_serial_margin(robot_);
    const bool has_gates = wish_.policy != PathPolicy::stay && !is_shut;
    PlannedPath through = has_gates ? pass_gates(from, to) : PlannedPath{};
    if (through || through.answer == SameAspect::no) return through;
    if (found.answer == SameAspect::unknown && !is_cancelled(control_))
      found = stay(from, to, SearchEffort::thorough);
    if (!found && has_gates) return through;
    if (!found && is_shut) found.message += " The serial margin shuts out all gates of B_jj = 0.";
    return found;
  }

 private:
  static PlannedPath cancelled() { return without_path(SameAspect::unknown, "Cancelled."); }

  PlannedPath pass_gates(const PathEnd& from, const PathEnd& to) const {
    const SignedEnd starts = signed_end(from), goals = signed_end(to);
    if (starts.found.empty() || goals.found.empty())
      return without_path(SameAspect::unknown, std::string("The ") +
                                                   (starts.found.empty() ? "start" : "goal") +
                                                   " is too close to a singularity or a limit to be "
                                                   "determined.");
    return pass_gates(starts, goals);
  }

  /// A thorough search is one in few modes, and is content with one path.
  PlannedPath stay(const PathEnd& from, const PathEnd& to, SearchEffort effort) {
    BestPath choice(robot_, wish_);
    PlannedPath none = without_path(SameAspect::no, "The ends are in different working modes.");
    bool is_first = true;
    std::size_t searched = 0;
    for (const WorkingMode& mode : working_modes(robot_)) {
      if (from.mode.value_or(mode) != mode || to.mode.value_or(mode) != mode) continue;
      if (is_cancelled(control_)) return cancelled();
      const PoseInMode start{from.pose, mode}, goal{to.pose, mode};
      const AspectComparison found = same_aspect(roadmap_, start, goal, effort);
      if (found.answer == SameAspect::yes) offer(found.path, mode, choice);
      if (found.answer == SameAspect::yes && !choice.has_path())
        none = without_path(SameAspect::unknown,
                            "The ends are proved to be joined, but not by segments of a quarter turn at "
                            "most.");
      else if (is_first || found.answer == SameAspect::unknown)
        none = without_path(found.answer, found.message);
      is_first = false;
      searched += found.searched_sign != 0 ? 1 : 0;
      if (effort == SearchEffort::thorough && (choice.has_path() || searched == most_thorough_modes)) break;
    }
    return choice.has_path() ? choice.take() : none;
  }

  void offer(const std::vector<Pose>& found, const WorkingMode& mode, BestPath& choice) const {
    const bool is_best = wish_.prefer == PathPreference::shortest && found.size() == 2;
    for (const PathShape& shape : is_best ? std::vector<PathShape>{short_shape} : shapes_for(wish_.prefer))
      for (const std::vector<Pose>& poses : shaped(found, mode, shape)) {
        PathBuilder builder(robot_, between_poses(robot_.motions()));
        builder.go(poses, mode);
        choice.offer(builder.take("Every segment is proved free of singularities, in the working mode " +
                                  to_string(mode) + "."));
      }
  }

  SegmentsInMode segments_in(const WorkingMode& mode) const {
    return {[this, mode](const Pose& from, const Pose& to) {
              return roadmap_.certifier().prove(from, to, mode).verdict == SegmentVerdict::free;
            },
            between_poses(robot_.motions()),
            [](const Pose& from, const Pose& to) { return from.orientation.angularDistance(to.orientation); },
            robot_, mode};
  }

  /// What becomes of a path that was found, and of another one by the same poses.
  std::vector<std::vector<Pose>> shaped(const std::vector<Pose>& found, const WorkingMode& mode,
                                        const PathShape& shape) const {
    const SegmentsInMode segments = segments_in(mode);
    if (found.size() == 2 && !shape.is_wide) return proved({found}, segments);
    const int sign = roadmap_.certifier().prove(found.front(), mode).sign;
    std::vector<std::vector<Pose>> result{found};
    if (const RoadmapSide* side = roadmap_.side(mode, sign)) {
      const double wanted = shape.is_wide ? std::min(index_at(robot_, found.front(), mode),
                                                     index_at(robot_, found.back(), mode))
                                          : 0.0;
      PoseGraph graph(roadmap_, *side, found.front(), found.back(), segments);
      if (std::vector<Pose> path = graph.find(wanted); !path.empty()) result.push_back(std::move(path));
    }
    for (std::vector<Pose>& path : result)
      path = shortened(path, segments,
                       shape.is_wide ? shape.kept_share * least_index_along(path, segments) : 0.0);
    return proved(result, segments);
  }

  /// The paths with short turns; a path for which these are not proved is left out.
  static std::vector<std::vector<Pose>> proved(const std::vector<std::vector<Pose>>& paths,
                                               const SegmentsInMode& segments) {
    std::vector<std::vector<Pose>> result;
    for (const std::vector<Pose>& path : paths)
      if (std::vector<Pose> turned = with_short_turns(path, segments); !turned.empty())
        result.push_back(std::move(turned));
    return result;
  }

  SignedEnd signed_end(const PathEnd& end) const {
    SignedEnd result;
    for (const WorkingMode& mode : working_modes(robot_)) {
      if (end.mode.value_or(mode) != mode) continue;
      const ConfigurationProof proof = roadmap_.certifier().prove(end.pose, mode);
      if (proof.sign != 0)
        result.found.push_back({{end.pose, mode}, proof.sign});
      else
        result.all_known = result.all_known && proof.proved_violation != Violation::none;
    }
    return result;
  }

  struct ModePair {
    PoseInMode start, goal;
    int sign;
    std::vector<std::size_t> legs;  // that change their posture
  };

  /// Of one sign of det A, those with the fewest changes first.
  std::vector<ModePair> mode_pairs(const SignedEnd& starts, const SignedEnd& goals) const {
    std::vector<ModePair> pairs;
    for (const auto& [start, sign] : starts.found)
      for (const auto& [goal, other] : goals.found) {
        if (sign != other) continue;
        ModePair pair{start, goal, sign, {}};
        for (std::size_t j = 0; j < robot_.leg_count(); ++j)
          if (start.mode.sign(j) != goal.mode.sign(j)) pair.legs.push_back(j);
        pairs.push_back(std::move(pair));
      }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const ModePair& a, const ModePair& b) { return a.legs.size() < b.legs.size(); });
    return pairs;
  }

  /// Searches from either end: a gate near the one may lead to where the other cannot be reached from.
  PlannedPath pass_gates(const SignedEnd& starts, const SignedEnd& goals) const {
    const std::vector<ModePair> pairs = mode_pairs(starts, goals);
    if (pairs.empty() && starts.all_known && goals.all_known && wish_.policy == PathPolicy::serial)
      return without_path(SameAspect::no,
                          "Proved: det A differs in sign, and no path through serial gates changes it.");
    for (const std::size_t gates : gates_tried) {
      if (PlannedPath path = follow_some(pairs, gates)) return path;
      if (PlannedPath path = follow_some(mode_pairs(goals, starts), gates)) return reversed(path);
      if (is_cancelled(control_)) return cancelled();
    }
    return without_path(SameAspect::unknown,
                        "No path through serial gates was found, which proves nothing; more samples may "
                        "find one.");
  }

  /// The first of the pairs between which there is a path.
  PlannedPath follow_some(const std::vector<ModePair>& pairs, std::size_t most_gates) const {
    BestPath choice(robot_, wish_);
    for (std::size_t i = 0; i < std::min(most_mode_pairs, pairs.size()) && !choice.has_path(); ++i) {
      if (pairs[i].legs.empty()) continue;  // that is what staying has tried
      for (const PathShape& shape : shapes_for(wish_.prefer)) {
        if (is_cancelled(control_)) return {};
        PlannedPath path;
        follow(PathBuilder(robot_, between_poses(robot_.motions())), pairs[i].start, pairs[i], pairs[i].legs,
               {shape, most_gates}, path);
        choice.offer(std::move(path));
      }
    }
    return choice.has_path() ? choice.take() : PlannedPath{};
  }

  PlannedPath reversed(PlannedPath path) const {
    std::reverse(path.points.begin(), path.points.end());
    std::reverse(path.crossings.begin(), path.crossings.end());
    const std::size_t last = path.points.size() - 1;
    for (PathCrossing& crossing : path.crossings)
      crossing = {crossing.kind, last - crossing.behind, last - crossing.point, crossing.leg,
                  crossing.to,   crossing.from};
    const JointVector q = inverse(robot_, path.points.front().pose, path.points.front().mode).q;
    return begun_at(q, robot_, std::move(path));
  }

  /// How gates are searched.
  struct GateSearch {
    PathShape shape;
    std::size_t most_gates;  // that are tried of each leg that changes its posture
  };

  /// From where the path is, through a gate of each of the legs; `result` is left as it is where no path is
  /// found.
  void follow(const PathBuilder& so_far, const PoseInMode& at, const ModePair& pair,
              const std::vector<std::size_t>& legs, const GateSearch& search, PlannedPath& result) const {
    if (legs.empty()) {
      PathBuilder builder = so_far;
      if (go(at, pair.goal.pose, search.shape, builder))
        result = builder.take("Every segment and every crossing is proved.");
      return;
    }
    std::size_t tried = 0;
    gates_.visit(at, pair.goal.pose, pair.sign, legs, [&](const RoadmapGate& gate) {
      PathBuilder builder = so_far;
      if (is_cancelled(control_) || !go(at, gate.outer, search.shape, builder)) return is_cancelled(control_);
      const PoseInMode behind{gate.outer, with_other_posture(at.mode, gate.leg)};
      builder.go({gate.inner}, at.mode);
      builder.cross_serial(gate.leg, 0, 0);
      builder.go({gate.inner, gate.outer}, behind.mode);
      std::vector<std::size_t> rest = legs;
      rest.erase(std::find(rest.begin(), rest.end(), gate.leg));
      follow(builder, behind, pair, rest, search, result);
      return result || is_cancelled(control_) || ++tried == search.most_gates;
    });
  }

  bool go(const PoseInMode& at, const Pose& to, const PathShape& shape, PathBuilder& builder) const {
    const AspectComparison found = same_aspect(roadmap_, at, {to, at.mode}, SearchEffort::brief);
    if (found.answer != SameAspect::yes) return false;
    const std::vector<std::vector<Pose>> paths = shaped(found.path, at.mode, shape);
    if (paths.empty()) return false;
    const auto shortest = std::min_element(paths.begin(), paths.end(), [this](const auto& a, const auto& b) {
      return length_of(robot_, a) < length_of(robot_, b);
    });
    builder.go(shape.is_wide ? paths.back() : *shortest, at.mode);
    return true;
  }

  const PoseRoadmap& roadmap_;
  const Manipulator& robot_;
  const RoadmapGates gates_;
  const PathWish& wish_;
  const MapControl& control_;
};

}  // namespace

PlannedPath plan_in_roadmap(const PoseRoadmap& roadmap, const PathEnd& from, const PathEnd& to,
                            const PathWish& wish, const MapControl& control) {
  return begun_at(from.q, *roadmap.certifier().manipulator(),
                  RoadmapPlanner(roadmap, wish, control).run(from, to));
}

}  // namespace parallel_aspects
