// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <tuple>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

struct Pair {
  int first, second;
  Crossing crossing;
  std::size_t leg;

  friend bool operator<(const Pair& a, const Pair& b) {
    return std::tie(a.first, a.second, a.crossing, a.leg) < std::tie(b.first, b.second, b.crossing, b.leg);
  }
  friend bool operator==(const Pair& a, const Pair& b) { return !(a < b) && !(b < a); }
  friend std::ostream& operator<<(std::ostream& out, const Pair& pair) {
    return out << pair.first << "-" << pair.second << " " << name(pair.crossing) << " " << pair.leg;
  }
};

Pair pair_of(int one, int other, Crossing crossing, std::size_t leg) {
  return {std::min(one, other), std::max(one, other), crossing, leg};
}

std::set<Pair> proved_pairs(const AspectMap& map) {
  std::set<Pair> pairs;
  for (const Neighbours& each : find_neighbours(map)) {
    EXPECT_LT(each.first, each.second);
    if (each.proved) pairs.insert({each.first, each.second, each.crossing, each.leg});
  }
  return pairs;
}

/// A second way, which proves nothing: steps of a fine grid from one configuration to the next, across
/// det A = 0 or out of reach of one leg.
class Grid {
 public:
  explicit Grid(const AspectMap& map) : map_(map), robot_(*map.manipulator()) {}

  /// Steps by pair, `cells` x `cells` times four.
  std::map<Pair, int> count(const Box& region, int cells) {
    cells_ = cells;
    for (int i = 0; i < cells; ++i)
      for (int k = 0; k < cells; ++k)
        for (const auto& [di, dk] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{-1, 0}, std::pair{0, -1}})
          for (const WorkingMode& mode : map_.working_modes()) {
            step(at(region, i, k), at(region, i + di, k + dk), mode);
          }
    return std::move(count_);
  }

 private:
  Pose at(const Box& region, int i, int k) const {
    Pose pose;
    pose.position << region.lower[0] + (i + 0.5) / cells_ * region.width(0),
        region.lower[1] + (k + 0.5) / cells_ * region.width(1), 0.0;
    return pose;
  }

  int sign(const Pose& pose, const WorkingMode& mode) const {
    const InverseSolution solution = inverse(robot_, pose, mode);
    if (solution.status != InverseStatus::solved) return 0;
    return direct_determinant(robot_, pose, solution.q) > 0.0 ? 1 : -1;
  }

  int aspect(const Pose& pose, const WorkingMode& mode) const {
    const Location location = map_.locate(pose, mode);
    return location.status == LocationStatus::inside ? location.aspect : 0;
  }

  void step(const Pose& from, const Pose& to, const WorkingMode& mode) {
    const int before = sign(from, mode);
    if (before == 0) return;
    const int after = sign(to, mode);
    if (after == -before)
      add(aspect(from, mode), aspect(to, mode), Crossing::parallel, 0);
    else if (after == 0)
      step_out(from, to, mode, before);
  }

  void step_out(const Pose& from, const Pose& to, const WorkingMode& mode, int before) {
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      if (squared_inverse_entry(robot_.leg(j), to.transform(robot_.leg(j).anchor)) > 0.0) continue;
      WorkingMode flipped = mode;
      flipped.set_sign(j, -mode.sign(j));
      if (sign(from, flipped) == before) add(aspect(from, mode), aspect(from, flipped), Crossing::serial, j);
    }
  }

  void add(int one, int other, Crossing crossing, std::size_t leg) {
    if (one != 0 && other != 0) ++count_[pair_of(one, other, crossing, leg)];
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  int cells_ = 0;
  std::map<Pair, int> count_;
};

struct RobotOfTwoDegrees {
  const char* name;
  std::function<Robot()> make;
};

class NeighboursOfTwoFreedoms : public testing::TestWithParam<RobotOfTwoDegrees> {};

