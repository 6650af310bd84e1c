// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_ROD_ON_ARC_H
#define PARALLEL_ASPECTS_LEGS_ROD_ON_ARC_H

#include "interval/interval.h"

namespace parallel_aspects {

/// u of a leg whose crank is on an arc, as a form of the leg that is fixed.
template <template <class> class Form>
struct RodOnArc {
  Form<Interval> form;
  Interval squared_length;  ///< of u, closer than that of the form
};

inline bool are_apart(const Interval& a, const Interval& b) noexcept {
  return a.upper() < b.lower() || b.upper() < a.lower();
}

inline bool has_sign(const Interval& value, int sign) noexcept {
  return sign > 0 ? value.positive() : value.negative();
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_ROD_ON_ARC_H
