// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/regular_workspace.h"

#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/configuration_at.h"
#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/sign_at.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

std::vector<int> all_ids(const AspectMap& map) {
  std::vector<int> ids;
  for (const Aspect& aspect : map.aspects()) ids.push_back(aspect.id);
  return ids;
}

std::vector<RegularWorkspace> largest(const AspectMap& map, const WorkspaceQuestion& question,
                                      double gap = 0.01) {
  WorkspaceOptions options;
  options.gap = gap;
  const auto found = find_regular_workspaces(map, all_ids(map), question, options);
  EXPECT_TRUE(found);
  return found.value_or(std::vector<RegularWorkspace>());
}

WorkspaceQuestion question_of(RegularShape shape) {
  WorkspaceQuestion question;
  question.shape = shape;
  return question;
}

Pose planar_pose(double x, double y, double phi = 0.0) {
  return {{x, y, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(phi, Eigen::Vector3d::UnitZ()))};
}

/// One working mode and sign of det A on a grid, by formulas of the test alone: which points belong to it,
/// and how far each is from the nearest that does not.
class Grid {
 public:
  Grid(const Robot& robot, const Box& region, const WorkingMode& mode, int sign, int cells)
      : region_(region), cells_(cells), holds_(count()), component_(count(), -1) {
    for (int i = 0; i < cells; ++i)
      for (int k = 0; k < cells; ++k) {
        const test::ConfigurationAt<double> at(*robot, planar_pose(x(i), y(k)), mode);
        holds_[place(i, k)] = at.reaches() && at.within_limits() > 0.0 &&
                              is_in_workspace(*robot, x(i), y(k)) && sign * at.determinant() > 0.0;
      }
    for (int i = 0; i < cells; ++i)
      for (int k = 0; k < cells; ++k) fill(i, k);
  }

  double step() const { return std::max(step_x(), step_y()); }

  /// The grid component near a position; -1 for none.
  int component_at(double px, double py) const {
    const int i = static_cast<int>((px - region_.lower[0]) / step_x());
    const int k = static_cast<int>((py - region_.lower[1]) / step_y());
    if (i < 0 || k < 0 || i >= cells_ || k >= cells_) return -1;
    return component_[place(i, k)];
  }

  /// Points of the grid within `size` of a position, in this norm, that do not belong to the component.
  template <class Norm>
  int strangers(double px, double py, double size, int component, const Norm& norm) const {
    int found = 0;
    for (int i = 0; i < cells_; ++i)
      for (int k = 0; k < cells_; ++k)
        if (norm(x(i) - px, y(k) - py) < size && component_[place(i, k)] != component) ++found;
    return found;
  }

  /// The largest distance, in the larger coordinate, of a point of the component from those that do not
  /// belong to it, by two sweeps.
  double largest_square(int component) const {
    std::vector<int> steps(count());
    for (int i = 0; i < cells_; ++i)
      for (int k = 0; k < cells_; ++k)
        steps[place(i, k)] = !holds_[place(i, k)]
                                 ? 0
                                 : 1 + std::min({at(steps, i - 1, k), at(steps, i, k - 1),
                                                 at(steps, i - 1, k - 1), at(steps, i - 1, k + 1)});
    for (int i = cells_ - 1; i >= 0; --i)
      for (int k = cells_ - 1; k >= 0; --k)
        steps[place(i, k)] =
            std::min(steps[place(i, k)], 1 + std::min({at(steps, i + 1, k), at(steps, i, k + 1),
                                                       at(steps, i + 1, k + 1), at(steps, i + 1, k - 1)}));
    int best = 0;
    for (std::size_t p = 0; p < count(); ++p)
      if (component_[p] == component) best = std::max(best, steps[p]);
    return best * step();
  }

  /// The same of Euclidean distances: for each row the distance in the column, then the lower envelope tried
  /// out to where it cannot be lower.
  double largest_disc(int component) const { return roomiest(component).radius; }

  /// Where it is.
  struct Disc {
    double radius, x, y;
  };
  Disc roomiest(int component) const {
    std::vector<double> column(count());
    for (int i = 0; i < cells_; ++i) sweep_column(i, column);
    Disc best{0.0, 0.0, 0.0};
    for (int i = 0; i < cells_; ++i)
      for (int k = 0; k < cells_; ++k) {
        if (component_[place(i, k)] != component) continue;
        if (const double radius = nearest(i, k, column, best.radius); radius > best.radius)
          best = {radius, x(i), y(k)};
      }
    return best;
  }

