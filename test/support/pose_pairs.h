// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_POSE_PAIRS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_POSE_PAIRS_H

#include "aspects/roadmap/pose_sampler.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"

#include "support/thoroughness.h"
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace parallel_aspects::test {

/// The sign of det A in plain double precision; 0 where a leg does not reach within its limits.
inline int sign_in_doubles(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.status != InverseStatus::solved) return 0;
  const double determinant = direct_determinant(robot, pose, solution.q);
  return determinant > 0.0 ? 1 : determinant < 0.0 ? -1 : 0;
}

/// Seeded random configurations of one robot, and segments between them, from short ones to long ones.
class PosePairs {
 public:
  PosePairs(std::shared_ptr<const Manipulator> robot, std::uint64_t seed)
      : robot_(std::move(robot)),
        modes_(working_modes(*robot_)),
        engine_(seed),
        sampler_(robot_, seed, unbounded(*robot_), EIGEN_PI) {}

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }

  /// A working mode in which a random pose is reached.
  WorkingMode mode() {
    for (int i = 0; i < 1000000; ++i) {
      const auto pose = sampler_.draw();
      const WorkingMode& mode = modes_[engine_() % modes_.size()];
      if (pose && sign_in_doubles(*robot_, *pose, mode) != 0) return mode;
    }
    return modes_.front();
  }

  /// A pose that is reached in this mode, one of some hundred; nothing where luck runs out.
  std::optional<Pose> reached(const WorkingMode& mode) {
    std::vector<Pose>& known = known_[mode.index()];
    if (known.size() >= 300) return known[engine_() % known.size()];
    for (int i = 0; i < 100000; ++i) {
      const auto pose = sampler_.draw();
      if (!pose || sign_in_doubles(*robot_, *pose, mode) == 0) continue;
      known.push_back(*pose);
      return pose;
    }
    return std::nullopt;
  }

  /// A pose on the path from `from` to a random one, reached as well.
  std::optional<Pose> nearby(const Pose& from, const WorkingMode& mode) {
    const auto far = reached(mode);
    if (!far) return std::nullopt;
    const Pose pose = pose_between(robot_->motions(), from, *far, std::pow(10.0, uniform(-2.0, 0.0)));
    return sign_in_doubles(*robot_, pose, mode) != 0 ? std::optional<Pose>(pose) : far;
  }

 private:
  static std::optional<Box> unbounded(const Manipulator& robot) {
    for (const Leg& leg : robot.legs())
      if (!std::isfinite(leg.longest_reach())) {
        const double r = robot.size();
        return Box{3, {-r, -r, -r}, {r, r, r}};
      }
    return std::nullopt;
  }

  std::shared_ptr<const Manipulator> robot_;
  std::vector<WorkingMode> modes_;
  std::mt19937_64 engine_;
  PoseSampler sampler_;
  std::map<std::size_t, std::vector<Pose>> known_;  // by mode
};

/// A roadmap of the working modes that a few questions need is enough.
inline std::shared_ptr<const PoseRoadmap> roadmap_of(const std::shared_ptr<const Manipulator>& robot,
                                                     const std::vector<WorkingMode>& modes,
                                                     std::size_t samples) {
  RoadmapOptions options;
  options.samples = is_sanitized ? samples / 4 : samples;
  options.modes = modes;
  return compute_pose_roadmap(robot, options).roadmap;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_POSE_PAIRS_H
