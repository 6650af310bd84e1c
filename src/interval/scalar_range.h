// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_SCALAR_RANGE_H
#define PARALLEL_ASPECTS_INTERVAL_SCALAR_RANGE_H

#include "interval/affine.h"
#include "interval/dual.h"
#include "interval/interval.h"
#include "interval/path_form.h"

#include <cstddef>

// What every kind of enclosure can tell of itself: `range_of` encloses its values, `center_of` the value in
// the middle of the box or of the part of a path.

namespace parallel_aspects {

inline double middle_of(const Interval& a) noexcept { return 0.5 * (a.lower() + a.upper()); }

inline Interval range_of(const Interval& a) noexcept { return a; }
inline Interval center_of(const Interval& a) noexcept { return a; }

template <std::size_t N>
Interval range_of(const Affine<N>& a) noexcept {
  return a.range();
}
template <std::size_t N>
Interval center_of(const Affine<N>& a) noexcept {
  return a.at_center();
}

template <std::size_t N, class Value>
Interval range_of(const Dual<N, Value>& a) noexcept {
  return range_of(a.value);
}
template <std::size_t N, class Value>
Interval center_of(const Dual<N, Value>& a) noexcept {
  return center_of(a.value);
}

inline Interval range_of(const PathForm& a) noexcept { return a.range; }
inline Interval center_of(const PathForm& a) noexcept { return a.center; }

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_SCALAR_RANGE_H