 private:
  std::size_t count() const { return static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_); }
  std::size_t place(int i, int k) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(k);
  }
  double step_x() const { return region_.width(0) / cells_; }
  double step_y() const { return region_.width(1) / cells_; }
  double x(int i) const { return region_.lower[0] + (i + 0.5) * step_x(); }
  double y(int k) const { return region_.lower[1] + (k + 0.5) * step_y(); }

  static bool is_in_workspace(const Manipulator& robot, double px, double py) {
    const auto& box = robot.constraints().workspace;
    return !box || (box->lower.x() < px && px < box->upper.x() && box->lower.y() < py && py < box->upper.y());
  }

  int at(const std::vector<int>& steps, int i, int k) const {
    return i < 0 || k < 0 || i >= cells_ || k >= cells_ ? 0 : steps[place(i, k)];
  }

  void fill(int i, int k) {
    if (!holds_[place(i, k)] || component_[place(i, k)] >= 0) return;
    std::vector<std::pair<int, int>> open{{i, k}};
    component_[place(i, k)] = components_;
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      for (const auto& [da, db] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const int c = a + da, d = b + db;
        if (c < 0 || d < 0 || c >= cells_ || d >= cells_) continue;
        if (!holds_[place(c, d)] || component_[place(c, d)] >= 0) continue;
        component_[place(c, d)] = components_;
        open.emplace_back(c, d);
      }
    }
    ++components_;
  }

  void sweep_column(int i, std::vector<double>& column) const {
    double far = 0.0;
    for (int k = 0; k < cells_; ++k) {
      far = holds_[place(i, k)] ? far + step_y() : 0.0;
      column[place(i, k)] = far;
    }
    far = 0.0;
    for (int k = cells_ - 1; k >= 0; --k) {
      far = holds_[place(i, k)] ? far + step_y() : 0.0;
      column[place(i, k)] = std::min(column[place(i, k)], far);
    }
  }

  double nearest(int i, int k, const std::vector<double>& column, double of_interest) const {
    double least = column[place(i, k)];
    for (int away = 1; away * step_x() < least && least > of_interest; ++away)
      for (const int other : {i - away, i + away}) {
        const double beside = other < 0 || other >= cells_ ? 0.0 : column[place(other, k)];
        least = std::min(least, std::hypot(away * step_x(), beside));
      }
    return least;
  }

  Box region_;
  int cells_;
  std::vector<char> holds_;
  std::vector<int> component_;
  int components_ = 0;
};

double larger_coordinate(double x, double y) { return 2.0 * std::max(std::abs(x), std::abs(y)); }
double euclidean(double x, double y) { return std::hypot(x, y); }

class FiveBarShapes : public testing::Test {
 protected:
  void SetUp() override {
    const MapResult result = compute_aspect_map(robot, {});
    ASSERT_TRUE(result.map) << result.message;
    map = result.map;
    region = map->region();
    // Squares of grid steps, and a rim that no pose reaches.
    const double side = std::max(region.width(0), region.width(1)) + 0.2;
    for (std::size_t i = 0; i < 2; ++i) {
      const double middle = region.center(i);
      region.lower[i] = middle - 0.5 * side;
      region.upper[i] = middle + 0.5 * side;
    }
  }

  template <class Check>
  void with_each_aspect(RegularShape shape, const Check& check) {
    const auto found = largest(*map, question_of(shape));
    ASSERT_EQ(found.size(), map->aspects().size());
    const int cells = test::is_sanitized ? 200 : 1000;
    for (const WorkingMode& mode : map->working_modes())
      for (const int sign : {1, -1}) {
        const Grid grid(robot, region, mode, sign, cells);
        for (const RegularWorkspace& each : found) {
          const Aspect& aspect = map->aspects()[static_cast<std::size_t>(each.aspect - 1)];
          if (aspect.mode != mode || aspect.determinant_sign != sign) continue;
          SCOPED_TRACE("aspect " + std::to_string(each.aspect));
          EXPECT_TRUE(each.proved) << each.lower << ' ' << each.upper;
          check(grid, each);
        }
      }
  }

  Robot robot = test::five_bar();
  std::shared_ptr<const AspectMap> map;
  Box region;
};

TEST_F(FiveBarShapes, DiscsAgreeWithAGrid) {
  with_each_aspect(RegularShape::disc, [](const Grid& grid, const RegularWorkspace& disc) {
    const int component = grid.component_at(disc.center[0], disc.center[1]);
    ASSERT_GE(component, 0);
    EXPECT_EQ(grid.strangers(disc.center[0], disc.center[1], disc.lower, component, euclidean), 0);
    const double of_grid = grid.largest_disc(component);
    EXPECT_GT(disc.upper, of_grid - 2.0 * grid.step());
    EXPECT_LT(disc.lower, of_grid + 2.0 * grid.step());
  });
}

