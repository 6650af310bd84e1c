// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/map_segments.h"

#include "aspects/boxes/segment_proof.h"
#include "aspects/map/map_contents.h"
#include "interval/interval.h"
#include "model/angles.h"
#include "motion/plan/path_shape.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int halvings_to_turning_points = 30;
constexpr std::array<double, 3> looks_at_a_segment{0.5, 0.25, 0.75};

}  // namespace

MapSegments::MapSegments(std::shared_ptr<const AspectMap> map)
    : map_(std::move(map)), certifier_(map_->manipulator()) {}

bool MapSegments::holds_joint() const { return map_->slice() && map_->slice()->joint; }

/// `to` with whole periods added, so that it is nearest to `from`.
MapPoint MapSegments::unrolled(const MapPosition& from, const MapPosition& to) const {
  const PoseSpace& space = map_->contents().tree.space();
  MapPoint result = to.point;
  for (std::size_t i = 0; i < space.dimension(); ++i) {
    const double period = space.region().width(i);
    if (space.is_periodic(i)) result[i] = from.point[i] + std::remainder(to.point[i] - from.point[i], period);
  }
  return result;
}

Pose MapSegments::between(const Pose& from, const Pose& to, double t) const {
  if (!holds_joint()) return pose_between(map_->manipulator()->motions(), from, to, t);
  const PoseSpace& space = map_->contents().tree.space();
  const MapPosition start = space.position(from);
  const MapPoint end = unrolled(start, space.position(to));
  MapPosition at = start;
  for (std::size_t i = 0; i < space.dimension(); ++i) at.point[i] += t * (end[i] - start.point[i]);
  return space.pose(at);
}

double MapSegments::turn(const Pose& from, const Pose& to) const {
  if (!holds_joint()) return from.orientation.angularDistance(to.orientation);
  const PoseSpace& space = map_->contents().tree.space();
  const MapPosition start = space.position(from);
  const MapPoint end = unrolled(start, space.position(to));
  double most = 0.0;  // in half turns, as the coordinates are
  for (std::size_t i = 0; i < space.dimension(); ++i)
    most = std::max(most, std::abs(end[i] - start.point[i]));
  return pi * most;
}

/// Divided where it goes through the ends of a periodic coordinate, which are the same poses.
std::vector<MapSegments::Piece> MapSegments::pieces(const Pose& from, const Pose& to) const {
  const PoseSpace& space = map_->contents().tree.space();
  const Box& region = space.region();
  MapPosition at = space.position(from);
  MapPoint end = unrolled(at, space.position(to));
  std::vector<Piece> result;
  while (result.size() <= space.dimension()) {
    double first = 1.0;  // share up to the first end that is passed
    std::size_t axis = space.dimension();
    for (std::size_t i = 0; i < space.dimension(); ++i) {
      const double beyond = end[i] > region.upper[i] ? region.upper[i] : region.lower[i];
      if (region.lower[i] <= end[i] && end[i] <= region.upper[i]) continue;
      const double share = (beyond - at.point[i]) / (end[i] - at.point[i]);
      if (share < first) first = share, axis = i;
    }
    if (axis == space.dimension()) {
      result.push_back({at, end});
      return result;
    }
    MapPoint face = at.point;
    for (std::size_t i = 0; i < space.dimension(); ++i) face[i] += first * (end[i] - face[i]);
    const bool upper = end[axis] > region.upper[axis];
    face = region.nearest(face);
    face[axis] = upper ? region.upper[axis] : region.lower[axis];
    result.push_back({at, face});
    at.point = face;
    at.point[axis] = upper ? region.lower[axis] : region.upper[axis];
    end[axis] += (upper ? -1.0 : 1.0) * region.width(axis);
  }
  return {};
}

bool MapSegments::pieces_are_free(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const {
  const RoundingUpward rounding;
  const AspectMap::Contents& map = map_->contents();
  const std::size_t index = *mode_index(map, mode);
  const std::vector<Piece> all = pieces(from, to);
  return !all.empty() && std::all_of(all.begin(), all.end(), [&](const Piece& piece) {
    return segment_is_free(*map.classifier, map.tree.dimension(), index, sign, piece.from, piece.to);
  });
}

/// Tests some poses first, which saves most of the proofs that would fail.
bool MapSegments::looks_free(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const {
  const Manipulator& robot = *map_->manipulator();
  return std::all_of(looks_at_a_segment.begin(), looks_at_a_segment.end(), [&](double t) {
    const Pose pose = pose_between(robot.motions(), from, to, t);
    const InverseSolution solution = inverse(robot, pose, mode);
    return solution && sign * direct_determinant(robot, pose, solution.q) > 0.0;
  });
}

bool MapSegments::is_free(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const {
  if (holds_joint()) return pieces_are_free(from, to, mode, sign);
  return looks_free(from, to, mode, sign) && certifier_.prove(from, to, mode).verdict == SegmentVerdict::free;
}

double MapSegments::free_share(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const {
  if (!holds_joint())
    return certifier_.prove_to_violation(from, to, mode, width_of_turning_points).free_until;
  double free = 0.0, not_proved = 1.0;
  for (int i = 0; i < halvings_to_turning_points; ++i) {
    const double middle = 0.5 * (free + not_proved);
    (pieces_are_free(from, between(from, to, middle), mode, sign) ? free : not_proved) = middle;
  }
  return free;
}

}  // namespace parallel_aspects
