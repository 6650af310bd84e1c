// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_DOMAIN_REPORT_H
#define PARALLEL_ASPECTS_ROS_MONITOR_DOMAIN_REPORT_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"
#include "ros/monitor/domain_finder.h"
#include "tracking/domain_watch.h"

#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/UniquenessState.h>

#include <ros/time.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// Where tracking began, or the assembly mode was stated since.
struct TrackingStart {
  std::uint64_t number = 0;  ///< from 1, of each start another
  Pose pose;                 ///< of the robot then
  WorkingMode mode;          ///< likewise
  double time = 0.0;         ///< of the sample, as the tracker counts it [s]
  ros::Time epoch;           ///< what the tracker's times count from
};

/// What states and transitions say of uniqueness domains. Not thread-safe.
class DomainReport {
 public:
  /// `hold` as in `DomainWatch`.
  DomainReport(std::shared_ptr<const Manipulator> manipulator, double hold);

  /// From now on that is what is known; true where it is something else than before.
  bool use(const KnownDomains& known);

  /// Looks up where the robot is; false where that is not possible, or was done for this sample.
  bool look(const TrackedState& tracked, const TrackingStart& start);

  const UniquenessState& state() const noexcept { return state_; }  ///< after the last `look`

  /// That the warning begins or ends with the last `look`.
  const std::optional<AspectTransition>& transition() const noexcept { return transition_; }

 private:
  UniquenessState message_of(const DomainState& found, const ros::Time& stamp) const;
  AspectTransition transition_of(const DomainState& found, const TrackedState& tracked,
                                 const ros::Time& epoch) const;

  std::shared_ptr<const Manipulator> manipulator_;
  double hold_;
  KnownDomains known_;
  std::optional<DomainWatch> watch_;
  std::uint64_t start_ = 0;  // its number; 0 for none
  double time_ = 0.0;        // of the last sample looked at
  UniquenessState state_;
  std::optional<AspectTransition> transition_;
};

/// Where the robot is not tracked, or nothing was looked up since it is.
UniquenessState unknown_domains(std::uint8_t known);

/// Why it warns.
std::string warning_of(const UniquenessState& state);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_DOMAIN_REPORT_H
