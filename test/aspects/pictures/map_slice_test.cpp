// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/map_slice.h"

#include "aspects/boxes/box_classifier.h"
#include "aspects/map/map_contents.h"
#include "aspects/tree/slice_space.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/rotation_slice.h"

#include <gtest/gtest.h>

#include "support/robots.h"
#include "support/shipped.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>

namespace parallel_aspects {
namespace {

using test::Held;
using test::map_of;
using test::options_of;
using test::random_position;
using test::Robot;
using test::slice_of;
using test::uniform;
using test::upright;

// Boxes that are small enough to be decided, of every orientation at one position.
TEST(SliceClassifier, NoOrientationContradictsItsBox) {
  const Robot robot = test::shipped("hexa")->manipulator();
  const MapSlice slice = slice_of(robot, {{"x", 0.05}, {"y", 0.0}, {"z", -0.6}});
  const auto modes = working_modes(*robot);
  const auto classifier = make_slice_classifier(*robot, modes, slice);
  const auto space = make_slice_space(slice, Box{}, 1.0);
  std::mt19937_64 random(12);
  int decided = 0;
  for (int i = 0; i < 1000; ++i) {
    const MapPosition corner = random_position(*space, random);
    Box box{3, corner.point, corner.point};
    for (double& upper : box.upper) upper += std::pow(2.0, uniform(random, -9.0, -5.0));
    std::vector<LeafState> states(modes.size());
    {
      const RoundingUpward rounding;
      classifier->classify(corner.root, box, ~ModeSet{0}, Detail::parts, states.data());
    }
    for (int k = 0; k < 3; ++k) {
      MapPosition at = corner;
      for (std::size_t j = 0; j < 3; ++j) at.point[j] = uniform(random, box.lower[j], box.upper[j]);
      for (std::size_t mode = 0; mode < modes.size(); ++mode) {
        const auto sign = test::sign_at(*robot, space->pose(at), modes[mode]);
        if (!sign) continue;
        decided += states[mode].is_inside();
        ASSERT_FALSE(states[mode].is_inside() ? !states[mode].is_inside(*sign)
                                              : *sign != 0 && !states[mode].may_be(*sign))
            << "trial " << i << ", mode " << to_string(modes[mode]);
      }
    }
  }
  EXPECT_GT(decided, 1000);
}

// The charts of slices take every leg in space; those of whole task spaces know what the space leaves out.
void expect_agreement(const Robot& robot, const Held& held, std::size_t held_axis, double at) {
  const auto modes = working_modes(*robot);
  const MapSlice slice = slice_of(robot, held);
  const auto whole = make_box_classifier(*robot, modes), sliced = make_slice_classifier(*robot, modes, slice);
  const Box region = *whole->reachable_positions();
  std::mt19937_64 random(10);
  std::map<std::pair<bool, bool>, int> decided;
  const RoundingUpward rounding;
  for (int i = 0; i < 5000; ++i) {
    const double width = std::pow(2.0, uniform(random, -9.0, -2.0)) * region.width(0);
    Box flat{3, {}, {}}, box{2, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      flat.lower[k] = box.lower[k] = uniform(random, region.lower[k], region.upper[k]);
      flat.upper[k] = box.upper[k] = box.lower[k] + width;
    }
    flat.lower[held_axis] = flat.upper[held_axis] = at;
    for (std::size_t mode = 0; mode < modes.size(); ++mode) {
      const LeafState one = whole->state(0, flat, mode), other = sliced->state(0, box, mode);
      ++decided[{one.is_undecided(), other.is_undecided()}];
      if (one.is_undecided() || other.is_undecided()) continue;
      ASSERT_EQ(one.is_inside(1), other.is_inside(1)) << robot->name() << ", trial " << i;
      ASSERT_EQ(one.is_inside(-1), other.is_inside(-1)) << robot->name() << ", trial " << i;
    }
  }
  const int both = decided[{false, false}], apart = decided[{true, false}] + decided[{false, true}];
  EXPECT_GT(both, 1000);
  EXPECT_LT(apart, both / 5);
}

TEST(SliceClassifier, AgreesWithThatOfAllPoses) {
  expect_agreement(test::three_rrr(), {{"phi", 0.0}}, 2, 0.0);
  expect_agreement(test::three_rrr_actuated_elbow(), {{"phi", 0.0}}, 2, 0.0);
  expect_agreement(test::three_rpr(), {{"phi", 0.0}}, 2, 0.0);
  expect_agreement(test::delta(), {{"z", -0.5}}, 2, -0.5);
}

// Without tilt and with both hexagons planar, det A is a constant times z^3, whatever x and y.
TEST(MapSlice, StewartPlatformWithoutTiltIsSingularInOnePlaneOnly) {
  const Robot robot = test::shipped("stewart")->manipulator();
  const auto map = map_of(robot, options_of(slice_of(robot, upright()), 0.1));
  ASSERT_EQ(map->aspects().size(), 2U);
  EXPECT_EQ(map->proved_count(), 2U);
  const double lower = map->aspects()[0].measure_lower;
  EXPECT_NEAR(map->aspects()[1].measure_lower, lower, 1e-3 * lower) << "but for leaves divided further";
  EXPECT_GT(map->aspects()[0].bounds.lower[2], 0.0);
  EXPECT_LT(map->aspects()[1].bounds.upper[2], 0.0);
  EXPECT_EQ(map->unit(), "m^3");
}

/// Cells of one working mode and sign on a fine grid, joined by flood fill.
class Flood {
 public:
  static constexpr int cells = 600;

