// SPDX-License-Identifier: BSD-3-Clause
#include "arms/joint_segment.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double shortest_piece = 0x1p-20;
constexpr std::size_t most_pieces = 20000;

}  // namespace

JointSegments::JointSegments(const SerialArm& arm, const ArmDeterminant& determinant)
    : sign_(determinant.sign) {
  for (const ArmJoint& joint : arm.joints()) turns_.push_back(joint.turns);
  for (const FactorGroup& group : determinant.groups)
    for (const TrigPolynomial& factor : group.factors) factors_.emplace_back(factor);
}

JointNumbers<Affine<1>> JointSegments::numbers(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                               double start, double end) const {
  JointNumbers<Affine<1>> joints;
  const auto along = Affine<1>::coordinate(Interval(start, end), 0);
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const Interval difference = Interval(to[at]) - Interval(from[at]);
    const Affine<1> value = difference * along + Affine<1>(from[at]);
    joints[i] = turns_[i] ? turn_of_any_half_turns(reciprocal(pi_enclosure()) * value)
                          : Turn<Affine<1>>{value, Affine<1>(0.0)};
  }
  return joints;
}

std::optional<std::vector<int>> JointSegments::signs(const Eigen::VectorXd& q) const {
  const RoundingUpward rounding;
  const auto joints = numbers(q, q, 0.0, 1.0);
  std::vector<int> signs;
  for (const EnclosedPolynomial& factor : factors_) {
    const Interval value = factor.over(joints).range();
    if (!value.positive() && !value.negative()) return std::nullopt;
    signs.push_back(value.positive() ? 1 : -1);
  }
  return signs;
}

int JointSegments::determinant_sign(const std::vector<int>& signs) const noexcept {
  int sign = sign_;
  for (const int each : signs) sign *= each;
  return sign;
}

JointSegmentVerdict JointSegments::verdict(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const {
  JointSegmentVerdict verdict;
  const auto at_start = signs(from), at_end = signs(to);
  if (at_start && at_end && *at_start != *at_end) return {true, 0};
  if (!at_start || !at_end) return verdict;
  const RoundingUpward rounding;
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    std::vector<std::pair<double, double>> open{{0.0, 1.0}};
    while (!open.empty()) {
      const auto [start, end] = open.back();
      open.pop_back();
      const Interval value = factors_[k].over(numbers(from, to, start, end)).range();
      if (++verdict.pieces > most_pieces) return verdict;
      const bool has_sign = (*at_start)[k] > 0 ? value.positive() : value.negative();
      if (has_sign) continue;
      // By the intermediate value theorem, as at the start the factor has the other sign.
      if ((*at_start)[k] > 0 ? value.negative() : value.positive()) return {true, verdict.pieces};
      if (end - start < shortest_piece) return verdict;
      const double middle = 0.5 * (start + end);
      open.emplace_back(middle, end);
      open.emplace_back(start, middle);
    }
  }
  verdict.has_singularity = false;
  return verdict;
}

Eigen::VectorXd short_way_round(const SerialArm& arm, const Eigen::VectorXd& from, Eigen::VectorXd to) {
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (arm.turns_freely(i)) to[at] -= 2.0 * half_turn * std::round((to[at] - from[at]) / (2.0 * half_turn));
  }
  return to;
}

}  // namespace parallel_aspects
