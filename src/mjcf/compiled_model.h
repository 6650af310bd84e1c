// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MJCF_COMPILED_MODEL_H
#define PARALLEL_ASPECTS_MJCF_COMPILED_MODEL_H

#include "mjcf/kinematic_elements.h"
#include <memory>
#include <mujoco/mujoco.h>
#include <string>

namespace parallel_aspects::mjcf {

/// Gives back what MuJoCo made.
struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// What MuJoCo makes of the elements; null, and a problem with the place in the file that people wrote, where
/// it refuses them.
std::unique_ptr<mjModel, Free> compiled(const KinematicElements& elements, const std::string& file,
                                        Problems& problems);

}  // namespace parallel_aspects::mjcf

#endif  // PARALLEL_ASPECTS_MJCF_COMPILED_MODEL_H