TEST_F(FiveBarShapes, SquaresAgreeWithAGrid) {
  with_each_aspect(RegularShape::square, [](const Grid& grid, const RegularWorkspace& square) {
    const int component = grid.component_at(square.center[0], square.center[1]);
    ASSERT_GE(component, 0);
    EXPECT_EQ(grid.strangers(square.center[0], square.center[1], square.lower, component, larger_coordinate),
              0);
    const double of_grid = 2.0 * grid.largest_square(component);
    EXPECT_GT(square.upper, of_grid - 4.0 * grid.step());
    EXPECT_LT(square.lower, of_grid + 4.0 * grid.step());
  });
}

TEST_F(FiveBarShapes, MirroredAspectsHaveEqualShapes) {
  // (x, -y) takes a working mode to its opposite, and det A to -det A.
  for (const RegularShape shape : {RegularShape::disc, RegularShape::square}) {
    const auto found = largest(*map, question_of(shape));
    for (const RegularWorkspace& each : found) {
      const Aspect& aspect = map->aspects()[static_cast<std::size_t>(each.aspect - 1)];
      int images = 0;
      for (const Aspect& other : map->aspects()) {
        if (other.determinant_sign != -aspect.determinant_sign ||
            other.measure_lower != aspect.measure_lower || other.mode.sign(0) == aspect.mode.sign(0) ||
            other.mode.sign(1) == aspect.mode.sign(1))
          continue;
        ++images;
        const RegularWorkspace& image = found[static_cast<std::size_t>(other.id - 1)];
        EXPECT_NEAR(image.lower, each.lower, 1e-4 * each.lower) << each.aspect << ' ' << other.id;
        EXPECT_NEAR(image.upper, each.upper, 0.01 * each.upper);
      }
      EXPECT_EQ(images, 1) << each.aspect;
    }
  }
}

TEST_F(FiveBarShapes, AHeldCenterIsKept) {
  WorkspaceQuestion question = question_of(RegularShape::disc);
  question.center = {4.512345678901, 8.0, std::nullopt};
  int found = 0;
  for (const RegularWorkspace& each : largest(*map, question)) {
    if (each.lower <= 0.0) continue;
    ++found;
    EXPECT_EQ(each.center[0], 4.512345678901) << "to the last digit";
    EXPECT_EQ(each.center[1], 8.0);
    EXPECT_TRUE(each.proved);
    const Aspect& aspect = map->aspects()[static_cast<std::size_t>(each.aspect - 1)];
    EXPECT_EQ(map->locate(planar_pose(4.512345678901, 8.0), aspect.mode).aspect, each.aspect);
  }
  EXPECT_EQ(found, 4) << "one for each working mode";
}

TEST_F(FiveBarShapes, BoxesKeepTheirRatio) {
  WorkspaceQuestion question = question_of(RegularShape::box);
  question.ratio = {1.0, 3.0};
  const auto squares = largest(*map, question_of(RegularShape::square)), boxes = largest(*map, question);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_TRUE(boxes[i].proved);
    EXPECT_LE(boxes[i].lower, squares[i].upper) << "the square of its shorter edge fits";
    EXPECT_LE(squares[i].lower, 3.0 * boxes[i].upper) << "a third of a square fits";
    const auto lengths = lengths_of(*map, question, boxes[i].lower);
    EXPECT_EQ(lengths[0].first, "edge_x");
    EXPECT_DOUBLE_EQ(lengths[1].second, 3.0 * lengths[0].second);
  }
}

TEST_F(FiveBarShapes, MarginsMakeThemSmaller) {
  Margins margins;
  margins.parallel = 0.2;
  margins.serial = 0.2;
  const MapResult narrow = compute_aspect_map(robot->with_margins(margins), {});
  ASSERT_TRUE(narrow.map);
  const auto best = [](const std::vector<RegularWorkspace>& all) {
    double size = 0.0;
    for (const RegularWorkspace& each : all) size = std::max(size, each.lower);
    return size;
  };
  const double with = best(largest(*narrow.map, question_of(RegularShape::disc)));
  EXPECT_GT(with, 0.0);
  EXPECT_LT(with, best(largest(*map, question_of(RegularShape::disc))));
}

/// Shapes of three coordinates, refuted by poses drawn in them and near their rims.
struct SpatialSubject {
  const char* name;
  Robot (*make)();
  RegularShape shape;
  double resolution;
};

