// SPDX-License-Identifier: BSD-3-Clause
#include "motion/guard/issued_motion.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

bool IssuedMotion::issue(double time, const TaskVector& twist, double brake) noexcept {
  if (!std::isfinite(time)) return false;
  if (count_ > 0 && time < at(count_ - 1).time) forget();  // time began anew
  drop_before(time - oldest_sample_);
  const bool stands = twist.isZero(0.0);
  // Commands to stop that follow each other need no list of them.
  if (stands && count_ > 0 && at(count_ - 1).twist.isZero(0.0)) return true;
  if (merge(time, twist, brake)) return true;
  if (count_ == most) return false;
  commands_[(first_ + count_++) % most] = {time, brake, 0.0, 0.0, twist};
  return true;
}

// Commands that follow each other within a grain of time are one, so that the list has room for all of them
// at the highest rate. The first of a series replaces it.
bool IssuedMotion::merge(double time, const TaskVector& twist, double brake) noexcept {
  if (count_ == 0) return false;
  Command& last = commands_[(first_ + count_ - 1) % most];
  const double grain = std::max(latency_ + oldest_sample_, last.brake) / 32.0;
  const TaskVector off = twist - last.twist;
  if (off.isZero(0.0)) return true;
  if (!(time < last.time + grain) || last.twist.isZero(0.0) || twist.isZero(0.0)) return false;
  last.turn_off = std::max(last.turn_off, off.head(turns_).norm());
  last.slide_off = std::max(last.slide_off, off.tail(off.size() - turns_).norm());
  last.brake = std::max(last.brake, brake);
  return true;
}

void IssuedMotion::drop_before(double time) noexcept {
  while (count_ > 1 && at(1).time + latency_ + at(0).brake < time) {
    first_ = (first_ + 1) % most;
    --count_;
  }
}

void IssuedMotion::pending(double seen, double now, Pending& result) const noexcept {
  result.count = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const bool is_last = i + 1 == count_;
    const double begin = at(i).time, end = is_last ? now : at(i + 1).time;
    if (!is_last && end + latency_ + at(i).brake < seen) continue;
    const double left = is_last ? end - begin : std::min(end - begin, end + latency_ - seen);
    const bool may_begin_yet = begin + latency_ >= seen;
    result.list[result.count++] = {at(i).twist,         at(i).turn_off, at(i).slide_off,
                                   std::max(0.0, left), at(i).brake,    may_begin_yet};
  }
}

namespace {

constexpr double rounding = 1e-9;

// The larger root of a s^2 + b s = c for a >= 0; negative where there is none.
double larger_root(double a, double b, double c) noexcept {
  const double squared = b * b + 4.0 * a * c;
  if (!(squared >= 0.0)) return -1.0;
  // Without the difference of nearly equal numbers.
  const double root = std::sqrt(squared);
  if (b > 0.0) return 2.0 * c / (b + root);
  return a > 0.0 ? (root - b) / (2.0 * a) : -1.0;
}

}  // namespace

double StoppingMotion::travel(double scale) const noexcept {
  return scale * speed * (seconds + 0.5 * scale * brake) +
         0.5 * std::max(0.0, last - scale * speed) * last_brake;
}

double StoppingMotion::largest_scale(double room) const noexcept {
  if (!(travel(0.0) <= room)) return 0.0;  // travel is convex in the scale
  if (travel(1.0) <= room) return 1.0;
  const double same = last / speed;  // the scale that goes on as before
  const double bend = 0.5 * speed * brake;
  double scale = larger_root(bend, speed * seconds, room);
  if (!(scale >= same)) {
    const double slope = speed * (seconds - 0.5 * last_brake), rest = room - 0.5 * last * last_brake;
    scale = std::min(same, larger_root(bend, slope, rest));
  }
  scale = std::min(1.0, scale * (1.0 - rounding));
  return scale > 0.0 && travel(scale) <= room * (1.0 + rounding) ? scale : 0.0;
}

}  // namespace parallel_aspects
