// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_ASSEMBLY_WATCH_H
#define PARALLEL_ASPECTS_TRACKING_ASSEMBLY_WATCH_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"
#include "tracking/continuation.h"

namespace parallel_aspects {

/// Notices assembly-mode changing motions without a singularity: the actuated joints have gone away from a
/// reference configuration and come back, and the platform is at another direct solution.
class AssemblyWatch {
 public:
  /// The actuated joints are back when each is within this of the reference [rad, or share of the robot's
  /// size in m], modulo whole turns where it has no limits; and away when one is twice as far.
  static constexpr double near = 0.02;

  /// From here on motions are compared with this configuration.
  void set_reference(const CertifiedPoint& reference) noexcept;
  const CertifiedPoint& reference() const noexcept { return reference_; }

  /// Whether the reference is the solution that was set, or has come back to it.
  bool is_at_first(const Manipulator& manipulator) const noexcept;

  /// The robot is at `now`, reached by certified continuation. `other` once for each change, when the
  /// actuated joints come back; the reference is then the present solution. `same` otherwise. Never
  /// allocates.
  AssemblyComparison watch(const Manipulator& manipulator, const PoseCertifier& certifier,
                           const CertifiedPoint& now) noexcept;

  /// The same question wherever the robot is; nothing is noted.
  AssemblyComparison compare(const Manipulator& manipulator, const PoseCertifier& certifier,
                             const CertifiedPoint& now, int max_steps) const noexcept;

 private:
  JointVector path_back(const Manipulator& manipulator, const JointVector& q) const noexcept;
  AssemblyComparison compare(const Manipulator& manipulator, const PoseCertifier& certifier,
                             const CertifiedPoint& now, int max_steps, CertifiedPoint& end) const noexcept;

  CertifiedPoint reference_;
  Pose first_;  // of the reference that was set
  bool away_ = false;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_ASSEMBLY_WATCH_H
