// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <gtest/gtest.h>

#include "support/held_joint_at.h"
#include "support/robots/robots.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

MapOptions options_of(const Robot& robot, std::size_t leg, double value) {
  Problems problems;
  MapOptions options;
  options.slice = make_slice(*robot, {{robot->leg(leg).actuated_joint, value}}, problems);
  EXPECT_TRUE(problems.empty()) << problems.front();
  return options;
}

std::shared_ptr<const AspectMap> map_of(const Robot& robot, std::size_t leg, double value) {
  const MapResult result = compute_aspect_map(robot, options_of(robot, leg, value));
  EXPECT_TRUE(result.map) << result.message;
  return result.map;
}

/// Strut 1 with its own limits, and struts 2 and 3 in these.
Robot three_rpr(double lower, double upper, double turned = 0.0) {
  ManipulatorDescription description = test::three_rpr()->description();
  for (std::size_t j = 0; j < 3; ++j) {
    Leg& leg = description.legs[j];
    if (j > 0) leg.limits = JointLimits{lower, upper};
    auto& strut = std::get<StrutActuation>(leg.actuation);
    strut.base = Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitZ()) * strut.base;
  }
  return std::make_shared<const Manipulator>(description);
}

/// The torus of a slice as a grid of cells, of one working mode and sign of det A; those that share a side
/// are joined, across both pairs of glued ends.
class Flood {
 public:
  Flood(const Robot& robot, std::size_t leg, double value, const WorkingMode& mode, int sign, int count)
      : count_(count), values_(place(count, 0)), parent_(values_.size()) {
    const test::HeldJointAt at(*robot, leg, value);
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < count; ++k) {
        const auto found = at.determinant(angle(i), angle(k), mode);
        values_[place(i, k)] = found ? static_cast<double>(sign * *found) : 0.0;
      }
  }

  /// Sizes of the sets of cells where the value is more than the level, the largest first.
  std::vector<std::size_t> sizes(double level) {
    join_above(level);
    std::map<std::size_t, std::size_t> size;
    for (std::size_t item = 0; item < values_.size(); ++item)
      if (values_[item] > level) ++size[root(item)];
    std::vector<std::size_t> result;
    for (const auto& each : size) result.push_back(each.second);
    std::sort(result.rbegin(), result.rend());
    return result;
  }

  /// The largest level at which two cells are joined; 0 without one.
  double widest(std::size_t from, std::size_t to) {
    std::vector<std::size_t> order(values_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [this](std::size_t a, std::size_t b) { return values_[a] > values_[b]; });
    std::iota(parent_.begin(), parent_.end(), 0U);
    std::vector<bool> is_there(values_.size(), false);
    for (const std::size_t item : order) {
      if (!(values_[item] > 0.0)) return 0.0;
      is_there[item] = true;
      for (const std::size_t next : around(item))
        if (is_there[next]) parent_[root(next)] = root(item);
      if (is_there[from] && is_there[to] && root(from) == root(to)) return values_[item];
    }
    return 0.0;
  }

  std::size_t cell_count() const { return values_.size(); }
  double value(std::size_t item) const { return values_[item]; }
  Pose pose(const AnchorCircle& circle, std::size_t item) const {
    const auto count = static_cast<std::size_t>(count_);
    return circle.pose(static_cast<double>(angle(static_cast<int>(item / count))),
                       static_cast<double>(angle(static_cast<int>(item % count))));
  }

 private:
  /// With those at its corners.
  std::vector<std::size_t> around(std::size_t item) const {
    const int i = static_cast<int>(item) / count_, k = static_cast<int>(item) % count_;
    std::vector<std::size_t> result;
    for (const int a : {i + count_ - 1, i, i + 1})
      for (const int b : {k + count_ - 1, k, k + 1}) result.push_back(place(a % count_, b % count_));
    return result;
  }

  long double angle(int i) const {
    return std::acos(-1.0L) * (2.0L * (static_cast<long double>(i) + 0.5L) / count_ - 1.0L);
  }
  std::size_t place(int i, int k) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(k);
  }
  std::size_t root(std::size_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  void join_above(double level) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (int i = 0; i < count_; ++i)
      for (int k = 0; k < count_; ++k)
        for (const std::size_t next : {place((i + 1) % count_, k), place(i, (k + 1) % count_)})
          if (values_[place(i, k)] > level && values_[next] > level) parent_[root(next)] = root(place(i, k));
  }

  int count_;
  std::vector<double> values_;
  std::vector<std::size_t> parent_;
};

