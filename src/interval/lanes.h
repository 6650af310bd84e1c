// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_LANES_H
#define PARALLEL_ASPECTS_INTERVAL_LANES_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

// Several numbers at once, in the lanes of a vector, and functions that do with each lane what they do with
// one number, so that a proof is written once for both. A condition on one number is a `bool`, on lanes a
// mask. Lanes round as one number does: what is computed in them is the same to the last digit. All of it is
// inlined, so that it takes on the instruction set of the function that it is used in (see `outlined`).

// Whether single functions can be compiled for wider vectors than the program. Sanitizers would make such
// functions huge.
#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PARALLEL_ASPECTS_HAS_WIDE_LANES
#define PARALLEL_ASPECTS_OUTLINED(instructions) [[gnu::target(instructions), gnu::flatten, gnu::noinline]]
#else
#define PARALLEL_ASPECTS_OUTLINED(instructions)
#endif

namespace parallel_aspects {

template <std::size_t Count>
struct LanesOf {
  using Numbers [[gnu::vector_size(Count * sizeof(double))]] = double;
};

/// Of `Count` numbers: 2 or 4.
template <std::size_t Count>
using Lanes = typename LanesOf<Count>::Numbers;

template <class Numbers>
inline constexpr std::size_t lane_count = sizeof(Numbers) / sizeof(double);

/// What comparisons of numbers give.
template <class Numbers>
using MaskOf = decltype(Numbers{} < Numbers{});

/// Bits that go with each number.
template <class Numbers>
using BitsOf = std::conditional_t<std::is_same_v<Numbers, double>, std::int64_t, MaskOf<Numbers>>;

/// Functions that are compiled for the processors that have vectors of these numbers, with all that they call
/// inlined. Nothing else of the program may be compiled for more than its oldest processor.
template <class Numbers>
struct LaneCode;

template <>
struct LaneCode<Lanes<2>> {
  template <class Work>
  PARALLEL_ASPECTS_OUTLINED("sse2")
  static auto run(const Work& work) noexcept {
    return work();
  }
};

template <>
struct LaneCode<Lanes<4>> {
  template <class Work>
  PARALLEL_ASPECTS_OUTLINED("avx2")
  static auto run(const Work& work) noexcept {
    return work();
  }
};

/// `work()`, compiled once as a function of its own and not inlined wherever it is used: what is computed in
/// lanes comes to many instructions, and would take minutes to compile as one piece. Of one number it is
/// inlined.
template <class Numbers, class Work>
[[gnu::always_inline]] inline auto outlined(const Work& work) noexcept {
  if constexpr (std::is_same_v<Numbers, double>)
    return work();
  else
    return LaneCode<Numbers>::run(work);
}

/// The same number in every lane.
template <class Numbers>
[[gnu::always_inline]] inline Numbers in_lanes(double value) noexcept {
  if constexpr (std::is_same_v<Numbers, double>) return value;
  if constexpr (sizeof(Numbers) == sizeof(Lanes<2>)) return Numbers{value, value};
  if constexpr (sizeof(Numbers) == sizeof(Lanes<4>)) return Numbers{value, value, value, value};
}

template <class Numbers, class = std::enable_if_t<!std::is_same_v<Numbers, double>>>
[[gnu::always_inline]] inline Numbers in_lanes(const Numbers& value) noexcept {
  return value;
}

/// |a|.
inline double modulus(double a) noexcept { return std::abs(a); }
template <class Numbers>
[[gnu::always_inline]] inline Numbers modulus(const Numbers& a) noexcept {
  using Mask = decltype(a < a);
  return (Numbers)((Mask)a & 0x7fff'ffff'ffff'ffffLL);
}

/// The larger of two; the first where they are equal, as `std::max`.
template <class Numbers>
[[gnu::always_inline]] inline Numbers larger_of(const Numbers& a, const Numbers& b) noexcept {
  return a < b ? b : a;
}

/// The smaller of two; the first where they are equal, as `std::min`.
template <class Numbers>
[[gnu::always_inline]] inline Numbers smaller_of(const Numbers& a, const Numbers& b) noexcept {
  return b < a ? b : a;
}

template <class Numbers>
[[gnu::always_inline]] inline Numbers root_of(const Numbers& a) noexcept {
  Numbers result;
  for (std::size_t i = 0; i < lane_count<Numbers>; ++i) result[i] = __builtin_sqrt(a[i]);
  return result;
}

/// Whether a condition holds in all lanes, or in none. Lanes are joined without a branch.
template <class Mask>
[[gnu::always_inline]] inline bool in_all(const Mask& condition) noexcept {
  if constexpr (std::is_arithmetic_v<Mask>) {
    return condition;
  } else {
    auto all = condition[0];
    for (std::size_t i = 1; i < lane_count<Mask>; ++i) all &= condition[i];
    return all != 0;
  }
}
template <class Mask>
[[gnu::always_inline]] inline bool in_none(const Mask& condition) noexcept {
  if constexpr (std::is_arithmetic_v<Mask>) {
    return !condition;
  } else {
    auto any = condition[0];
    for (std::size_t i = 1; i < lane_count<Mask>; ++i) any |= condition[i];
    return any == 0;
  }
}

/// Bits where the condition holds, else 0.
template <class Mask, class Bits>
[[gnu::always_inline]] inline auto bits_where(const Mask& condition, const Bits& bits) noexcept {
  if constexpr (std::is_arithmetic_v<Mask>)
    return condition ? bits : Bits{};
  else
    return condition & bits;
}

/// What is in the i-th lane.
template <class Several>
[[gnu::always_inline]] inline auto lane_of(const Several& of, std::size_t i) noexcept {
  if constexpr (std::is_arithmetic_v<Several>)
    return of;
  else
    return of[i];
}

/// `a` where the condition holds, else `b`.
template <class Mask, class Numbers>
[[gnu::always_inline]] inline Numbers where(const Mask& condition, const Numbers& a,
                                            const Numbers& b) noexcept {
  return condition ? a : b;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_LANES_H
