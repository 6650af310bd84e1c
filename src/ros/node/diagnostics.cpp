// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/diagnostics.h"

#include "model/spherical_links.h"
#include "ros/messages/hazard_messages.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

std::string region_text(std::uint32_t number) { return number == 0 ? "unknown" : std::to_string(number); }

void add_distances(const Manipulator& manipulator, const MonitorFindings& findings, bool known,
                   diagnostic_updater::DiagnosticStatusWrapper& status) {
  const DistanceUnit distance_unit(manipulator);
  const std::string unit = std::string(" [") + distance_unit.name() + "]";
  const auto shown = [distance_unit](double length) {
    return std::to_string(distance_unit.displayed(length));
  };
  for (std::size_t i = 0; i < hazard_count; ++i)
    status.add("proved distance to the nearest " + std::string(name(static_cast<Hazard>(i))) + unit,
               known ? shown(findings.distances[i].lower) : "unknown");
  status.add("stand-off from the nearest parallel singularity, estimated" + unit,
             known && std::isfinite(findings.stand_off) ? shown(findings.stand_off) : "unknown");
}

void merge_threshold(const ThresholdState& state, diagnostic_updater::DiagnosticStatusWrapper& status) {
  switch (state.level) {
    case ThresholdLevel::clear:
      return;
    case ThresholdLevel::warn:
      return status.mergeSummary(Level::WARN, "near a boundary");
    case ThresholdLevel::stop:
      return status.mergeSummary(Level::ERROR, "too near a boundary");
    case ThresholdLevel::unknown:
      return status.mergeSummary(Level::ERROR, "a distance that has a threshold is not known");
    case ThresholdLevel::unset:
      return status.mergeSummary(Level::WARN, "no threshold is set");
  }
}

std::string age_text(const ros::Time& stamp, const ros::Time& now) {
  return stamp.isZero() ? "no sample yet" : std::to_string(now.toSec() - stamp.toSec());
}

}  // namespace

// Before the robot was ever followed this is a warning; losing it afterwards is an error.
std::uint8_t diagnostic_level(const Status& status) noexcept {
  switch (status.code) {
    case Status::OK:
      return Level::OK;
    case Status::NO_JOINT_STATES:
    case Status::NOT_STARTED:
      return Level::WARN;
    default:
      return Level::ERROR;
  }
}

Diagnostics::Diagnostics(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                         const Manipulator& manipulator, const RobotMonitor& monitor, const MapWorker& worker,
                         const FrameWatch& frames)
    : manipulator_(manipulator),
      monitor_(monitor),
      worker_(worker),
      frames_(frames),
      before_(take()),
      now_(before_),
      updater_(nh, private_nh) {
  updater_.setHardwareID(manipulator.name());
  updater_.add("tracking", [this](Wrapper& status) { report_tracking(status); });
  updater_.add("joint_states", [this](Wrapper& status) { report_joint_states(status); });
  updater_.add("map", [this](Wrapper& status) { report_map(status); });
  updater_.add("tf", [this](Wrapper& status) { report_frames(status); });
}

Diagnostics::Snapshot Diagnostics::take() const {
  return {ros::WallTime::now(), monitor_.counts(), outputs_.load(std::memory_order_relaxed)};
}

void Diagnostics::offer(std::string thresholds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  offer_ = std::move(thresholds);
}

void Diagnostics::publish() {
  before_ = now_;
  now_ = take();
  updater_.force_update();
}

void Diagnostics::report_tracking(Wrapper& status) const {
  const ros::Time now = ros::Time::now();
  const CurrentConfiguration current = monitor_.current(now);
  const bool well = current.status.code == Status::OK;
  const MonitorFindings findings = monitor_.findings();
  status.summary(diagnostic_level(current.status), well ? "tracking" : current.status.message);
  const UniquenessState uniqueness = monitor_.uniqueness();
  if (well) merge_threshold(findings.threshold, status);
  if (well && uniqueness.warns)
    status.mergeSummary(Level::WARN, "the actuated joints alone do not determine the pose");
  status.add("level", well ? name(level_of(findings.threshold, uniqueness)) : name(ThresholdLevel::unknown));
  if (well && findings.threshold.level == ThresholdLevel::unset) {
    const std::lock_guard<std::mutex> lock(mutex_);
    status.add("thresholds", offer_);
  }
  add_distances(manipulator_, findings, well, status);
  status.add("residual of passive joints [tolerances]",
             well && std::isfinite(findings.residual) ? std::to_string(findings.residual) : "unknown");
  status.add("status code", static_cast<int>(current.status.code));
  status.add("working mode", well ? to_string(current.tracked.mode) : "unknown");
  status.add("sign of det A", well ? std::to_string(current.tracked.determinant_sign) : "unknown");
  status.add("aspect",
             well && current.tracked.aspect != 0 ? std::to_string(current.tracked.aspect) : "unknown");
  status.add("basic region", region_text(well ? uniqueness.basic_region : 0));
  status.add("basic region where tracking began", region_text(well ? uniqueness.reference_region : 0));
  status.add("age of the last sample [s]", age_text(current.stamp, now));
}

void Diagnostics::report_joint_states(Wrapper& status) const {
  const double seconds = std::max((now_.time - before_.time).toSec(), 1e-9);
  const auto rate = [&](std::uint64_t before, std::uint64_t now) {
    return static_cast<double>(now - before) / seconds;
  };
  const MonitorCounts &before = before_.inputs, &now = now_.inputs;
  const ros::Time clock = ros::Time::now();
  const CurrentConfiguration current = monitor_.current(clock);
  if (current.status.code == Status::STALE || current.status.code == Status::SEVERAL_PUBLISHERS)
    status.summary(Level::ERROR, current.status.message);
  else if (current.stamp.isZero())
    status.summary(Level::WARN, current.status.message);
  else if (now.invalid > before.invalid)
    status.summary(Level::WARN, "messages are refused");
  else if (now.lost > before.lost)
    status.summary(Level::WARN, "messages are lost on the way");
  else
    status.summary(Level::OK, "arriving");
  status.add("rate of samples used [Hz]", rate(before.usable, now.usable));
  status.add("rate of samples refused [Hz]", rate(before.invalid, now.invalid));
  status.add("rate of states published [Hz]", rate(before_.outputs, now_.outputs));
  status.add("age of the last sample [s]", age_text(current.stamp, clock));
  status.add("used", now.usable);
  status.add("refused", now.invalid);
  status.add("of other robots", now.foreign);
  status.add("lost",
             now.counted ? std::to_string(now.lost) : "unknown: the publisher does not set header.seq");
}

void Diagnostics::report_map(Wrapper& status) const {
  const MapProgress progress = worker_.progress();
  const bool ready = worker_.map() != nullptr || !has_map(manipulator_.task_space());
  switch (progress.state) {
    case MapProgress::COMPLETE:
      status.summary(Level::OK, progress.message);
      break;
    case MapProgress::COMPUTING:
      status.summary(ready ? Level::OK : Level::WARN, progress.message);
      break;
    default:
      status.summary(Level::WARN, progress.message);
  }
  status.add("aspects", progress.aspects);
  status.add("aspects proved", progress.proved_count);
  status.add("pairs unresolved", progress.unresolved);
  status.add("file", worker_.file_message());
  status.add("uniqueness domains", worker_.domains().message);
}

void Diagnostics::report_frames(Wrapper& status) const {
  const std::string message = frames_.message(ros::WallTime::now());
  status.summary(message.empty() ? Level::OK : Level::WARN,
                 message.empty() ? "each frame has one publisher" : message);
}

}  // namespace parallel_aspects
