// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

std::shared_ptr<const AspectMap> hinge_map(const Robot& robot, double resolution, bool complete = false) {
  MapOptions options;
  options.resolution = resolution;
  options.complete = complete;
  return compute_aspect_map(robot, options).map;
}

std::string key(const WorkingMode& mode, int sign) { return to_string(mode) + (sign > 0 ? "+" : "-"); }

std::map<std::string, std::vector<double>> measures(const AspectMap& map) {
  std::map<std::string, std::vector<double>> result;
  for (const Aspect& aspect : map.aspects())
    result[key(aspect.mode, aspect.determinant_sign)].push_back(aspect.measure);
  return result;
}

// Areas in rad^2 by another program, on a grid of 3000 x 3000 angles.
TEST(AnkleMap, HasTheSixteenAspectsOfAnIndependentFlood) {
  const std::map<std::string, std::vector<double>> expected{
      {"(+,+)+", {1.1982, 1.0460}}, {"(+,+)-", {1.2500, 1.1704}}, {"(-,+)+", {1.1973, 1.0462}},
      {"(-,+)-", {1.2497, 1.1713}}, {"(+,-)+", {1.1977, 1.0441}}, {"(+,-)-", {1.2518, 1.1709}},
      {"(-,-)+", {1.1968, 1.0443}}, {"(-,-)-", {1.2516, 1.1718}}};
  const auto map = hinge_map(test::ankle(), 0.0125);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->aspects().size(), 16U);
  EXPECT_EQ(map->proved_count(), 16U);
  EXPECT_EQ(map->count_at_most(), std::optional<std::size_t>(16));
  const auto found = measures(*map);
  for (const auto& [of, areas] : expected) {
    ASSERT_EQ(found.count(of), 1U) << of;
    ASSERT_EQ(found.at(of).size(), areas.size()) << of;
    for (std::size_t i = 0; i < areas.size(); ++i)
      EXPECT_NEAR(found.at(of)[i], areas[i], 2e-3 * areas[i]) << of;
  }
  for (const Aspect& aspect : map->aspects()) {
    EXPECT_LE(aspect.measure_lower, aspect.measure);
    EXPECT_LE(aspect.measure, aspect.measure_upper);
    EXPECT_LT(aspect.measure_upper - aspect.measure_lower, 0.1 * aspect.measure);
  }
}

TEST(FourBarMap, HasFourAspectsOfKnownWidths) {
  const auto map = hinge_map(test::four_bar(), 0.0002);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->proved_count(), 4U);
  const auto found = measures(*map);
  EXPECT_NEAR(found.at("(+)-").at(0), 3.6021, 2e-4);
  EXPECT_NEAR(found.at("(+)+").at(0), 2.6811, 2e-4);
  EXPECT_NEAR(found.at("(-)+").at(0), 3.6021, 2e-4);
  EXPECT_NEAR(found.at("(-)-").at(0), 2.6811, 2e-4);
  const auto other = hinge_map(test::four_bar(0.3, 0.4, 0.1, 0.38), 0.0002);
  ASSERT_EQ(other->aspects().size(), 4U);
  EXPECT_EQ(other->proved_count(), 4U);
  EXPECT_EQ(other->count_at_most(), std::optional<std::size_t>(4));
  for (const Aspect& aspect : other->aspects()) EXPECT_NEAR(aspect.measure, 0.7149, 2e-4);
}

// The numbers are exact, whatever the resolution, and with limits.
TEST(HingeMaps, HaveExactCounts) {
  const std::vector<std::pair<SharedMechanism, std::size_t>> robots{
      {models::ankle(), 16}, {models::skew_wrist(), 24}, {models::tilt_table(), 1}};
  for (const auto& [robot, count] : robots)
    for (const double resolution : {0.1, 0.03}) {
      const auto map = hinge_map(robot->mapped_manipulator(), resolution, true);
      ASSERT_TRUE(map);
      EXPECT_EQ(map->proved_count(), count) << robot->manipulator()->name() << ' ' << resolution;
      EXPECT_EQ(map->count_at_most(), std::optional<std::size_t>(count))
          << robot->manipulator()->name() << ' ' << resolution;
    }
}

/// The legs by rotations as matrices and nothing of the package's kinematics but its robots: sign of det A in
/// a mode, 0 out of reach. Columns of A by central differences of the anchor.
class OtherKinematics {
 public:
  explicit OtherKinematics(const Manipulator& robot) : robot_(robot) {}

