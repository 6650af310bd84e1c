// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/panel_model.h"

#include "draw/plane/palette.h"
#include "draw/scene/placed_labels.h"
#include "model/message_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/conversions.h"

#include <parallel_aspects/DistanceBounds.h>
#include <parallel_aspects/Status.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr int digits = 3;
constexpr double too_silent = 1.0;     // for a robot that is followed [s]
constexpr double slowest_seen = 1e-4;  // speeds below count as standing still [m/s]

const char* title_of(std::uint8_t status) {
  switch (status) {
    case Status::NO_JOINT_STATES:
      return "NO JOINT STATES";
    case Status::NOT_STARTED:
      return "NOT STARTED";
    case Status::AMBIGUOUS:
      return "AMBIGUOUS";
    case Status::STALE:
      return "STALE";
    case Status::INVALID_JOINT_STATES:
      return "INVALID JOINT STATES";
    case Status::SEVERAL_PUBLISHERS:
      return "SEVERAL PUBLISHERS";
    case Status::INCONSISTENT:
      return "INCONSISTENT";
    default:
      return "UNKNOWN";
  }
}

std::string waits_for(const NodeView& view) {
  if (!view.master_answers) return "Waits for a ROS master; start roscore.";
  if (view.node.empty())
    return "Waits for an aspect_node: none is running. Start one with roslaunch parallel_aspects "
           "aspects.launch "
           "robot:=five_bar";
  if (!view.connected) return "Waits for " + view.node + ", which is not running.";
  if (!view.state) return "Waits for the first message of " + view.node + "/state.";
  return {};
}

SafetyLevel safety_of(std::uint8_t level) {
  switch (level) {
    case AspectState::CLEAR:
      return SafetyLevel::clear;
    case AspectState::WARN:
      return SafetyLevel::warn;
    case AspectState::STOP:
      return SafetyLevel::stop;
    default:
      return SafetyLevel::unknown;
  }
}

const char* title_of_level(std::uint8_t level) {
  switch (level) {
    case AspectState::CLEAR:
      return "CLEAR";
    case AspectState::WARN:
      return "WARN";
    case AspectState::STOP:
      return "STOP";
    case AspectState::NO_THRESHOLD:
      return "NO THRESHOLD";
    default:
      return "UNKNOWN";
  }
}

std::string place_of(const AspectState& state) {
  const std::string aspect = state.aspect > 0 ? "Aspect " + std::to_string(state.aspect) : "Aspect not known";
  return aspect + ", " + branch_of(state.working_mode, state.determinant_sign);
}

Banner banner_of_followed(const AspectState& state) {
  Banner banner{safety_of(state.level), title_of_level(state.level), place_of(state)};
  for (const std::string& more : {state.reason, state.status.message})
    if (!more.empty()) banner.text += "\n" + more;
  return banner;
}

// Of the basic region, or the last one that was proved, and that where tracking began.
std::string sharing_of(const UniquenessState& domains) {
  const std::string reference = std::to_string(domains.reference_region);
  if (domains.warns || domains.sharing == UniquenessState::APART)
    return "in no known domain with " + reference;
  if (domains.sharing == UniquenessState::SHARED) return "in one domain with " + reference;
  return "perhaps in no domain with " + reference;
}

std::string text_of(const UniquenessState& domains) {
  const bool is_known = domains.basic_region != 0;
  const std::string region =
      is_known ? "Basic region " + std::to_string(domains.basic_region) : "Basic region not known";
  if (domains.reference_region == 0) return region;
  if (domains.basic_region == domains.reference_region) return region + ", where tracking began";
  return region + (is_known ? ", " : ", last ") + sharing_of(domains);
}

DomainLine line_of_regions(const UniquenessState& domains) {
  return {domains.warns ? SafetyLevel::warn : SafetyLevel::clear, text_of(domains),
          "Uniqueness domains that hold it: " + std::to_string(domains.domains.size()) +
              ". While one also holds the basic region where tracking began, the actuated joints alone "
              "determine the pose."};
}

