// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_ASSEMBLY_SEARCH_H
#define PARALLEL_ASPECTS_ROS_MONITOR_ASSEMBLY_SEARCH_H

#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// A configuration as a tracker takes it.
struct TrackedSample {
  double time = 0.0;
  JointVector q, uncertainty;
};

/// Looks for the assembly mode of a robot that is not followed, on a copy of its tracker: takes up to some
/// 100 ms, while others go on with the tracker. The samples that these take are then followed here as well,
/// so that the copy is what the tracker would be.
class AssemblySearch {
 public:
  /// Copies the tracker, whose transitions must have been reported. `readings` of all joints are of its last
  /// sample.
  AssemblySearch(const Tracker& tracker, Eigen::VectorXd readings)
      : tracker_(tracker), readings_(std::move(readings)) {}

  /// What takes long. A pose that is found is compared with measured passive joints at once.
  void run(const PassiveJoints& passive);

  /// The samples since, in their order.
  void follow(const std::vector<TrackedSample>& samples);

  Tracker& tracker() { return tracker_; }

  /// What was found, and crossed by the samples since.
  const std::vector<Transition>& transitions() const { return transitions_; }
  bool found() const;  ///< whether the assembly mode is that of before

  const PassiveResidual& residual() const { return residual_; }  ///< of the pose that was found

 private:
  void keep_transitions();

  Tracker tracker_;
  Eigen::VectorXd readings_;
  std::vector<Transition> transitions_;
  PassiveResidual residual_;
};

/// The samples that a tracker takes while a search looks on a copy of it. What else changes the tracker makes
/// the search void.
class SamplesMeanwhile {
 public:
  void begin() { samples_.emplace(); }
  void end() { samples_.reset(); }
  bool valid() const { return samples_.has_value(); }  ///< whether a search is on, and not void

  void add(const TrackedSample& sample) {
    if (samples_ && samples_->size() == most) end();
    if (samples_) samples_->push_back(sample);
  }

  std::size_t size() const { return samples_->size(); }                       ///< while valid
  std::vector<TrackedSample> take() { return std::exchange(*samples_, {}); }  ///< while valid

 private:
  static constexpr std::size_t most = 10000;  // some seconds at the highest rates
  std::optional<std::vector<TrackedSample>> samples_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_ASSEMBLY_SEARCH_H
