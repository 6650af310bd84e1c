// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_ASSEMBLY_MODES_H
#define PARALLEL_ASPECTS_TRACKING_ASSEMBLY_MODES_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"
#include "tracking/continuation.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// An assembly mode that the robot may be in.
struct Candidate {
  CertifiedPoint point;      ///< pose and actuated joints
  int determinant_sign = 0;  ///< +1 or -1; 0 where that is not proved
  bool followed = true;      ///< whether its solution is proved; it is dropped with the next sample otherwise
};

/// The assembly modes that remain possible, each followed by certified continuation.
class Candidates {
 public:
  /// More are never kept; no manipulator has more direct solutions than 40.
  static constexpr std::size_t most = 64;

  Candidates() { list_.reserve(most); }
  Candidates(const Candidates& other) : Candidates() { *this = other; }
  Candidates& operator=(const Candidates& other) = default;

  /// Every direct solution at `q`. Allocates, and takes up to some 10 ms in SE3.
  void find(const Manipulator& manipulator, const PoseCertifier& certifier, const JointVector& q);

  /// Only this one.
  void set(const Candidate& only) noexcept;

  /// Moves the actuated joints straight to `q`. A candidate that cannot be followed is dropped, and the list
  /// is then no longer complete. Never allocates.
  void follow(const PoseCertifier& certifier, const JointVector& q, const JointVector& bend,
              int max_steps) noexcept;

  void remove(std::size_t index) noexcept;
  void clear() noexcept;

  /// From now on the robot need not be in any of them.
  void mark_incomplete() noexcept { complete_ = false; }

  /// Whether the robot must be in one of them, as far as the list of direct solutions was complete and none
  /// was dropped since without a reason.
  bool complete() const noexcept { return complete_; }

  std::size_t size() const noexcept { return list_.size(); }
  const Candidate& operator[](std::size_t index) const noexcept { return list_[index]; }

 private:
  std::vector<Candidate> list_;  // its room is reserved once
  bool complete_ = false;
};

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

#endif  // PARALLEL_ASPECTS_TRACKING_ASSEMBLY_MODES_H
