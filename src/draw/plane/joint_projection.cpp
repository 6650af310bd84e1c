// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/map_pictures.h"
#include "model/angles.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

constexpr double longest_edge = 0.25;    // of an image, where it can be had [rad]
constexpr double longest_segment = 0.5;  // likewise
constexpr int max_splits = 2;

// Images are drawn a little larger than they are, so that no gap is seen where a straight side meets two that
// are not quite in line.
constexpr double enlargement = 1.04;

std::array<Vector2d, 4> corners_of(const Box& box) {
  return {Vector2d(box.lower[0], box.lower[1]), Vector2d(box.upper[0], box.lower[1]),
          Vector2d(box.upper[0], box.upper[1]), Vector2d(box.lower[0], box.upper[1])};
}

using Polygon = std::vector<Vector2d>;

// Four polygons at the corners of a quadrilateral or of a triangle; a fan of triangles for more corners.
std::vector<Polygon> parts_of(const Polygon& p) {
  const std::size_t n = p.size();
  std::vector<Polygon> parts;
  if (n > 4) {
    for (std::size_t i = 2; i < n; ++i) parts.push_back({p[0], p[i - 1], p[i]});
    return parts;
  }
  Vector2d center = Vector2d::Zero();
  for (const Vector2d& corner : p) center += corner / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i)
    parts.push_back({p[i], 0.5 * (p[i] + p[(i + 1) % n]), center, 0.5 * (p[i] + p[(i + n - 1) % n])});
  return parts;
}

// Triangles of a convex polygon, turned counter-clockwise.
void add_fan(const Polygon& polygon, TriangleCorners& corners) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector2d first = polygon[i - 1] - polygon[0], second = polygon[i] - polygon[0];
    const bool turned = first.x() * second.y() - first.y() * second.x() < 0.0;
    corners.insert(corners.end(), {polygon[0], polygon[turned ? i : i - 1], polygon[turned ? i - 1 : i]});
  }
}

Polygon enlarged(Polygon polygon) {
  Vector2d center = Vector2d::Zero();
  for (const Vector2d& corner : polygon) center += corner / static_cast<double>(polygon.size());
  for (Vector2d& corner : polygon) corner = center + enlargement * (corner - center);
  return polygon;
}

std::optional<std::size_t> singular_leg(const BoundarySegment& segment) {
  return segment.kind == BoundaryKind::serial ? std::optional<std::size_t>(segment.leg) : std::nullopt;
}

std::optional<std::size_t> singular_leg(const LevelSegment&) { return std::nullopt; }

PoseSlice plane_of(const AspectMap& map) {
  return map.slice() ? PoseSlice(*map.manipulator(), *map.slice())
                     : PoseSlice(map.manipulator()->motions(), 0.0);
}

}  // namespace

bool JointProjection::is_possible(const AspectMap& map) noexcept {
  const TaskSpace space = map.manipulator()->task_space();
  return map.slice() ? map.slice()->joint.has_value() : space == TaskSpace::T2 || space == TaskSpace::R2;
}

JointProjection::JointProjection(std::shared_ptr<const AspectMap> map)
    : map_(std::move(map)), slice_(plane_of(*map_)) {
  if (map_->slice()) {
    const std::size_t held = map_->slice()->joint->leg;
    legs_ = {held == 0 ? 1U : 0U, held == 2 ? 1U : 2U};
  }
  find_window();
}

// Of a leg that is singular there both branches meet; beside it the joint value changes like a root, and a
// point that is traced is not quite on the curve. The sign 0 is the value between the branches.
Vector2d JointProjection::joint_values(const Vector2d& point, const WorkingMode& mode,
                                       std::optional<std::size_t> singular) const {
  const Pose pose = slice_.pose(point);
  Vector2d q;
  for (std::size_t i = 0; i < 2; ++i) {
    const Leg& leg = map_->manipulator()->leg(legs_[i]);
    const int sign = legs_[i] == singular ? 0 : mode.sign(legs_[i]);
    q[static_cast<Eigen::Index>(i)] = joint_value(leg, pose.transform(leg.anchor), sign);
  }
  return q;
}

Vector2d JointProjection::image(const Vector2d& point, const WorkingMode& mode) const {
  return window_.wrapped(joint_values(point, mode));
}

