// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_INJECTIVE_BOXES_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_INJECTIVE_BOXES_H

#include "aspects/cusps/strut_slice.h"
#include "parallel_aspects/aspects/box.h"

#include <vector>

namespace parallel_aspects {

/// Boxes of a slice in which no two singular poses have the same lengths: there g takes D = 0 to its image
/// one to one. It does in a box B where
///
///  - {D, t.g} does not vanish, for a fixed t. Of two poses, with v from one to the other, the mean value
///    theorem gives points of B with grad D . v = 0 and grad(t.g) . v = 0, though their determinant is not
///    zero.
///  - or B lies in one about a cusp where D vanishes on neither of two opposite edges, and its derivative
///    from one of these to the other has one sign where D = 0, which thus is a graph over the others. With w
///    a column of J and n.w > 0 the image moves along the curve by k w. There {D, n.k w} has one sign, so
///    that k has one zero at most, and w turns one way, {D, w} x w != 0. So the integral of k w from one pose
///    to another does not vanish: if the zero is between them, then what comes before it is, but for its
///    sign, a vector on one side of w there, and what comes after it one on the other.
///
/// Needs a live `RoundingUpward`.
class InjectiveBoxes {
 public:
  /// `cusps` are small boxes about those of the slice, which must outlive it.
  InjectiveBoxes(const StrutSlice& slice, const std::vector<Box>& cusps);

  /// Whether it is proved of this box.
  bool holds(const Box& box) const;

  /// The boxes about cusps of which it is proved; not every cusp has one.
  const std::vector<Box>& about_cusps() const noexcept { return about_cusps_; }

 private:
  const StrutSlice& slice_;
  std::vector<Box> about_cusps_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_INJECTIVE_BOXES_H