  Flood(const Manipulator& robot, const WorkingMode& mode, int sign) : free_(cells * cells) {
    for (int k = 0; k < cells * cells; ++k) {
      Pose pose;
      pose.position << center(k % cells), center(k / cells), 0.0;
      const InverseSolution solution = inverse(robot, pose, mode);
      free_[static_cast<std::size_t>(k)] = solution.status == InverseStatus::solved &&
                                           sign * direct_determinant(robot, pose, solution.q) > 0.0;
    }
  }

  /// Cells of each set that is connected.
  std::vector<std::vector<Eigen::Vector2d>> pieces() {
    std::vector<std::vector<Eigen::Vector2d>> result;
    for (int k = 0; k < cells * cells; ++k)
      if (free_[static_cast<std::size_t>(k)]) result.push_back(take(k));
    return result;
  }

  static constexpr double area_of_cell() { return width * width; }

 private:
  static constexpr double lowest = -20.0, width = 30.0 / cells;
  static double center(int i) { return lowest + (i + 0.5) * width; }

  std::vector<Eigen::Vector2d> take(int start) {
    std::vector<Eigen::Vector2d> piece;
    std::vector<int> open{start};
    while (!open.empty()) {
      const int k = open.back();
      open.pop_back();
      if (!free_[static_cast<std::size_t>(k)]) continue;
      free_[static_cast<std::size_t>(k)] = false;
      piece.emplace_back(center(k % cells), center(k / cells));
      if (k % cells > 0) open.push_back(k - 1);
      if (k % cells < cells - 1) open.push_back(k + 1);
      if (k >= cells) open.push_back(k - cells);
      if (k < cells * (cells - 1)) open.push_back(k + cells);
    }
    return piece;
  }

