// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/neighbours.h"

#include "parallel_aspects/aspects/crossing_proof.h"
#include "parallel_aspects/aspects/interval.h"
#include "parallel_aspects/aspects/map_contents.h"
#include "parallel_aspects/aspects/map_location.h"
#include "parallel_aspects/aspects/segment_proof.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_leaves = 20000;  // of one working mode that are looked at
constexpr int most_attempts = 30;           // to prove a pair

using Key = std::tuple<int, int, Crossing, std::size_t>;

struct Finding {
  bool proved = false;
  int attempts = 0;
  Pose pose;
};

/// A proved configuration and the aspect that holds it.
struct Held {
  MapPosition at;
  int aspect = 0;
};

/// Crossings in the undecided leaves of one working mode.
class ModeNeighbours {
 public:
  ModeNeighbours(const AspectMap::Contents& map, std::size_t mode, const MapControl& control)
      : map_(map), mode_(mode), control_(control) {}

  std::map<Key, Finding> run() {
    const RoundingUpward rounding;
    std::vector<NodeIndex> leaves;
    for (NodeIndex node = 0; node < map_.tree.node_count(); ++node)
      if (map_.tree.state(node, mode_).is_undecided()) leaves.push_back(node);
    const std::size_t step = 1 + leaves.size() / most_leaves;
    for (std::size_t i = 0; i < leaves.size() && !is_cancelled(control_); i += step) look_at(leaves[i]);
    return std::move(found_);
  }

 private:
  void look_at(NodeIndex leaf) {
    const Box box = map_.tree.box(leaf);
    const RootIndex root = map_.tree.place(leaf).root;
    const BoxFacts facts = map_.classifier->facts(root, box, mode_);
    if (facts.all_clear_but(0)) return look_for_parallel(root, box);
    for (std::size_t j = 0; j < map_.modes[mode_].leg_count(); ++j)
      if (map_.modes[mode_].sign(j) > 0 && facts.all_clear_but(BoxFacts::bit(j)))
        return look_for_serial(root, box, j);
  }

  void look_for_parallel(RootIndex root, const Box& box) {
    const Held positive = find_held(root, box, mode_, 1), negative = find_held(root, box, mode_, -1);
    if (positive.aspect == 0 || negative.aspect == 0) return;
    add(positive.aspect, negative.aspect, Crossing::parallel, 0,
        {box.dimension, root, positive.at.point, negative.at.point}, [&](const CrossingSegment& segment) {
          return crosses_parallel_singularity(*map_.classifier, segment, mode_);
        });
  }

  void look_for_serial(RootIndex root, const Box& box, std::size_t leg) {
    WorkingMode flipped = map_.modes[mode_];
    flipped.set_sign(leg, -1);
    const auto other = mode_index(map_, flipped);
    const std::optional<MapPoint> beyond = find_unreachable(root, box, leg);
    if (!other || !beyond) return;
    for (const int sign : {1, -1}) {
      const Held here = find_held(root, box, mode_, sign);
      if (here.aspect == 0 || proved_sign(*map_.classifier, box.dimension, *other, here.at) != sign) continue;
      const Location there = locate(map_, *other, here.at);
      if (there.status != LocationStatus::inside) continue;
      add(here.aspect, there.aspect, Crossing::serial, leg, {box.dimension, root, here.at.point, *beyond},
          [&](const CrossingSegment& segment) {
            return crosses_serial_singularity(*map_.classifier, segment, mode_, *other, leg, sign);
          });
    }
  }

  template <class Proof>
  void add(int one, int other, Crossing crossing, std::size_t leg, const CrossingSegment& segment,
           const Proof& proof) {
    Finding& finding = found_[{std::min(one, other), std::max(one, other), crossing, leg}];
    if (finding.proved || finding.attempts == most_attempts) return;
    ++finding.attempts;
    finding.proved = proof(segment);
    MapPosition middle{segment.root, {}};
    for (std::size_t i = 0; i < segment.dimension; ++i)
      middle.point[i] = 0.5 * (segment.from[i] + segment.to[i]);
    if (finding.proved || finding.attempts == 1) finding.pose = map_.tree.space().pose(middle);
  }

  /// The middle of the box, its corners, and those of a box twice as large: a singularity may lie on a face.
  template <class Visit>
  void visit_points(const Box& box, const Visit& visit) const {
    if (visit(box.middle())) return;
    const Box& region = map_.tree.region();
    for (const double share : {0.5, 1.0})
      for (std::uint32_t corner = 0; corner < 1U << box.dimension; ++corner) {
        MapPoint point{};
        for (std::size_t i = 0; i < box.dimension; ++i) {
          const double away = (corner >> i & 1U) != 0 ? share : -share;
          point[i] = std::clamp(box.center(i) + away * box.width(i), region.lower[i], region.upper[i]);
        }
        if (visit(point)) return;
      }
  }

  Held find_held(RootIndex root, const Box& box, std::size_t mode, int sign) const {
    Held held;
    visit_points(box, [&](const MapPoint& point) {
      held.at = {root, point};
      if (proved_sign(*map_.classifier, box.dimension, mode, held.at) != sign) return false;
      const Location location = locate(map_, mode, held.at);
      if (location.status != LocationStatus::inside) return false;
      const Aspect& aspect = map_.aspects[static_cast<std::size_t>(location.aspect - 1)];
      if (aspect.determinant_sign == sign) held.aspect = location.aspect;
      return held.aspect != 0;
    });
    return held;
  }

  std::optional<MapPoint> find_unreachable(RootIndex root, const Box& box, std::size_t leg) const {
    std::optional<MapPoint> found;
    visit_points(box, [&](const MapPoint& point) {
      const BoxFacts facts = map_.classifier->facts(root, Box{box.dimension, point, point}, mode_);
      if ((facts.unreachable & BoxFacts::bit(leg)) != 0) found = point;
      return found.has_value();
    });
    return found;
  }

  const AspectMap::Contents& map_;
  std::size_t mode_;
  const MapControl& control_;
  std::map<Key, Finding> found_;
};

}  // namespace

std::vector<Neighbours> find_neighbours(const AspectMap& map, const MapControl& control) {
  const AspectMap::Contents& contents = map.contents();
  std::vector<std::map<Key, Finding>> found(contents.modes.size());
  tbb::parallel_for(std::size_t{0}, found.size(),
                    [&](std::size_t mode) { found[mode] = ModeNeighbours(contents, mode, control).run(); });
  std::vector<Neighbours> result;
  if (is_cancelled(control)) return result;
  // A parallel crossing belongs to one mode and a serial one is looked for from one of its two.
  for (const auto& of_mode : found)
    for (const auto& [key, finding] : of_mode) {
      const auto [first, second, crossing, leg] = key;
      result.push_back({first, second, crossing, leg, finding.proved, finding.pose});
    }
  std::sort(result.begin(), result.end(), [](const Neighbours& a, const Neighbours& b) {
    return std::tie(a.first, a.second, a.leg) < std::tie(b.first, b.second, b.leg);
  });
  return result;
}

const char* name(Crossing crossing) noexcept { return crossing == Crossing::serial ? "serial" : "parallel"; }

}  // namespace parallel_aspects
