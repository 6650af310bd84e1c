// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/assembly_modes.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

void Candidates::find(const Manipulator& manipulator, const PoseCertifier& certifier, const JointVector& q) {
  clear();
  const DirectResult result = direct(manipulator, q);
  bool are_distinct = true;  // near det A = 0 two assembly modes may come as one
  for (const AssemblyMode& mode : result.solutions) {
    are_distinct = are_distinct && !mode.near_singular;
    if (list_.size() == most) break;
    Candidate candidate;
    candidate.followed = certify_solution(certifier, mode.pose, q, candidate.point);
    if (candidate.followed) {
      const RoundingUpward upward;
      candidate.determinant_sign = certifier.determinant_sign(candidate.point);
    } else {
      candidate.point.pose = mode.pose;
      candidate.point.q = q;
    }
    list_.push_back(candidate);
  }
  complete_ = result.status == DirectStatus::solved && are_distinct && result.solutions.size() <= most;
}

void Candidates::set(const Candidate& only) noexcept {
  clear();
  list_.push_back(only);
  complete_ = true;
}

void Candidates::follow(const PoseCertifier& certifier, const JointVector& q, const JointVector& bend,
                        int max_steps) noexcept {
  for (std::size_t i = list_.size(); i-- > 0;) {
    Candidate& candidate = list_[i];
    bool stays = candidate.point.q == q;
    if (candidate.followed && !stays) {
      Continuation path(certifier, candidate.point, q, bend);
      stays = path.run(max_steps) == ContinuationStatus::finished;
      candidate.point = path.at();
    }
    if (stays) continue;
    remove(i);
    complete_ = false;
  }
}

void Candidates::remove(std::size_t index) noexcept {
  list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(index));
}

void Candidates::clear() noexcept {
  list_.clear();
  complete_ = false;
}

namespace {

constexpr int max_steps_when_back = 32;

// Direct solutions that are proved to be isolated are known far better than this, over the robot's size.
constexpr double same_solution = 1e-6;

bool are_same(const Manipulator& manipulator, const Pose& a, const Pose& b) noexcept {
  return anchor_distance(manipulator, a, b) <= same_solution * manipulator.size();
}

}  // namespace

const char* name(AssemblyComparison comparison) noexcept {
  switch (comparison) {
    case AssemblyComparison::same:
      return "same";
    case AssemblyComparison::other:
      return "other";
    case AssemblyComparison::unknown:
      break;
  }
  return "unknown";
}

void AssemblyWatch::set_reference(const CertifiedPoint& reference) noexcept {
  reference_ = reference;
  first_ = reference.pose;
  away_ = false;
}

bool AssemblyWatch::is_at_first(const Manipulator& manipulator) const noexcept {
  return are_same(manipulator, first_, reference_.pose);
}

// From `q` to the reference; whole turns of actuated joints without limits are left out.
JointVector AssemblyWatch::path_back(const Manipulator& manipulator, const JointVector& q) const noexcept {
  JointVector path = reference_.q - q;
  for (Eigen::Index i = 0; i < path.size(); ++i) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(i));
    if (leg.actuated_by_angle() && !leg.limits.limited()) path[i] = std::remainder(path[i], 2.0 * EIGEN_PI);
  }
  return path;
}

AssemblyComparison AssemblyWatch::watch(const Manipulator& manipulator, const PoseCertifier& certifier,
                                        const CertifiedPoint& now) noexcept {
  const JointVector path = path_back(manipulator, now.q);
  double farthest = 0.0;
  for (Eigen::Index i = 0; i < path.size(); ++i) {
    const bool angle = manipulator.leg(static_cast<std::size_t>(i)).actuated_by_angle();
    farthest = std::max(farthest, std::abs(path[i]) / (angle ? near : near * manipulator.size()));
  }
  if (farthest > 2.0) away_ = true;
  if (!away_ || farthest > 1.0) return AssemblyComparison::same;
  CertifiedPoint end;
  const AssemblyComparison result = compare(manipulator, certifier, now, max_steps_when_back, end);
  if (result == AssemblyComparison::unknown) return AssemblyComparison::same;
  away_ = false;
  if (result == AssemblyComparison::other) reference_ = end;
  return result;
}

AssemblyComparison AssemblyWatch::compare(const Manipulator& manipulator, const PoseCertifier& certifier,
                                          const CertifiedPoint& now, int max_steps) const noexcept {
  CertifiedPoint end;
  return compare(manipulator, certifier, now, max_steps, end);
}

AssemblyComparison AssemblyWatch::compare(const Manipulator& manipulator, const PoseCertifier& certifier,
                                          const CertifiedPoint& now, int max_steps,
                                          CertifiedPoint& end) const noexcept {
  Continuation path(certifier, now, now.q + path_back(manipulator, now.q));
  if (path.run(max_steps) != ContinuationStatus::finished) return AssemblyComparison::unknown;
  end = path.at();
  return are_same(manipulator, end.pose, reference_.pose) ? AssemblyComparison::same
                                                          : AssemblyComparison::other;
}

}  // namespace parallel_aspects