  std::vector<bool> free_;
};

/// The aspect that holds every cell that the map decides; 0 where there are two.
int the_one_aspect_of(const AspectMap& map, const WorkingMode& mode,
                      const std::vector<Eigen::Vector2d>& piece) {
  std::set<int> found;
  for (std::size_t i = 0; i < piece.size(); i += 7) {
    Pose pose;
    pose.position << piece[i], 0.0;
    const Location location = map.locate(pose, mode);
    if (location.status != LocationStatus::undecided) found.insert(location.aspect);
  }
  return found.size() == 1 ? *found.begin() : 0;
}

// Of eight working modes.
constexpr std::size_t flooded_modes = test::is_sanitized ? 2 : 8,
                      aspects_in_them = test::is_sanitized ? 8 : 27;

// The robot and the slice of Caro, Chablat, Goldsztejn, Ishii and Jermann, Artificial Intelligence 211, 2014.
TEST(MapSlice, ThreeRrrWithFrozenOrientationAgreesWithFloodFill) {
  const Robot robot = test::three_rrr();
  const double smallest = 0.5;  // [m^2], which a grid of 0.05 m shows well
  MapOptions options = options_of(slice_of(robot, {{"phi", 0.0}}), 0.2);
  options.extra_levels = 12;
  options.modes = working_modes(*robot);
  options.modes.resize(flooded_modes);
  const auto map = map_of(robot, options);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->proved_count(), aspects_in_them);
  EXPECT_EQ(map->aspects().size(), aspects_in_them);
  std::map<int, double> areas;
  std::size_t large_pieces = 0;
  for (const WorkingMode& mode : options.modes)
    for (const int sign : {1, -1})
      for (const auto& piece : Flood(*robot, mode, sign).pieces()) {
        const double area = static_cast<double>(piece.size()) * Flood::area_of_cell();
        if (area < smallest) continue;
        ++large_pieces;
        const int aspect = the_one_aspect_of(*map, mode, piece);
        ASSERT_NE(aspect, 0) << to_string(mode) << ", sign " << sign << ", area " << area;
        areas[aspect] += area;
      }
  std::size_t large_aspects = 0;
  for (const Aspect& aspect : map->aspects()) {
    if (aspect.measure_lower < smallest) continue;
    ++large_aspects;
    EXPECT_GT(areas[aspect.id], aspect.measure_lower * 0.995 - 0.2) << aspect.id;
    EXPECT_LT(areas[aspect.id], aspect.measure_upper * 1.005 + 0.2) << aspect.id;
  }
  // One aspect has a neck that is thinner than a cell.
  EXPECT_EQ(areas.size(), large_aspects);
  EXPECT_LE(large_pieces, large_aspects + 1);
}

TEST(MapSlice, ModesCanBeLeftOut) {
  const Robot robot = test::three_rrr();
  const WorkingMode mode = WorkingMode::from_index(3, 5);
  const MapSlice slice = slice_of(robot, {{"phi", 0.0}});
  const auto all = map_of(robot, options_of(slice, 0.5)), one = map_of(robot, options_of(slice, 0.5, {mode}));
  ASSERT_EQ(one->working_modes(), std::vector<WorkingMode>{mode});
  const auto of_mode = std::count_if(all->aspects().begin(), all->aspects().end(),
                                     [&mode](const Aspect& aspect) { return aspect.mode == mode; });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(one->aspects().size()), of_mode);
  EXPECT_EQ(one->locate(Pose{}, WorkingMode(3)).status, LocationStatus::not_mapped);
}

TEST(MapSlice, TurnsAboutEveryAxis) {
  const Robot robot = test::shipped("stewart")->manipulator();
  MapSlice slice;
  slice.held.position << 0.0, 0.0, 1.3;
  slice.held.orientation = Eigen::AngleAxisd(0.2, Eigen::Vector3d(0.6, 0.8, 0.0));
  slice.axis << 1.0, 2.0, 2.0;
  slice.rotation = MapSlice::Rotation::about_axis;
  const auto map = map_of(robot, options_of(slice, 0.01));
  ASSERT_TRUE(map);
  const Eigen::Quaterniond third(Eigen::AngleAxisd(0.3, slice.axis.normalized()));
  const Pose pose = map->contents().tree.space().pose({0, {0.3 / static_cast<double>(EIGEN_PI), 0.0, 0.0}});
  EXPECT_LT(pose.orientation.angularDistance(third * slice.held.orientation), 1e-12);
  std::mt19937_64 random(11);
  for (int i = 0; i < 2000; ++i) {
    const Pose at = map->contents().tree.space().pose({0, {uniform(random, -1.0, 1.0), 0.0, 0.0}});
    const Location location = map->locate(at, WorkingMode(6));
    const auto sign = test::sign_at(*robot, at, WorkingMode(6));
    if (!sign || location.status == LocationStatus::undecided) continue;
    ASSERT_EQ(location.status == LocationStatus::inside, *sign != 0) << to_string(TaskSpace::SE3, at);
  }
}

