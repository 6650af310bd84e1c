// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/part_proof.h"
#include "aspects/boxes/segment_proof.h"
#include "aspects/components/climb.h"
#include "aspects/components/disjoint_sets.h"
#include "aspects/map/map_computation.h"
#include "interval/interval.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

struct Case {
  const char* name;
  std::function<std::shared_ptr<const Manipulator>()> make;
  std::uint32_t depth;
};

std::ostream& operator<<(std::ostream& out, const Case& robot) { return out << robot.name; }

/// Leaves of a base map with parts that are said to be whole.
class WholePartsTest : public testing::TestWithParam<Case> {
 protected:
  WholePartsTest() {
    Box positions;
    if (const auto reachable = classifier->reachable_positions(); reachable && reachable->dimension > 0)
      positions = *exact_region(*reachable);
    tree = std::make_unique<PoseTree>(
        make_pose_space(robot->task_space(), positions, robot->characteristic_length()), modes.size());
    grow_base_map(*tree, *classifier, GetParam().depth, Detail::parts, {});
  }

  struct Part {
    NodeIndex node;
    std::size_t mode;
    int sign;
  };

  std::vector<Part> whole_parts() const {
    std::vector<Part> parts;
    for (NodeIndex node = 0; node < tree->node_count(); ++node)
      for (std::size_t mode = 0; mode < modes.size(); ++mode)
        for (const int sign : {1, -1}) {
          const LeafState state = tree->state(node, mode);
          if (state.is_undecided() && state.is_whole(sign)) parts.push_back({node, mode, sign});
        }
    return parts;
  }

  bool holds(const MapPosition& position, const Part& part) const {
    const Pose pose = tree->space().pose(position);
    const InverseSolution solution = inverse(*robot, pose, modes[part.mode]);
    if (solution.status != InverseStatus::solved) return false;
    return direct_determinant(*robot, pose, solution.q) * part.sign > 0.0;
  }

  /// Sizes of the connected sets of grid points that hold poses of the part, largest first.
  std::vector<int> grid_components(const Part& part, int points) const {
    const Box box = tree->box(part.node);
    const std::size_t total = static_cast<std::size_t>(std::pow(points, box.dimension) + 0.5);
    std::vector<bool> held(total);
    DisjointSets sets(total);
    for (std::size_t index = 0; index < total; ++index) {
      MapPosition position{tree->place(part.node).root, {}};
      std::size_t rest = index, stride = 1;
      for (std::size_t i = 0; i < box.dimension; ++i, rest /= static_cast<std::size_t>(points))
        position.point[i] =
            box.lower[i] +
            box.width(i) * (static_cast<double>(rest % static_cast<std::size_t>(points)) + 0.5) / points;
      held[index] = holds(position, part);
      rest = index;
      for (std::size_t i = 0; i < box.dimension;
           ++i, rest /= static_cast<std::size_t>(points), stride *= static_cast<std::size_t>(points))
        if (held[index] && rest % static_cast<std::size_t>(points) > 0 && held[index - stride])
          sets.unite(static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index - stride));
    }
    std::map<std::uint32_t, int> size;
    for (std::size_t index = 0; index < total; ++index)
      if (held[index]) ++size[sets.find(static_cast<std::uint32_t>(index))];
    std::vector<int> sizes;
    for (const auto& each : size) sizes.push_back(each.second);
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes;
  }

  std::shared_ptr<const Manipulator> robot = GetParam().make();
  std::vector<WorkingMode> modes = working_modes(*robot);
  std::unique_ptr<const BoxClassifier> classifier = make_box_classifier(*robot, modes);
  std::unique_ptr<PoseTree> tree;
};

// Against a flood fill of grid points. Wedges thinner than the grid fall apart there, so that small sets of
// points beside the largest say nothing.
TEST_P(WholePartsTest, AreConnectedOnAGrid) {
  std::vector<Part> parts = whole_parts();
  ASSERT_GT(parts.size(), 50U);
  std::mt19937 random(7);
  std::shuffle(parts.begin(), parts.end(), random);
  const bool flat = tree->dimension() == 2;
  const int points = flat ? 40 : 14;
  for (std::size_t i = 0; i < std::min(parts.size(), test::thinned<std::size_t>(flat ? 300 : 50)); ++i) {
    const std::vector<int> sizes = grid_components(parts[i], points);
    if (sizes.size() < 2) continue;
    EXPECT_LT(sizes[1], 3 * points) << "node " << parts[i].node << ", mode "
                                    << to_string(modes[parts[i].mode]) << ", sign " << parts[i].sign;
  }
}

TEST_P(WholePartsTest, PartsThatAreProvedEmptyHoldNoGridPointAndOthersTheirPose) {
  std::vector<Part> parts = whole_parts();
  std::mt19937 random(8);
  std::shuffle(parts.begin(), parts.end(), random);
  int known = 0;
  parts.resize(std::min(parts.size(), test::thinned<std::size_t>(100)));
  for (const Part& each : parts) {
    parallel_aspects::Part found;
    {
      const RoundingUpward rounding;
      found = find_part(*classifier, each.mode, each.sign, tree->place(each.node).root, tree->box(each.node));
    }
    known += found.kind != parallel_aspects::Part::Kind::unknown;
    if (found.kind == parallel_aspects::Part::Kind::empty) {
      EXPECT_TRUE(grid_components(each, 8).empty()) << "node " << each.node;
    }
    if (found.kind == parallel_aspects::Part::Kind::connected) {
      EXPECT_TRUE(tree->box(each.node).contains(found.pose));
      const RoundingUpward rounding;
      EXPECT_EQ(
          proved_sign(*classifier, tree->dimension(), each.mode, {tree->place(each.node).root, found.pose}),
          each.sign);
    }
  }
  EXPECT_GT(known, static_cast<int>(0.9 * static_cast<double>(parts.size())));
}

// Every step of a climb stays in the set, and ends clearer than it began.
TEST_P(WholePartsTest, ClimbsLeadIntoTheOpen) {
  std::vector<Part> parts = whole_parts();
  std::mt19937 random(9);
  std::shuffle(parts.begin(), parts.end(), random);
  int climbed = 0;
  for (std::size_t i = 0; i < std::min(parts.size(), test::thinned<std::size_t>(40)); ++i) {
    const Part& each = parts[i];
    const RoundingUpward rounding;
    const RootIndex root = tree->place(each.node).root;
    const auto found = find_part(*classifier, each.mode, each.sign, root, tree->box(each.node));
    if (found.kind != parallel_aspects::Part::Kind::connected) continue;
    const ClimbPolicy policy;
    Climb climb(*classifier, tree->space(), each.mode, each.sign, {root, found.pose}, policy);
    int steps = 0;
    while (steps < 30 && climb.step()) {
      ++steps;
      ASSERT_EQ(proved_sign(*classifier, tree->dimension(), each.mode, climb.position()), each.sign);
    }
    climbed += steps > 0;
  }
  EXPECT_GT(climbed, test::thinned(10));
}

INSTANTIATE_TEST_SUITE_P(Robots, WholePartsTest,
                         testing::Values(Case{"five_bar", test::five_bar, 6}, Case{"bipod", test::bipod, 6},
                                         Case{"three_rpr", test::three_rpr, 5},
                                         Case{"three_rrr", test::three_rrr, 6},
                                         Case{"actuated_elbow", test::three_rrr_actuated_elbow, 6},
                                         Case{"delta", test::delta, 6}),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace parallel_aspects
