// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/gate_crossings.h"

#include "aspects/boxes/segment_proof.h"
#include "aspects/constraints/serial_margin.h"
#include "aspects/map/map_contents.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace parallel_aspects {
namespace {

/// How far the actuated joints are from their limits, over half of their range; 1 without limits.
double room_to_limits(const Manipulator& robot, const JointVector& q) {
  double room = 1.0;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const JointLimits& limits = robot.leg(j).limits;
    const double value = q[static_cast<Eigen::Index>(j)], half = 0.5 * (limits.upper - limits.lower);
    if (std::isfinite(half))
      room = std::min({room, (value - limits.lower) / half, (limits.upper - value) / half});
  }
  return room;
}

}  // namespace

double crossing_index(const Manipulator& robot, const Pose& pose, const WorkingMode& mode, Crossing crossing,
                      std::size_t leg) {
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.status != InverseStatus::solved) return -1.0;
  TaskVector entries = serial_indices(robot, pose, solution.q);
  const double room = room_to_limits(robot, solution.q);
  if (crossing == Crossing::parallel) return std::min(room, entries.minCoeff());
  entries[static_cast<Eigen::Index>(leg)] = 1.0;
  return std::min({room, parallel_index(robot, pose, solution.q), entries.minCoeff()});
}

namespace {

/// A position in the box of a leaf or near it, on its own side of a glued face or beyond it.
struct NearPosition {
  MapPosition at;
  std::optional<std::size_t> beyond;  // across the face at the end of this coordinate
  MapPoint on_face{};                 // where, in the coordinates of the leaf
};

/// A proved configuration and the aspect that holds it.
struct Held {
  NearPosition near;
  int aspect = 0;
};

/// Looks in one leaf.
class LeafSearch {
 public:
  LeafSearch(const MarkedMap& marked, NodeIndex leaf, std::size_t mode)
      : marked_(marked),
        map_(marked.map),
        mode_(mode),
        root_(map_.tree.place(leaf).root),
        box_(map_.tree.box(leaf)) {}

  std::optional<LeafCrossing> parallel() const {
    const Held positive = find_held(1);
    if (positive.aspect == 0) return std::nullopt;
    const Held negative = find_held(-1);
    if (negative.aspect == 0) return std::nullopt;
    const auto segments = path(positive.near, negative.near);
    if (!segments) return std::nullopt;
    return LeafCrossing{positive.aspect, negative.aspect,
                        crosses_parallel_singularity(*map_.classifier, *segments, mode_), *segments};
  }

  std::optional<LeafCrossing> serial(std::size_t other, std::size_t leg, int sign) const {
    const std::optional<NearPosition> near = find_unreachable(leg);
    if (!near && !has_serial_margin(*map_.manipulator)) return std::nullopt;
    const Held here = find_held(sign);
    const MapPosition& at = here.near.at;
    if (here.aspect == 0 || proved_sign(*map_.classifier, box_.dimension, other, at) != sign)
      return std::nullopt;
    const Location there = locate(marked_, other, at, sign);
    if (there.status != LocationStatus::inside) return std::nullopt;
    const std::optional<NearPosition> end = near ? near : find_beyond_margin(here.near, leg);
    const auto segments = end ? path(here.near, *end) : std::nullopt;
    if (!segments) return std::nullopt;
    return LeafCrossing{here.aspect, there.aspect,
                        crosses_serial_singularity(*map_.classifier, *segments, mode_, other, leg, sign),
                        *segments};
  }

 private:
  /// The path between two positions near one leaf; nothing where they lie beyond different faces.
  std::optional<CrossingPath> path(const NearPosition& from, const NearPosition& to) const {
    const std::size_t dimension = map_.tree.dimension();
    if (from.beyond == to.beyond && from.at.root == to.at.root)
      return CrossingPath{{CrossingSegment{dimension, from.at.root, from.at.point, to.at.point}}, 1};
    if (from.beyond && to.beyond) return std::nullopt;
    const NearPosition& far = from.beyond ? from : to;
    const MapPosition face{root_, far.on_face}, other_side = map_.tree.space().across(face, *far.beyond);
    const CrossingSegment here{dimension, root_, from.at.point, face.point},
        there{dimension, far.at.root, other_side.point, far.at.point};
    if (to.beyond) return CrossingPath{{here, there}, 2};
    return CrossingPath{{CrossingSegment{dimension, far.at.root, far.at.point, other_side.point},
                         CrossingSegment{dimension, root_, face.point, to.at.point}},
                        2};
  }

  /// The middle of the box, its corners, and those of a box twice as large, since a singularity may lie on a
  /// face; at last those of them that are beyond a glued face.
  template <class Visit>
  void visit_positions(const Visit& visit) const {
    if (visit(NearPosition{{root_, box_.middle()}, {}, {}})) return;
    const Box& region = map_.tree.region();
    for (const double share : {0.5, 1.0})
      for (std::uint32_t corner = 0; corner < 1U << box_.dimension; ++corner)
        if (visit(NearPosition{{root_, region.nearest(corner_of(corner, share))}, {}, {}})) return;
    for (std::size_t axis = 0; axis < box_.dimension; ++axis)
      for (std::uint32_t corner = 0; corner < 1U << box_.dimension; ++corner)
        if (const auto position = beyond_face(corner, axis); position && visit(*position)) return;
  }

