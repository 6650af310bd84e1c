// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/neighbours.h"

#include "aspects/boxes/crossing_proof.h"
#include "aspects/boxes/segment_proof.h"
#include "aspects/map/map_contents.h"
#include "aspects/map/map_location.h"
#include "interval/interval.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t leaves_of_a_share = 20000;  // of one working mode
constexpr int max_attempts = 30;                  // to prove a pair

using Key = std::tuple<int, int, Crossing, std::size_t>;

struct Finding {
  bool proved = false;
  int attempts = 0;
  Pose pose;
  std::vector<Pose> segment;
};

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
    const std::size_t shares = 1 + leaves.size() / leaves_of_a_share;
    has_news_ = true;
    for (std::size_t share = 0; share < shares && has_news_; ++share) {
      has_news_ = false;
      for (std::size_t i = share; i < leaves.size() && !is_cancelled(control_); i += shares)
        look_at(leaves[i]);
    }
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
    if (all_proved(Crossing::parallel, 0, 1, mode_, -1)) return;
    const Held positive = find_held(root, box, mode_, 1), negative = find_held(root, box, mode_, -1);
    if (positive.aspect == 0 || negative.aspect == 0) return;
    add(positive.aspect, negative.aspect, {Crossing::parallel, 0, 1},
        path(root, positive.near, negative.near), [&](const CrossingPath& path) {
          return crosses_parallel_singularity(*map_.classifier, path, mode_);
        });
  }

  void look_for_serial(RootIndex root, const Box& box, std::size_t leg) {
    WorkingMode flipped = map_.modes[mode_];
    flipped.set_sign(leg, -1);
    const auto other = mode_index(map_, flipped);
    const auto is_done = [&](int sign) { return all_proved(Crossing::serial, leg, sign, *other, sign); };
    if (!other || (is_done(1) && is_done(-1))) return;
    const std::optional<NearPosition> near = find_unreachable(root, box, leg);
    if (!near && !has_serial_margin()) return;
    for (const int sign : {1, -1}) {
      if (is_done(sign)) continue;
      const Held here = find_held(root, box, mode_, sign);
      const MapPosition& at = here.near.at;
      if (here.aspect == 0 || proved_sign(*map_.classifier, box.dimension, *other, at) != sign) continue;
      const Location there = locate(map_, *other, at);
      if (there.status != LocationStatus::inside) continue;
      const std::optional<NearPosition> end = near ? near : find_beyond_margin(here.near, leg);
      if (!end) continue;
      add(here.aspect, there.aspect, {Crossing::serial, leg, sign}, path(root, here.near, *end),
          [&](const CrossingPath& path) {
            return crosses_serial_singularity(*map_.classifier, path, mode_, *other, leg, sign);
          });
    }
  }

  /// Crossings of one kind from the aspects of this mode with this sign of det A.
  using Side = std::tuple<Crossing, std::size_t, int>;

  std::size_t count_aspects(std::size_t mode, int sign) const {
    return static_cast<std::size_t>(
        std::count_if(map_.aspects.begin(), map_.aspects.end(), [&](const Aspect& aspect) {
          return aspect.mode == map_.modes[mode] && aspect.determinant_sign == sign;
        }));
  }

  /// Whether there is no pair left to look for: most aspects are alone in their mode and sign.
  bool all_proved(Crossing crossing, std::size_t leg, int sign, std::size_t other_mode, int other_sign) {
    const auto [side, is_new] = open_pairs_.try_emplace({crossing, leg, sign}, 0);
    if (is_new) side->second = count_aspects(mode_, sign) * count_aspects(other_mode, other_sign);
    return side->second == 0;
  }

  template <class Proof>
  void add(int one, int other, const Side& side, const std::optional<CrossingPath>& path,
           const Proof& proof) {
    if (!path) return;
    Finding& finding =
        found_[{std::min(one, other), std::max(one, other), std::get<Crossing>(side), std::get<1>(side)}];
    if (finding.proved || finding.attempts == max_attempts) return;
    ++finding.attempts;
    has_news_ = has_news_ || finding.attempts == 1;
    finding.proved = proof(*path);
    if (finding.proved) {
      --open_pairs_[side];
      has_news_ = true;
      finding.segment = poses(*path);
    }
    if (finding.proved || finding.attempts == 1) finding.pose = map_.tree.space().pose(middle(*path));
  }

  std::vector<Pose> poses(const CrossingPath& path) const {
    const PoseSpace& space = map_.tree.space();
    std::vector<Pose> result{space.pose({path.segments.front().root, path.segments.front().from})};
    for (std::size_t i = 0; i < path.count; ++i)
      result.push_back(space.pose({path.segments[i].root, path.segments[i].to}));
    return result;
  }

  static MapPosition middle(const CrossingPath& path) {
    const CrossingSegment& first = path.segments.front();
    if (path.count == 2) return {first.root, first.to};
    MapPosition result{first.root, {}};
    for (std::size_t i = 0; i < first.dimension; ++i) result.point[i] = 0.5 * (first.from[i] + first.to[i]);
    return result;
  }

  /// The path between two positions near one leaf; nothing where they lie beyond different faces.
  std::optional<CrossingPath> path(RootIndex root, const NearPosition& from, const NearPosition& to) const {
    const std::size_t dimension = map_.tree.dimension();
    if (from.beyond == to.beyond && from.at.root == to.at.root)
      return CrossingPath{{CrossingSegment{dimension, from.at.root, from.at.point, to.at.point}}, 1};
    if (from.beyond && to.beyond) return std::nullopt;
    const NearPosition& far = from.beyond ? from : to;
    const MapPosition face{root, far.on_face}, other_side = map_.tree.space().across(face, *far.beyond);
    const CrossingSegment here{dimension, root, from.at.point, face.point},
        there{dimension, far.at.root, other_side.point, far.at.point};
    if (to.beyond) return CrossingPath{{here, there}, 2};
    return CrossingPath{{CrossingSegment{dimension, far.at.root, far.at.point, other_side.point},
                         CrossingSegment{dimension, root, face.point, to.at.point}},
                        2};
  }

  /// The middle of the box, its corners, and those of a box twice as large, since a singularity may lie on a
  /// face; at last those of them that are beyond a glued face.
  template <class Visit>
  void visit_positions(RootIndex root, const Box& box, const Visit& visit) const {
    if (visit(NearPosition{{root, box.middle()}, {}, {}})) return;
    const Box& region = map_.tree.region();
    for (const double share : {0.5, 1.0})
      for (std::uint32_t corner = 0; corner < 1U << box.dimension; ++corner)
        if (visit(NearPosition{{root, region.nearest(corner_of(box, corner, share))}, {}, {}})) return;
    for (std::size_t axis = 0; axis < box.dimension; ++axis)
      for (std::uint32_t corner = 0; corner < 1U << box.dimension; ++corner)
        if (const auto position = beyond_face(root, box, corner, axis); position && visit(*position)) return;
  }

  static MapPoint corner_of(const Box& box, std::uint32_t corner, double share) {
    MapPoint point{};
    for (std::size_t i = 0; i < box.dimension; ++i)
      point[i] = box.center(i) + ((corner >> i & 1U) != 0 ? share : -share) * box.width(i);
    return point;
  }

  /// Half the width of the box beyond its face at an end of the coordinate `axis`, where that face is glued.
  std::optional<NearPosition> beyond_face(RootIndex root, const Box& box, std::uint32_t corner,
                                          std::size_t axis) const {
    const Box& region = map_.tree.region();
    const bool upper = (corner >> axis & 1U) != 0;
    if (upper ? box.upper[axis] != region.upper[axis] : box.lower[axis] != region.lower[axis])
      return std::nullopt;
    const MapPoint on_face = region.nearest(corner_of(box, corner, 0.5));
    const auto position = map_.tree.space().beyond({root, on_face}, axis, 0.5 * box.width(axis));
    if (!position) return std::nullopt;
    return NearPosition{*position, axis, on_face};
  }

  Held find_held(RootIndex root, const Box& box, std::size_t mode, int sign) const {
    Held held;
    visit_positions(root, box, [&](const NearPosition& near) {
      held.near = near;
      if (proved_sign(*map_.classifier, box.dimension, mode, near.at) != sign) return false;
      const Location location = locate(map_, mode, near.at);
      if (location.status != LocationStatus::inside) return false;
      const Aspect& aspect = map_.aspects[static_cast<std::size_t>(location.aspect - 1)];
      if (aspect.determinant_sign == sign) held.aspect = location.aspect;
      return held.aspect != 0;
    });
    return held;
  }

  std::optional<NearPosition> find_unreachable(RootIndex root, const Box& box, std::size_t leg) const {
    std::optional<NearPosition> found;
    visit_positions(root, box, [&](const NearPosition& near) {
      if (is_unreachable(near.at, leg)) found = near;
      return found.has_value();
    });
    return found;
  }

  bool has_serial_margin() const { return map_.manipulator->constraints().margins.serial > 0.0; }

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

  const AspectMap::Contents& map_;
  std::size_t mode_;
  const MapControl& control_;
  std::map<Key, Finding> found_;
  std::map<Side, std::size_t> open_pairs_;  // of aspects, not proved to touch
  bool has_news_ = false;                   // since a share of the leaves was begun
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
      result.push_back({first, second, crossing, leg, finding.proved, finding.pose, finding.segment});
    }
  std::sort(result.begin(), result.end(), [](const Neighbours& a, const Neighbours& b) {
    return std::tie(a.first, a.second, a.leg) < std::tie(b.first, b.second, b.leg);
  });
  return result;
}

const char* name(Crossing crossing) noexcept { return crossing == Crossing::serial ? "serial" : "parallel"; }

}  // namespace parallel_aspects
