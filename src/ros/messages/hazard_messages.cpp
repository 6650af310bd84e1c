// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/hazard_messages.h"

#include "ros/messages/conversions.h"

#include <parallel_aspects/AspectState.h>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

static_assert(static_cast<std::uint8_t>(ThresholdLevel::clear) == AspectState::CLEAR);
static_assert(static_cast<std::uint8_t>(ThresholdLevel::warn) == AspectState::WARN);
static_assert(static_cast<std::uint8_t>(ThresholdLevel::stop) == AspectState::STOP);
static_assert(static_cast<std::uint8_t>(ThresholdLevel::unknown) == AspectState::UNKNOWN);
static_assert(static_cast<std::uint8_t>(ThresholdLevel::unset) == AspectState::NO_THRESHOLD);

std::uint8_t kind_of(const std::optional<ProvedHazard>& last) {
  if (!last) return LastHazard::NONE;
  switch (last->hazard) {
    case Hazard::parallel_singularity:
      return LastHazard::PARALLEL_SINGULARITY;
    case Hazard::serial_singularity:
      return LastHazard::SERIAL_SINGULARITY;
    case Hazard::limit:
      break;
  }
  return LastHazard::LIMIT;
}

const char* motion_of(double speed) {
  if (std::isnan(speed)) return "";
  return speed < 0.0 ? ", and was approached" : ", and was not approached";
}

}  // namespace

ThresholdLevel level_of(const ThresholdState& state, const UniquenessState& uniqueness) noexcept {
  return state.level == ThresholdLevel::clear && uniqueness.warns ? ThresholdLevel::warn : state.level;
}

std::uint8_t level_message(ThresholdLevel level) noexcept { return static_cast<std::uint8_t>(level); }

std::string reason_of(const ThresholdState& state, DistanceUnit unit) {
  if (state.level == ThresholdLevel::clear) return {};
  if (state.level == ThresholdLevel::unknown)
    return std::string("the distance to the nearest ") + name(state.hazard) + " is not known";
  const std::string nearest =
      std::string("the nearest ") + name(state.hazard) + " may be " + unit.text(state.distance, 4) + " away";
  if (state.level == ThresholdLevel::unset)
    return "no threshold is set" + (std::isfinite(state.distance) ? ": " + nearest : std::string());
  return name(state.level) + (": " + nearest) + "; the threshold is " + unit.text(state.threshold, 4) +
         (state.held ? ", held until left by the hysteresis" : "");
}

std::string reason_of(const std::optional<ProvedHazard>& last, DistanceUnit unit) {
  if (!last) return "nothing is known of the distances";
  return std::string("no distance is known; the nearest ") + name(last->hazard) + " was last proved to be " +
         unit.text(last->distance, 4) + " away" + motion_of(last->speed);
}

std::string message_of(const StandOffEstimate& estimate, DistanceUnit unit) {
  if (estimate.poses == 0) return {};
  return "By tracking/encoder_noise, the assembly mode can be determined as near as " +
         unit.text(estimate.largest, 3) + " to parallel singularities; the largest of " +
         std::to_string(estimate.poses) + " that were examined, an estimate.";
}

std::string warning_of(const StandOffEstimate& estimate, double parallel_stop, DistanceUnit unit) {
  if (!(parallel_stop > 0.0 && parallel_stop < estimate.largest)) return {};
  return "thresholds/parallel_stop is " + unit.text(parallel_stop, 3) + ", but nearer than about " +
         unit.text(estimate.largest, 3) +
         " noise of the encoders can hide the assembly mode: the level may become UNKNOWN before it is STOP. "
         "Raise the threshold, or lower tracking/encoder_noise where the encoders are better.";
}

DistanceBounds unknown_distance() {
  DistanceBounds bounds;
  bounds.lower = bounds.upper = bounds.speed = not_a_number;
  return bounds;
}

DistanceBounds bounds_of(const BoundaryDistance& distance) {
  DistanceBounds bounds = unknown_distance();
  if (distance.status == DistanceStatus::unavailable) return bounds;
  bounds.lower = distance.lower;
  bounds.upper = distance.upper;
  return bounds;
}

DistanceBounds after_motion(DistanceBounds bounds, double by, double size) {
  const double change = by * (1.0 + 1e-9) + 1e-12 * size;
  bounds.lower = std::max(0.0, bounds.lower - change);
  bounds.upper += change;
  return bounds;
}

LastHazard hazard_message(const std::optional<ProvedHazard>& last, const ros::Time& epoch) {
  LastHazard message;
  message.kind = kind_of(last);
  message.stamp = last ? epoch + ros::Duration(last->time) : ros::Time();
  message.lower = last ? last->distance : not_a_number;
  message.speed = last ? last->speed : not_a_number;
  return message;
}

}  // namespace parallel_aspects
