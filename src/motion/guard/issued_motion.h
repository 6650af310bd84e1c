// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_GUARD_ISSUED_MOTION_H
#define PARALLEL_ASPECTS_MOTION_GUARD_ISSUED_MOTION_H

#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// A command that was issued, as far as the robot may still be about to carry it out.
struct PendingMotion {
  TaskVector twist;    ///< (w, v) [rad/s and m/s]; others that were merged with it are off it by these
  double turn_off;     ///< [rad/s]
  double slide_off;    ///< [m/s]
  double seconds;      ///< for which it may still be followed, beyond what delays that differ make of it [s]
  double brake;        ///< how long the robot takes to stop from it [s]
  bool may_begin_yet;  ///< whether the robot may still have followed the one before when it was seen
};

/// The commands of the last moments. Neither allocates nor throws.
class IssuedMotion {
 public:
  static constexpr std::size_t most = 128;  ///< that are kept

  /// Samples of the robot are no older than `oldest_sample` [s] when they are asked about. `turns`: how many
  /// entries of a twist, at its beginning, are rotational.
  IssuedMotion(double latency, double oldest_sample, std::size_t turns) noexcept
      : latency_(latency), oldest_sample_(oldest_sample), turns_(static_cast<Eigen::Index>(turns)) {}

  /// A command from `time` on, until the next. Those that follow quickly are merged into one. False where
  /// there are too many, or the time is none; then the one before is kept as if it went on.
  bool issue(double time, const TaskVector& twist, double brake) noexcept;

  void forget() noexcept { count_ = 0; }

  struct Pending {
    std::array<PendingMotion, most> list;
    std::size_t count = 0;
  };

  /// What a robot that was seen at `seen` may do yet, by the commands up to `now`; the oldest first.
  void pending(double seen, double now, Pending& result) const noexcept;

 private:
  struct Command {
    double time, brake, turn_off, slide_off;
    TaskVector twist;
  };

  bool merge(double time, const TaskVector& twist, double brake) noexcept;

  void drop_before(double time) noexcept;
  const Command& at(std::size_t i) const noexcept { return commands_[(first_ + i) % most]; }

  double latency_, oldest_sample_;
  Eigen::Index turns_;
  std::array<Command, most> commands_;
  std::size_t first_ = 0, count_ = 0;
};

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

#endif  // PARALLEL_ASPECTS_MOTION_GUARD_ISSUED_MOTION_H