// Pairs that a grid steps across often are proved, and a proved pair is one that a fine grid about its pose
// does.
TEST_P(NeighboursOfTwoFreedoms, AgreeWithSteppingOverAGrid) {
  const auto map = compute_aspect_map(GetParam().make()).map;
  ASSERT_TRUE(map);
  std::set<Pair> proved;
  for (const Neighbours& each : find_neighbours(*map)) {
    if (!each.proved) continue;
    const Pair pair{each.first, each.second, each.crossing, each.leg};
    proved.insert(pair);
    const double x = each.pose.position.x(), y = each.pose.position.y(), around = 2.0 * map->resolution();
    const Box near{2, {x - around, y - around, 0.0}, {x + around, y + around, 0.0}};
    // Steps that are too short end where the map does not tell the aspect.
    bool found = false;
    for (const int cells : {8, 15, 30, 60}) found = found || Grid(*map).count(near, cells).count(pair) == 1;
    EXPECT_TRUE(found) << pair;
  }
  EXPECT_FALSE(proved.empty());
  for (const auto& [pair, count] : Grid(*map).count(map->region(), test::is_sanitized ? 100 : 300))
    EXPECT_TRUE(count <= 8 || proved.count(pair) == 1) << pair << ", " << count << " steps";
}

INSTANTIATE_TEST_SUITE_P(Robots, NeighboursOfTwoFreedoms,
                         testing::Values(RobotOfTwoDegrees{"five_bar", test::five_bar},
                                         RobotOfTwoDegrees{"bipod", test::bipod},
                                         RobotOfTwoDegrees{"limited_five_bar", test::limited_five_bar}),
                         [](const auto& robot) { return std::string(robot.param.name); });

// The reflection in the base line flips all signs: it maps aspects to aspects, and so neighbours to
// neighbours.
TEST(Neighbours, OfTheFiveBarAreTheirOwnReflection) {
  MapOptions options;
  options.use_symmetry = false;
  const auto map = compute_aspect_map(test::five_bar(), options).map;
  const auto reflected = [&map](int id) {
    const Aspect& aspect = map->aspects()[static_cast<std::size_t>(id - 1)];
    Pose pose = aspect.deepest;
    pose.position.y() *= -1.0;
    WorkingMode mode(2);
    for (std::size_t j = 0; j < 2; ++j) mode.set_sign(j, -aspect.mode.sign(j));
    return map->locate(pose, mode).aspect;
  };
  const std::set<Pair> pairs = proved_pairs(*map);
  EXPECT_EQ(pairs.size(), 18U);
  std::set<Pair> images;
  for (const Pair& pair : pairs)
    images.insert(pair_of(reflected(pair.first), reflected(pair.second), pair.crossing, pair.leg));
  EXPECT_EQ(images, pairs);
}

TEST(Neighbours, DifferInTheLegThatCrossesOrInTheSignOfTheDeterminant) {
  for (const char* name : {"linear_delta", "three_prr"}) {
    const Robot robot = test::shipped(name)->manipulator();
    MapOptions options;
    options.resolution = robot->size() / 16.0;
    options.extra_levels = 6;
    const auto map = compute_aspect_map(robot, options).map;
    ASSERT_TRUE(map);
    const auto neighbours = find_neighbours(*map);
    EXPECT_GT(neighbours.size(), map->aspects().size());
    for (const Neighbours& each : neighbours) {
      const Aspect& one = map->aspects()[static_cast<std::size_t>(each.first - 1)];
      const Aspect& other = map->aspects()[static_cast<std::size_t>(each.second - 1)];
      WorkingMode expected = one.mode;
      if (each.crossing == Crossing::serial) expected.set_sign(each.leg, -one.mode.sign(each.leg));
      EXPECT_EQ(other.mode, expected) << each.first << "-" << each.second;
      const int factor = each.crossing == Crossing::serial ? 1 : -1;
      EXPECT_EQ(other.determinant_sign, factor * one.determinant_sign) << each.first << "-" << each.second;
    }
  }
}

// Near the pose of a proved crossing there are poses on both sides of it.
TEST(Neighbours, PosesAreCloseToWhatVanishes) {
  const Robot robot = test::shipped("three_rrr")->manipulator();
  MapOptions options;
  Problems problems;
  options.slice = make_slice(TaskSpace::SE2, {{"phi", 0.0}}, problems);
  options.extra_levels = 6;
  options.resolution = 0.3;
  const auto map = compute_aspect_map(robot, options).map;
  const double near = 4.0 * map->resolution(), size = robot->size();
  std::size_t proved = 0;
  for (const Neighbours& each : find_neighbours(*map)) {
    if (!each.proved) continue;
    ++proved;
    const Aspect& one = map->aspects()[static_cast<std::size_t>(each.first - 1)];
    const InverseSolution solution = inverse(*robot, each.pose, one.mode);
    if (each.crossing == Crossing::serial) {
      const Leg& leg = robot->leg(each.leg);
      const double entry = squared_inverse_entry(leg, each.pose.transform(leg.anchor));
      EXPECT_LT(std::abs(entry), near * size * size * size) << each.first << "-" << each.second;
    } else if (solution.status == InverseStatus::solved) {
      EXPECT_LT(std::abs(direct_determinant(*robot, each.pose, solution.q)), near * size * size * size);
    }
  }
  EXPECT_GT(proved, 27U);
}

