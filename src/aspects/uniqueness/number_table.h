// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_NUMBER_TABLE_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_NUMBER_TABLE_H

#include "aspects/regions/uniqueness_domains.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/working_mode.h"

namespace parallel_aspects {

// Sums of many measures are off by less.
inline constexpr double rounded_up = 1.0 + 1e-9, rounded_down = 1.0 - 1e-9;

/// The aspect that holds a pose; 0 where the map can not tell, or not from others.
int aspect_at(const AspectMap& map, const Pose& pose, const WorkingMode& mode);

/// Adds a component to the list, and to the region of its number of solutions.
void add_component(BasicComponent component, SolutionNumbers& result);

/// Once all are added: on so much no number is proved [m^2 or other].
void set_unknown(double unknown, SolutionNumbers& result);

/// Domains of the basic regions that are there.
void add_domains(FoundDomains domains, Uniqueness& result);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_NUMBER_TABLE_H
