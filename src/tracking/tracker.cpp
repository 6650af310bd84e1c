// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/tracker.h"

#include "parallel_aspects/model/manipulator.h"
#include "tracking/tracker_core.h"

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
      return "the actuated joints came too near to det A = 0 to determine the assembly mode";
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

}  // namespace parallel_aspects
