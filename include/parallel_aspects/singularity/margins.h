// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_SINGULARITY_MARGINS_H
#define PARALLEL_ASPECTS_SINGULARITY_MARGINS_H

#include "parallel_aspects/model/constraints.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <string>

namespace parallel_aspects {

/// Those that ask something, as "parallel 0.05, serial 0.1"; empty where none does.
std::string to_string(const Margins& margins);

/// Which margins of the manipulator a configuration does not keep, as "the parallel index is 0.71, below the
/// margin 0.9"; empty where it keeps all. In double precision, so it proves nothing. `q` must assemble with
/// `pose`; both must be finite.
std::string missed_margins(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_SINGULARITY_MARGINS_H
