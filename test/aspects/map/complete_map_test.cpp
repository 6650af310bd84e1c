// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/sign_at.h"
#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

/// Pieces of S(mode, sign) on grids of poses, in double precision and without any proof of the package.
class Floods {
 public:
  Floods(const AspectMap& map, std::size_t mode, int sign) : map_(map.contents()), mode_(mode), sign_(sign) {}

  bool is_in_set(const MapPosition& at) const {
    return map_.tree.region().contains(at.point) &&
           test::sign_in_doubles(*map_.manipulator, map_.tree.space().pose(at), map_.modes[mode_]) == sign_;
  }

  /// Aspects that a pose is joined with: out of thin pieces by grids that grow about what lies deepest of the
  /// one before.
  std::set<int> aspects_of(const MapPosition& start, const Box& leaf) {
    flood(start, leaf, 2.0);
    MapPosition from = start;
    for (double share = 0x1p-14; aspects_.empty() && share < 2.0; share *= 2.0)
      from = flood(from, leaf, share);
    for (int i = 0; aspects_.empty() && i < max_grids; ++i) from = flood(from, leaf, i % 4 == 3 ? 8.0 : 2.0);
    return aspects_;
  }

  /// Straight edges of the grid are examined in so many places.
  int places = 2;

 private:
  static constexpr int max_grids = 60, half = 6, count = 2 * half + 1, nodes = count * count * count;

  /// Of the grid about a pose, over so many times the edges of the leaf. Returns a deep pose of the piece
  /// that holds `from`.
  MapPosition flood(const MapPosition& from, const Box& leaf, double share) {
    from_ = from;
    for (std::size_t i = 0; i < 3; ++i) step_[i] = share * leaf.width(i) / (2 * half);
    std::vector<int> depth(nodes, -1);  // 0 in the piece
    std::vector<int> piece{nodes / 2};
    depth[nodes / 2] = 0;
    for (std::size_t head = 0; head < piece.size(); ++head) {
      note_aspect(piece[head]);
      for_each_neighbour(piece[head], [&](int neighbour) {
        if (depth[neighbour] >= 0 || !is_edge_free(piece[head], neighbour)) return;
        depth[neighbour] = 0;
        piece.push_back(neighbour);
      });
    }
    return position(deepest(piece, depth));
  }

  /// The node that is the farthest from nodes which are not in the piece.
  int deepest(std::vector<int> piece, std::vector<int>& depth) const {
    int best = nodes / 2;
    for (int level = 1; !piece.empty(); ++level) {
      std::vector<int> rest;
      for (const int node : piece) {
        bool is_deep = true;
        for_each_neighbour(node, [&](int neighbour) { is_deep = is_deep && depth[neighbour] >= level - 1; });
        if (is_deep) rest.push_back(node);
      }
      for (const int node : rest) depth[node] = level;
      if (!rest.empty()) best = rest[rest.size() / 2];
      if (rest.size() == piece.size()) break;
      piece.swap(rest);
    }
    return best;
  }

  template <class Visit>
  static void for_each_neighbour(int node, const Visit& visit) {
    for (int stride = 1; stride < nodes; stride *= count)
      for (const int side : {-1, 1}) {
        const int place = node / stride % count + side;
        if (place >= 0 && place < count) visit(node + side * stride);
      }
  }

  MapPosition position(int node) const {
    MapPosition at = from_;
    for (std::size_t i = 0; i < 3; ++i, node /= count) at.point[i] += (node % count - half) * step_[i];
    return at;
  }

  bool is_edge_free(int a, int b) const {
    const MapPosition from = position(a), to = position(b);
    for (int k = 1; k <= places; ++k) {
      MapPosition at = from;
      for (std::size_t i = 0; i < 3; ++i) at.point[i] += k * (to.point[i] - from.point[i]) / places;
      if (!is_in_set(at)) return false;
    }
    return true;
  }

