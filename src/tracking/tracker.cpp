// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/tracker.h"

#include "aspects/roadmap/pose_sampler.h"
#include "model/linear_algebra.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "tracking/pose_certifier.h"
#include "tracking/tracker_core.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {

const char* name(TrackStatus status) noexcept {
  switch (status) {
    case TrackStatus::uninitialised:
      return "uninitialised";
    case TrackStatus::tracking:
      return "tracking";
    case TrackStatus::ambiguous:
      return "ambiguous";
    case TrackStatus::inconsistent:
      return "inconsistent";
  }
  return "unknown";
}

const char* reason(Ambiguity ambiguity) noexcept {
  switch (ambiguity) {
    case Ambiguity::none:
      return "";
    case Ambiguity::near_parallel_singularity:
      return "the actuated joints came too near to det A = 0 to tell the assembly mode";
    case Ambiguity::gap:
      return "the last step of the actuated joints was longer than their velocity limits allow";
    case Ambiguity::silence:
      return "no sample came for so long that the robot may have moved unseen (tracking/longest_interval)";
    case Ambiguity::pause:
      return "no sample came for so many times the usual interval that the robot may have moved unseen "
             "(tracking/interval_ratio)";
    case Ambiguity::half_turn:
      return "no sample came for so long that an actuated joint may have turned by half a turn at its "
             "velocity "
             "limit";
    case Ambiguity::step_budget:
      return "the last step of the actuated joints was too long to be certified with the subdivisions "
             "allowed";
    case Ambiguity::several_assembly_modes:
      return "the actuated joints can be assembled in several ways";
    case Ambiguity::serial_singularity:
      return "a leg is stretched or folded, so that the working mode cannot be determined yet";
    case Ambiguity::no_direct_solution:
      return "the actuated joints cannot be assembled";
    case Ambiguity::no_candidate_fits:
      return "what is measured or was said of the pose fits no assembly mode of the actuated joints";
  }
  return "unknown";
}

const char* name(TransitionKind kind) noexcept {
  switch (kind) {
    case TransitionKind::working_mode:
      return "working mode";
    case TransitionKind::aspect:
      return "aspect";
    case TransitionKind::lost:
      return "lost";
    case TransitionKind::assembly_mode:
      return "assembly mode";
    case TransitionKind::found:
      return "found";
  }
  return "unknown";
}

std::vector<std::string> problems_of(const TrackerOptions& options) {
  std::vector<std::string> problems = problems_of(options.samples);
  if (!(options.hysteresis >= 0.0 && options.hysteresis < 1.0))
    problems.push_back("The hysteresis of working modes is " + std::to_string(options.hysteresis) +
                       "; it must be a sine from 0 to below 1.");
  if (options.max_steps < 1)
    problems.push_back("The number of subdivisions of a step is " + std::to_string(options.max_steps) +
                       "; it must be 1 or more.");
  return problems;
}

std::size_t PossibleAssemblyModes::size() const noexcept { return list_.size(); }

PossibleAssemblyMode PossibleAssemblyModes::operator[](std::size_t index) const noexcept {
  const Candidate& candidate = list_[index];
  return {candidate.point.pose, candidate.point.q, candidate.determinant_sign, candidate.followed};
}

bool PossibleAssemblyModes::complete() const noexcept { return list_.complete(); }

Tracker::Tracker(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options)
    : core_(std::make_unique<TrackerCore>(std::move(manipulator), options)) {}

Tracker::Tracker(const Tracker& other) : core_(std::make_unique<TrackerCore>(*other.core_)) {}
Tracker::Tracker(Tracker&& other) noexcept = default;
Tracker& Tracker::operator=(const Tracker& other) { return *this = Tracker(other); }
Tracker& Tracker::operator=(Tracker&& other) noexcept = default;
Tracker::~Tracker() = default;

void Tracker::set_map(std::shared_ptr<const AspectMap> map) noexcept { core_->set_map(std::move(map)); }

bool Tracker::start_near(double time, const JointVector& q, const Pose& pose, double tolerance,
                         const JointVector& uncertainty) {
  return core_->start(time, q, pose, tolerance, uncertainty);
}

bool Tracker::start_with_sign(double time, const JointVector& q, int determinant_sign,
                              const JointVector& uncertainty) {
  return core_->start(time, q, determinant_sign, uncertainty);
}

void Tracker::stop() noexcept { core_->stop(); }

const TrackedState& Tracker::update(double time, const JointVector& q,
                                    const JointVector& uncertainty) noexcept {
  return core_->update(time, q, uncertainty);
}

const TrackedState& Tracker::state() const noexcept { return core_->state(); }
const JointVector& Tracker::bend() const noexcept { return core_->bend(); }
const Transitions& Tracker::transitions() const noexcept { return core_->transitions(); }
Transitions Tracker::take_transitions() noexcept { return core_->take_transitions(); }
bool Tracker::wants_candidates() const noexcept { return core_->wants_candidates(); }
bool Tracker::find_candidates() { return core_->find_candidates(); }

PossibleAssemblyModes Tracker::candidates() const noexcept {
  return PossibleAssemblyModes(core_->candidates());
}

void Tracker::remove_candidate(std::size_t index) noexcept { core_->remove_candidate(index); }
bool Tracker::settle_kept() noexcept { return core_->settle_kept(); }

void Tracker::report_residual(double residual, bool contradicts) noexcept {
  core_->report_residual(residual, contradicts);
}

void Tracker::set_reference() noexcept { core_->set_reference(); }

AssemblyComparison Tracker::compare_with_reference(int max_steps) const noexcept {
  return core_->compare_with_reference(max_steps);
}

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