class SpatialShapes : public testing::TestWithParam<SpatialSubject> {};

Pose drawn_in(const WorkspaceQuestion& question, const RegularWorkspace& found, bool turns,
              std::mt19937_64& random) {
  Eigen::Vector3d in = Eigen::Vector3d::Zero();
  do {
    for (int i = 0; i < (turns ? 2 : 3); ++i) in[i] = test::uniform(random, -1.0, 1.0);
  } while (question.shape != RegularShape::box &&
           (question.shape == RegularShape::cylinder ? in.head<2>().norm() : in.norm()) > 1.0);
  if (random() % 2 == 0 && question.shape != RegularShape::box) in.head<2>().normalize();
  if (question.shape == RegularShape::ball && in.norm() > 1.0) in.normalize();
  const double scale = question.shape == RegularShape::box ? 0.5 * found.lower : found.lower;
  Pose pose = planar_pose(0.0, 0.0,
                          turns ? test::uniform(random, question.angle->lower, question.angle->upper) : 0.0);
  for (int i = 0; i < (turns ? 2 : 3); ++i)
    pose.position[i] = found.center[static_cast<std::size_t>(i)] + scale * in[i];
  return pose;
}

TEST_P(SpatialShapes, HoldNoPoseOfAnotherAspect) {
  if (test::is_sanitized) GTEST_SKIP() << "a map of three coordinates";
  const Robot robot = GetParam().make();
  MapOptions options;
  options.resolution = GetParam().resolution;
  options.modes = {working_modes(*robot).back()};
  if (robot->task_space() == TaskSpace::SE2) options.region = Box{2, {-1.0, -1.0}, {1.0, 1.0}};
  const MapResult result = compute_aspect_map(robot, options);
  ASSERT_TRUE(result.map) << result.message;
  WorkspaceQuestion question = question_of(GetParam().shape);
  const bool turns = robot->task_space() == TaskSpace::SE2;
  if (turns) question.angle = AngleRange{-0.3, 0.2};
  const auto found = largest(*result.map, question, 0.05);
  std::mt19937_64 random(20);
  int shapes = 0;
  for (const RegularWorkspace& each : found) {
    EXPECT_LE(each.lower, each.upper);
    const Aspect& aspect = result.map->aspects()[static_cast<std::size_t>(each.aspect - 1)];
    if (each.lower <= 0.0) continue;
    ++shapes;
    for (int i = 0; i < 2000; ++i) {
      const Pose pose = drawn_in(question, each, turns, random);
      const auto sign = test::sign_at(*robot, pose, aspect.mode);
      EXPECT_TRUE(!sign || *sign == aspect.determinant_sign)
          << "aspect " << each.aspect << " at " << to_string(robot->task_space(), pose);
    }
  }
  EXPECT_GT(shapes, 0);
}

INSTANTIATE_TEST_SUITE_P(
    All, SpatialShapes,
    testing::Values(SpatialSubject{"DeltaCylinder", test::delta, RegularShape::cylinder, 0.06},
                    SpatialSubject{"DeltaBall", test::delta, RegularShape::ball, 0.06},
                    SpatialSubject{"DeltaBox", test::delta, RegularShape::box, 0.06},
                    SpatialSubject{"PlanarDisc", test::three_prr, RegularShape::disc, 0.1}),
    [](const testing::TestParamInfo<SpatialSubject>& each) { return std::string(each.param.name); });

Robot within(const Robot& robot, const WorkspaceBox& box) {
  ManipulatorDescription description = robot->description();
  description.constraints.workspace = box;
  return std::make_shared<const Manipulator>(description);
}

/// Shapes about centers where a grid has the most room, of the aspect that the largest shape is said to be
/// of.
void expect_none_about_other_centers_is_larger(const Robot& robot) {
  const auto map = compute_aspect_map(robot).map;
  ASSERT_TRUE(map);
  for (const RegularShape shape : {RegularShape::disc, RegularShape::square}) {
    const WorkspaceQuestion question = question_of(shape);
    for (const RegularWorkspace& each : largest(*map, question)) {
      const Aspect& aspect = map->aspects()[static_cast<std::size_t>(each.aspect - 1)];
      const Grid grid(robot, map->region(), aspect.mode, aspect.determinant_sign, 100);
      const int component = grid.component_at(each.center[0], each.center[1]);
      if (each.lower <= 0.0 || component < 0) continue;
      const Grid::Disc disc = grid.roomiest(component);
      WorkspaceQuestion about = question;
      about.center = {disc.x, disc.y, std::nullopt};
      const auto there = find_regular_workspaces(*map, {each.aspect}, about);
      ASSERT_TRUE(there);
      EXPECT_LE(there->front().lower, each.upper)
          << robot->name() << ", aspect " << each.aspect << ", about " << disc.x << ' ' << disc.y;
    }
  }
}

