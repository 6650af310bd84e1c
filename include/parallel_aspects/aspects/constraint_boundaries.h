// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINT_BOUNDARIES_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINT_BOUNDARIES_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/constraints.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// The undecided leaves, over all working modes, in which a constraint neither holds everywhere nor fails
/// everywhere: what encloses its boundary. One leaf may enclose several.
struct ConstraintBoundary {
  ConstraintKind kind = ConstraintKind::actuated_limits;  ///< whose boundary it is
  std::size_t leaves = 0;                                 ///< how many there are
  double measure = 0.0;                                   ///< of these leaves, in the unit of `measure_unit`
};

/// One for each constraint that the map was computed with, in the order of `all_constraint_kinds`.
std::vector<ConstraintBoundary> constraint_boundaries(const AspectMap& map);

/// Working modes in which no pose is proved to be free of singularities.
struct MissingModes {
  std::vector<WorkingMode> empty;    ///< proved: no pose of the region is in an aspect of it
  std::vector<WorkingMode> unknown;  ///< undecided leaves are left
};

/// Those of the modes that the map was computed for.
MissingModes missing_modes(const AspectMap& map);

/// Whether the region of the map may leave out poses that legs reach in the workspace. Then aspects are
/// connected within the region, and one of the robot that it cuts may be counted as several.
bool is_cut_by_region(const AspectMap& map);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINT_BOUNDARIES_H
