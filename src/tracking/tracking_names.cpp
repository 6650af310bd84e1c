// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/tracker.h"

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

}  // namespace parallel_aspects
