// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/homotopy/platform_paths.h"

#include "kinematics/homotopy/platform_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#pragma GCC diagnostic ignored "-Wpsabi"

namespace parallel_aspects::platform_paths {
namespace {

// Corrections that do not shrink by this factor are not in the basin of one solution alone.
constexpr double contraction = 0.05;

// Corrections below this are rounding.
constexpr double rounding = 1e-11;

// The second correction at t = 1, after which the error is about its square.
constexpr double arrival = 1e-8;

// So close to t = 1 a path is over, singular or infinite.
constexpr double near_end = 1e-13;

// Paths that get too ill-conditioned to go on from here are at a multiple solution; its distance is the
// square root.
constexpr double stuck_at_end = 1e-8;

// What a path did since it came so close to t = 1 tells where it goes.
constexpr double close_to_end = 1e-2;

// On a path to infinity the nearness falls like (1 - t)^k, with k = 1/2 or 1 mostly; on others it has k = 0
// in the end.
constexpr double least_fall = 0.1;

// At infinity there are solutions for any parameters, a continuum of them. Paths that are on it before they
// are close to the end have jumped; the end of others may lie on it, so that they get too ill-conditioned to
// arrive. The same befalls paths to solutions that are so close to infinity that they are real under no
// circumstances.
constexpr double at_infinity = 1e-9;
constexpr double close_to_infinity = 1e-5;

constexpr double smallest_relative_step = 1e-6;

// |e . e| / |e|^2: 1 for a real pose, 0 at infinity.
double nearness(const Solution& z) {
  double squared_norm = 0.0;
  for (std::size_t i = 0; i < 4; ++i) squared_norm += std::norm(z[i]);
  return std::abs(z[0] * z[0] + z[1] * z[1] + z[2] * z[2] + z[3] * z[3]) / squared_norm;
}

// The bookkeeping of one lane: which path it follows, and how it fares.
struct Traveller {
  std::size_t path = 0;
  bool active = false;
  int steps = 0;
  double nearness_before_end = 1.0;  // where the path was last not close to the end
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
    each = Traveller{next_path_, next_path_ < starts_.size()};
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
    const bool arrives = now_.t[lane] + now_.step[lane] >= 1.0;
    const bool converges = second <= (arrives ? arrival : std::max(rounding, contraction * first));
    const bool good = first <= accuracy_.prediction && converges;
    if (good) accept(lane);
    if (good && over(lane)) return;
    plan(lane, std::isfinite(first) ? first : 1.0, converges);
  }

  void accept(int lane) {
    for (std::size_t i = 0; i < starts_[0].size(); ++i) {
      now_.solution[i].re[lane] = next_.solution[i].re[lane];
      now_.solution[i].im[lane] = next_.solution[i].im[lane];
    }
    now_.t[lane] += now_.step[lane];
  }

  // Ends the path if it is at its end or next to it.
  bool over(int lane) {
    const double left = 1.0 - now_.t[lane], near = nearness(solution(lane));
    Traveller& each = traveller(lane);
    if (left > close_to_end) each.nearness_before_end = near;
    if (left >= near_end) return false;
    if (left <= 0.0)
      finish(lane, near > close_to_infinity ? Ending::regular : out_there(each));
    else
      finish(lane, falls(each, left, near) ? Ending::infinite : Ending::singular);
    return true;
  }

  void give_up(int lane) { finish(lane, ending_where_stuck(lane)); }

  Ending ending_where_stuck(int lane) {
    const double left = 1.0 - now_.t[lane], near = nearness(solution(lane));
    if (left < close_to_end && near < close_to_infinity) return out_there(traveller(lane));
    return left < stuck_at_end ? Ending::singular : Ending::lost;
  }

  static Ending out_there(const Traveller& each) {
    return each.nearness_before_end > at_infinity ? Ending::infinite : Ending::lost;
  }

  // The exponent of the nearness over the last part of the path: log-log slope between its ends.
  static bool falls(const Traveller& each, double left, double near) {
    return std::log(each.nearness_before_end / near) > least_fall * std::log(close_to_end / left);
  }

  // The error of the prediction is of order 5 in the step.
  void plan(int lane, double error, bool converges) {
    const double left = 1.0 - now_.t[lane];
    const double wanted = 0.8 * std::pow(accuracy_.prediction / std::max(error, 1e-15), 0.2);
    const double factor = converges ? std::clamp(wanted, 0.2, 2.5) : std::clamp(wanted, 0.2, 0.5);
    const double step = now_.step[lane] * factor;
    if (step < smallest_relative_step * left || traveller(lane).steps >= accuracy_.max_steps)
      return give_up(lane);
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

// Solutions are homogeneous: the common factor of length 1 that brings them nearest to each other is that of
// their inner product.
double distance(const Solution& a, const Solution& b) {
  Complex product = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) product += std::conj(a[i]) * b[i];
  const double length = std::abs(product);
  const Complex factor = length > 0.0 ? product / length : 1.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::norm(factor * a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace parallel_aspects::platform_paths
