// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/map_picture.h"

#include "ros/monitor/five_bar_setup.h"
#include "ros/pictures/marker_batch.h"
#include "ros/pictures/marker_groups.h"

#include <gtest/gtest.h>
#include <ros/serialization.h>

#include "support/robots/robots.h"
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace parallel_aspects {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

std::shared_ptr<const AspectMap> map_of(const std::shared_ptr<const Manipulator>& manipulator) {
  MapOptions options;
  options.resolution = 0.2;
  return compute_aspect_map(manipulator, options).map;
}

BoundaryPicture traced(const AspectMap& map, const WorkingMode& mode) {
  return trace_slice(map, mode, PoseSlice(TaskSpace::T2, 0.0), slice_bounds(map), 160);
}

// Signed area of a list of triangles seen from above.
double area(const Marker& marker) {
  double twice = 0.0;
  for (std::size_t i = 0; i + 2 < marker.points.size(); i += 3) {
    const auto &a = marker.points[i], &b = marker.points[i + 1], &c = marker.points[i + 2];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return 0.5 * twice;
}

class MapPictureTest : public testing::Test {
 protected:
  std::optional<DrawnConfiguration> now(double x, double y, const std::vector<int>& signs) const {
    const WorkingMode mode = *WorkingMode::from_signs(signs);
    const Pose pose = test::pose_at(x, y);
    return DrawnConfiguration{mode, map_->locate(pose, mode).aspect, {pose, inverse(*robot_, pose, mode).q}};
  }

  std_msgs::ColorRGBA color_of(int aspect) const {
    return color(aspect_colors(map_->aspects())[static_cast<std::size_t>(aspect - 1)]);
  }

  std::shared_ptr<const Manipulator> robot_ = test::five_bar();
  std::shared_ptr<const AspectMap> map_ = map_of(robot_);
  std::shared_ptr<const Picture> picture_ = make_map_picture(map_, test::frames, DisplayOptions{});
};

TEST_F(MapPictureTest, EveryArrayDeletesFirstAndHasStampZeroAndUniqueIds) {
  for (const MarkerArray& array : {picture_->gallery(std::nullopt), picture_->present(now(4.5, 8.0, {1, -1})),
                                   picture_->present(std::nullopt), picture_->position(std::nullopt),
                                   picture_->position(now(4.5, 8.0, {1, -1}))}) {
    ASSERT_FALSE(array.markers.empty());
    EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
    std::set<std::pair<std::string, int>> ids;
    for (std::size_t i = 1; i < array.markers.size(); ++i) {
      const Marker& marker = array.markers[i];
      EXPECT_TRUE(marker.header.stamp.isZero());
      EXPECT_EQ(marker.color.a, 1.0F);
      EXPECT_TRUE(ids.emplace(marker.ns, marker.id).second) << marker.ns << " " << marker.id;
    }
  }
}

TEST_F(MapPictureTest, PointsAreFinite) {
  for (const MarkerArray& array :
       {picture_->gallery(std::nullopt), picture_->present(now(4.5, 8.0, {1, -1}))})
    for (const Marker& marker : array.markers)
      for (const auto& point : marker.points)
        ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) << marker.ns;
}

TEST_F(MapPictureTest, EachAspectIsOneTriangleListInItsColourAndSize) {
  const auto fills = test::in_group(picture_->gallery(std::nullopt), "workspace/aspects");
  ASSERT_EQ(fills.size(), map_->aspects().size());
  const double scale = DisplayOptions{}.gallery_scale;
  for (const Aspect& aspect : map_->aspects()) {
    const Marker& marker = fills[static_cast<std::size_t>(aspect.id - 1)];
    EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
    EXPECT_EQ(marker.header.frame_id, test::frames.aspects);
    EXPECT_EQ(marker.color, color_of(aspect.id));
    // Drawn are the inside leaves and slivers of the undecided ones.
    EXPECT_GE(area(marker) / (scale * scale), aspect.measure_lower * (1.0 - 1e-9));
    EXPECT_LE(area(marker) / (scale * scale), aspect.measure_upper * (1.0 + 1e-9));
  }
}

TEST_F(MapPictureTest, JointProjectionsAreInTheWindowAndTurnedToTheViewer) {
  const auto fills = test::in_group(picture_->gallery(std::nullopt), "joint_space/aspects");
  ASSERT_EQ(fills.size(), map_->aspects().size());
  for (const Marker& marker : fills) {
    EXPECT_EQ(marker.header.frame_id, test::frames.joint_space);
    for (std::size_t i = 0; i + 2 < marker.points.size(); i += 3) {
      const auto &a = marker.points[i], &b = marker.points[i + 1], &c = marker.points[i + 2];
      EXPECT_GE((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), -1e-12);
    }
  }
}

// With two assembly modes at the same joint values, one fill hides another: the present one is over all, and
// a word says that there are several.
TEST_F(MapPictureTest, ThePresentAspectIsOverOthersInJointSpace) {
  const auto gallery = picture_->gallery(std::nullopt);
  const auto fills = test::in_group(gallery, "joint_space/aspects");
  EXPECT_EQ(test::in_group(gallery, "joint_space/several").size(), map_->working_modes().size());
  for (const auto& present : {now(4.5, 8.0, {1, -1}), now(4.5, -8.0, {1, -1})}) {
    ASSERT_NE(present->aspect, 0);
    const auto over = test::in_group(picture_->present(present), "joint_space/present");
    ASSERT_EQ(over.size(), 1U);
    EXPECT_EQ(over.front().color, color_of(present->aspect));
    for (const Marker& fill : fills) EXPECT_GT(over.front().points.front().z, fill.points.front().z);
  }
}

TEST_F(MapPictureTest, TheProjectionOfAnAspectHoldsTheDrivesOfItsPoses) {
  const JointProjection projection(map_);
  for (const Aspect& aspect : map_->aspects()) {
    const Eigen::Vector2d q =
        projection.window().wrapped(inverse(*robot_, aspect.deepest, aspect.mode).q.head<2>());
    const auto corners = projection.triangles(aspect.id, traced(*map_, aspect.mode).slivers);
    bool held = false;
    for (std::size_t i = 0; i + 2 < corners.size() && !held; i += 3) {
      const auto left_of = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (b - a).x() * (q - a).y() - (b - a).y() * (q - a).x() >= -1e-9;
      };
      held = left_of(corners[i], corners[i + 1]) && left_of(corners[i + 1], corners[i + 2]) &&
             left_of(corners[i + 2], corners[i]);
    }
    EXPECT_TRUE(held) << "aspect " << aspect.id << " at q = " << q.transpose();
  }
}

