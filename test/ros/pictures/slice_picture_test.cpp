// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/palette.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/pictures/map_picture.h"
#include "ros/pictures/marker_groups.h"
#include "ros/pictures/scene.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include <algorithm>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const char* const long_message =
    "The assembly mode is not known: the step to the next sample cannot be certified, as it came too near to "
    "det A = 0; say where the robot is with set_assembly_mode, or bring it back to where it was started.";

std::vector<std::string> lines_of(const std::string& words) {
  std::vector<std::string> lines{""};
  for (const char letter : words) {
    if (letter == '\n')
      lines.emplace_back();
    else
      lines.back() += letter;
  }
  return lines;
}

class CaptionTest : public testing::TestWithParam<const char*> {
 protected:
  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped(GetParam());
  const Scene scene_ = scene_of(*mechanism_, NodeOptions());
};

// What it takes, to the right and upward from where it is put.
Eigen::AlignedBox2d extent(const Caption& caption, const Eigen::Vector2d& at) {
  std::size_t longest = 0;
  const auto lines = lines_of(caption.words);
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  const Eigen::Vector2d half = 0.5 * caption.text_height *
                               Eigen::Vector2d(Caption::letter_width * static_cast<double>(longest),
                                               Caption::line_pitch * static_cast<double>(lines.size()));
  return {Eigen::Vector2d(at - half), Eigen::Vector2d(at + half)};
}

TEST_P(CaptionTest, CoversNeitherTheRobotNorTheGallery) {
  const Caption caption = caption_of(scene_, std::string("robot: ") + long_message + "\n" + long_message);
  EXPECT_EQ(lines_of(caption.words).size(), Caption::max_lines);
  if (scene_.planar) {
    const auto box = extent(caption, caption.at.head<2>());
    EXPECT_LE(box.max().y(), scene_.robot.min().y());
    EXPECT_LE(box.max().x(), scene_.gallery.translation().x());
    return;
  }
  const Eigen::Vector3d at = scene_.gallery.inverse() * caption.at;
  const auto box = extent(caption, at.head<2>());
  EXPECT_GE(box.min().y(), 1.6 * scene_.tiles.text_height());  // the title of the gallery
  EXPECT_GE(box.min().x(), scene_.robot.min().x() - scene_.gallery.translation().x());
  EXPECT_LE(box.max().x(), scene_.tiles.width() + 1e-9);
}

TEST_P(CaptionTest, KeepsLinesThatFit) { EXPECT_EQ(caption_of(scene_, "ab, cd\nef").words, "ab, cd\nef"); }

INSTANTIATE_TEST_SUITE_P(ShippedRobots, CaptionTest,
                         testing::Values("five_bar", "bipod", "three_rrr", "delta", "agile_eye", "stewart",
                                         "ankle"),
                         [](const auto& robot) { return std::string(robot.param); });

// Of the Delta, computed once.
const std::shared_ptr<const AspectMap>& coarse_map() {
  static const auto map = [] {
    MapOptions options;
    options.resolution = 0.1;
    options.extra_levels = 3;
    return compute_aspect_map(test::shipped("delta")->manipulator(), options).map;
  }();
  return map;
}

class SlicePictureOfADelta : public testing::Test {
 protected:
  Drawn at_the_middle_of(const Aspect& aspect) const {
    return DrawnConfiguration{
        aspect.mode, aspect.id, {aspect.deepest, inverse(*robot_, aspect.deepest, aspect.mode).q}};
  }
  // The last aspect of the first working mode that has more than the legend has lines.
  const Aspect& one_of_many() const {
    for (const WorkingMode& mode : map_->working_modes()) {
      const Aspect* last = nullptr;
      int count = 0;
      for (const Aspect& aspect : map_->aspects())
        if (aspect.mode == mode) last = (++count, &aspect);
      if (count > 3) return *last;
    }
    ADD_FAILURE() << "no working mode has many aspects";
    return map_->aspects().front();
  }
  bool in_legend(const Drawn& now, int aspect) const {
    const auto lines = test::in_group(picture_->gallery(now), "gallery/sizes");
    return std::any_of(lines.begin(), lines.end(), [&](const Marker& line) {
      return line.text.rfind("aspect " + std::to_string(aspect) + ":", 0) == 0;
    });
  }

  const std::shared_ptr<const Mechanism> mechanism_ = test::shipped("delta");
  const std::shared_ptr<const AspectMap> map_ = coarse_map();
  const std::shared_ptr<const Manipulator> robot_ = map_->manipulator();
  const std::shared_ptr<const Picture> picture_ =
      make_slice_picture(map_, test::frames, scene_of(*mechanism_, NodeOptions()), DisplayOptions());
};

