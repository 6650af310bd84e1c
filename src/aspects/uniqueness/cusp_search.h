// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CUSP_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CUSP_SEARCH_H

#include "aspects/uniqueness/strut_slice.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// The cusps of a slice.
struct CuspBoxes {
  std::vector<Box> cusps;      ///< each holds exactly one, and no two the same [half turns]
  std::vector<Box> undecided;  ///< whatever else there is, is in these [half turns]
  bool cancelled = false;
};

/// Where three direct solutions of the slice meet, with (g_0, g_1) of `StrutSlice` and their Jacobian J:
///
///     D = det J = 0  and  grad D . k = 0 for the columns k of adj J, {D, g_1} and -{D, g_0}.
///
/// At D = 0 both columns are multiples of the kernel of J; so where one is proved not to vanish, J has rank 1
/// and the other equation holds too. A regular zero of D and that equation is an ordinary cusp (H. Whitney,
/// Annals of Mathematics 62, 1955): grad D is not zero, and neither is the second derivative along the
/// kernel. The rest of the slice is excluded by bounds of D and of both equations. Poses where J = 0
/// altogether, and cusps that are not ordinary, stay in `undecided`.
///
/// Needs a live `RoundingUpward`.
CuspBoxes find_cusp_boxes(const StrutSlice& slice, const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_CUSP_SEARCH_H
