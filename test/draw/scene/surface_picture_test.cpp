// SPDX-License-Identifier: BSD-3-Clause
// What the display draws of a map.
#include "draw/scene/surface_picture.h"

#include "draw/plane/palette.h"
#include "draw/scene/robot_lines.h"
#include "draw/scene/workspace_bodies.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/slices.h"
#include <algorithm>
#include <cmath>
#include <map>
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

SurfaceStore& five_bar_store() {
  static SurfaceStore store(coarse_map("five_bar", 0.01));
  return store;
}

const AspectMap& five_bar() { return five_bar_store().map(); }

SurfaceStore& three_rrr_store() {
  static SurfaceStore store(coarse_map("three_rrr", 0.05, 1));
  return store;
}

const AspectMap& three_rrr() { return three_rrr_store().map(); }

PictureChoice in_aspect(const AspectMap& map, int id) {
  PictureChoice choice;
  choice.aspect = id;
  choice.modes = {map.aspects()[static_cast<std::size_t>(id - 1)].mode};
  choice.robot = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
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
    EXPECT_EQ(map.aspects()[static_cast<std::size_t>(id - 1)].mode, choice.modes.front());
  EXPECT_GE(shown_aspects(map, choice).size(), 2U);
  choice.shown = Shown::present_aspect;
  EXPECT_EQ(shown_aspects(map, choice), std::vector<int>{3});
  choice.shown = Shown::all;
  EXPECT_EQ(shown_aspects(map, choice).size(), map.aspects().size());
  choice.shown = Shown::chosen;
  EXPECT_TRUE(shown_aspects(map, choice).empty());
}

// Aspects of different working modes lie upon each other, and may be deepest at one place.
TEST(SurfacePicture, LabelsDoNotOverprint) {
  PictureChoice choice = in_aspect(five_bar(), 1);
  choice.shown = Shown::all;
  choice.aspect = 0;
  for (const Aspect& aspect : five_bar().aspects()) choice.candidates.insert(aspect.id);
  const auto labels = draw_surfaces(five_bar_store(), choice, std::nullopt, not_cancelled).moving.labels;
  EXPECT_EQ(labels.size(), five_bar().aspects().size());
  const double height = id_height * five_bar().manipulator()->size();
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector3f apart = (labels[i].at - labels[j].at).cwiseAbs();
      EXPECT_TRUE(apart.y() >= height ||
                  apart.x() >=
                      0.25 * height * static_cast<double>(labels[i].text.size() + labels[j].text.size()))
          << labels[i].text << " upon " << labels[j].text;
    }
}

// Seen from obliquely above, a line has less room than it has from the side.
TEST(SurfacePicture, LabelsOfBodiesDoNotOverprintFromAbove) {
  SurfaceStore store(coarse_map("linear_delta", 0.05));
  PictureChoice choice = in_aspect(store.map(), 1);
  choice.shown = Shown::all;
  choice.aspect = 0;
  for (const Aspect& aspect : store.map().aspects()) choice.candidates.insert(aspect.id);
  const auto labels = draw_surfaces(store, choice, std::nullopt, not_cancelled).moving.labels;
  EXPECT_GT(labels.size(), 6U);
  const double height = id_height * store.map().manipulator()->size();
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector3f apart = (labels[i].at - labels[j].at).cwiseAbs();
      const double width = 0.25 * height * static_cast<double>(labels[i].text.size() + labels[j].text.size());
      EXPECT_TRUE(apart.z() >= 1.5 * height || apart.head<2>().maxCoeff() >= 0.99 * std::max(height, width))
          << labels[i].text << " upon " << labels[j].text;
    }
}

TEST(SurfacePicture, TheLegendHasTheColoursThatItNames) {
  const SurfacePicture picture =
      draw_surfaces(five_bar_store(), in_aspect(five_bar(), 1), std::nullopt, not_cancelled);
  EXPECT_EQ(picture.legend.text.find('\n'), std::string::npos);
  ASSERT_EQ(picture.meanings.size(), 2U);
  EXPECT_NE(picture.meanings[0].text.find("serial"), std::string::npos);
  EXPECT_EQ(picture.meanings[0].color, boundary_color(BoundaryKind::serial));
  EXPECT_EQ(picture.meanings[1].color, boundary_color(BoundaryKind::parallel));
  EXPECT_GT(picture.meanings[1].raised, picture.meanings[0].raised + 1.0);
  EXPECT_GT(picture.legend.raised, picture.meanings[1].raised + 1.0);
}

