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
  const Problems problems =
      read_only_ ? Problems{"the node is read_only."} : problems_of(wanted, "thresholds/");
  for (const std::string& problem : problems) ROS_WARN_STREAM("Not changed: " << problem);
  if (!problems.empty()) return fill(thresholds_, config);
  thresholds_ = wanted;
  on_thresholds_(wanted);
}

// Ranges are kept by the server, but it lets through what is not a number.
void Reconfiguration::change(DisplayConfig& config) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::exchange(display_started_, true)) return fill(display_, config);
  const bool differs = config.gallery != display_.gallery || config.gallery_scale != display_.gallery_scale ||
                       config.rate != display_.rate;
  if (!differs) return;
  const bool numbers = std::isfinite(config.gallery_scale) && std::isfinite(config.rate);
  if (!numbers || read_only_) {
    ROS_WARN_STREAM("Not changed: " << (read_only_
                                            ? "the node is read_only."
                                            : "display/gallery_scale and display/rate must be numbers."));
    return fill(display_, config);
  }
  display_.gallery = config.gallery;
  display_.gallery_scale = config.gallery_scale;
  display_.rate = config.rate;
  on_display_(display_);
}

}  // namespace parallel_aspects
