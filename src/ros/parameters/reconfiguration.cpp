// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/reconfiguration.h"

#include <ros/console.h>

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

ThresholdParameters parameters_of(const ThresholdsConfig& config) {
  return {config.parallel_warn, config.parallel_stop, config.serial_warn, config.serial_stop,
          config.limit_warn,    config.limit_stop,    config.hysteresis};
}

void fill(const ThresholdParameters& parameters, ThresholdsConfig& config) {
  config.parallel_warn = parameters.parallel_warn;
  config.parallel_stop = parameters.parallel_stop;
  config.serial_warn = parameters.serial_warn;
  config.serial_stop = parameters.serial_stop;
  config.limit_warn = parameters.limit_warn;
  config.limit_stop = parameters.limit_stop;
  config.hysteresis = parameters.hysteresis;
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

void Reconfiguration::change(ThresholdsConfig& config) {
  const ThresholdParameters wanted = parameters_of(config);
  const Problems problems =
      read_only_ ? Problems{"the node is read_only."} : problems_of(wanted, "thresholds/");
  for (const std::string& problem : problems) ROS_WARN_STREAM("Not changed: " << problem);
  if (!problems.empty()) return fill(thresholds_, config);
  thresholds_ = wanted;
  on_thresholds_(wanted);
}

// Ranges are kept by the server, but it lets through what is not a number.
void Reconfiguration::change(DisplayConfig& config) {
  const bool numbers = std::isfinite(config.gallery_scale) && std::isfinite(config.rate);
  if (!numbers || read_only_) {
    ROS_WARN_COND(!numbers, "Not changed: display/gallery_scale and display/rate must be numbers.");
    config.gallery = display_.gallery;
    config.gallery_scale = display_.gallery_scale;
    config.rate = display_.rate;
  }
  const bool differs = config.gallery != display_.gallery || config.gallery_scale != display_.gallery_scale ||
                       config.rate != display_.rate;
  display_.gallery = config.gallery;
  display_.gallery_scale = config.gallery_scale;
  display_.rate = config.rate;
  if (differs) on_display_(display_);
}

}  // namespace parallel_aspects
