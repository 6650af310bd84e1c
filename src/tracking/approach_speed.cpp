// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/approach_speed.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

const char* name(Approach approach) noexcept {
  switch (approach) {
    case Approach::approaching:
      return "approaching";
    case Approach::leaving:
      return "leaving";
    case Approach::steady:
      return "steady";
    case Approach::unknown:
      break;
  }
  return "unknown";
}

void ApproachSpeed::add(double time, double value) noexcept {
  if (!std::isfinite(time) || !std::isfinite(value) || (count_ > 0 && !(time > newest(0).time))) forget();
  if (!std::isfinite(time) || !std::isfinite(value)) return;
  samples_[next_] = {time, value};
  next_ = (next_ + 1) % most;
  count_ = std::min(count_ + 1, most);
  while (count_ > 2 && newest(count_ - 1).time < time - window_) --count_;
}

double ApproachSpeed::speed() const noexcept {
  if (!known()) return 0.0;
  // About the newest sample, so that large times lose nothing.
  const Sample origin = newest(0);
  double t = 0.0, v = 0.0, tt = 0.0, tv = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double dt = newest(i).time - origin.time, dv = newest(i).value - origin.value;
    t += dt;
    v += dv;
    tt += dt * dt;
    tv += dt * dv;
  }
  const auto n = static_cast<double>(count_);
  const double spread = n * tt - t * t;
  return spread > 0.0 ? (n * tv - t * v) / spread : 0.0;
}

Approach ApproachSpeed::approach() const noexcept {
  if (!known()) return Approach::unknown;
  const double now = speed();
  if (now < -steady_) return Approach::approaching;
  return now > steady_ ? Approach::leaving : Approach::steady;
}

}  // namespace parallel_aspects