// Also where the wall of the region, and nothing else, is nearest to the center.
TEST(RegularWorkspace, NoneAboutAnotherCenterIsLarger) {
  for (const unsigned seed : {0U, 1U, 7U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_none_about_other_centers_is_larger(test::bounded_robot(seed, TaskSpace::T2, false));
  }
  expect_none_about_other_centers_is_larger(within(test::five_bar(), {{0.0, 1.0, 0.0}, {9.0, 9.0, 0.0}}));
}

// Half a turn is an angle as any other: how far the base is turned changes no size.
TEST(RegularWorkspace, AnglesHaveNoEnd) {
  constexpr double gap = 0.02;
  const auto of = [](const Robot& robot, double angle, RegularShape shape) {
    MapOptions options;
    options.resolution = 0.02;
    const auto map = compute_aspect_map(test::turned_about_first_hinge(*robot, angle), options).map;
    std::vector<RegularWorkspace> found = largest(*map, question_of(shape), gap);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.lower < b.lower; });
    return found;
  };
  for (const Robot& robot : {test::ankle(), test::four_bar(), test::four_bar(0.25, 0.4, 0.3, 0.5)})
    for (const RegularShape shape : {RegularShape::box, RegularShape::disc}) {
      if (shape == RegularShape::disc && robot->leg_count() == 1) continue;
      const auto reference = of(robot, 0.0, shape);
      for (const double angle : {1.0, 3.0, -2.2}) {
        const auto found = of(robot, angle, shape);
        ASSERT_EQ(found.size(), reference.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_TRUE(found[i].proved);
          EXPECT_LE(found[i].lower, reference[i].upper) << robot->name() << ' ' << angle;
          EXPECT_GE(found[i].upper, reference[i].lower) << robot->name() << ' ' << angle;
        }
      }
    }
}

// The poses of a shape that goes on beyond half a turn have one sign of det A.
TEST(RegularWorkspace, ShapesOfAnglesHoldNoSingularity) {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  MapOptions options;
  options.resolution = 0.05;
  const Robot robot = test::ankle();
  const auto map = compute_aspect_map(robot, options).map;
  int beyond = 0;
  for (const RegularWorkspace& each : largest(*map, question_of(RegularShape::square))) {
    const Aspect& aspect = map->aspects()[static_cast<std::size_t>(each.aspect - 1)];
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector2d angles(each.center[0] + 0.5 * each.lower * share(random),
                                   each.center[1] + 0.5 * each.lower * share(random));
      const auto pose = pose_from_coordinates(robot->motions(), angles);
      ASSERT_TRUE(pose);
      const auto sign = test::sign_at(*robot, *pose, aspect.mode);
      if (sign) {
        EXPECT_EQ(*sign, aspect.determinant_sign) << angles.transpose();
      }
      beyond += angles.cwiseAbs().maxCoeff() > M_PI ? 1 : 0;
    }
  }
  EXPECT_GT(beyond, 1000);
}

TEST(RegularWorkspace, QuestionsThatDoNotFitAreRefused) {
  const auto problems = [](const Robot& robot, const WorkspaceQuestion& question) {
    return problems_of(*robot, std::nullopt, question);
  };
  const WorkspaceQuestion ball = question_of(RegularShape::ball), disc = question_of(RegularShape::disc);
  EXPECT_EQ(problems(test::five_bar(), ball),
            Problems{"A ball takes 3 free positions, but 2 are free; choose box, square or disc."});
  EXPECT_EQ(problems(test::five_bar(), disc), Problems{});
  WorkspaceQuestion wrong = disc;
  wrong.ratio = {1.0};
  wrong.angle = AngleRange{0.0, 1.0};
  wrong.center[2] = 1.0;
  EXPECT_EQ(problems(test::five_bar(), wrong).size(), 3U);
  wrong = question_of(RegularShape::box);
  wrong.ratio = {1.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(problems(test::five_bar(), wrong).size(), 1U);
  wrong = disc;
  wrong.angle = AngleRange{1.0, 0.0};
  EXPECT_EQ(problems(test::three_prr(), wrong).size(), 1U);
  wrong.angle = AngleRange{0.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(problems(test::three_prr(), wrong).size(), 1U);
}

}  // namespace
}  // namespace parallel_aspects
