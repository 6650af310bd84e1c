// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TRACKING_TRANSITIONS_H
#define PARALLEL_ASPECTS_TRACKING_TRANSITIONS_H

#include "parallel_aspects/kinematics/working_mode.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// What a transition changes.
enum class TransitionKind {
  working_mode,  ///< B_jj of `leg` went through zero
  aspect,        ///< the aspect became known, or a start found the robot in another one than before
  lost,  ///< the assembly mode is not known from here on; `determinant` where det A came too near zero
  assembly_mode,  ///< the actuated joints are back where they were at the reference, the platform at another
                  ///< direct solution, and det A never vanished in between
  found,          ///< it was lost, and is proved to be the same: wherever the actuated joints can have been
                  ///< meanwhile, they tell the pose
};

/// "working mode", "aspect", "lost", "assembly mode" or "found".
const char* name(TransitionKind kind) noexcept;

/// Why the assembly mode is not known.
enum class Ambiguity {
  none,
  near_parallel_singularity,  ///< the last step came too near to det A = 0 to be certified
  gap,                        ///< the last step was longer than the velocity limits allow
  silence,                    ///< more than the longest interval went by between the last two samples
  pause,                      ///< many times the usual interval went by between them
  half_turn,                  ///< so long a time that an actuated joint may have turned by half a turn
  step_budget,                ///< the last step needed more subdivisions than allowed
  several_assembly_modes,     ///< the actuated joints can be assembled in several ways
  serial_singularity,         ///< a leg is stretched or folded where tracking would start
  no_direct_solution,         ///< the actuated joints cannot be assembled
  no_candidate_fits,          ///< what was said of the pose contradicts every candidate
};

/// A clause for people, such as "the step came too near to det A = 0"; empty for none.
const char* reason(Ambiguity ambiguity) noexcept;

/// One change of working mode, aspect or assembly mode.
struct Transition {
  TransitionKind kind = TransitionKind::working_mode;  ///< what changed
  double time = 0.0;                      ///< of the crossing, interpolated between two samples [s]
  std::size_t leg = 0;                    ///< whose B_jj crossed zero, for a change of working mode
  bool determinant = false;               ///< whether det A lost its sign, or has another one than before
  Ambiguity ambiguity = Ambiguity::none;  ///< of a loss, and where it is made good: why it was lost
  bool inside_aspect = false;  ///< for a change of assembly mode: no working mode has changed either since
                               ///< the reference, so that both solutions are in one aspect
  bool first_again = false;  ///< for a change of assembly mode: the platform is at the direct solution again
                             ///< that was the reference at first
  WorkingMode mode_before;   ///< one sign a leg
  WorkingMode mode_after;    ///< one sign a leg
  int determinant_sign_before = 0;  ///< +1 or -1; 0 while unknown
  int determinant_sign_after = 0;   ///< +1 or -1; 0 while unknown
  int aspect_before = 0;            ///< id in the map; 0 while unknown
  int aspect_after = 0;             ///< id in the map; 0 while unknown
};

/// Transitions of one update, in the order in which they were certain; the zero of a leg that is slow to come
/// past the hysteresis can be earlier than that of the one before.
struct Transitions {
  static constexpr std::size_t most = 16;  ///< a step that crosses more often ends with `dropped`
  std::array<Transition, most> items;      ///< the first `count` are valid
  std::size_t count = 0;                   ///< 0 to `most`
  bool dropped = false;                    ///< more happened than there was room for

  const Transition* begin() const noexcept { return items.data(); }        ///< the earliest
  const Transition* end() const noexcept { return items.data() + count; }  ///< behind the latest
  bool empty() const noexcept { return count == 0; }                       ///< nothing has changed
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_TRACKING_TRANSITIONS_H