// A legend at what is drawn alone would lie upon the robot, or move with the section.
TEST(SurfacePicture, TheLegendStandsAboveWhatIsReachedAndHasTheSizeOfTheView) {
  PictureChoice choice = in_aspect(five_bar(), 1);
  choice.reach = {Eigen::Vector3d(-20.0, -20.0, 0.0), Eigen::Vector3d(20.0, 40.0, 0.0)};
  choice.seen = 60.0;
  const SurfacePicture picture = draw_surfaces(five_bar_store(), choice, std::nullopt, not_cancelled);
  EXPECT_GT(picture.legend.at.y(), 40.0F);
  EXPECT_FLOAT_EQ(picture.legend.at.y(), picture.meanings[0].at.y());
  EXPECT_DOUBLE_EQ(picture.legend_size, legend_height * 60.0);
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
  const SurfacePicture picture = draw_surfaces(five_bar_store(), choice, std::nullopt, not_cancelled);
  ASSERT_EQ(picture.moving.meshes.size(), map.aspects().size());
  for (const ColoredMesh& mesh : picture.moving.meshes) {
    const Aspect& aspect = map.aspects()[static_cast<std::size_t>(mesh.aspect - 1)];
    EXPECT_NEAR(area(mesh), aspect.measure, 0.03 * aspect.measure + 0.5) << "aspect " << mesh.aspect;
  }
  EXPECT_EQ(picture.moving.labels.size(), map.aspects().size());
  EXPECT_FALSE(picture.moving.lines.empty());
  EXPECT_NE(picture.legend.text.find("not known"), std::string::npos) << picture.legend.text;
}

// Links and the handle stand at the robot, and beyond its ends the words of an aspect are on nothing.
TEST(SurfacePicture, LabelsKeepOffTheRobotAndTheEndsOfTheirAspects) {
  for (SurfaceStore* const store : {&five_bar_store(), &three_rrr_store()}) {
    const Aspect& aspect = store->map().aspects().front();
    PictureChoice choice = in_aspect(store->map(), aspect.id);
    choice.section = Section::at_robot;
    const SurfacePicture picture = draw_surfaces(*store, choice, aspect.deepest, not_cancelled);
    const Eigen::Vector3d robot = drawn_point(store->robot(), aspect.deepest, picture.radian);
    const auto present = std::find_if(picture.moving.labels.begin(), picture.moving.labels.end(),
                                      [&](const Label& label) { return label.aspect == aspect.id; });
    ASSERT_NE(present, picture.moving.labels.end());
    double to_end = 1e9;
    for (const ColoredLines& lines : picture.moving.lines)
      for (const Eigen::Vector3f& end : lines.ends)
        to_end = std::min(to_end, double{(end - present->at).norm()});
    EXPECT_GT((present->at.cast<double>() - robot).norm(), 0.03 * picture.size) << store->robot().name();
    EXPECT_GT(to_end, 0.03 * picture.size) << store->robot().name();
    for (const Label& label : picture.moving.labels) EXPECT_EQ(label.color, ink_color) << label.text;
  }
}

// Of an ankle where its normal points on a sphere, in front of the platform.
TEST(SurfacePicture, AnAnkleHasPatchesOnASphere) {
  MapOptions options;
  options.resolution = 0.1;
  SurfaceStore store(test::map_of(test::ankle(), options));
  for (const Aspect& aspect : store.map().aspects()) {
    PictureChoice choice = in_aspect(store.map(), aspect.id);
    choice.shown = Shown::present_aspect;
    const SurfacePicture picture = draw_surfaces(store, choice, aspect.deepest, not_cancelled);
    ASSERT_EQ(picture.moving.meshes.size(), 1U);
    const Eigen::Vector3d robot = drawn_point(store.robot(), aspect.deepest, picture.radian);
    double nearest = 1e9;
    for (const Eigen::Vector3f& point : picture.moving.meshes.front().points) {
      EXPECT_NEAR(point.norm(), picture.radian, 0.09 * picture.radian);
      nearest = std::min(nearest, (point.cast<double>() - robot).norm());
    }
    EXPECT_LT(nearest, 0.06 * picture.radian) << aspect.id;
  }
}

