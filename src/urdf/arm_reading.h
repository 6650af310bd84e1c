// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_ARM_READING_H
#define PARALLEL_ASPECTS_URDF_ARM_READING_H

#include "parallel_aspects/arms/serial_arm.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The serial arm that a URDF and its YAML describe: no loops, and all actuated joints on the way from the
/// base link to the operational point. Null where they describe something else, or nothing that can be read:
/// `load_mechanism` says what. The names are those of files, for messages. Throws `InvalidDescription` where
/// it is an arm of no use, as a redundant one.
std::shared_ptr<const SerialArm> read_arm(const std::string& urdf_text, const std::string& urdf_name,
                                          const std::string& config_text, const std::string& config_name);

/// The YAML of a serial arm of which there is only the URDF, with the reasons for what it says.
struct ArmSetup {
  std::string config;
  std::shared_ptr<const SerialArm> arm;  ///< what the URDF makes with it; never null
};

/// What people know of it already; empty where not.
struct ArmAnswers {
  std::string base_link, operational_point;
  std::vector<std::string> actuated_joints;
};

/// Looks for the base and the flange of a bare URDF: the chain with the most joints, from the link that its
/// first joint is on to the frame fixed to its end that is named as a flange, or else to the last one. What
/// is on other branches, as the fingers of a gripper, is left out. Nothing where there is none of two joints.
/// Throws `InvalidDescription` where the arm is refused.
std::optional<ArmSetup> set_up_arm(const std::string& urdf_text, const std::string& urdf_name,
                                   const std::string& config_name, const ArmAnswers& answers);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_ARM_READING_H
