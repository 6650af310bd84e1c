// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_MECHANISM_RECOGNITION_H
#define PARALLEL_ASPECTS_URDF_MECHANISM_RECOGNITION_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/corrections/edit.h"
#include "urdf/description/closure.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"
#include "urdf/load_mechanism.h"
#include "urdf/mechanism_contents.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace parallel_aspects {

/// Six for each leg of a hexapod, and twenty; the time to assemble a mechanism grows with their third power.
inline constexpr std::ptrdiff_t max_joints_in_loops = 120;

/// Whether there are some, and not too many; `problems` where not.
bool check_joints_in_loops(const ClosureSystem& system, const SourceNames& files, Problems& problems);

/// Everything after names and types of closures: assembles the mechanism, recognises it and proves the result
/// on random poses. Nothing, and `problems`, where it is no manipulator.
std::unique_ptr<Mechanism::Contents> recognise_mechanism(const std::shared_ptr<const Tree>& tree,
                                                         const MechanismConfig& config,
                                                         const ResolvedConfig& resolved,
                                                         const SourceNames& files, const LoadSearch& search,
                                                         Problems& problems);

/// Recognises a mechanism whose closures all have a type; nothing, and problems, where it is no manipulator.
using Recognise = std::function<std::unique_ptr<Mechanism::Contents>(const ResolvedConfig&, Problems&)>;

/// The mechanism, where the description leaves open what joint a closure is, which end of a weld turns, or
/// which of many joints are actuated: the choices under which it is a manipulator. Notes say what was chosen.
/// Nothing, and problems, where there are none, or two that make different robots.
std::unique_ptr<Mechanism::Contents> recognise_open(const std::shared_ptr<const Tree>& tree,
                                                    const ResolvedConfig& resolved,
                                                    const Recognise& recognise, const SourceNames& files,
                                                    Problems& problems);

/// The mechanism that a description makes; null where none.
using RecogniseIn = std::function<std::unique_ptr<Mechanism::Contents>(const std::shared_ptr<const Tree>&,
                                                                       const ResolvedConfig&, Problems&)>;

/// A description that has been recognised, and how others are.
struct RecognisedEnds {
  const Subject& subject;  ///< as it is written
  bool ends_meet = false;  ///< whether ends that are apart at zero were put together
  const RecogniseIn& recognise;
  const Attempt& attempt;
};

/// Adds what of the ends of its closures may not be meant: ends that are crossed, or apart while all joints
/// are zero.
void note_ends(const RecognisedEnds& ends, Mechanism::Contents& contents);

/// Says where `Mechanism::home` is, once all of the robot is known. A note where the stated start is beyond
/// reach.
void find_home(const MechanismConfig& config, const SourceNames& files, Mechanism::Contents& contents);

/// Random poses, near and far, in random working modes: each must close every loop, or `problems` say where
/// one does not. How far loops stay open by rounding is accepted, with a note.
void close_trial_poses(Mechanism::Contents& contents, const SourceNames& files, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_MECHANISM_RECOGNITION_H
