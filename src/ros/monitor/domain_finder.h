// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_DOMAIN_FINDER_H
#define PARALLEL_ASPECTS_ROS_MONITOR_DOMAIN_FINDER_H

#include "parallel_aspects/aspects/uniqueness.h"
#include "ros/parameters/node_options.h"

#include <parallel_aspects/UniquenessState.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_DOMAIN_FINDER_H