/// The components of one mode and sign.
std::vector<Aspect> aspects_of(const AspectMap& map, const WorkingMode& mode, int sign) {
  std::vector<Aspect> result;
  for (const Aspect& aspect : map.aspects())
    if (aspect.mode == mode && aspect.determinant_sign == sign) result.push_back(aspect);
  return result;
}

struct Slice {
  const char* name;
  std::function<Robot()> make;
  std::size_t leg;
  double value;
};

class MapOfHeldJoint : public testing::TestWithParam<Slice> {};

// Components of the grid that are too small to be told from chance are left out; each other one is a
// component of the map with its area.
TEST_P(MapOfHeldJoint, HasTheComponentsOfAGrid) {
  const int count = test::is_sanitized ? 150 : 400;
  const Robot robot = GetParam().make();
  const auto map = map_of(robot, GetParam().leg, GetParam().value);
  ASSERT_TRUE(map);
  const double cell = std::pow(2.0 * EIGEN_PI / count, 2);
  const double chance = 40.0 * cell;
  std::size_t compared = 0;
  for (const WorkingMode& mode : working_modes(*robot))
    for (const int sign : {1, -1}) {
      const std::vector<Aspect> certified = aspects_of(*map, mode, sign);
      const std::vector<std::size_t> flooded =
          Flood(robot, GetParam().leg, GetParam().value, mode, sign, count).sizes(0.0);
      for (std::size_t i = 0; i < std::max(certified.size(), flooded.size()); ++i) {
        const double area = i < flooded.size() ? cell * static_cast<double>(flooded[i]) : 0.0;
        const double lower = i < certified.size() ? certified[i].measure_lower : 0.0,
                     upper = i < certified.size() ? certified[i].measure_upper : 0.0;
        ++compared;
        if (test::is_sanitized) continue;  // so coarse a grid steps over thin boundaries
        EXPECT_GT(area, 0.98 * lower - chance) << to_string(mode) << sign << ", component " << i;
        EXPECT_LT(area, 1.02 * upper + chance) << to_string(mode) << sign << ", component " << i;
      }
    }
  EXPECT_GT(compared, 0U);
  EXPECT_EQ(map->unit(), "rad^2");
  EXPECT_EQ(map->coordinates(), (std::vector<std::string>{"direction", "phi"}));
}

