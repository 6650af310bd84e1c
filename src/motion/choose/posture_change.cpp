// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/posture_change.h"

#include "aspects/boxes/segment_proof.h"
#include "interval/interval.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int steps_of_ray = 80;  // over the size of the robot
constexpr int bisections = 40;    // of a step
constexpr double beyond = 1e-4;   // of the way, past B_jj = 0, where the leg is proved not to reach
constexpr int looks_on_ray = 16;  // at the sign of det A, before a proof is tried
constexpr int directions_in_plane = 32;

MapPoint along(const MapPosition& from, const MapPoint& direction, double share) {
  MapPoint result = from.point;
  for (std::size_t i = 0; i < max_map_dimension; ++i) result[i] += share * direction[i];
  return result;
}

/// Positions are not bounded by the space; angles and charts of rotations are.
bool is_mapped(const PoseSpace& space, const MapPoint& point) {
  for (std::size_t i = 0; i < space.dimension(); ++i)
    if ((space.is_periodic(i) || space.root_count() > 1) && !(std::abs(point[i]) <= 1.0)) return false;
  return true;
}

/// A box of positions in place of all of them; the space ignores it.
Box any_positions(TaskSpace space) {
  Box box{degrees_of_freedom(space), {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  if (space == TaskSpace::SE2) box.dimension = 2;
  if (has_hinges(space)) box.dimension = 0;
  return box;
}

}  // namespace

PostureChangeSearch::PostureChangeSearch(const Manipulator& manipulator)
    : manipulator_(manipulator),
      modes_(working_modes(manipulator)),
      classifier_(make_box_classifier(manipulator, modes_)),
      space_(classifier_ ? make_pose_space(manipulator.motions(), any_positions(manipulator.task_space()),
                                           manipulator.characteristic_length())
                         : nullptr) {}

std::optional<PostureChange> PostureChangeSearch::find(const Pose& pose, std::size_t mode, std::size_t leg,
                                                       int sign) {
  if (!is_possible()) return std::nullopt;
  WorkingMode flipped = modes_[mode];
  flipped.set_sign(leg, -flipped.sign(leg));
  const auto other =
      static_cast<std::size_t>(std::find(modes_.begin(), modes_.end(), flipped) - modes_.begin());
  if (other == modes_.size()) return std::nullopt;
  for (const Ray& each : rays_from(pose)) {
    if (each.leg != leg || !is_promising(each, mode, other, sign) || !is_proved(each, mode, other, sign))
      continue;
    const Pose singular = space_->pose({each.from.root, along(each.from, each.direction, 1.0)});
    return PostureChange{0.0, pose, singular, leg, modes_[mode], flipped, 2.0 * each.length};
  }
  return std::nullopt;
}

const std::vector<PostureChangeSearch::Ray>& PostureChangeSearch::rays_from(const Pose& pose) {
  const bool known =
      pose_ && pose_->position == pose.position && pose_->orientation.coeffs() == pose.orientation.coeffs();
  if (known) return rays_;
  pose_ = pose;
  rays_.clear();
  const MapPosition from = space_->position(pose);
  for (const MapPoint& direction : directions())
    if (const auto found = ray(from, direction)) rays_.push_back(*found);
  std::sort(rays_.begin(), rays_.end(), [](const Ray& a, const Ray& b) { return a.length < b.length; });
  return rays_;
}

/// In weighted coordinates of unit length: all around in one or two dimensions; to the middles of the faces,
/// edges and corners of a cube and of its faces' quarters in three.
std::vector<MapPoint> PostureChangeSearch::directions() const {
  std::vector<MapPoint> result;
  const std::size_t dimension = space_->dimension();
  if (dimension == 1) return {{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}};
  if (dimension == 2) {
    for (int i = 0; i < directions_in_plane; ++i) {
      const double angle = 2.0 * static_cast<double>(EIGEN_PI) * i / directions_in_plane;
      result.push_back({std::cos(angle), std::sin(angle), 0.0});
    }
    return result;
  }
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != 2) continue;
        const double norm = std::sqrt(static_cast<double>(x * x + y * y + z * z));
        result.push_back({x / norm, y / norm, z / norm});
      }
  return result;
}

/// The leg that is farthest out of reach.
std::optional<std::size_t> PostureChangeSearch::unreached_leg(const MapPosition& from,
                                                              const MapPoint& direction, double share) const {
  const Pose pose = space_->pose({from.root, along(from, direction, share)});
  std::optional<std::size_t> found;
  double least = 0.0;
  for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
    const Leg& leg = manipulator_.leg(j);
    const double entry = squared_inverse_entry(leg, pose.transform(leg.anchor));
    if (!(entry < least)) continue;
    least = entry;
    found = j;
  }
  return found;
}

std::optional<PostureChangeSearch::Ray> PostureChangeSearch::ray(const MapPosition& from,
                                                                 const MapPoint& unit) const {
  const MapPoint weights = space_->weights();
  const double size = manipulator_.size();
  MapPoint direction{};  // over the size of the robot
  for (std::size_t i = 0; i < space_->dimension(); ++i) direction[i] = unit[i] * size / weights[i];
  for (int step = 1; step <= steps_of_ray; ++step) {
    double reached = (step - 1.0) / steps_of_ray, unreached = static_cast<double>(step) / steps_of_ray;
    if (!is_mapped(*space_, along(from, direction, unreached * (1.0 + beyond)))) return std::nullopt;
    if (!unreached_leg(from, direction, unreached)) continue;
    for (int i = 0; i < bisections; ++i) {
      const double middle = 0.5 * (reached + unreached);
      (unreached_leg(from, direction, middle) ? unreached : reached) = middle;
    }
    Ray result{from, {}, unreached * size, *unreached_leg(from, direction, unreached)};
    for (std::size_t i = 0; i < space_->dimension(); ++i) result.direction[i] = unreached * direction[i];
    return result;
  }
  return std::nullopt;
}

bool PostureChangeSearch::is_promising(const Ray& ray, std::size_t mode, std::size_t other, int sign) const {
  for (int i = 1; i < looks_on_ray; ++i) {
    const double share = static_cast<double>(i) / looks_on_ray;
    const Pose pose = space_->pose({ray.from.root, along(ray.from, ray.direction, share)});
    for (const std::size_t each : {mode, other}) {
      const InverseSolution solution = inverse(manipulator_, pose, modes_[each]);
      if (!solution || !(sign * direct_determinant(manipulator_, pose, solution.q) > 0.0)) return false;
    }
  }
  return true;
}

bool PostureChangeSearch::is_proved(const Ray& ray, std::size_t mode, std::size_t other, int sign) const {
  const RoundingUpward rounding;
  CrossingPath path;
  path.segments[0] = {space_->dimension(), ray.from.root, ray.from.point,
                      along(ray.from, ray.direction, 1.0 + beyond)};
  return crosses_serial_singularity(*classifier_, path, mode, other, ray.leg, sign);
}

}  // namespace parallel_aspects
