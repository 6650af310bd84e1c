// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/gate_classes.h"

#include "aspects/map/map_location.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
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
