// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_WRIST_NOTES_H
#define PARALLEL_ASPECTS_URDF_SETUP_WRIST_NOTES_H

#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/setup/body_graph.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// Of planar robots: joints at the end of a chain that turn without moving anything else. They may be a wrist
/// behind the platform, whose tool is closed into a loop. A note for each, with the option that leaves it
/// out. `closures`: "a=b".
std::vector<std::string> wrist_notes(const Tree& tree, const Bodies& bodies, const Mechanism& mechanism,
                                     const std::vector<std::string>& closures, const std::string& urdf_name);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_WRIST_NOTES_H