/// The sign of det A; 0 where a leg does not reach.
int sign_of(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.status != InverseStatus::solved) return 0;
  return direct_determinant(robot, pose, solution.q) > 0.0 ? 1 : -1;
}

void expect_crossing(const AspectMap& map, const Neighbours& gate, const GateCrossing& crossing) {
  const Manipulator& robot = *map.manipulator();
  const Aspect &one = map.aspects()[static_cast<std::size_t>(gate.first - 1)],
               &other = map.aspects()[static_cast<std::size_t>(gate.second - 1)];
  const Pose &first = crossing.segment.front(), &last = crossing.segment.back();
  if (gate.crossing == Crossing::parallel) {
    EXPECT_EQ(sign_of(robot, first, one.mode), 1);
    EXPECT_EQ(sign_of(robot, last, one.mode), -1);
    return;
  }
  const Leg& leg = robot.leg(gate.leg);
  EXPECT_EQ(sign_of(robot, first, one.mode), one.determinant_sign);
  EXPECT_EQ(sign_of(robot, first, other.mode), one.determinant_sign);
  EXPECT_LT(squared_inverse_entry(leg, last.transform(leg.anchor)), 0.0);
}

// Several of a gate, the one that is farthest from other singularities first, and not all in one place.
TEST(Neighbours, CrossingsAreSpreadOverTheirGate) {
  const auto map = compute_aspect_map(test::five_bar()).map;
  const double size = map->manipulator()->size();
  std::size_t wide = 0, gates = 0;
  for (const Neighbours& gate : find_neighbours(*map)) {
    EXPECT_EQ(gate.proved, !gate.crossings.empty());
    if (!gate.proved) continue;
    double farthest = 0.0;
    for (const GateCrossing& crossing : gate.crossings) {
      SCOPED_TRACE(std::to_string(gate.first) + "-" + std::to_string(gate.second));
      expect_crossing(*map, gate, crossing);
      EXPECT_LE(crossing.index, gate.crossings.front().index);
      farthest = std::max(farthest, (crossing.pose.position - gate.pose.position).norm());
    }
    ++gates;
    wide += farthest > 0.1 * size;
  }
  EXPECT_GT(2 * wide, gates) << "of " << gates;
}

/// A 3-RPR with a platform like its base: det A = 0 wherever the platform is parallel to the base, that is in
/// a plane phi = const of poses, which turning the frame of the platform moves.
Robot congruent_three_rpr(double turned) {
  const test::Points base{{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {3.0, 8.0, 0.0}};
  test::Points platform;
  for (const Eigen::Vector3d& point : base)
    platform.push_back(Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitZ()) * point);
  std::vector<Leg> legs = test::struts(base, platform);
  for (Leg& leg : legs) leg.limits = JointLimits{3.0, 9.0};
  return test::manipulator("congruent", TaskSpace::SE2, std::move(legs));
}

TEST(Neighbours, AreFoundAcrossTheEndsOfTheAngle) {
  MapOptions options;
  options.resolution = 1.2;
  for (const double turned : {0.0, static_cast<double>(EIGEN_PI), 1.0}) {
    const auto map = compute_aspect_map(congruent_three_rpr(turned), options).map;
    ASSERT_TRUE(map);
    EXPECT_EQ(map->proved_count(), 4U) << turned;
    EXPECT_EQ(proved_pairs(*map).size(), 3U) << turned;
  }
}

TEST(Neighbours, AreNoneWhereCancelled) {
  const auto map = compute_aspect_map(test::five_bar()).map;
  const std::atomic<bool> cancelled{true};
  MapControl control;
  control.cancelled = &cancelled;
  EXPECT_TRUE(find_neighbours(*map, control).empty());
}

