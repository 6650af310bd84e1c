// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/candidates.h"

#include "parallel_aspects/kinematics/direct.h"

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

}  // namespace parallel_aspects
