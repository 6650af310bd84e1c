// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_GUARD_STOPPING_H
#define PARALLEL_ASPECTS_MOTION_GUARD_STOPPING_H

namespace parallel_aspects {

/// What a robot travels in one direction until it stands, for a command of a scale s in [0, 1]: s `speed`
/// for `seconds`; then it brakes for s `brake` seconds; and it first loses what it is faster by than the
/// command, in `last_brake` seconds:
///
///     s speed (seconds + s brake / 2) + max(0, last - s speed) last_brake / 2.
struct StoppingMotion {
  double speed = 0.0;       ///< of the whole command, 0 or more [m/s]
  double seconds = 0.0;     ///< for which it is followed [s]
  double brake = 0.0;       ///< until the robot stands, from the whole command [s]
  double last = 0.0;        ///< speed of the command before, 0 or more [m/s]
  double last_brake = 0.0;  ///< until the robot stands, from that [s]

  /// [m]
  double travel(double scale) const noexcept;

  /// The largest scale up to 1 that travels no more than `room` [m], by up to a billionth less, as all
  /// smaller ones do; 0 where none does.
  double largest_scale(double room) const noexcept;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_GUARD_STOPPING_H