  MapPoint corner_of(std::uint32_t corner, double share) const {
    MapPoint point{};
    for (std::size_t i = 0; i < box_.dimension; ++i)
      point[i] = box_.center(i) + ((corner >> i & 1U) != 0 ? share : -share) * box_.width(i);
    return point;
  }

  /// Half the width of the box beyond its face at an end of the coordinate `axis`, where that face is glued.
  std::optional<NearPosition> beyond_face(std::uint32_t corner, std::size_t axis) const {
    const Box& region = map_.tree.region();
    const bool upper = (corner >> axis & 1U) != 0;
    if (upper ? box_.upper[axis] != region.upper[axis] : box_.lower[axis] != region.lower[axis])
      return std::nullopt;
    const MapPoint on_face = region.nearest(corner_of(corner, 0.5));
    const auto position = map_.tree.space().beyond({root_, on_face}, axis, 0.5 * box_.width(axis));
    if (!position) return std::nullopt;
    return NearPosition{*position, axis, on_face};
  }

  Held find_held(int sign) const {
    Held held;
    visit_positions([&](const NearPosition& near) {
      held.near = near;
      if (proved_sign(*map_.classifier, box_.dimension, mode_, near.at) != sign) return false;
      const Location location = locate(marked_, mode_, near.at, sign);
      if (location.status != LocationStatus::inside) return false;
      const Aspect& aspect = map_.aspects[static_cast<std::size_t>(location.aspect - 1)];
      if (aspect.determinant_sign == sign) held.aspect = location.aspect;
      return held.aspect != 0;
    });
    return held;
  }

  std::optional<NearPosition> find_unreachable(std::size_t leg) const {
    std::optional<NearPosition> found;
    visit_positions([&](const NearPosition& near) {
      if (is_unreachable(near.at, leg)) found = near;
      return found.has_value();
    });
    return found;
  }

  bool is_unreachable(const MapPosition& at, std::size_t leg) const {
    const Box point{map_.tree.dimension(), at.point, at.point};
    return (map_.classifier->facts(at.root, point, mode_).unreachable & BoxFacts::bit(leg)) != 0;
  }

  /// Where a serial margin keeps aspects apart: straight on, down the slope of B_jj^2, to where the leg does
  /// not reach.
  std::optional<NearPosition> find_beyond_margin(const NearPosition& from, std::size_t leg) const {
    const Conditions conditions = map_.classifier->conditions(from.at, mode_, 1);
    if (conditions.count == 0) return std::nullopt;
    const Condition& entry = conditions.items[conditions.entry_of_leg[leg]];
    double square = 0.0;
    for (const double slope : entry.slope) square += slope * slope;
    if (!(square > 0.0)) return std::nullopt;
    NearPosition to = from;
    for (const double share : {1.02, 1.1, 1.3, 1.7, 2.5}) {
      for (std::size_t i = 0; i < map_.tree.dimension(); ++i)
        to.at.point[i] = from.at.point[i] - share * entry.value / square * entry.slope[i];
      if (map_.tree.region().nearest(to.at.point) != to.at.point) return std::nullopt;
      if (is_unreachable(to.at, leg)) return to;
    }
    return std::nullopt;
  }

  const MarkedMap& marked_;
  const AspectMap::Contents& map_;
  std::size_t mode_;
  RootIndex root_;
  Box box_;
};

}  // namespace

std::optional<LeafCrossing> find_parallel_crossing(const MarkedMap& map, NodeIndex leaf, std::size_t mode) {
  return LeafSearch(map, leaf, mode).parallel();
}

std::optional<LeafCrossing> find_serial_crossing(const MarkedMap& map, NodeIndex leaf, std::size_t mode,
                                                 std::size_t other_mode, std::size_t leg, int sign) {
  return LeafSearch(map, leaf, mode).serial(other_mode, leg, sign);
}

std::vector<Pose> poses_of(const PoseSpace& space, const CrossingPath& path) {
  std::vector<Pose> result{space.pose({path.segments.front().root, path.segments.front().from})};
  for (std::size_t i = 0; i < path.count; ++i)
    result.push_back(space.pose({path.segments[i].root, path.segments[i].to}));
  return result;
}

Pose middle_of(const PoseSpace& space, const CrossingPath& path) {
  const CrossingSegment& first = path.segments.front();
  if (path.count == 2) return space.pose({first.root, first.to});
  MapPosition result{first.root, {}};
  for (std::size_t i = 0; i < first.dimension; ++i) result.point[i] = 0.5 * (first.from[i] + first.to[i]);
  return space.pose(result);
}