/// As a title, where "limit" alone would say too little.
const char* title_of(Hazard hazard) {
  switch (hazard) {
    case Hazard::parallel_singularity:
      return "Parallel singularity";
    case Hazard::serial_singularity:
      return "Serial singularity";
    case Hazard::limit:
      break;
  }
  return "Joint limit";
}

const DistanceBounds& bounds_of(const AspectState& state, Hazard hazard) {
  switch (hazard) {
    case Hazard::parallel_singularity:
      return state.parallel_distance;
    case Hazard::serial_singularity:
      return state.serial_distance;
    case Hazard::limit:
      break;
  }
  return state.limit_distance;
}

// Of a number that is one already.
std::string with_unit(double value, DistanceUnit unit) {
  return number_text(value, digits) + " " + unit.name();
}

std::string motion_of(double speed, DistanceUnit unit) {
  if (!std::isfinite(speed) || std::abs(speed) < slowest_seen) return {};
  return std::string(speed < 0.0 ? ", shrinks " : ", grows ") + number_text(std::abs(speed), 2) + " " +
         unit.name() + "/s";
}

// In the unit of the thresholds.
DistanceBounds displayed_bounds(const DistanceBounds& bounds, DistanceUnit unit) {
  DistanceBounds shown = bounds;
  shown.lower = unit.displayed(bounds.lower);
  shown.upper = unit.displayed(bounds.upper);
  shown.speed = unit.displayed_speed(bounds.lower, bounds.speed);
  return shown;
}

std::string text_of(const DistanceBounds& bounds, DistanceUnit unit) {
  if (std::isnan(bounds.lower)) return "not measured";
  if (std::isinf(bounds.lower)) return "none";
  return with_unit(bounds.lower, unit) + motion_of(bounds.speed, unit);
}

bool is_set(const LevelThresholds& thresholds) { return thresholds.warn > 0.0 || thresholds.stop > 0.0; }

std::string tip_of(const DistanceBounds& bounds, const LevelThresholds& thresholds, DistanceUnit unit) {
  if (std::isnan(bounds.lower)) return "Not measured yet.";
  std::string tip = std::isinf(bounds.lower)
                        ? "Proved: there is none in this working mode."
                        : "Proved: none is nearer than " + with_unit(bounds.lower, unit) + ".";
  if (std::isfinite(bounds.upper)) tip += " One was found at " + with_unit(bounds.upper, unit) + ".";
  if (thresholds.warn > 0.0) tip += " WARN below " + with_unit(thresholds.warn, unit) + ".";
  if (thresholds.stop > 0.0) tip += " STOP below " + with_unit(thresholds.stop, unit) + ".";
  if (!is_set(thresholds)) tip += " No threshold is set.";
  return tip;
}

SafetyLevel safety_of(const DistanceBounds& bounds, const LevelThresholds& thresholds) {
  if (std::isnan(bounds.lower)) return SafetyLevel::unknown;
  if (!is_set(thresholds) && std::isfinite(bounds.lower))
    return SafetyLevel::unknown;  // nothing says what is near
  if (bounds.lower <= thresholds.stop && thresholds.stop > 0.0) return SafetyLevel::stop;
  if (bounds.lower <= thresholds.warn && thresholds.warn > 0.0) return SafetyLevel::warn;
  return SafetyLevel::clear;
}

double share_of(double value, double scale) {
  return std::isnan(value) ? value : std::clamp(value / scale, 0.0, 1.0);
}

// Of a hazard that there is not the bar is empty: a full one would be of a distance beyond the scale.
DistanceBounds drawn_bounds(DistanceBounds bounds) {
  if (std::isinf(bounds.lower)) bounds.lower = bounds.upper = 0.0;
  return bounds;
}

