// SPDX-License-Identifier: BSD-3-Clause
#include "interval/turn_memory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace parallel_aspects {
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