  void note_aspect(int node) {
    const auto leaf = map_.tree.leaf_at(position(node), mode_);
    if (leaf && map_.leaf_aspect(*leaf, mode_) != 0) aspects_.insert(map_.leaf_aspect(*leaf, mode_));
  }

  const AspectMap::Contents& map_;
  std::size_t mode_;
  int sign_;
  MapPosition from_;
  std::array<double, 3> step_{};
  std::set<int> aspects_;
};

struct CompleteMapCase {
  const char* name;
  SharedMechanism (*mechanism)();
  std::vector<std::size_t> modes;  // all if empty
  std::size_t aspects;
};

void PrintTo(const CompleteMapCase& each, std::ostream* out) { *out << each.name; }

class CompleteMapTest : public testing::TestWithParam<CompleteMapCase> {
 protected:
  static int floods() {
    const char* asked = std::getenv("PARALLEL_ASPECTS_FLOODS");  // for longer campaigns
    return asked == nullptr ? 150 : std::atoi(asked);
  }

  MapPosition random_in(NodeIndex leaf, const AspectMap::Contents& map) {
    const Box box = map.tree.box(leaf);
    MapPosition at{map.tree.place(leaf).root, {}};
    for (std::size_t i = 0; i < 3; ++i)
      at.point[i] = std::uniform_real_distribution<double>(box.lower[i], box.upper[i])(engine_);
    return at;
  }

  /// A pose of the set in an undecided leaf: 0 where it is in none.
  int sign_of(const MapPosition& at, const AspectMap::Contents& map, std::size_t mode) const {
    return test::sign_at(*map.manipulator, map.tree.space().pose(at), map.modes[mode]).value_or(0);
  }

  std::mt19937_64 engine_{20261126};
};

TEST_P(CompleteMapTest, EveryPieceBelongsToOneListedAspect) {
  const auto robot = GetParam().mechanism()->mapped_manipulator();
  MapOptions options;
  for (const std::size_t mode : GetParam().modes) options.modes.push_back(working_modes(*robot)[mode]);
  options.complete = true;
  const MapResult result = compute_aspect_map(robot, options);
  ASSERT_TRUE(result.map) << result.message;
  EXPECT_EQ(result.map->proved_count(), GetParam().aspects);
  ASSERT_EQ(result.map->count_at_most().value_or(0), GetParam().aspects);
  const AspectMap::Contents& map = result.map->contents();
  int flooded = 0;
  for (int trial = 0; flooded < floods() && trial < 1000 * floods(); ++trial) {
    const auto leaf = static_cast<NodeIndex>(engine_() % map.tree.node_count());
    const std::size_t mode = engine_() % map.modes.size();
    if (!map.tree.state(leaf, mode).is_undecided()) continue;
    const MapPosition at = random_in(leaf, map);
    const int sign = sign_of(at, map, mode);
    if (sign == 0) continue;
    ++flooded;
    Floods coarse(*result.map, mode, sign);
    std::set<int> met = coarse.aspects_of(at, map.tree.box(leaf));
    if (met.size() > 1) {  // an edge may have jumped over a sheet
      Floods fine(*result.map, mode, sign);
      fine.places = 64;
      met = fine.aspects_of(at, map.tree.box(leaf));
    }
    ASSERT_EQ(met.size(), 1U) << testing::PrintToString(at.point) << " of root " << at.root << " in "
                              << to_string(map.modes[mode]) << ", sign " << sign;
    const Aspect& aspect = result.map->aspects()[static_cast<std::size_t>(*met.begin() - 1)];
    EXPECT_EQ(aspect.determinant_sign, sign);
    EXPECT_EQ(aspect.mode, map.modes[mode]);
  }
  EXPECT_EQ(flooded, floods());
}

INSTANTIATE_TEST_SUITE_P(Robots, CompleteMapTest,
                         testing::Values(CompleteMapCase{"linear_delta", models::linear_delta, {}, 14},
                                         CompleteMapCase{"three_prr", models::three_prr, {0}, 2}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace parallel_aspects