Eigen::Quaterniond orientation_of(double roll, double pitch, double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

TEST(MapSlice, TurnsAboutAxesOfTheBaseAndOfThePlatform) {
  const Robot robot = test::shipped("stewart")->manipulator();
  Problems problems;
  const Held held{{"x", 0.0}, {"y", 0.0}, {"z", 1.3}, {"roll", 0.3}, {"pitch", 0.2}, {"yaw", 0.1}};
  const MapSlice base = make_rotation_slice(TaskSpace::SE3, held, "y", problems);
  const MapSlice own = make_rotation_slice(TaskSpace::SE3, held, "own-z", problems);
  ASSERT_TRUE(problems.empty());
  EXPECT_EQ(find_slice_problem(*robot, own), "");
  const Eigen::Quaterniond start = orientation_of(0.3, 0.2, 0.1);
  const MapPosition quarter{0, {0.5, 0.0, 0.0}};
  const Pose about_base = make_slice_space(base, Box{}, 1.0)->pose(quarter);
  const Pose about_own = make_slice_space(own, Box{}, 1.0)->pose(quarter);
  const Eigen::Quaterniond y(Eigen::AngleAxisd(0.5 * EIGEN_PI, Eigen::Vector3d::UnitY()));
  const Eigen::Quaterniond z(Eigen::AngleAxisd(0.5 * EIGEN_PI, Eigen::Vector3d::UnitZ()));
  EXPECT_LT(about_base.orientation.angularDistance(y * start), 1e-7);
  EXPECT_LT(about_own.orientation.angularDistance(start * z), 1e-7);
  EXPECT_EQ(coordinate_names(own), std::vector<std::string>{"phi"});
  EXPECT_EQ(measure_unit(own), "rad");
}

// A free roll, pitch or yaw turns about the axis that it should.
TEST(MapSlice, FreeAnglesAreThoseOfTheOrientation) {
  const std::map<std::string, std::function<Eigen::Quaterniond(double)>> expected{
      {"roll", [](double t) { return orientation_of(t, 0.2, 0.1); }},
      {"pitch", [](double t) { return orientation_of(0.3, t, 0.1); }},
      {"yaw", [](double t) { return orientation_of(0.3, 0.2, t); }}};
  for (const auto& [free, orientation] : expected) {
    Held held;
    for (const HeldCoordinate& each :
         Held{{"x", 0.0}, {"y", 0.0}, {"z", 1.0}, {"roll", 0.3}, {"pitch", 0.2}, {"yaw", 0.1}})
      if (each.name != free) held.push_back(each);
    Problems problems;
    const auto space = make_slice_space(make_slice(TaskSpace::SE3, held, problems), Box{}, 1.0);
    for (const double half_turns : {-0.7, -0.2, 0.0, 0.1, 0.9})
      EXPECT_LT(space->pose({0, {half_turns, 0.0, 0.0}})
                    .orientation.angularDistance(orientation(half_turns * EIGEN_PI)),
                1e-7)
          << free << " " << half_turns;
  }
}

std::string rotation_problem(TaskSpace space, const Held& held, const std::string& axis) {
  Problems problems;
  make_rotation_slice(space, held, axis, problems);
  return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
}

TEST(MapSlice, EveryMistakeAboutAxesIsOneSentence) {
  EXPECT_EQ(
      rotation_problem(TaskSpace::SE3, upright({{"x", 0.0}}), "w"),
      "The slice turns about 'w'; give x, y or z of the base, or own-x, own-y or own-z of the platform.");
  EXPECT_EQ(rotation_problem(TaskSpace::SE3, {{"x", 0.0}, {"y", 0.0}, {"roll", 0.0}}, "x"),
            "The slice turns from an orientation that it does not tell; hold 'pitch' once.");
  EXPECT_EQ(rotation_problem(TaskSpace::SE2, {{"x", 0.0}}, "z"),
            "A slice of SE2 turns about no other axis; leave 'turn' out.");
  EXPECT_NE(rotation_problem(TaskSpace::SE3, upright(), "x"), "0 problems");
}

std::string problem_of(TaskSpace space, const Held& held) {
  Problems problems;
  make_slice(space, held, problems);
  return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
}

TEST(MapSlice, EveryMistakeIsOneSentence) {
  EXPECT_EQ(problem_of(TaskSpace::T3, {{"phi", 0.0}}),
            "A slice of T3 has no coordinate 'phi'; hold some of x, y and z.");
  EXPECT_EQ(problem_of(TaskSpace::T3, {{"z", 0.0}, {"z", 1.0}}), "The slice holds 'z' twice; leave one out.");
  EXPECT_EQ(problem_of(TaskSpace::T3, {{"z", NAN}}), "The slice holds 'z' at no finite number; give one.");
  EXPECT_EQ(problem_of(TaskSpace::SE2, {}),
            "The slice holds nothing; hold some of x, y and phi, such as \"phi=0\".");
  EXPECT_EQ(problem_of(TaskSpace::T2, {{"x", 0.0}, {"y", 1.0}}),
            "The slice leaves no coordinate free; leave one to three.");
  EXPECT_EQ(problem_of(TaskSpace::SE3, {{"x", 0.0}, {"roll", 1.0}}),
            "The slice leaves y, z, pitch and yaw free; leave one to three.");
  EXPECT_EQ(
      problem_of(TaskSpace::SE3, {{"x", 0.0}, {"y", 0.0}, {"z", 1.0}, {"yaw", 0.0}}),
      "The slice leaves the angles roll and pitch free; hold all of them but one, or let all three turn "
      "with x, y and z held.");
  EXPECT_EQ(problem_of(TaskSpace::T1, {{"x", 0.0}}),
            "T1 has no slices, since x is all there is; map it whole.");
}

TEST(MapSlice, SlicesThatDoNotFitTheRobotAreRefused) {
  const Robot planar = test::three_rrr(), spatial = test::stewart(), delta = test::delta();
  MapSlice slice = slice_of(planar, {{"phi", 0.0}});
  EXPECT_EQ(find_slice_problem(*planar, slice), "");
  slice.moves[2] = true;
  EXPECT_NE(find_slice_problem(*planar, slice), "");
  slice = slice_of(planar, {{"x", 0.0}});
  slice.axis = Eigen::Vector3d::UnitX();
  EXPECT_NE(find_slice_problem(*planar, slice), "");
  slice = slice_of(delta, {{"z", 0.0}});
  slice.held.orientation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  EXPECT_NE(find_slice_problem(*delta, slice), "");
  slice = slice_of(spatial, upright());
  slice.held.position.x() = NAN;
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
  slice = slice_of(spatial, upright());
  slice.axis.setZero();
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
  slice = slice_of(spatial, upright());
  slice.rotation = MapSlice::Rotation::freely;
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
  slice.moves.fill(false);
  slice.rotation = MapSlice::Rotation::none;
  EXPECT_NE(find_slice_problem(*spatial, slice), "");
}

}  // namespace
}  // namespace parallel_aspects