TEST(SurfacePicture, ASectionAtTheRobotLeavesWhatIsBelowIt) {
  const AspectMap& map = three_rrr();
  const Aspect& aspect = map.aspects().front();
  PictureChoice choice = in_aspect(map, aspect.id);
  choice.section = Section::at_robot;
  const SurfacePicture picture = draw_surfaces(three_rrr_store(), choice, aspect.deepest, not_cancelled);
  ASSERT_FALSE(picture.moving.meshes.empty());
  EXPECT_TRUE(picture.is_cut);
  const double level = drawn_point(three_rrr_store().robot(), aspect.deepest, picture.radian).z();
  double cut = 0.0;
  const auto colors = aspect_colors(map.aspects());
  for (const ColoredMesh& mesh : picture.moving.meshes) {
    for (const Eigen::Vector3f& point : mesh.points) EXPECT_LE(point.z(), level + 1e-4);
    if (!mesh.is_flat) continue;
    cut += area(mesh);
    EXPECT_EQ(mesh.color, colors[static_cast<std::size_t>(mesh.aspect - 1)]) << "faces have plain colours";
    for (const Eigen::Vector3f& point : mesh.points) EXPECT_NEAR(point.z(), level, 1e-4);
  }
  EXPECT_FALSE(picture.moving.lines.empty()) << "faces have no outline";
  EXPECT_GT(cut, 1.0);
  EXPECT_NE(picture.legend.text.find("in aspect " + std::to_string(aspect.id)), std::string::npos);
  EXPECT_NEAR(placement(*map.manipulator(), aspect.deepest, picture.radian).z() + level, 0.0,
              0.05 * map.manipulator()->size());
}

TEST(SurfacePicture, WhileTheStateIsAmbiguousTheCandidatesAreDrawn) {
  const AspectMap& map = five_bar();
  PictureChoice choice;
  EXPECT_TRUE(shown_aspects(map, choice).empty()) << "nothing is known";
  choice.candidates = {1, 4};
  choice.modes = {map.aspects()[0].mode, map.aspects()[3].mode};
  for (const int id : shown_aspects(map, choice)) {
    const WorkingMode& mode = map.aspects()[static_cast<std::size_t>(id - 1)].mode;
    EXPECT_TRUE(mode == choice.modes[0] || mode == choice.modes[1]) << id;
  }
  choice.shown = Shown::present_aspect;
  EXPECT_EQ(shown_aspects(map, choice), (std::vector<int>{1, 4}));
  choice.robot = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
  const SurfacePicture picture = draw_surfaces(five_bar_store(), choice, std::nullopt, not_cancelled);
  EXPECT_NE(picture.legend.text.find("may be in aspect 1 or 4"), std::string::npos) << picture.legend.text;
  std::set<std::string> words;
  for (const Label& label : picture.moving.labels) words.insert(label.text);
  EXPECT_EQ(words, (std::set<std::string>{"aspect 1?", "aspect 4?"}));
}

TEST(SurfacePicture, JointSpacesHaveThePointOfThePresentJointValues) {
  for (SurfaceStore* const store : {&five_bar_store(), &three_rrr_store()}) {
    const Aspect& aspect = store->map().aspects().front();
    PictureChoice choice = in_aspect(store->map(), aspect.id);
    choice.shown = Shown::present_aspect;
    choice.joint_space = true;
    const SurfacePicture picture = draw_surfaces(*store, choice, aspect.deepest, not_cancelled);
    ASSERT_EQ(picture.joint_spaces.size(), 1U);
    const InverseSolution solution = inverse(store->robot(), aspect.deepest, aspect.mode);
    ASSERT_TRUE(solution);
    const Eigen::Vector3d point = picture.joint_spaces.front().drawn(solution.q);
    double nearest = 1e9;
    Eigen::AlignedBox3d box;
    for (const ColoredMesh& mesh : picture.standing.meshes)
      for (const Eigen::Vector3f& each : mesh.points) {
        nearest = std::min(nearest, (each.cast<double>() - point).norm());
        box.extend(each.cast<double>());
      }
    EXPECT_LT(nearest, 0.2 * box.sizes().norm());
    EXPECT_GT(box.min().x(), 1.0) << "it stands beside the robot";
  }
}

