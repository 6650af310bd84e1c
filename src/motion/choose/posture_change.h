// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_POSTURE_CHANGE_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_POSTURE_CHANGE_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/tree/pose_space.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Looks for changes of posture at poses, along straight ways in many directions.
class PostureChangeSearch {
 public:
  explicit PostureChangeSearch(const Manipulator& manipulator);

  /// False with six degrees of freedom, where no change is found.
  bool is_possible() const noexcept { return classifier_ != nullptr; }

  /// The shortest that is found at a pose from a working mode (by its index among `working_modes`) by this
  /// leg; det A must have the sign in both modes. `time` of the change is not filled in.
  std::optional<PostureChange> find(const Pose& pose, std::size_t mode, std::size_t leg, int sign);

 private:
  /// A straight way to where a leg does not reach.
  struct Ray {
    MapPosition from;
    MapPoint direction{};  // to where B_jj = 0 first
    double length = 0.0;   // [m]
    std::size_t leg = 0;
  };

  const std::vector<Ray>& rays_from(const Pose& pose);
  std::optional<Ray> ray(const MapPosition& from, const MapPoint& direction) const;
  std::optional<std::size_t> unreached_leg(const MapPosition& from, const MapPoint& direction,
                                           double share) const;
  std::vector<MapPoint> directions() const;
  bool is_promising(const Ray& ray, std::size_t mode, std::size_t other, int sign) const;
  bool is_proved(const Ray& ray, std::size_t mode, std::size_t other, int sign) const;

  const Manipulator& manipulator_;
  std::vector<WorkingMode> modes_;
  std::unique_ptr<const BoxClassifier> classifier_;
  std::shared_ptr<const PoseSpace> space_;
  std::optional<Pose> pose_;  // that the rays are from
  std::vector<Ray> rays_;     // shortest first
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_POSTURE_CHANGE_H
