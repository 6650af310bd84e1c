// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H
#define PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H

#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Bounds the fastest motion of each actuated joint by halving parts until no bound is far above what is
/// proved to be reached.
class SpeedSearch {
 public:
  explicit SpeedSearch(std::vector<FastestMotion>& speeds) : speeds_(speeds) {}

  /// `bounds(begin, end)` are those over a part of a segment, in shares of its `duration` [s].
  template <class Bounds>
  void pass(double start_time, double duration, double end, const Bounds& bounds) {
    if (!(duration > 0.0) || !(end > 0.0)) return;
    start_time_ = start_time;
    duration_ = duration;
    budget_ = 256;
    halve(0.0, end, bounds);
  }

 private:
  static constexpr double tolerance = 1e-3;    // of a bound, over what is reached
  static constexpr double shortest = 0x1p-12;  // part that is halved
  static constexpr double instant = 0x1p-20;   // for what is reached
  static constexpr double down = 1.0 - 0x1p-50, up = 1.0 + 0x1p-50;

  template <class Bounds>
  void halve(double begin, double end, const Bounds& bounds) {
    const double middle = 0.5 * (begin + end);
    const std::optional<SpeedBounds> whole = bounds(begin, end);
    if (whole && is_settled(*whole, 0.0)) return;
    const double half = std::min(instant, 0.5 * (end - begin));
    if (const auto here = bounds(middle - half, middle + half))
      reach(*here, start_time_ + middle * duration_);
    if (!whole || !is_settled(*whole, tolerance)) {
      if (end - begin > shortest && --budget_ > 0) {
        halve(begin, middle, bounds);
        return halve(middle, end, bounds);
      }
    }
    raise(whole);
  }

  bool is_settled(const SpeedBounds& bounds, double more) const {
    for (std::size_t j = 0; j < speeds_.size(); ++j)
      if (!(bounds.most[j] * up / duration_ <= std::max(speeds_[j].bound, (1.0 + more) * speeds_[j].value)))
        return false;
    return true;
  }

  void reach(const SpeedBounds& here, double time) {
    for (std::size_t j = 0; j < speeds_.size(); ++j) {
      const double least = here.least[j] * down / duration_;
      if (least > speeds_[j].value) speeds_[j] = {least, std::max(least, speeds_[j].bound), time};
    }
  }

  void raise(const std::optional<SpeedBounds>& bounds) {
    for (std::size_t j = 0; j < speeds_.size(); ++j)
      speeds_[j].bound = bounds ? std::max(speeds_[j].bound, bounds->most[j] * up / duration_)
                                : std::numeric_limits<double>::infinity();
  }

  std::vector<FastestMotion>& speeds_;
  double start_time_ = 0.0, duration_ = 1.0;
  int budget_ = 0;
};

/// Gathers indices of a trajectory from samples of it, and those where they are asked for.
class TrajectorySurvey {
 public:
  /// Both must outlive it.
  TrajectorySurvey(const Manipulator& manipulator, bool keep_samples, TrajectoryCheck& check);

  /// The next sample; times must not fall, and `q` must assemble with the pose. Since the last one the
  /// platform was no farther from either than `radius`, in the metric of `PoseCertifier::distance` [m].
  void add(double time, const Pose& pose, const JointVector& q, double radius);

 private:
  const Manipulator& manipulator_;
  bool keep_samples_;
  TrajectoryCheck& check_;
  double lever_ = 0.0;  // at least the RMS displacement of the anchors over that metric
  double travel_ = 0.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_TRAJECTORY_SURVEY_H
