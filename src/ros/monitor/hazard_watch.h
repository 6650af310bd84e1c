// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_HAZARD_WATCH_H
#define PARALLEL_ASPECTS_ROS_MONITOR_HAZARD_WATCH_H

#include "model/spherical_links.h"
#include "parallel_aspects/motion/motion_guard.h"
#include "parallel_aspects/tracking/hazards.h"
#include "parallel_aspects/tracking/tracker.h"

#include <parallel_aspects/AspectState.h>

#include <ros/time.h>

#include <array>
#include <memory>
#include <optional>

namespace parallel_aspects {

/// What the last state reported of distances and passive joints.
struct MonitorFindings {
  ThresholdState threshold;
  std::array<DistanceBounds, hazard_count> distances;  ///< by `Hazard`; not a number where unknown
  double stand_off = 0.0, residual = 0.0;              ///< as in AspectState
};

/// Distances as they were measured, and where.
struct MeasuredHazards {
  Pose pose;
  WorkingMode mode;
  std::array<DistanceBounds, hazard_count> bounds;  ///< by `Hazard`
  double stand_off = 0.0;                           ///< as in AspectState
  std::array<TaskVector, hazard_count> towards{};   ///< as `BoundaryDistance::direction`; empty where none
};

/// Bounds the distances between two measurements by the motion since, and compares them with the thresholds.
/// Not thread-safe.
class HazardWatch {
 public:
  HazardWatch(std::shared_ptr<const Manipulator> manipulator, const DistanceThresholds::Options& thresholds);

  void set_thresholds(const DistanceThresholds::Options& thresholds) { thresholds_.set_options(thresholds); }

  /// What was measured at a sample of this time [s].
  void take(MeasuredHazards measured, double time);

  /// Fills in distances, level and reason of a state that is tracked. `residual`: of passive joints, not a
  /// number where none is measured. `epoch`: what the tracker's times count from.
  void judge(const TrackedState& tracked, double residual, const ros::Time& epoch, AspectState& state);

  /// Fills in what was last known, where nothing is.
  void lose(const ros::Time& epoch, AspectState& state);

  /// What was measured is of no use any more.
  void forget_measured();

  /// As if nothing had ever been seen: time began anew.
  void forget();

  const MonitorFindings& findings() const noexcept { return findings_; }

  /// What was last measured, as far as it is of use; not numbers where nothing was.
  ProvedDistances proved() const noexcept;

 private:
  void bound_distances(const TrackedState& tracked);
  void show_escape(const TrackedState& tracked, AspectState& state) const;

  std::shared_ptr<const Manipulator> manipulator_;
  DistanceUnit unit_;  // of displayed distances
  std::optional<MeasuredHazards> measured_;
  std::array<ApproachSpeed, hazard_count> speeds_;
  DistanceThresholds thresholds_;
  HazardMemory memory_;
  MonitorFindings findings_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_HAZARD_WATCH_H
