// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/reconfiguration.h"

#include <ros/console.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

struct Threshold {
  double ThresholdParameters::*parameter;
  double ThresholdsConfig::*config;
};
const std::array<Threshold, 7> thresholds{{
    {&ThresholdParameters::parallel_warn, &ThresholdsConfig::parallel_warn},
    {&ThresholdParameters::parallel_stop, &ThresholdsConfig::parallel_stop},
    {&ThresholdParameters::serial_warn, &ThresholdsConfig::serial_warn},
    {&ThresholdParameters::serial_stop, &ThresholdsConfig::serial_stop},
    {&ThresholdParameters::limit_warn, &ThresholdsConfig::limit_warn},
    {&ThresholdParameters::limit_stop, &ThresholdsConfig::limit_stop},
    {&ThresholdParameters::hysteresis, &ThresholdsConfig::hysteresis},
}};

ThresholdParameters parameters_of(const ThresholdsConfig& config) {
  ThresholdParameters parameters;
  for (const Threshold& each : thresholds) parameters.*each.parameter = config.*each.config;
  return parameters;
}

bool same(const ThresholdParameters& a, const ThresholdParameters& b) {
  return std::all_of(thresholds.begin(), thresholds.end(),
                     [&](const Threshold& each) { return a.*each.parameter == b.*each.parameter; });
}

void fill(const ThresholdParameters& parameters, ThresholdsConfig& config) {
  for (const Threshold& each : thresholds) config.*each.config = parameters.*each.parameter;
}

void fill(const DisplayOptions& display, DisplayConfig& config) {
  config.gallery = display.gallery;
  config.gallery_scale = display.gallery_scale;
  config.rate = display.rate;
}

}  // namespace

Reconfiguration::Reconfiguration(const ros::NodeHandle& private_nh, const NodeOptions& options,
                                 OnThresholds on_thresholds, OnDisplay on_display)
    : read_only_(options.read_only),
      thresholds_(options.thresholds),
      display_(options.display),
      on_thresholds_(std::move(on_thresholds)),
      on_display_(std::move(on_display)),
      threshold_server_(ros::NodeHandle(private_nh, "thresholds")),
      display_server_(ros::NodeHandle(private_nh, "display")) {
  threshold_server_.setCallback([this](ThresholdsConfig& config, std::uint32_t) { change(config); });
  display_server_.setCallback([this](DisplayConfig& config, std::uint32_t) { change(config); });
}

NodeOptions Reconfiguration::in_force(NodeOptions options) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  options.thresholds = thresholds_;
  options.display = display_;
  return options;
}

// The server also calls at its start, with the parameters as they are by then. Those may be of another robot,
// which was refused.
void Reconfiguration::change(ThresholdsConfig& config) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::exchange(thresholds_started_, true)) return fill(thresholds_, config);
  const ThresholdParameters wanted = parameters_of(config);
  if (same(wanted, thresholds_)) return;
  if (is_refused(problems_of(wanted, "thresholds/"))) return fill(thresholds_, config);
  thresholds_ = wanted;
  on_thresholds_(wanted);
}

void Reconfiguration::change(DisplayConfig& config) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::exchange(display_started_, true)) return fill(display_, config);
  DisplayOptions wanted = display_;
  wanted.gallery = config.gallery;
  wanted.gallery_scale = config.gallery_scale;
  wanted.rate = config.rate;
  if (wanted.gallery == display_.gallery && wanted.gallery_scale == display_.gallery_scale &&
      wanted.rate == display_.rate)
    return;
  if (is_refused(problems_of(wanted, "display/"))) return fill(display_, config);
  display_ = wanted;
  on_display_(wanted);
}

// With a warning for each problem.
bool Reconfiguration::is_refused(const Problems& found) const {
  const Problems problems = read_only_ ? Problems{"the node is read_only."} : found;
  for (const std::string& problem : problems) ROS_WARN_STREAM("Not changed: " << problem);
  return !problems.empty();
}

}  // namespace parallel_aspects
