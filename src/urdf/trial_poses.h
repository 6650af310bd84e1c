// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_TRIAL_POSES_H
#define PARALLEL_ASPECTS_URDF_TRIAL_POSES_H

#include "parallel_aspects/model/problems.h"
#include "urdf/description/messages.h"
#include "urdf/mechanism_contents.h"

namespace parallel_aspects {

/// Random poses, near and far, in random working modes: each must close every loop, or `problems` say where
/// one does not. How far loops stay open by rounding is accepted, with a note.
void close_trial_poses(Mechanism::Contents& contents, const SourceNames& files, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_TRIAL_POSES_H
