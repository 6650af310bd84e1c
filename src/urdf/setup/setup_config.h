// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_SETUP_CONFIG_H
#define PARALLEL_ASPECTS_URDF_SETUP_SETUP_CONFIG_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/task_space.h"
#include "urdf/description/note.h"
#include "urdf/setup/setup.h"

#include <optional>
#include <string>

namespace parallel_aspects {

/// What the YAML of a robot says, with the reasons for it.
struct SetupDraft {
  std::string robot;
  std::string urdf_name;
  SetupCandidate base_link, operational_point, actuated_joints;
  SetupCandidate closures;          ///< empty where the URDF describes them
  bool adds_closures = false;       ///< to those that the URDF describes
  std::string closure_type;         ///< of all of them
  std::vector<SetupChoice> others;  ///< what else would do, by key
  std::optional<TaskSpace> task_space;
  std::optional<Pose> home;        ///< in which the loops were closed
  std::vector<std::string> notes;  ///< on the URDF
  Notes closure_notes;             ///< with lists of closures that may be meant
};

/// As commented YAML.
std::string config_text(const SetupDraft& draft);

/// The options of `aspects setup` that ask for what it says.
std::string options_for(const SetupDraft& draft);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_SETUP_CONFIG_H