DistanceGauge gauge_of(const NodeView& view, Hazard hazard, double scale) {
  const LevelThresholds& thresholds = view.thresholds[static_cast<std::size_t>(hazard)];
  DistanceBounds bounds;
  bounds.lower = bounds.upper = bounds.speed = std::numeric_limits<double>::quiet_NaN();
  if (view.connected && view.state && view.state->status.code == Status::OK)
    bounds = displayed_bounds(bounds_of(*view.state, hazard), view.unit);
  DistanceGauge gauge;
  gauge.name = title_of(hazard);
  gauge.safety = safety_of(bounds, thresholds);
  const DistanceBounds drawn = drawn_bounds(bounds);
  gauge.lower = share_of(drawn.lower, scale);
  gauge.upper = share_of(drawn.upper, scale);
  gauge.warn = share_of(thresholds.warn, scale);
  gauge.stop = share_of(thresholds.stop, scale);
  gauge.text = text_of(bounds, view.unit);
  gauge.tip = tip_of(bounds, thresholds, view.unit);
  return gauge;
}

std::string clock_text(const ros::Time& stamp) {
  const std::time_t seconds = stamp.sec;
  std::tm parts{};
  localtime_r(&seconds, &parts);
  char text[32];
  std::snprintf(text, sizeof text, "%02d:%02d:%02d.%03u", parts.tm_hour, parts.tm_min, parts.tm_sec,
                static_cast<unsigned>(stamp.nsec / 1000000U));
  return text;
}

// Of the turn as roll, pitch and yaw about the fixed axes x, y and z.
std::string turn_of(const geometry_msgs::Quaternion& q) {
  const double roll = std::atan2(2.0 * (q.w * q.x + q.y * q.z), 1.0 - 2.0 * (q.x * q.x + q.y * q.y));
  const double pitch = std::asin(std::clamp(2.0 * (q.w * q.y - q.z * q.x), -1.0, 1.0));
  const double yaw = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  const auto angle = [](const char* name, double value) {
    return std::string(", ") + name + " " + number_text(std::abs(value) < 5e-7 ? 0.0 : value, digits);
  };
  constexpr double seen = 1e-6;
  if (std::abs(roll) < seen && std::abs(pitch) < seen)
    return std::abs(yaw) < seen ? std::string() : angle("phi", yaw);
  return angle("roll", roll) + angle("pitch", pitch) + angle("yaw", yaw);
}

}  // namespace

std::string mode_of(const std::vector<std::int8_t>& working_mode) {
  const auto mode = WorkingMode::from_signs({working_mode.begin(), working_mode.end()});
  return mode ? to_string(*mode) : "any";
}

std::string branch_of(const std::vector<std::int8_t>& working_mode, int determinant_sign) {
  const auto mode = WorkingMode::from_signs({working_mode.begin(), working_mode.end()});
  return mode ? branch_text(*mode, determinant_sign) : std::string("working mode not known");
}

std::string pose_of(const geometry_msgs::Pose& pose, DistanceUnit unit) {
  if (unit.is_angle()) {
    const std::string turn = turn_of(pose.orientation);
    return turn.empty() ? "not turned" : turn.substr(2);
  }
  constexpr double seen = 1e-9;  // what is less is rounding
  const auto length = [](double value) { return number_text(std::abs(value) < seen ? 0.0 : value, 4); };
  std::string text = "x " + length(pose.position.x) + ", y " + length(pose.position.y);
  if (std::abs(pose.position.z) > seen) text += ", z " + length(pose.position.z);
  return text + turn_of(pose.orientation);
}

Banner banner_of(const NodeView& view) {
  const std::string waiting = waits_for(view);
  if (!waiting.empty()) return {SafetyLevel::unknown, "WAITING", waiting};
  const AspectState& state = *view.state;
  if (state.status.code != Status::OK) {
    Banner banner{SafetyLevel::unknown, title_of(state.status.code), state.status.message};
    if (!state.last_hazard.kind) return banner;
    banner.text += "\nLast proved: " + view.unit.text(state.last_hazard.lower, digits) + " from the hazard.";
    return banner;
  }
  if (view.silence > too_silent)
    return {SafetyLevel::unknown, "SILENT",
            view.node + " has said nothing for " + number_text(std::floor(view.silence), 6) +
                " s. Last: " + place_of(state)};
  return banner_of_followed(state);
}

