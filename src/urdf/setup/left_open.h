// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_LEFT_OPEN_H
#define PARALLEL_ASPECTS_URDF_SETUP_LEFT_OPEN_H

#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/description/tree.h"
#include "urdf/setup/body_graph.h"
#include "urdf/setup/open_ends.h"
#include "urdf/setup/setup.h"

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Marks links that no loop is closed at by their names, as cameras and fingers, and with nothing else on
/// them.
std::vector<bool> fittings(const Tree& tree);

/// Marks besides those in `left_open` bodies that end a chain with one joint, two or more on one body that is
/// not the root, and are not named as ends of loops: as the fingers of a gripper.
std::vector<bool> with_fingers(const Tree& tree, const Bodies& bodies, std::vector<bool> left_open);

/// The same of the one such body that a slide holds, as the jaw of a gripper, where there is no other, it is
/// not on slides alone, and its name does not say that it is the platform.
std::vector<bool> with_single_finger(const Tree& tree, const Bodies& bodies, std::vector<bool> left_open);

/// Where the root is called base, and the base that was found is not and stands on a chain of several joints
/// of the root, which may be a leg: the ends of the closures that were found, each with the place on the root
/// where it is while all joints are zero. Nothing else.
std::optional<Pairing> ends_on_root(const Tree& tree, const Bodies& bodies, const SetupResult& found);

/// Whether that chain is left out, or a leg, which the ends on the root make of it.
SetupQuestion question_of_leg(const SetupResult& found, const SetupCandidate& on_root,
                              const std::string& urdf_name);

/// Of planar robots: joints at the end of a chain that turn without moving anything else. They may be a wrist
/// behind the platform, whose tool is closed into a loop. A note for each, with the option that leaves it
/// out. `closures`: "a=b".
std::vector<std::string> wrist_notes(const Tree& tree, const Bodies& bodies, const Mechanism& mechanism,
                                     const std::vector<std::string>& closures, const std::string& urdf_name);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_LEFT_OPEN_H
