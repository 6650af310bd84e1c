// SPDX-License-Identifier: BSD-3-Clause
#include "interval/half_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr double rounded_pi = 3.141592653589793;

// pi t is off by less than 2e-15 for |t| <= 1.5, and sine and cosine of the C library by a unit in the last
// place in every rounding direction.
Interval between(double a, double b) {
  return {std::max(-1.0, std::min(a, b) - few_units), std::min(1.0, std::max(a, b) + few_units)};
}

// Boxes that are made longer than the region may leave [-1, 1]; there is no extreme but these up to here.
bool is_near(const Interval& a) { return -1.5 <= a.lower() && a.upper() <= 1.5; }

/// Of an angle and a function of it. Searches along other coordinates ask for one angle again and again.
struct Last {
  double lower = std::numeric_limits<double>::quiet_NaN(), upper = lower;  // equal to no number
  Interval value;
};

/// The value of what was asked for last, or the one that `compute` has.
template <class Compute>
const Interval& remembered(Last& last, const Interval& a, const Compute& compute) {
  if (last.lower != a.lower() || last.upper != a.upper()) last = {a.lower(), a.upper(), compute(a)};
  return last.value;
}

bool holds(const Interval& a, double t) { return a.lower() <= t && t <= a.upper(); }

Interval cosine_near(const Interval& a) {
  const Interval ends = between(std::cos(rounded_pi * a.lower()), std::cos(rounded_pi * a.upper()));
  return {holds(a, -1.0) || holds(a, 1.0) ? -1.0 : ends.lower(), holds(a, 0.0) ? 1.0 : ends.upper()};
}

Interval sine_near(const Interval& a) {
  const Interval ends = between(std::sin(rounded_pi * a.lower()), std::sin(rounded_pi * a.upper()));
  return {holds(a, -0.5) ? -1.0 : ends.lower(), holds(a, 0.5) ? 1.0 : ends.upper()};
}

}  // namespace

Interval pi_enclosure() noexcept { return {rounded_pi, 3.1415926535897936}; }

Interval cosine_of_half_turns(const Interval& a) noexcept {
  if (!is_near(a)) return {-1.0, 1.0};
  thread_local Last last;
  return remembered(last, a, cosine_near);
}

Interval sine_of_half_turns(const Interval& a) noexcept {
  if (!is_near(a)) return {-1.0, 1.0};
  thread_local Last last;
  return remembered(last, a, sine_near);
}

Turn<Interval> enclosed_turn(double angle) noexcept {
  const double cosine = std::cos(angle), sine = std::sin(angle), error = few_units * (1.0 + std::abs(angle));
  return {{cosine - error, cosine + error}, {sine - error, sine + error}};
}

Turn<Interval> enclosed_turn(double zero, double sense, const Interval& q) noexcept {
  const double middle = 0.5 * (q.lower() + q.upper());
  const Turn<Interval> at_middle = enclosed_turn(zero + sense * middle);
  if (q.lower() == q.upper()) return at_middle;
  const double half = std::max(q.upper() - middle, middle - q.lower());
  if (!(half <= 3.0)) return {{-1.0, 1.0}, {-1.0, 1.0}};
  const Turn<Interval> by = turn_of_half_turns(Interval(-half, half) * reciprocal(pi_enclosure()));
  return {at_middle.cosine * by.cosine - at_middle.sine * by.sine,
          at_middle.sine * by.cosine + at_middle.cosine * by.sine};
}

namespace {

constexpr std::size_t bits_of_places = 9;

struct Remembered {
  double lower = std::numeric_limits<double>::quiet_NaN(), upper = lower;  // equal to no number
  Turn<Interval> turn;
};

std::uint64_t bits_of(double value) noexcept {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// By multiplication with odd numbers, which spreads the digits that boxes differ in over the upper bits.
std::size_t place_of(double lower, double upper) noexcept {
  const std::uint64_t mixed = bits_of(lower) * 0x9e3779b97f4a7c15ULL + bits_of(upper) * 0xc2b2ae3d27d4eb4fULL;
  return static_cast<std::size_t>(mixed >> (64 - bits_of_places));
}

}  // namespace

const Turn<Interval>& remembered_turn(const Interval& a) noexcept {
  thread_local std::array<Remembered, std::size_t{1} << bits_of_places> memory;
  Remembered& known = memory[place_of(a.lower(), a.upper())];
  if (known.lower != a.lower() || known.upper != a.upper())
    known = {a.lower(), a.upper(), turn_of_half_turns(a)};
  return known.turn;
}

}  // namespace parallel_aspects
