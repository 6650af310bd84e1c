// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/lead_in.h"

#include "aspects/map/map_contents.h"
#include "aspects/map/map_location.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr int max_rounds = 12;

class Climb {
 public:
  Climb(const AspectMap& map, const MapSegments& segments, const WorkingMode& mode, int sign)
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

}  // namespace

std::vector<Pose> climb(const AspectMap& map, const MapSegments& segments, const Pose& pose,
                        const WorkingMode& mode, int sign, const std::function<bool(const Pose&)>& is_there) {
  return Climb(map, segments, mode, sign).run(pose, is_there);
}

LeadIn find_lead_in(const AspectMap& map, const MapSegments& segments, const Pose& pose,
                    const WorkingMode& mode, int sign) {
  LeadIn lead;
  lead.poses = climb(map, segments, pose, mode, sign, [&](const Pose& at) {
    const Location location = map.locate(at, mode);
    if (!location) return false;
    if (map.aspects()[static_cast<std::size_t>(location.aspect - 1)].determinant_sign != sign) return false;
    lead.aspect = location.aspect;
    return true;
  });
  return lead;
}

}  // namespace parallel_aspects
