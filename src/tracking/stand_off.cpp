// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/roadmap/pose_sampler.h"
#include "model/linear_algebra.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/tracking/tracker.h"
#include "tracking/pose_certifier.h"
#include "tracking/tracker_core.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int halvings = 30;  // of the path to a singular pose
constexpr int digits = 7;     // binary ones, of a stand-off
constexpr int draws_a_pose = 100;
constexpr int looks = 64;  // along a path

// A pose solves its own actuated joints to rounding, except where Newton's method runs off to another
// solution.
constexpr double same_pose = 1e-6;  // over the robot's size

// The signs with which errors of the actuated joints move the platform farthest, to first order: next to det
// A = 0 all rows of the inverse are about multiples of one.
JointVector worst_signs(const CertifiedPoint& point) noexcept {
  const Eigen::Index size = point.q.size();
  JointVector largest = JointVector::Zero(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    JointVector row(size);
    for (Eigen::Index j = 0; j < size; ++j)
      row[j] = point.inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] *
               point.inverse_diagonal[static_cast<std::size_t>(j)].upper();
    if (row.squaredNorm() > largest.squaredNorm()) largest = row;
  }
  for (double& entry : coefficients_of(largest)) entry = entry < 0.0 ? -1.0 : 1.0;
  return largest;
}

std::optional<Box> region_for(const Manipulator& manipulator) {
  const double size = manipulator.size();
  for (const Leg& leg : manipulator.legs())
    if (!std::isfinite(leg.longest_reach())) return Box{3, {-size, -size, -size}, {size, size, size}};
  return std::nullopt;
}

// Whether the legs reach all along, but for the ends; as far as some poses tell.
bool is_reached(const Manipulator& manipulator, const Pose& from, const Pose& to, const WorkingMode& mode) {
  for (int i = 1; i < looks; ++i)
    if (inverse(manipulator, pose_between(manipulator.motions(), from, to, i / double{looks}), mode).status ==
        InverseStatus::out_of_reach)
      return false;
  return true;
}

}  // namespace

StandOff::StandOff(std::shared_ptr<const Manipulator> manipulator, const SampleOptions& options)
    : manipulator_(std::move(manipulator)),
      certifier_(std::make_shared<const PoseCertifier>(*manipulator_)),
      noise_(encoder_noise(*manipulator_, options)),
      resting_bend_(PathBend::at_rest(options, noise_)) {}

bool StandOff::can_distinguish(const Pose& pose, const WorkingMode& mode,
                               const JointVector& bend) const noexcept {
  const InverseSolution solution = inverse(*manipulator_, pose, mode);
  if (solution.status == InverseStatus::out_of_reach) return false;
  const RoundingUpward upward;
  const JointVector still = JointVector::Zero(noise_.size());
  CertifiedPoint point;
  point.pose = pose;
  point.q = solution.q;
  if (!certifier_->evaluate(point) ||
      !(certifier_->distance(pose, point.pose) <= same_pose * manipulator_->size()))
    return false;
  const CertifiedBall noisy = certifier_->ball(point, still, noise_, 0.0, 0.0);
  if (!noisy.certified) return false;
  JointVector step = 2.0 * noise_ + resting_bend_;
  if (bend.size() == step.size()) step = step.cwiseMax(2.0 * noise_ + bend);
  const JointVector error = noise_.cwiseProduct(worst_signs(point));
  // Samples at rest may be off to opposite sides: one by its worst error, the next by twice that from there.
  for (const double side : {-1.0, 1.0}) {
    CertifiedPoint seen;
    seen.q = point.q + side * error;
    seen.pose = certifier_->predicted(point, seen.q);
    if (!certifier_->evaluate(seen) || !(certifier_->distance(point.pose, seen.pose) <= noisy.radius) ||
        !certifier_->ball(seen, still, step, 0.0, 0.0).certified)
      return false;
  }
  return true;
}

// Outwards from the singular pose, as the path to it may lead past other obstacles.
double StandOff::along_path(const Pose& pose, const Pose& singular, const WorkingMode& mode,
                            const JointVector& bend) const noexcept {
  const auto distinguished_at = [&](double share) {
    return can_distinguish(pose_between(manipulator_->motions(), singular, pose, share), mode, bend);
  };
  double clear = std::ldexp(1.0, -halvings), hidden = 0.0;  // shares of the path
  while (clear < 1.0 && !distinguished_at(clear)) {
    hidden = clear;
    clear *= 2.0;
  }
  for (int i = 0; i < digits && clear < 1.0; ++i) {
    const double between = 0.5 * (clear + hidden);
    (distinguished_at(between) ? clear : hidden) = between;
  }
  return anchor_distance(*manipulator_, pose_between(manipulator_->motions(), singular, pose, clear),
                         singular);
}

StandOffEstimate estimate_stand_off(const std::shared_ptr<const Manipulator>& manipulator,
                                    const SampleOptions& options, int poses,
                                    const std::function<bool()>& goes_on) {
  PoseSampler sampler(manipulator, 1, region_for(*manipulator), EIGEN_PI);
  BoundaryDistanceMeter meter(manipulator);
  const StandOff stand_off(manipulator, options);
  const std::vector<WorkingMode> modes = working_modes(*manipulator);
  StandOffEstimate estimate;
  for (int i = 0; i < draws_a_pose * poses && estimate.poses < poses && goes_on(); ++i) {
    const std::optional<Pose> pose = sampler.draw();
    const WorkingMode& mode = modes[static_cast<std::size_t>(i) % modes.size()];
    if (!pose || inverse(*manipulator, *pose, mode).status != InverseStatus::solved) continue;
    const BoundaryDistance nearest = meter.measure(*pose, mode).parallel;
    if (!std::isfinite(nearest.upper) || !is_reached(*manipulator, *pose, nearest.witness, mode)) continue;
    ++estimate.poses;
    const double here = stand_off.along_path(*pose, nearest.witness, mode);
    if (!(here < nearest.upper)) continue;  // too near to tell how far off it must stand
    if (here > estimate.largest) estimate.largest = here, estimate.at = nearest.witness;
  }
  return estimate;
}

}  // namespace parallel_aspects
