// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PARAMETERS_RECONFIGURATION_H
#define PARALLEL_ASPECTS_ROS_PARAMETERS_RECONFIGURATION_H

#include "ros/parameters/node_options.h"

#include <parallel_aspects/DisplayConfig.h>
#include <parallel_aspects/ThresholdsConfig.h>

#include <ros/node_handle.h>

#include <dynamic_reconfigure/server.h>
#include <functional>
#include <mutex>

namespace parallel_aspects {

/// Thresholds and display by dynamic_reconfigure, under ~thresholds and ~display; nothing else changes while
/// the node runs. What `problems_of` does not accept is refused with a warning, and what was there stays; so
/// is everything where the options say read_only. At the start the options hold, whatever the parameters are
/// by then.
class Reconfiguration {
 public:
  using OnThresholds = std::function<void(const ThresholdParameters&)>;
  using OnDisplay = std::function<void(const DisplayOptions&)>;

  /// Sets the parameters to what `options` says.
  Reconfiguration(const ros::NodeHandle& private_nh, const NodeOptions& options, OnThresholds on_thresholds,
                  OnDisplay on_display);

  /// What is in force in place of what `options` says.
  NodeOptions in_force(NodeOptions options) const;

 private:
  void change(ThresholdsConfig& config);
  void change(DisplayConfig& config);
  bool is_refused(const Problems& found) const;

  const bool read_only_;
  mutable std::mutex mutex_;  // of those that follow, up to the functions
  bool thresholds_started_ = false, display_started_ = false;
  ThresholdParameters thresholds_;
  DisplayOptions display_;
  const OnThresholds on_thresholds_;
  const OnDisplay on_display_;
  dynamic_reconfigure::Server<ThresholdsConfig> threshold_server_;
  dynamic_reconfigure::Server<DisplayConfig> display_server_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PARAMETERS_RECONFIGURATION_H