/// A second way to the aspects that a serial margin keeps apart, which proves nothing: points of a fine grid
/// where all other margins hold in both working modes, joined where they are next to each other.
class GateGrid {
 public:
  GateGrid(const AspectMap& map, int cells) : map_(map), robot_(*map.manipulator()), cells_(cells) {}

  /// Pairs of aspects that hold one pose from which points lead to where a leg does not reach.
  std::set<Pair> pairs() {
    for (const WorkingMode& mode : map_.working_modes())
      for (std::size_t leg = 0; leg < mode.leg_count(); ++leg)
        if (mode.sign(leg) > 0)
          for (const int sign : {1, -1}) look(mode, leg, sign);
    return std::move(pairs_);
  }

 private:
  Pose at(int point) const {
    const Box region = map_.region();
    return Pose::planar(region.lower[0] + region.width(0) * (point / cells_ + 0.5) / cells_,
                        region.lower[1] + region.width(1) * (point % cells_ + 0.5) / cells_);
  }

  bool is_open(const Pose& pose, const WorkingMode& mode, std::size_t leg, int sign) const {
    const InverseSolution found = inverse(robot_, pose, mode);
    if (found.status != InverseStatus::solved) return false;
    const Margins& margins = robot_.constraints().margins;
    const TaskVector serial = serial_indices(robot_, pose, found.q);
    for (std::size_t j = 0; j < robot_.leg_count(); ++j)
      if (j != leg && serial[static_cast<Eigen::Index>(j)] < margins.serial) return false;
    return sign * direct_determinant(robot_, pose, found.q) > 0.0 &&
           parallel_index(robot_, pose, found.q) >= margins.parallel;
  }

  void look(const WorkingMode& mode, std::size_t leg, int sign) {
    WorkingMode other = mode;
    other.set_sign(leg, -1);
    std::vector<bool> open(static_cast<std::size_t>(cells_ * cells_));
    for (int point = 0; point < cells_ * cells_; ++point)
      open[static_cast<std::size_t>(point)] =
          is_open(at(point), mode, leg, sign) && is_open(at(point), other, leg, sign);
    for (int point = 0; point < cells_ * cells_; ++point) flood(point, open, mode, other, leg);
  }

  void flood(int start, std::vector<bool>& open, const WorkingMode& mode, const WorkingMode& other,
             std::size_t leg) {
    std::vector<int> queue;
    const auto take = [&](int point) {
      if (!open[static_cast<std::size_t>(point)]) return;
      open[static_cast<std::size_t>(point)] = false;
      queue.push_back(point);
    };
    take(start);
    std::set<Pair> found;
    bool leads_out = false;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Location one = map_.locate(at(queue[next]), mode), two = map_.locate(at(queue[next]), other);
      if (one && two) found.insert(pair_of(one.aspect, two.aspect, Crossing::serial, leg));
      const int i = queue[next] / cells_, k = queue[next] % cells_;
      for (const auto& [a, b] : {std::pair(i + 1, k), {i - 1, k}, {i, k + 1}, {i, k - 1}}) {
        if (a < 0 || b < 0 || a >= cells_ || b >= cells_) continue;
        const InverseSolution beyond = inverse(robot_, at(a * cells_ + b), mode);
        leads_out = leads_out || (beyond.status == InverseStatus::out_of_reach && beyond.leg == leg);
        take(a * cells_ + b);
      }
    }
    if (leads_out) pairs_.insert(found.begin(), found.end());
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  int cells_;
  std::set<Pair> pairs_;
};

TEST(Neighbours, AreFoundAcrossSerialMargins) {
  for (const Margins& margins : {Margins{0.0, 0.02, 0.0}, {0.0, 0.2, 0.0}, {0.3, 0.2, 0.0}}) {
    const auto map = compute_aspect_map(test::five_bar()->with_margins(margins)).map;
    ASSERT_TRUE(map);
    std::set<Pair> serial;
    for (const Pair& pair : proved_pairs(*map)) {
      if (pair.crossing == Crossing::serial) serial.insert(pair);
      EXPECT_TRUE(pair.crossing == Crossing::serial || margins.parallel == 0.0) << pair;
    }
    EXPECT_GE(serial.size(), 8U);
    if (test::is_sanitized) continue;
    EXPECT_EQ(serial, GateGrid(*map, 240).pairs()) << margins.parallel << ' ' << margins.serial;
  }
}

}  // namespace
}  // namespace parallel_aspects
