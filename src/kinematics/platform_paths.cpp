// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/platform_paths.h"

#include "parallel_aspects/kinematics/platform_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#pragma GCC diagnostic ignored "-Wpsabi"

namespace parallel_aspects::platform_paths {
namespace {

// Corrections that do not shrink by this factor are not in the basin of one solution alone.
constexpr double contraction = 0.05;

// Corrections below this, relative to the point, are rounding.
constexpr double rounding = 1e-11;

// So close to t = 1 a path is judged by what it has done since `far_from_end`.
constexpr double near_end = 1e-10;
constexpr double far_from_end = 1e-5;

// A path that grows by this factor between the two, or to this size, goes to infinity. One with a pole
// s^(-1/m) at s = 1 - t grows by 1e5^(1/m), that is by 6 for m = 6; one that stays finite by next to nothing.
constexpr double growth_to_infinity = 4.0;
constexpr double infinite_size = 1e7;

// Points farther out than this on the way are ill-conditioned, and the path may have gone astray.
constexpr double off_course = 1e6;

constexpr double smallest_relative_step = 1e-6;

double norm(const Solution& z) {
  double sum = 0.0;
  for (const Complex& each : z) sum += std::norm(each);
  return std::sqrt(sum);
}

// The bookkeeping of one lane: which path it follows, and how it fares.
struct Traveller {
  std::size_t path = 0;
  bool active = false;
  int steps = 0;
  double size_far_from_end = 0.0;
};

class Follower {
 public:
  Follower(const ParameterPath& path, const std::vector<Solution>& starts, const Accuracy& accuracy)
      : path_(path), starts_(starts), accuracy_(accuracy), ends_(starts.size()) {
    for (int lane = 0; lane < lanes::count; ++lane) take_next(lane);
  }

  std::vector<PathEnd> run() {
    while (std::any_of(travellers_.begin(), travellers_.end(), [](const Traveller& t) { return t.active; })) {
      attempt(path_, now_, next_);
      for (int lane = 0; lane < lanes::count; ++lane) judge(lane);
    }
    return std::move(ends_);
  }

 private:
  Traveller& traveller(int lane) { return travellers_[static_cast<std::size_t>(lane)]; }

  // Idle lanes go on standing at the start of the first path.
  void take_next(int lane) {
    Traveller& each = traveller(lane);
    each = Traveller{next_path_, next_path_ < starts_.size(), 0, 0.0};
    const Solution& start = starts_[each.active ? next_path_++ : 0];
    for (std::size_t i = 0; i < start.size(); ++i) {
      now_.solution[i].re[lane] = start[i].real();
      now_.solution[i].im[lane] = start[i].imag();
    }
    now_.t[lane] = 0.0;
    now_.step[lane] = each.active ? 0.02 : 0.0;
  }

  Solution solution(int lane) const {
    Solution z;
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = {now_.solution[i].re[lane], now_.solution[i].im[lane]};
    return z;
  }

  void judge(int lane) {
    Traveller& each = traveller(lane);
    if (!each.active) return;
    ++each.steps;
    const double first = std::sqrt(next_.first_correction[lane]),
                 second = std::sqrt(next_.second_correction[lane]);
    const bool converges = second <= std::max(rounding, contraction * first);
    if (first <= accuracy_.prediction && converges) accept(lane);
    if (each.active) plan(lane, std::isfinite(first) ? first : 1.0, converges);
  }

  void accept(int lane) {
    for (std::size_t i = 0; i < starts_[0].size(); ++i) {
      now_.solution[i].re[lane] = next_.solution[i].re[lane];
      now_.solution[i].im[lane] = next_.solution[i].im[lane];
    }
    now_.t[lane] += now_.step[lane];
    const double left = 1.0 - now_.t[lane];
    if (left <= 0.0) return finish(lane, Ending::regular);
    Traveller& each = traveller(lane);
    const double size = norm(solution(lane));
    if (left > far_from_end || each.size_far_from_end == 0.0) each.size_far_from_end = size;
    const bool infinite = size > growth_to_infinity * each.size_far_from_end;
    if (size > infinite_size) return finish(lane, Ending::infinite);
    if (left < near_end) return finish(lane, infinite ? Ending::infinite : Ending::singular);
  }

  // The error of the prediction is of order 5 in the step.
  void plan(int lane, double error, bool converges) {
    const double left = 1.0 - now_.t[lane];
    const double wanted = 0.8 * std::pow(accuracy_.prediction / std::max(error, 1e-15), 0.2);
    const double factor = converges ? std::clamp(wanted, 0.2, 2.5) : std::clamp(wanted, 0.2, 0.5);
    const double step = now_.step[lane] * factor;
    const bool off = norm(solution(lane)) > off_course && left > far_from_end;
    if (off || step < smallest_relative_step * left || traveller(lane).steps >= accuracy_.most_steps)
      return finish(lane, Ending::lost);
    // Rather two equal steps to the end than one and a tiny one.
    now_.step[lane] = step >= left ? left : std::min(step, std::max(0.5 * left, step * 0.5));
  }

  void finish(int lane, Ending ending) {
    const Traveller& each = traveller(lane);
    ends_[each.path] = {solution(lane), ending, each.steps};
    take_next(lane);
  }

  const ParameterPath& path_;
  const std::vector<Solution>& starts_;
  Accuracy accuracy_;
  std::vector<PathEnd> ends_;
  std::array<Traveller, lanes::count> travellers_{};
  std::size_t next_path_ = 0;
  Lanes now_{};
  Attempt next_{};
};

}  // namespace

std::vector<PathEnd> followed(const ParameterPath& path, const std::vector<Solution>& starts,
                              const Accuracy& accuracy) {
  if (starts.empty()) return {};
  return Follower(path, starts, accuracy).run();
}

double distance(const Solution& a, const Solution& b) {
  double same = 0.0, opposite = 0.0, displacement = 0.0;
  for (std::size_t i = 0; i < 4; ++i) same += std::norm(a[i] - b[i]), opposite += std::norm(a[i] + b[i]);
  for (std::size_t i = 4; i < 7; ++i) displacement += std::norm(a[i] - b[i]);
  return std::sqrt(std::min(same, opposite) + displacement) / std::max(norm(a), norm(b));
}

}  // namespace parallel_aspects::platform_paths
