// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/end_aspects.h"

#include "aspects/map/map_contents.h"
#include "aspects/roadmap/violation_text.h"
#include "motion/plan/leaf_path.h"
#include "motion/plan/path_builder.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr int max_rounds = 12;
constexpr std::size_t most_reasons = 4, most_modes = 4;  // that are listed

class IndexClimb {
 public:
  IndexClimb(const AspectMap& map, const MapSegments& segments, const WorkingMode& mode, int sign)
      : map_(map), contents_(map.contents()), segments_(segments), mode_(mode), sign_(sign) {}

  std::vector<Pose> run(const Pose& pose, const std::function<bool(const Pose&)>& is_there) {
    std::vector<Pose> poses{pose};
    double index = index_at(pose);
    for (int round = 0; round < max_rounds; ++round) {
      const std::optional<Pose> next = best_around(poses.back(), index);
      if (!next) return {};
      poses.push_back(*next);
      if (is_there(*next)) return poses;
    }
    return {};
  }

 private:
  /// The smallest index of all singularities; negative where a leg does not reach.
  double index_at(const Pose& pose) const {
    const Manipulator& robot = *map_.manipulator();
    const InverseSolution solution = inverse(robot, pose, mode_);
    if (solution.status != InverseStatus::solved) return -1.0;
    return std::min(parallel_index(robot, pose, solution.q),
                    serial_indices(robot, pose, solution.q).minCoeff());
  }

  /// Where the index is larger than `index`, which becomes that one.
  std::optional<Pose> best_around(const Pose& pose, double& index) const {
    std::vector<std::pair<double, Pose>> around;
    for (const Pose& each : poses_around(pose))
      if (const double at = index_at(each); at > index) around.emplace_back(at, each);
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [at, each] : around) {
      if (!segments_.is_free(pose, each, mode_, sign_)) continue;
      index = at;
      return each;
    }
    return std::nullopt;
  }

  /// Along the coordinates of the map and its diagonals, some widths of the leaf away.
  std::vector<Pose> poses_around(const Pose& pose) const {
    const PoseSpace& space = contents_.tree.space();
    const MapPosition at = space.position(pose);
    std::vector<Pose> result;
    const auto leaf = contents_.tree.leaf_at(at, *mode_index(contents_, mode_));
    if (!leaf) return result;
    const Box box = contents_.tree.box(*leaf);
    for (const double share : {0.1, 0.5, 2.0, 6.0})
      for (const MapPoint& direction : directions(box.dimension)) {
        MapPosition to = at;
        for (std::size_t i = 0; i < box.dimension; ++i) to.point[i] += share * box.width(i) * direction[i];
        if (space.region().contains(to.point)) result.push_back(space.pose(to));
      }
    return result;
  }

  /// All of -1, 0 and 1, but for that of zeros.
  static std::vector<MapPoint> directions(std::size_t dimension) {
    std::size_t count = 1;
    for (std::size_t i = 0; i < dimension; ++i) count *= 3;
    std::vector<MapPoint> result;
    for (std::size_t code = 0; code < count; ++code) {
      MapPoint direction{};
      std::size_t rest = code;
      for (std::size_t i = 0; i < dimension; ++i, rest /= 3)
        direction[i] = static_cast<double>(rest % 3) - 1.0;
      if (direction != MapPoint{}) result.push_back(direction);
    }
    return result;
  }

  const AspectMap& map_;
  const AspectMap::Contents& contents_;
  const MapSegments& segments_;
  const WorkingMode& mode_;
  int sign_;
};

bool is_in_slice(const AspectMap& map, const Pose& pose) {
  const PoseSpace& space = map.contents().tree.space();
  const Pose nearest = space.pose(space.position(pose));
  return distance_between(*map.manipulator(), pose, nearest) < held_joint_tolerance;
}

/// What is known of an end in a working mode in which no aspect is found to hold it.
void explain(const AspectMap& map, const SegmentCertifier& certifier, const PoseInMode& at,
             LocationStatus status, EndAspects& end) {
  const ConfigurationProof proof = certifier.prove(at.pose, at.mode);
  const bool is_proved = proof.proved_violation != Violation::none;
  end.all_known = end.all_known && is_proved;
  if (is_proved)
    end.reasons.add(at.mode, violation_text(*map.manipulator(), at, proof));
  else if (!mode_index(map.contents(), at.mode))
    end.reasons.add(at.mode, "the working mode " + to_string(at.mode) + " is not mapped");
  else if (status == LocationStatus::not_mapped)
    end.reasons.add(at.mode, "it lies outside the region of the map");
  else
    end.reasons.add(at.mode, "it is closer to a singularity or a limit than the map can decide");
}