TEST_F(MapPictureTest, TheBoundaryLiesOnSingularities) {
  for (const WorkingMode& mode : map_->working_modes()) {
    const BoundaryPicture boundary = traced(*map_, mode);
    ASSERT_FALSE(boundary.segments.empty());
    for (const BoundarySegment& segment : boundary.segments) {
      ASSERT_EQ(segment.kind == BoundaryKind::limit, false);
      if (segment.kind != BoundaryKind::serial) continue;
      const double reach =
          segment.leg == 0 ? segment.from.norm() : (segment.from - Eigen::Vector2d(9.0, 0.0)).norm();
      EXPECT_LT(std::min(std::abs(reach - 13.0), std::abs(reach - 3.0)), 0.02) << segment.from.transpose();
    }
  }
}

TEST_F(MapPictureTest, OnlyTheAspectsOfThePresentModeAreAtTheRobot) {
  EXPECT_TRUE(test::in_group(picture_->present(std::nullopt), "robot/aspects").empty());
  const auto present = now(4.5, 8.0, {1, -1});
  ASSERT_NE(present->aspect, 0);
  const auto fills = test::in_group(picture_->present(present), "robot/aspects");
  EXPECT_EQ(fills.size(), 3U);
  int highlighted = 0;
  for (const Marker& marker : fills) highlighted += marker.color == color_of(present->aspect) ? 1 : 0;
  EXPECT_EQ(highlighted, 1);
  EXPECT_EQ(test::in_group(picture_->present(present), "robot/outline").size(), 1U);
}

TEST_F(MapPictureTest, ThePositionIsDrawnInBothTilesOfItsModeAndGoesAway) {
  const MarkerArray position = picture_->position(now(4.5, 8.0, {1, -1}));
  EXPECT_FALSE(test::in_group(position, "position/workspace").empty());
  EXPECT_FALSE(test::in_group(position, "position/joint_space").empty());
  EXPECT_EQ(picture_->position(std::nullopt).markers.size(), 1U);
}

TEST_F(MapPictureTest, OnlyAnotherModeOrAspectIsDrawnAnew) {
  const Drawn here = now(4.5, 8.0, {1, -1});
  EXPECT_FALSE(picture_->present_differs(here, now(4.6, 8.0, {1, -1})));
  EXPECT_TRUE(picture_->present_differs(here, now(4.5, 8.0, {1, 1})));
  EXPECT_TRUE(picture_->present_differs(here, std::nullopt));
  EXPECT_FALSE(picture_->gallery_differs(here, now(4.5, 8.0, {1, 1})));
}

// rviz takes them over the network, and again each time that it is opened.
TEST_F(MapPictureTest, MessagesAreSmall) {
  const auto map = compute_aspect_map(robot_).map;
  const auto picture = make_map_picture(map, test::frames, DisplayOptions{});
  EXPECT_LT(ros::serialization::serializationLength(picture->gallery(std::nullopt)), 3000000U);
  EXPECT_LT(ros::serialization::serializationLength(picture->present(now(4.5, 8.0, {1, -1}))), 1500000U);
}

TEST_F(MapPictureTest, WithoutAGalleryOnlyTheRobotIsDrawn) {
  DisplayOptions options;
  options.gallery = false;
  const auto plain = make_map_picture(map_, test::frames, options);
  EXPECT_TRUE(test::in_group(plain->gallery(now(4.5, 8.0, {1, -1})), "workspace/aspects").empty());
  EXPECT_FALSE(test::in_group(plain->present(now(4.5, 8.0, {1, -1})), "robot/aspects").empty());
}

TEST(MapPictureOfABipod, DrawsJointLimitsAsBoundaries) {
  const auto map = map_of(test::bipod());
  ASSERT_TRUE(map);
  std::map<BoundaryKind, int> kinds;
  for (const BoundarySegment& segment : traced(*map, map->working_modes().front()).segments)
    ++kinds[segment.kind];
  EXPECT_GT(kinds[BoundaryKind::limit], 0);
  EXPECT_GT(kinds[BoundaryKind::parallel], 0);
}

}  // namespace
}  // namespace parallel_aspects
