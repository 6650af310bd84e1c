// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_SEARCH_H

#include "aspects/cusps/cusp_trace.h"
#include "aspects/cusps/cusp_tube.h"
#include "aspects/cusps/held_slice.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// A box of the slice that holds exactly one cusp of a posture.
struct CuspBox {
  Box box;  ///< [half turns]
  SlicePosture posture;
};

/// The cusps of a slice.
struct CuspBoxes {
  std::vector<CuspBox> cusps;      ///< no two the same
  std::vector<CuspBox> undecided;  ///< whatever else there is, is in these
  /// The undecided boxes of a posture were so many that they lie along curves, which are not examined
  /// closer.
  bool has_curves = false;
  bool cancelled = false;
};

/// Where three direct solutions of the slice meet, in each posture, with the equations (g_0, g_1) of
/// `HeldSlice` and their Jacobian J by the coordinates of the slice, at fixed joint values:
///
///     D = det J = 0  and  grad D . k = 0 for the columns k of adj J, {D, g_1} and -{D, g_0}.
///
/// At D = 0 both columns are multiples of the kernel of J; so where one is proved not to vanish, J has rank 1
/// and the other equation holds too. Along the slice the joint values follow its coordinates x: q_x =
/// g_x / B_jj. A regular zero of D and of one of the equations over x is an ordinary cusp of the map from x
/// to q (H. Whitney, Annals of Mathematics 62, 1955), whose Jacobian is J divided by B_jj, row by row: its
/// kernel is that of J, along which q does not move to first order, grad D is not zero, and neither is the
/// second derivative along the kernel. The rest of the slice is excluded by bounds of D and of both
/// equations, up to its serial singularities, where these stay bounded. Poses where J = 0 altogether, and
/// cusps that are not ordinary or are serial singularities, stay in `undecided`.
///
/// Needs a live `RoundingUpward`.
CuspBoxes find_cusp_boxes(const HeldSlice& slice, const MapControl& control);

/// All curves of cusps of a family.
struct CuspTraces {
  std::vector<CuspTrace> traces;  ///< no two the same
  std::vector<Box> undecided;     ///< whatever else there is within limits, is in these
};

/// Boxes of the family are excluded by bounds, as those of a slice are by `find_cusp_boxes`, or hold one arc
/// of a curve by `test_tube`. That is followed both ways, unless a tube of a curve that is known holds a
/// point of it. So closed curves are found like any others. After `most_evaluations` those that are left are
/// undecided.
///
/// Needs a live `RoundingUpward`.
CuspTraces find_cusp_traces(SliceFamily& family, const TraceBounds& bounds, std::size_t most_evaluations,
                            const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_CUSP_SEARCH_H
