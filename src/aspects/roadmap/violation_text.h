// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ROADMAP_VIOLATION_TEXT_H
#define PARALLEL_ASPECTS_ASPECTS_ROADMAP_VIOLATION_TEXT_H

#include "parallel_aspects/aspects/pose_roadmap.h"

#include <string>

namespace parallel_aspects {

/// Why no aspect holds a configuration of which that is proved: "leg 'leg_2' cannot reach it" and so on; that
/// it is stretched or folded where B_jj is proved to be zero.
std::string violation_text(const Manipulator& manipulator, const PoseInMode& at,
                           const ConfigurationProof& proof);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ROADMAP_VIOLATION_TEXT_H
