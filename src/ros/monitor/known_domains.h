// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_KNOWN_DOMAINS_H
#define PARALLEL_ASPECTS_ROS_MONITOR_KNOWN_DOMAINS_H

#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"
#include "ros/parameters/node_options.h"
#include "tracking/domain_watch.h"

#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/UniquenessState.h>

#include <ros/time.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace parallel_aspects {

/// What is known of uniqueness domains.
struct KnownDomains {
  std::uint8_t known = UniquenessState::OFF;     ///< one of the constants
  std::string message;                           ///< a sentence: what, or why not
  std::shared_ptr<const Uniqueness> uniqueness;  ///< with REGIONS alone
};

/// Finds the uniqueness domains of all poses of the node's robot, where that is asked for, and logs what
/// comes of it.
class DomainFinder {
 public:
  DomainFinder(const Manipulator& manipulator, const UniquenessParameters& parameters);

  /// Finds those of a new map, and drops those of the one before. Takes long; one call at a time.
  void find(const std::shared_ptr<const AspectMap>& map, const std::atomic<bool>& cancelled);

  KnownDomains known() const;  ///< from any thread

 private:
  void set(KnownDomains known);

  const UniquenessParameters parameters_;
  mutable std::mutex mutex_;
  KnownDomains known_;
  const bool computes_;
};

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
  double time_ = 0.0;        // of the last sample examined
  UniquenessState state_;
  std::optional<AspectTransition> transition_;
};

/// Where the robot is not tracked, or nothing was looked up since it is.
UniquenessState unknown_domains(std::uint8_t known);

/// Why it warns.
std::string warning_of(const UniquenessState& state);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_KNOWN_DOMAINS_H