DomainLine domain_line_of(const NodeView& view) {
  if (!view.connected || !view.state) return {};
  const UniquenessState& domains = view.state->uniqueness;
  switch (domains.known) {
    case UniquenessState::WAITING:
      return {SafetyLevel::unknown, "Uniqueness domains are being computed", "They come after the map."};
    case UniquenessState::ASPECTS:
      return {SafetyLevel::clear, "Each aspect is a uniqueness domain",
              "In it the actuated joints determine the pose, by a theorem."};
    case UniquenessState::REGIONS:
      if (view.state->status.code == Status::OK && view.silence <= too_silent)
        return line_of_regions(domains);
      return {SafetyLevel::unknown, "Basic region not known", "The robot is not followed."};
    default:
      return {};
  }
}

double scale_of(const NodeView& view) {
  double largest = view.unit.displayed(view.largest_distance);
  for (const LevelThresholds& each : view.thresholds)
    largest = std::max({largest, 2.0 * each.warn, 2.0 * each.stop});
  if (!(largest > 0.0) || !std::isfinite(largest)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(largest)));
  for (const double step : {1.0, 2.0, 5.0})
    if (largest <= step * power) return step * power;
  return 10.0 * power;
}

std::array<DistanceGauge, 3> gauges_of(const NodeView& view) {
  const double scale = scale_of(view);
  return {gauge_of(view, Hazard::parallel_singularity, scale),
          gauge_of(view, Hazard::serial_singularity, scale), gauge_of(view, Hazard::limit, scale)};
}

std::vector<EventLine> events_of(const NodeView& view) {
  std::vector<EventLine> lines;
  for (auto each = view.transitions.rbegin(); each != view.transitions.rend(); ++each)
    lines.push_back({clock_text(each->header.stamp), each->message});
  return lines;
}

// Before its first joint_states a node has none: what is known is of the node that was there before.
std::vector<CandidateLine> candidates_of(const NodeView& view) {
  std::vector<CandidateLine> lines;
  if (!view.connected || !view.state) return lines;
  const auto code = view.state->status.code;
  if (code == Status::OK || code == Status::NO_JOINT_STATES) return lines;
  for (const SolvedConfiguration& each : view.candidates.candidates) {
    CandidateLine line{candidate_name(lines.size()), candidate_color(lines.size()),
                       branch_of(each.working_mode, each.determinant_sign), pose_of(each.pose, view.unit)};
    if (const auto turn = line.text.find(", roll"); turn != std::string::npos)
      line.text.replace(turn, 2, "\n");  // a button has the width of three coordinates
    if (each.aspect > 0) line.branch = "Aspect " + std::to_string(each.aspect) + ", " + line.branch;
    lines.push_back(line);
  }
  return lines;
}

MapLine map_line_of(const NodeView& view) {
  if (!view.connected || !view.progress) return {};
  const MapProgress& progress = *view.progress;
  const bool runs = progress.state == MapProgress::COMPUTING;
  return {progress.message, runs ? progress.progress : 1.0, runs};
}

Permission may_ask(const NodeView& view) { return {waits_for(view)}; }

Permission may_choose(const NodeView& view) {
  if (const Permission asked = may_ask(view); !asked) return asked;
  if (view.read_only)
    return {
        "The node is read-only (~read_only): nobody can say the assembly mode. Restart it with a start that "
        "is true."};
  return {};
}

Permission may_compute_map(const NodeView& view) {
  if (const Permission asked = may_ask(view); !asked) return asked;
  if (view.read_only) return {"The node is read-only (~read_only): it computes no other map."};
  if (!view.hears) return {"Waits for " + view.node + "/compute_map."};
  return {};
}

Permission may_cancel_map(const NodeView& view) {
  if (const Permission computed = may_compute_map(view); !computed) return computed;
  if (!map_line_of(view).runs) return {"No map is being computed."};
  return {};
}

}  // namespace parallel_aspects
