// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_SETUP_CONFIG_H
#define PARALLEL_ASPECTS_URDF_SETUP_SETUP_CONFIG_H

#include "parallel_aspects/model/pose.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"
#include "urdf/setup/setup.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A frame in that of a link that has no link of its own, written "rod_2@0.4:0:0", or where it is turned
/// "rod_2@0.4:0:0:0:1.57:0".
struct PlacedFrame {
  std::string link;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();  ///< in the frame of the link [m]
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();  ///< [rad]
};

/// Nothing where the text is not written so, as the name of a link.
std::optional<PlacedFrame> placed_frame(const std::string& text);

/// Adds it to the tree as a link of that name, fixed to the link that it is in. Does nothing for any other
/// text, or where that link is missing.
void add_placed_frame(Tree& tree, const std::string& text);

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
