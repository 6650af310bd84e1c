// SPDX-License-Identifier: BSD-3-Clause
// What the display draws of a map, without rviz.
#include "rviz/display/surface_picture.h"

#include <gtest/gtest.h>

#include "support/shipped.h"
#include "support/slices.h"
#include <set>

namespace parallel_aspects {
namespace {

const std::atomic<bool> not_cancelled{false};

std::shared_ptr<const AspectMap> coarse_map(const char* name, double share, std::size_t modes = 0) {
  const test::Robot robot = test::shipped(name)->mapped_manipulator();
  MapOptions options;
  options.resolution = share * robot->size();
  options.extra_levels = 3;
  if (modes > 0) options.modes = working_modes(*robot);
  if (modes > 0) options.modes.resize(modes);
  return test::map_of(robot, options);
}

const AspectMap& five_bar() {
  static const auto map = coarse_map("five_bar", 0.01);
  return *map;
}

const AspectMap& three_rrr() {
  static const auto map = coarse_map("three_rrr", 0.05, 1);
  return *map;
}

PictureChoice in_aspect(const AspectMap& map, int id) {
  PictureChoice choice;
  choice.aspect = id;
  choice.mode = map.aspects()[static_cast<std::size_t>(id - 1)].mode;
  return choice;
}

double area(const ColoredMesh& mesh) {
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.points[triangle[0]].cast<double>(),
                          b = mesh.points[triangle[1]].cast<double>(),
                          c = mesh.points[triangle[2]].cast<double>();
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

TEST(SurfacePicture, ChoicesShowTheAspectsThatTheyName) {
  const AspectMap& map = five_bar();
  PictureChoice choice = in_aspect(map, 3);
  for (const int id : shown_aspects(map, choice))
    EXPECT_EQ(map.aspects()[static_cast<std::size_t>(id - 1)].mode, *choice.mode);
  EXPECT_GE(shown_aspects(map, choice).size(), 2U);
  choice.shown = Shown::present_aspect;
  EXPECT_EQ(shown_aspects(map, choice), std::vector<int>{3});
  choice.shown = Shown::all;
  EXPECT_EQ(shown_aspects(map, choice).size(), map.aspects().size());
  choice.shown = Shown::chosen;
  EXPECT_TRUE(shown_aspects(map, choice).empty());
}

TEST(SurfacePicture, IdsAndModesAreReadAndOtherWordsNamed) {
  const AspectMap& map = five_bar();
  std::string problem;
  EXPECT_EQ(chosen_aspects(map, "1, 4", problem), (std::set<int>{1, 4}));
  EXPECT_EQ(problem, "");
  std::set<int> of_mode;
  for (const Aspect& aspect : map.aspects())
    if (to_string(aspect.mode) == "(+,-)") of_mode.insert(aspect.id);
  EXPECT_EQ(chosen_aspects(map, "(+,-)", problem), of_mode);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(chosen_aspects(map, "2 (+,+,+) 99", problem), std::set<int>{2});
  EXPECT_NE(problem.find("'(+,+,+)'"), std::string::npos) << problem;
}

TEST(SurfacePicture, PlanesAreFilledAsFarAsTheMapSays) {
  const AspectMap& map = five_bar();
  PictureChoice choice;
  choice.shown = Shown::all;
  const SurfacePicture picture = draw_surfaces(map, choice, std::nullopt, not_cancelled);
  ASSERT_EQ(picture.meshes.size(), map.aspects().size());
  for (const ColoredMesh& mesh : picture.meshes) {
    const Aspect& aspect = map.aspects()[static_cast<std::size_t>(mesh.aspect - 1)];
    EXPECT_NEAR(area(mesh), aspect.measure, 0.03 * aspect.measure + 0.5) << "aspect " << mesh.aspect;
  }
  EXPECT_EQ(picture.labels.size(), map.aspects().size());
  EXPECT_FALSE(picture.lines.empty());
  EXPECT_NE(picture.legend.text.find("not known"), std::string::npos) << picture.legend.text;
}

TEST(SurfacePicture, ASectionAtTheRobotLeavesWhatIsBelowIt) {
  const AspectMap& map = three_rrr();
  const Aspect& aspect = map.aspects().front();
  PictureChoice choice = in_aspect(map, aspect.id);
  choice.section = Section::at_robot;
  const SurfacePicture picture = draw_surfaces(map, choice, aspect.deepest, not_cancelled);
  ASSERT_FALSE(picture.meshes.empty());
  EXPECT_TRUE(picture.is_cut);
  const double level = drawn_point(TaskSpace::SE2, aspect.deepest, picture.radian).z();
  double cut = 0.0;
  for (const ColoredMesh& mesh : picture.meshes) {
    for (const Eigen::Vector3f& point : mesh.points) EXPECT_LE(point.z(), level + 1e-4);
    if (mesh.is_cut) cut += area(mesh);
  }
  EXPECT_GT(cut, 1.0);
  EXPECT_NE(picture.legend.text.find("in aspect " + std::to_string(aspect.id)), std::string::npos);
  EXPECT_NEAR(placement(*map.manipulator(), aspect.deepest, picture.radian).z() + level, 0.0,
              0.05 * map.manipulator()->size());
}

TEST(SurfacePicture, ACancelledOneIsEmpty) {
  const std::atomic<bool> cancelled{true};
  PictureChoice choice;
  choice.shown = Shown::all;
  EXPECT_TRUE(draw_surfaces(three_rrr(), choice, std::nullopt, cancelled).meshes.empty());
}

}  // namespace
}  // namespace parallel_aspects