  int sign(const WorkingMode& mode, const std::vector<double>& angles) const {
    const auto n = static_cast<Eigen::Index>(robot_.leg_count());
    Eigen::MatrixXd a(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Leg& leg = robot_.leg(static_cast<std::size_t>(j));
      const auto& crank = std::get<RevoluteActuation>(leg.actuation);
      const Eigen::Vector3d p = anchor(leg, angles), d = p - crank.center;
      const Eigen::Vector3d e1 = crank.zero_direction, e2 = crank.axis.cross(e1);
      const double x = d.dot(e1), y = d.dot(e2), r = std::hypot(x, y);
      const double c = (d.squaredNorm() + crank.radius * crank.radius - leg.rod_length * leg.rod_length) /
                       (2.0 * crank.radius * r);
      if (!(std::abs(c) < 1.0)) return 0;
      // Of the two angles the one with  u . c' = radius (y cos q - x sin q)  of the sign.
      const double q = std::atan2(y, x) - mode.sign(static_cast<std::size_t>(j)) * std::acos(c);
      const Eigen::Vector3d u = d - crank.radius * (std::cos(q) * e1 + std::sin(q) * e2);
      for (Eigen::Index i = 0; i < n; ++i) {
        std::vector<double> ahead = angles, behind = angles;
        ahead[static_cast<std::size_t>(i)] += 1e-5;
        behind[static_cast<std::size_t>(i)] -= 1e-5;
        a(j, i) = u.dot(anchor(leg, ahead) - anchor(leg, behind));
      }
    }
    const double determinant = n == 1 ? a(0, 0) : a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    return determinant > 0.0 ? 1 : -1;
  }

 private:
  Eigen::Vector3d anchor(const Leg& leg, const std::vector<double>& angles) const {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    if (angles.size() == 1) return AngleAxisd(angles[0], Vector3d::UnitZ()) * leg.anchor;
    const HingePair& hinges = robot_.description().hinges;
    const Vector3d turned =
        AngleAxisd(hinges.twist, Vector3d::UnitX()) * (AngleAxisd(angles[1], Vector3d::UnitZ()) * leg.anchor);
    return AngleAxisd(angles[0], Vector3d::UnitZ()) * (Vector3d(hinges.offset, 0.0, 0.0) + turned);
  }

  const Manipulator& robot_;
};

/// The signs at the middles of cells around the torus.
std::vector<int> signs_of(const Manipulator& robot, const WorkingMode& mode, int cells) {
  const OtherKinematics kinematics(robot);
  const auto angle = [cells](int i) -> double { return 2.0 * EIGEN_PI * (i + 0.5) / cells - EIGEN_PI; };
  std::vector<int> signs;
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k) signs.push_back(kinematics.sign(mode, {angle(i), angle(k)}));
  return signs;
}