// The whole range of a length counts like a turn, whatever its unit.
double JointProjection::span(const Vector2d& from, const Vector2d& to) const {
  Vector2d result = (to - from).cwiseAbs();
  for (const int i : {0, 1})
    if (!map_->manipulator()->leg(legs_[static_cast<std::size_t>(i)]).actuated_by_angle())
      result[i] *= full_turn / (window_.upper[i] - window_.lower[i]);
  return result.maxCoeff();
}

void JointProjection::find_window() {
  window_.lower.setConstant(std::numeric_limits<double>::infinity());
  window_.upper = -window_.lower;
  for (const Aspect& aspect : map_->aspects())
    map_->visit_inside_leaves(aspect.id, [&](const Box& box) {
      for (const Vector2d& corner : corners_of(box)) {
        const Vector2d q = joint_values(corner, aspect.mode);
        window_.lower = window_.lower.cwiseMin(q);
        window_.upper = window_.upper.cwiseMax(q);
      }
    });
  for (const int i : {0, 1}) {
    const Leg& leg = map_->manipulator()->leg(legs_[static_cast<std::size_t>(i)]);
    if (!leg.actuated_by_angle() || leg.limits.limited()) continue;
    window_.turns[static_cast<std::size_t>(i)] = true;
    window_.lower[i] = -0.5 * full_turn;
    window_.upper[i] = 0.5 * full_turn;
  }
}

TriangleCorners JointProjection::triangles(int aspect, const std::vector<BoundarySliver>& slivers) const {
  const WorkingMode mode = map_->aspects()[static_cast<std::size_t>(aspect - 1)].mode;
  TriangleCorners corners;
  const auto add = [&](const Polygon& image) {
    for (const Polygon& copy : window_.copies_of(enlarged(image), true)) add_fan(copy, corners);
  };
  for (const BoundarySliver& sliver : slivers)
    if (sliver.aspect == aspect) visit_images(sliver.corners, mode, max_splits, add);
  return corners;
}

std::vector<BoundarySliver> JointProjection::images(int aspect,
                                                    const std::vector<BoundarySliver>& slivers) const {
  const WorkingMode mode = map_->aspects()[static_cast<std::size_t>(aspect - 1)].mode;
  std::vector<BoundarySliver> pieces;
  const auto add = [&](const Polygon& image) {
    for (Polygon& copy : window_.copies_of(image, true)) pieces.push_back({aspect, std::move(copy)});
  };
  for (const BoundarySliver& sliver : slivers)
    if (sliver.aspect == aspect) visit_images(sliver.corners, mode, max_splits, add);
  return pieces;
}

void JointProjection::visit_images(const std::vector<Vector2d>& polygon, const WorkingMode& mode,
                                   int splits_left,
                                   const std::function<void(const std::vector<Vector2d>&)>& visit) const {
  Polygon image;
  double longest = 0.0;
  for (const Vector2d& corner : polygon) {
    const Vector2d q = joint_values(corner, mode);
    image.push_back(image.empty() ? q : window_.near(image.front(), q));
    longest = std::max(longest, span(image.front(), image.back()));
  }
  if (longest > longest_edge && splits_left > 0) {
    for (const Polygon& part : parts_of(polygon)) visit_images(part, mode, splits_left - 1, visit);
    return;
  }
  // An image that still spans a large part of a turn cannot be unwrapped safely; it is smaller than can be
  // seen.
  if (longest < 0.25 * full_turn) visit(image);
}

template <class Segment>
std::vector<Segment> JointProjection::images_of(const std::vector<Segment>& segments,
                                                const WorkingMode& mode) const {
  std::vector<Segment> images;
  for (Segment segment : segments) {
    const Vector2d from = joint_values(segment.from, mode, singular_leg(segment)),
                   to = window_.near(from, joint_values(segment.to, mode, singular_leg(segment)));
    if (!(span(from, to) < longest_segment)) continue;
    for (const auto& piece : window_.pieces(from, to)) {
      segment.from = piece[0];
      segment.to = piece[1];
      images.push_back(segment);
    }
  }
  return images;
}

std::vector<BoundarySegment> JointProjection::images(const std::vector<BoundarySegment>& segments,
                                                     const WorkingMode& mode) const {
  return images_of(segments, mode);
}

std::vector<LevelSegment> JointProjection::images(const std::vector<LevelSegment>& segments,
                                                  const WorkingMode& mode) const {
  return images_of(segments, mode);
}

}  // namespace parallel_aspects