TEST(SurfacePicture, TheGalleryHasEachWorkingModeOnceAndNoTwoTilesMeet) {
  PictureChoice choice = in_aspect(five_bar(), 1);
  choice.gallery = choice.joint_space = true;
  const SurfacePicture picture =
      draw_surfaces(five_bar_store(), choice, five_bar().aspects().front().deepest, not_cancelled);
  EXPECT_EQ(picture.workspaces.size(), five_bar().working_modes().size());
  EXPECT_EQ(picture.joint_spaces.size(), five_bar().working_modes().size());
  std::map<std::string, Eigen::AlignedBox3f> boxes;
  for (const ColoredMesh& mesh : picture.standing.meshes) {
    const Aspect& aspect = five_bar().aspects()[static_cast<std::size_t>(mesh.aspect - 1)];
    for (const Eigen::Vector3f& point : mesh.points) boxes[to_string(aspect.mode)].extend(point);
  }
  EXPECT_EQ(boxes.size(), five_bar().working_modes().size());
  for (const auto& [mode, box] : boxes)
    for (const auto& [other, beside] : boxes)
      EXPECT_EQ(box.intersects(beside), mode == other) << mode << " " << other;
}

// To the right and up, as whoever examines rviz sees it.
Eigen::Vector2d seen(const Eigen::Vector3d& way, bool planar) {
  return planar ? Eigen::Vector2d(way.head<2>())
                : Eigen::Vector2d(way.x(), way.z() * std::cos(view_pitch) + way.y() * std::sin(view_pitch));
}

// The platform hides what is upon it: words there are beside it, with a line to what they name.
TEST(SurfacePicture, LabelsKeepOffThePlatform) {
  for (const auto& [name, share] : {std::pair{"three_prr", 0.05}, {"linear_delta", 0.05}}) {
    SurfaceStore store(coarse_map(name, share));
    const Manipulator& robot = store.robot();
    const bool planar = is_planar(robot.task_space());
    const Pose pose = store.map().aspects().front().deepest;
    PictureChoice choice = in_aspect(store.map(), store.map().aspects().front().id);
    choice.shown = Shown::all;
    const SurfacePicture picture = draw_surfaces(store, choice, pose, not_cancelled);
    const Eigen::Vector3d point = drawn_point(robot, pose, picture.radian);
    const double height = id_height * robot.size();
    ASSERT_FALSE(picture.moving.labels.empty());
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i)
      for (int k = 0; i + k <= steps; ++k) {
        const Eigen::Vector3d corners[] = {robot.leg(0).anchor, robot.leg(1).anchor, robot.leg(2).anchor};
        const Eigen::Vector3d on_platform =
            pose.orientation * ((i * corners[0] + k * corners[1] + (steps - i - k) * corners[2]) / steps);
        for (const Label& label : picture.moving.labels) {
          const Eigen::Vector2d off = seen(on_platform + point - label.at.cast<double>(), planar);
          const double half = 0.25 * height * static_cast<double>(label.text.size());
          EXPECT_FALSE(std::abs(off.x()) < half && std::abs(off.y()) < 0.45 * height)
              << name << ": " << label.text << " lies on the platform";
        }
      }
    const auto leaders = std::find_if(picture.moving.lines.begin(), picture.moving.lines.end(),
                                      [](const ColoredLines& lines) { return lines.is_leader; });
    ASSERT_NE(leaders, picture.moving.lines.end()) << name;
    EXPECT_EQ(leaders->ends.size() % 2, 0U);
  }
}

TEST(SurfacePicture, ACancelledOneIsEmpty) {
  const std::atomic<bool> cancelled{true};
  PictureChoice choice;
  choice.shown = Shown::all;
  EXPECT_TRUE(draw_surfaces(three_rrr_store(), choice, std::nullopt, cancelled).moving.meshes.empty());
}

}  // namespace
}  // namespace parallel_aspects
