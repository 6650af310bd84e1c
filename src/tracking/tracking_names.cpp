// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/tracker.h"

namespace parallel_aspects {

const char* name(TrackStatus status) noexcept {
  switch (status) {
    case TrackStatus::unstarted:
      return "unstarted";
    case TrackStatus::tracking:
      return "tracking";
    case TrackStatus::ambiguous:
      return "ambiguous";
    case TrackStatus::inconsistent:
      return "inconsistent";
  }
  return "unknown";
}

const char* reason(Doubt doubt) noexcept {
  switch (doubt) {
    case Doubt::none:
      return "";
    case Doubt::near_parallel_singularity:
      return "the drives came too near to det A = 0 to tell the assembly mode";
    case Doubt::gap:
      return "the last step of the drives was longer than their velocity limits allow";
    case Doubt::silence:
      return "no sample came for so long that the robot may have moved unseen (tracking/longest_interval)";
    case Doubt::step_budget:
      return "the last step of the drives was too long to be certified with the subdivisions allowed";
    case Doubt::several_assembly_modes:
      return "the drives can be assembled in several ways";
    case Doubt::serial_singularity:
      return "a leg is stretched or folded, so that the working mode cannot be told yet";
    case Doubt::no_direct_solution:
      return "the drives cannot be assembled";
    case Doubt::no_candidate_fits:
      return "what is measured or was said of the pose fits no assembly mode of the drives";
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
  }
  return "unknown";
}

}  // namespace parallel_aspects