TEST_F(SlicePictureOfADelta, TheLegendAlwaysHasThePresentAspect) {
  const Aspect& aspect = one_of_many();
  const Drawn now = at_the_middle_of(aspect);
  EXPECT_FALSE(in_legend(std::nullopt, aspect.id));
  EXPECT_TRUE(in_legend(now, aspect.id));
  Drawn elsewhere = now;
  elsewhere->aspect = 0;
  EXPECT_TRUE(picture_->gallery_differs(elsewhere, now));
  EXPECT_FALSE(picture_->gallery_differs(now, now));
}

TEST_F(SlicePictureOfADelta, TheSliceDoesNotHideThePlatform) {
  const Drawn now = at_the_middle_of(one_of_many());
  const double joints = 0.0075;  // half the thickness of the platform in delta.urdf [m]
  const auto fills = test::in_group(picture_->present(now), "robot/aspects");
  ASSERT_FALSE(fills.empty());
  for (const Marker& marker : fills) {
    EXPECT_LT(marker.colors.front().a, 0.7F);
    EXPECT_LT(marker.pose.position.z + marker.points.front().z, now->solved.pose.position.z() - joints);
  }
}

TEST(SlicePictureOfAPlanarRobot, IsSeenThroughAboveAPlatformThatWouldHideIt) {
  const auto mechanism = test::shipped("three_prr");
  MapOptions options;
  options.resolution = 0.05;
  options.extra_levels = 2;
  const auto map = compute_aspect_map(mechanism->mapped_manipulator(), options).map;
  ASSERT_TRUE(map);
  const Aspect& aspect = map->aspects().front();
  const auto picture =
      make_slice_picture(map, test::frames, scene_of(*mechanism, NodeOptions()), DisplayOptions());
  const auto fills =
      test::in_group(picture->present(DrawnConfiguration{
                         aspect.mode,
                         aspect.id,
                         {aspect.deepest, inverse(*map->manipulator(), aspect.deepest, aspect.mode).q}}),
                     "robot/aspects");
  ASSERT_FALSE(fills.empty());
  constexpr double tool = 0.115;  // how high the platform is in three_prr.urdf [m]
  for (const Marker& marker : fills) {
    const auto& colors = marker.colors;
    EXPECT_LT(colors.empty() ? marker.color.a : colors.front().a, 0.7F);
    EXPECT_GT(marker.pose.position.z + marker.points.front().z, tool);
  }
}

// The torus of both angles is a square that stands upright in the base frame, whatever way the first hinge
// points. The dot is in the tile of its mode.
TEST(SlicePictureOfAnAnkle, IsASquareOfBothAngles) {
  const auto mechanism = test::shipped("ankle");
  MapOptions options;
  options.resolution = 0.05;
  const auto map = compute_aspect_map(mechanism->mapped_manipulator(), options).map;
  ASSERT_TRUE(map);
  const Scene scene = scene_of(*mechanism, NodeOptions());
  const auto picture = make_slice_picture(map, test::frames, scene, DisplayOptions());
  const geometry_msgs::Quaternion turn = picture->frames().front().transform.rotation;
  const Eigen::Vector3d up = Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z) * Eigen::Vector3d::UnitY();
  EXPECT_GT(up.z(), 0.8);
  for (const Aspect& aspect : map->aspects()) {
    const Drawn now =
        DrawnConfiguration{aspect.mode,
                           aspect.id,
                           {aspect.deepest, inverse(*map->manipulator(), aspect.deepest, aspect.mode).q}};
    EXPECT_TRUE(test::in_group(picture->present(now), "robot/aspects").empty());
    bool has_dot = false;
    for (const Marker& marker : picture->position(now).markers) {
      if (marker.points.empty()) continue;
      has_dot = true;
      const auto modes = map->working_modes();
      const auto tile =
          static_cast<std::size_t>(std::find(modes.begin(), modes.end(), aspect.mode) - modes.begin());
      const Eigen::Vector2d at(marker.points.front().x, marker.points.front().y);
      EXPECT_LE((at - scene.tiles.center(tile)).cwiseAbs().maxCoeff(), 0.51 * scene.tiles.side());
    }
    EXPECT_TRUE(has_dot);
  }
  EXPECT_FALSE(test::in_group(picture->gallery(std::nullopt), "gallery/aspects").empty());
}

TEST(CandidateColors, DifferFromEachOther) {
  std::vector<Rgb> colors{ink_color};
  for (std::size_t i = 0; i < hue_count; ++i) {
    EXPECT_EQ(std::count(colors.begin(), colors.end(), candidate_color(i)), 0) << i;
    colors.push_back(candidate_color(i));
  }
}

}  // namespace
}  // namespace parallel_aspects