namespace {

CrossingSegment image(const PoseSymmetry& poses, const CrossingSegment& segment) {
  return {segment.dimension, poses.image(segment.root), poses.image({segment.root, segment.from}).point,
          poses.image({segment.root, segment.to}).point};
}

CrossingPath image(const PoseSymmetry& poses, const CrossingPath& path) {
  CrossingPath result = path;
  for (std::size_t i = 0; i < path.count; ++i) result.segments[i] = image(poses, path.segments[i]);
  return result;
}

CrossingPath reversed(CrossingPath path) {
  for (std::size_t i = 0; i < path.count; ++i) std::swap(path.segments[i].from, path.segments[i].to);
  if (path.count == 2) std::swap(path.segments[0], path.segments[1]);
  return path;
}

/// The aspect at a position, if it has this sign of det A; else 0.
int aspect_at(const MarkedMap& map, std::size_t mode, int sign, const MapPosition& position) {
  const Location location = locate(map, mode, position);
  if (location.status != LocationStatus::inside) return 0;
  const auto index = static_cast<std::size_t>(location.aspect - 1);
  return map.map.aspects[index].determinant_sign == sign ? location.aspect : 0;
}

std::optional<LeafCrossing> parallel_image(const MarkedMap& map, const LeafCrossing& crossing,
                                           const GateClasses::Image& to) {
  CrossingPath path = image(to.symmetry->poses, crossing.path);
  if (to.symmetry->determinant_sign < 0) path = reversed(path);
  const CrossingSegment &first = path.segments.front(), &last = path.last();
  const int positive = aspect_at(map, to.to.mode, 1, {first.root, first.from}),
            negative = aspect_at(map, to.to.mode, -1, {last.root, last.to});
  if (positive == 0 || negative == 0) return std::nullopt;
  const bool proved = crossing.proved && crosses_parallel_singularity(*map.map.classifier, path, to.to.mode);
  return LeafCrossing{positive, negative, proved, path};
}

std::optional<LeafCrossing> serial_image(const MarkedMap& map, const LeafCrossing& crossing, int sign,
                                         const GateClasses::Image& to) {
  const CrossingPath path = image(to.symmetry->poses, crossing.path);
  const MapPosition start{path.segments.front().root, path.segments.front().from};
  const std::size_t other = *other_mode(map.map, to.to);
  const int image_sign = sign * to.symmetry->determinant_sign;
  const int here = aspect_at(map, to.to.mode, image_sign, start),
            there = aspect_at(map, other, image_sign, start);
  if (here == 0 || there == 0) return std::nullopt;
  const bool proved = crossing.proved && crosses_serial_singularity(*map.map.classifier, path, to.to.mode,
                                                                    other, to.to.leg, image_sign);
  return LeafCrossing{here, there, proved, path};
}

}  // namespace

std::optional<std::size_t> other_mode(const AspectMap::Contents& map, const GateClass& gates) {
  WorkingMode mode = map.modes[gates.mode];
  if (gates.crossing == Crossing::parallel || mode.sign(gates.leg) < 0) return std::nullopt;
  mode.set_sign(gates.leg, -1);
  return mode_index(map, mode);
}

GateClasses::GateClasses(const AspectMap::Contents& map) : is_needed_(map.modes.size()) {
  if (!map.slice) symmetries_ = find_map_symmetries(*map.manipulator, map.tree.region(), map.modes);
  for (std::size_t mode = 0; mode < map.modes.size(); ++mode) {
    add(map, {Crossing::parallel, mode, 0});
    for (std::size_t leg = 0; leg < map.modes[mode].leg_count(); ++leg)
      if (other_mode(map, {Crossing::serial, mode, leg})) add(map, {Crossing::serial, mode, leg});
  }
}

void GateClasses::add(const AspectMap::Contents& map, const GateClass& gates) {
  for (const MapSymmetry& symmetry : symmetries_)
    for (const GateClass& known : searched_)
      if (image(map, symmetry, known) == gates) {
        images_.push_back({known, gates, &symmetry});
        return;
      }
  searched_.push_back(gates);
  is_needed_[gates.mode] = true;
  if (const auto other = other_mode(map, gates)) is_needed_[*other] = true;
}

/// The modes at both sides have images that differ in one leg.
std::optional<GateClass> GateClasses::image(const AspectMap::Contents& map, const MapSymmetry& symmetry,
                                            const GateClass& gates) {
  const std::size_t mode = symmetry.mode_image[gates.mode];
  if (gates.crossing == Crossing::parallel) return GateClass{Crossing::parallel, mode, 0};
  const std::size_t other = symmetry.mode_image[*other_mode(map, gates)];
  for (std::size_t leg = 0; leg < map.modes[mode].leg_count(); ++leg)
    if (map.modes[mode].sign(leg) != map.modes[other].sign(leg))
      return GateClass{Crossing::serial, map.modes[mode].sign(leg) > 0 ? mode : other, leg};
  return std::nullopt;
}

bool GateClasses::is_searched(const GateClass& gates) const noexcept {
  return std::find(searched_.begin(), searched_.end(), gates) != searched_.end();
}

std::optional<LeafCrossing> image_of(const MarkedMap& map, const LeafCrossing& crossing, int sign,
                                     const GateClasses::Image& image) {
  return image.of.crossing == Crossing::serial ? serial_image(map, crossing, sign, image)
                                               : parallel_image(map, crossing, image);
}

}  // namespace parallel_aspects
