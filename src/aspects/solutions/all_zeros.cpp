// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/all_zeros.h"

#include "aspects/cusps/cosine_sum.h"
#include "aspects/zeros/known_zeros.h"

#include <algorithm>
#include <cstddef>

namespace parallel_aspects {
namespace {

// Boxes that are larger are not worth Krawczyk's test, and smaller ones not worth being divided [half turns].
constexpr double largest_tested_for_zero = 0.2, smallest_with_zero = 0x1p-34;

// Its test of a somewhat larger box also proves zeros that lie on a face.
constexpr double inflation_for_zero = 1.5;
constexpr std::size_t largest_search = 20000;
constexpr int contractions_of_zero = 6;

class ZeroFinder {
 public:
  explicit ZeroFinder(const PairOver& pair_over) : pair_over_(pair_over) {}

  std::optional<std::vector<Box>> run() {
    boxes_.push_back(whole_slice());
    for (std::size_t effort = 0; !boxes_.empty(); ++effort) {
      const Box box = boxes_.back();
      boxes_.pop_back();
      if (effort > largest_search || !examine(box)) return std::nullopt;
    }
    std::vector<Box> result;
    for (const KnownZero& each : known_.all()) result.push_back(without_turns(each.enclosure));
    return result;
  }

 private:
  static bool may_vanish(const Box& box, const PairOverBox& pair) {
    const SliceCenter middle(box);
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval value =
          pair.center[i] + pair.jacobian[i][0] * middle.offset(0) + pair.jacobian[i][1] * middle.offset(1);
      if (value.positive() || value.negative()) return false;
    }
    return true;
  }

  /// False where the box is too small to be divided.
  bool examine(const Box& box) {
    if (known_.cover(box) || !may_vanish(box, pair_over_(box))) return true;
    const double width = std::max(box.width(0), box.width(1));
    if (width < largest_tested_for_zero && is_settled(scaled(box, inflation_for_zero))) return true;
    for (const Box& half : halves_of(box)) boxes_.push_back(half);
    return width > smallest_with_zero;
  }

  bool is_settled(const Box& box) {
    const ZeroSearch found = krawczyk_test(box, pair_over_(box));
    if (found.zeros != Zeros::one) return found.zeros == Zeros::none;
    return known_.note({box, contracted(pair_over_, found.enclosure, contractions_of_zero)});
  }

  const PairOver& pair_over_;
  std::vector<Box> boxes_;
  KnownZeros known_;
};

}  // namespace

Box contracted(const PairOver& pair_over, Box box, int times) {
  for (int k = 0; k < times; ++k) box = intersection(box, krawczyk_test(box, pair_over(box)).enclosure);
  return box;
}

std::optional<std::vector<Box>> find_all_zeros(const PairOver& pair_over) {
  assert_rounding_upward();
  return ZeroFinder(pair_over).run();
}

}  // namespace parallel_aspects