/// Where the map itself does not place the end, a proved path into an aspect does.
PoseInAspect find_lead(const AspectMap& map, const MapSegments& segments, const PoseInMode& at) {
  const int sign = segments.certifier().prove(at.pose, at.mode).sign;
  if (sign == 0) return {};
  int aspect = 0;
  std::vector<Pose> poses = climb(map, segments, at.pose, at.mode, sign, [&](const Pose& pose) {
    const Location location = map.locate(pose, at.mode);
    if (!location) return false;
    if (map.aspects()[static_cast<std::size_t>(location.aspect - 1)].determinant_sign != sign) return false;
    aspect = location.aspect;
    return true;
  });
  if (aspect == 0) return {};
  const Pose last = poses.back();
  return {last, aspect, std::move(poses)};
}

std::string listed(const std::vector<WorkingMode>& modes) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most_modes, modes.size()); ++i)
    text += (i == 0 ? "" : ", ") + to_string(modes[i]);
  return modes.size() > most_modes ? text + " and " + std::to_string(modes.size() - most_modes) + " more"
                                   : text;
}

}  // namespace

std::string ExclusionReasons::text() const {
  if (modes_.size() == 1) return modes_.begin()->first;
  std::string text;
  std::size_t said = 0;
  for (const auto& [reason, modes] : modes_) {
    if (said++ == most_reasons) break;
    text += (text.empty() ? "" : "; ") + ("in " + listed(modes)) + " " + reason;
  }
  return modes_.size() > most_reasons ? text + "; likewise in the others, for " +
                                            std::to_string(modes_.size() - most_reasons) + " more reasons"
                                      : text;
}

std::vector<Pose> climb(const AspectMap& map, const MapSegments& segments, const Pose& pose,
                        const WorkingMode& mode, int sign, const std::function<bool(const Pose&)>& is_there) {
  return IndexClimb(map, segments, mode, sign).run(pose, is_there);
}

EndAspects find_aspects(const AspectMap& map, const MapSegments& segments, const PathEnd& end) {
  EndAspects result;
  const std::string fault = !is_finite(end.pose)          ? "its pose is not finite"
                            : !is_in_slice(map, end.pose) ? "it does not lie in the slice"
                                                          : "";
  if (!fault.empty()) {
    result.all_known = false;
    result.reasons.add({}, fault);
    return result;
  }
  for (const WorkingMode& mode : working_modes(*map.manipulator())) {
    if (end.mode && mode != *end.mode) continue;
    const Location location = map.locate(end.pose, mode);
    if (location) {
      result.found.push_back({end.pose, location.aspect});
      continue;
    }
    const PoseInAspect led = location.status == LocationStatus::undecided
                                 ? find_lead(map, segments, {end.pose, mode})
                                 : PoseInAspect{};
    if (led.aspect != 0)
      result.found.push_back(led);
    else
      explain(map, segments.certifier(), {end.pose, mode}, location.status, result);
  }
  return result;
}

std::optional<PlannedPath> excluded_end(const SegmentCertifier& certifier, const PathEnd& from,
                                        const PathEnd& to) {
  const Manipulator& robot = *certifier.manipulator();
  for (const PathEnd* end : {&from, &to}) {
    ExclusionReasons reasons;
    bool is_excluded = is_finite(end->pose);
    for (const WorkingMode& mode : working_modes(robot)) {
      if (!is_excluded) break;
      if (end->mode.value_or(mode) != mode) continue;
      const PoseInMode at{end->pose, mode};
      const ConfigurationProof proof = certifier.prove(at.pose, at.mode);
      is_excluded = proof.proved_violation != Violation::none;
      if (is_excluded) reasons.add(mode, violation_text(robot, at, proof));
    }
    if (is_excluded)
      return without_path(SameAspect::no, std::string("Proved: no aspect holds the ") +
                                              (end == &from ? "start" : "goal") + ": " + reasons.text() +
                                              ".");
  }
  return std::nullopt;
}

}  // namespace parallel_aspects
