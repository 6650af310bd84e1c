// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_ACTUATION_CHOICES_H
#define PARALLEL_ASPECTS_URDF_CLOSING_ACTUATION_CHOICES_H

#include "urdf/closing/chain.h"

#include <vector>

namespace parallel_aspects {

/// Whether a fully parallel robot may have so many actuated joints: one, two, three or six.
bool is_actuation_count(std::size_t count) noexcept;

/// Which of `described.variables`, of which there may be too many, can be the actuated joints: those at one
/// distance from the base in all legs, or in all but one.
std::vector<std::vector<std::size_t>> actuation_choices(const ClosureSystem& system,
                                                        const ActuatedJoints& described,
                                                        const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_ACTUATION_CHOICES_H