/// Components of this sign, by their number of cells.
std::vector<int> flood(const std::vector<int>& signs, int sign, int cells) {
  std::vector<char> open;
  for (const int each : signs) open.push_back(each == sign ? 1 : 0);
  std::vector<int> sizes;
  for (int start = 0; start < cells * cells; ++start) {
    if (open[static_cast<std::size_t>(start)] == 0) continue;
    std::vector<int> front{start};
    open[static_cast<std::size_t>(start)] = 0;
    int size = 0;
    while (!front.empty()) {
      const int at = front.back(), i = at / cells, k = at % cells;
      front.pop_back();
      ++size;
      for (const auto& [di, dk] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const int next = (i + di + cells) % cells * cells + (k + dk + cells) % cells;
        if (open[static_cast<std::size_t>(next)] == 0) continue;
        open[static_cast<std::size_t>(next)] = 0;
        front.push_back(next);
      }
    }
    sizes.push_back(size);
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

// Each component of a grid that is more than a sliver is as large as the map proves of an aspect, to the
// cells along its edge.
void expect_like_flood(const Robot& robot, double resolution) {
  constexpr int cells = 240;
  constexpr double cell = (2.0 * EIGEN_PI / cells) * (2.0 * EIGEN_PI / cells), sliver = 0.03;
  const auto map = hinge_map(robot, resolution, true);
  ASSERT_TRUE(map);
  std::size_t pieces = 0;  // of more than a few cells, which may be tips of others
  for (const WorkingMode& mode : working_modes(*robot)) {
    const std::vector<int> signs = signs_of(*robot, mode, cells);
    for (const int sign : {1, -1}) {
      std::vector<Aspect> aspects;  // by falling measure
      for (const Aspect& aspect : map->aspects())
        if (aspect.mode == mode && aspect.determinant_sign == sign) aspects.push_back(aspect);
      const std::vector<int> sizes = flood(signs, sign, cells);
      pieces += static_cast<std::size_t>(
          std::count_if(sizes.begin(), sizes.end(), [](int size) { return size > 9; }));
      for (std::size_t i = 0; i < sizes.size() && cell * sizes[i] > 3.0 * sliver; ++i) {
        SCOPED_TRACE(robot->name() + ' ' + key(mode, sign) + ' ' + std::to_string(i));
        ASSERT_LT(i, aspects.size());
        EXPECT_GE(cell * sizes[i], aspects[i].measure_lower - sliver);
        EXPECT_LE(cell * sizes[i], aspects[i].measure_upper + sliver);
      }
      const auto larger = [](const Aspect& aspect) { return aspect.measure_lower > 3.0 * sliver; };
      const auto found = [](int size) { return cell * size > sliver; };
      EXPECT_LE(std::count_if(aspects.begin(), aspects.end(), larger),
                std::count_if(sizes.begin(), sizes.end(), found));
    }
  }
  if (map->count_at_most()) {
    EXPECT_LE(pieces, *map->count_at_most()) << robot->name();
  }
}

TEST(HingeMaps, AgreeWithAFloodByOtherCode) {
  expect_like_flood(test::ankle(), 0.025);
  test::RandomRobots random(4201);
  for (int i = 0; i < 2; ++i)
    expect_like_flood(random.robot(TaskSpace::R2, test::ActuationKind::revolute), 0.05);
}

// In one mode of the wrist with axes at 60 degrees an aspect takes less than 0.01 rad^2.
TEST(HingeMaps, HaveTheSmallAspectsOfAFineFlood) {
  const Robot robot = models::skew_wrist()->mapped_manipulator();
  const auto map = hinge_map(robot, 0.05, true);
  const WorkingMode mode = *WorkingMode::from_signs({1, -1});
  constexpr int cells = 800, sliver = 20;
  const std::vector<int> signs = signs_of(*robot, mode, cells);
  for (const int sign : {1, -1}) {
    const std::vector<int> sizes = flood(signs, sign, cells);
    EXPECT_EQ(std::count_if(sizes.begin(), sizes.end(), [](int size) { return size > sliver; }), 3);
    EXPECT_EQ(measures(*map)[key(mode, sign)].size(), 3U);
  }
}

// Poses that a map has located are where inverse kinematics and det A say.
TEST(HingeMaps, LocatePosesByTheirSigns) {
  test::RandomRobots random(4202);
  for (const TaskSpace space : {TaskSpace::R1, TaskSpace::R2})
    for (const test::ActuationKind kind : test::all_actuation_kinds) {
      const Robot robot = random.robot(space, kind);
      const auto map = hinge_map(robot, space == TaskSpace::R1 ? 0.01 : 0.05);
      ASSERT_TRUE(map);
      for (int i = 0; i < 2000; ++i) {
        const Pose pose = random.pose(robot->motions());
        for (const WorkingMode& mode : map->working_modes()) {
          const Location location = map->locate(pose, mode);
          const InverseSolution solution = inverse(*robot, pose, mode);
          if (location.status == LocationStatus::outside) {
            EXPECT_FALSE(solution) << to_string(space, pose);
          }
          if (location.status != LocationStatus::inside) continue;
          ASSERT_TRUE(solution) << to_string(space, pose);
          const Aspect& aspect = map->aspects()[static_cast<std::size_t>(location.aspect - 1)];
          ASSERT_EQ(direct_determinant(*robot, pose, solution.q) > 0.0, aspect.determinant_sign > 0)
              << to_string(space, pose);
        }
      }
    }
}

// Limits of the joints of the passive chain bound aspects, and no pose beyond them is in one.
TEST(HingeMaps, KeepTheLimitsOfTheChain) {
  ManipulatorDescription description = test::ankle()->description();
  description.constraints.hinge_limits = {{"pitch", 0, {-0.8, 0.5}}, {"roll", 1, {-0.4, 0.4}}};
  const auto robot = std::make_shared<const Manipulator>(description);
  const auto map = hinge_map(robot, 0.0125);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->aspects().size(), map->proved_count());
  test::RandomRobots random(4203);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pose pose = random.pose(robot->motions());
    const PoseCoordinates angles = pose_coordinates(TaskSpace::R2, pose);
    const bool within = angles[0] > -0.8 && angles[0] < 0.5 && std::abs(angles[1]) < 0.4;
    for (const WorkingMode& mode : map->working_modes()) {
      const Location location = map->locate(pose, mode);
      if (location.status != LocationStatus::inside) continue;
      EXPECT_TRUE(within) << to_string(TaskSpace::R2, pose);
      ++inside;
    }
  }
  EXPECT_GT(inside, 100);
  double area = 0.0;
  for (const Aspect& aspect : map->aspects()) area = std::max(area, aspect.measure);
  EXPECT_LT(area, 1.3 * 0.8 + 1e-6);
}

}  // namespace
}  // namespace parallel_aspects