// |det A| changes by a few percent from one cell of the grid to the next.
TEST_P(MapOfHeldJoint, BottlenecksAreThoseOfAGrid) {
  const int count = test::is_sanitized ? 100 : 500;
  const Robot robot = GetParam().make();
  const MapSlice slice = *options_of(robot, GetParam().leg, GetParam().value).slice;
  const auto map = map_of(robot, GetParam().leg, GetParam().value);
  ASSERT_TRUE(map);
  const auto is_smaller = [](const Aspect& a, const Aspect& b) { return a.measure < b.measure; };
  const Aspect& aspect = *std::max_element(map->aspects().begin(), map->aspects().end(), is_smaller);
  Flood grid(robot, GetParam().leg, GetParam().value, aspect.mode, aspect.determinant_sign, count);
  const AnchorCircle circle = circle_of_anchor(*robot, *slice.joint);
  std::mt19937_64 random(11);
  int compared = 0;
  for (int i = 0; i < 100000 && compared < 5; ++i) {
    const std::size_t from = random() % grid.cell_count(), to = random() % grid.cell_count();
    const double widest = grid.value(from) > 0.0 && grid.value(to) > 0.0 ? grid.widest(from, to) : 0.0;
    if (!(widest > 0.0)) continue;
    const Pose start = grid.pose(circle, from), end = grid.pose(circle, to);
    const Bottleneck found = find_bottleneck(*map, aspect.mode, start, end, ParallelIndex::determinant);
    if (found.status != BottleneckStatus::found) continue;  // next to a boundary
    EXPECT_LE(found.index.lower, 1.05 * widest) << "from " << from << " to " << to;
    EXPECT_GE(found.index.upper, 0.98 * widest) << "from " << from << " to " << to;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(Robots, MapOfHeldJoint,
                         testing::Values(Slice{"strut", [] { return three_rpr(10.0, 40.0); }, 0, 14.98},
                                         Slice{"other_strut", test::three_rpr, 1, 20.0},
                                         Slice{"crank", test::three_rrr, 0, 0.4},
                                         Slice{"rail", test::three_prr, 2, 0.3}),
                         [](const auto& each) { return std::string(each.param.name); });

// The base turned by an angle: directions and phi are the same but for it, and what was in the middle of the
// region is at its glued ends.
TEST(MapOfHeldStrut, DoesNotDependOnWhereDirectionsAreCountedFrom) {
  const auto one = map_of(three_rpr(10.0, 40.0), 0, 14.98),
             other = map_of(three_rpr(10.0, 40.0, 2.0), 0, 14.98);
  ASSERT_TRUE(one && other);
  ASSERT_EQ(one->aspects().size(), other->aspects().size());
  EXPECT_EQ(one->proved_count(), other->proved_count());
  for (std::size_t i = 0; i < one->aspects().size(); ++i) {
    EXPECT_NEAR(one->aspects()[i].measure, other->aspects()[i].measure, 0.01 * one->aspects()[i].measure);
    EXPECT_NEAR(one->aspects()[i].deepest_clearance, other->aspects()[i].deepest_clearance,
                0.05 * one->aspects()[i].deepest_clearance);
  }
}

// Without limits of the others the slice has two components, with three of the six solutions each.
TEST(MapOfHeldStrut, HasTwoComponentsWithoutLimits) {
  ManipulatorDescription description = test::three_rpr()->description();
  for (std::size_t j = 1; j < 3; ++j) description.legs[j].limits = JointLimits{};
  const auto map = map_of(std::make_shared<const Manipulator>(description), 0, 14.98);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->aspects().size(), 2U);
  EXPECT_EQ(map->proved_count(), 2U);
}

struct BottleneckCase {
  std::array<double, 3> from, to;
  double bottleneck, share;  // |det A|, and how far it may be off
};

// By brute force, to half a percent.
TEST(MapOfHeldStrut, BottlenecksAreThoseOfBruteForce) {
  const auto map = map_of(three_rpr(10.0, 40.0), 0, 14.98);
  ASSERT_TRUE(map);
  const std::array<double, 3> first{-14.89612810, 1.58296166, 0.24530953},
      second{-5.49566082, -13.93549828, -0.04733137}, third{-8.72659533, 12.17566975, -0.98697424},
      fourth{-13.41993901, -6.65624796, 0.58567278};
  for (const BottleneckCase& pair :
       {BottleneckCase{first, second, 9522.0, 0.005}, BottleneckCase{third, fourth, 9847.0, 0.005}}) {
    const Bottleneck found =
        find_bottleneck(*map, WorkingMode(3), Pose::planar(pair.from[0], pair.from[1], pair.from[2]),
                        Pose::planar(pair.to[0], pair.to[1], pair.to[2]), ParallelIndex::determinant);
    ASSERT_EQ(found.status, BottleneckStatus::found) << found.message;
    EXPECT_LE(found.index.lower, (1.0 + pair.share) * pair.bottleneck);
    EXPECT_GE(found.index.upper, (1.0 - pair.share) * pair.bottleneck);
    EXPECT_LE(found.index.upper - found.index.lower, 0.05 * found.index.upper);
  }
}

// The planning example SingFree/3RPR of the CUIK suite asks for it.
TEST(MapOfHeldStrut, AssemblyModeChangesFarFromSingularities) {
  const auto map = map_of(three_rpr(10.0, 40.0), 0, 14.98);
  ASSERT_TRUE(map);
  const Bottleneck found =
      find_bottleneck(*map, WorkingMode(3), Pose::planar(14.67394366, -3.01260312, 2.13290437),
                      Pose::planar(-5.49566082, -13.93549828, -0.04733137), ParallelIndex::determinant);
  ASSERT_EQ(found.status, BottleneckStatus::found) << found.message;
  EXPECT_GE(found.index.lower, 20000.0);
}

TEST(MapOfHeldStrut, FilesHoldTheJointAndItsValue) {
  const Robot robot = three_rpr(10.0, 40.0);
  const auto map = map_of(robot, 0, 14.98);
  ASSERT_TRUE(map);
  const std::string file = testing::TempDir() + "held_strut.map";
  ASSERT_TRUE(save_map(*map, file).saved);
  const MapResult same = load_map(robot, options_of(robot, 0, 14.98), file);
  ASSERT_TRUE(same.map) << same.message;
  EXPECT_EQ(same.map->aspects().size(), map->aspects().size());
  EXPECT_FALSE(load_map(robot, options_of(robot, 0, 14.99), file).map);
  EXPECT_FALSE(load_map(robot, options_of(robot, 1, 14.98), file).map);
  std::remove(file.c_str());
}

}  // namespace
}  // namespace parallel_aspects
