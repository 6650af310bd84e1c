// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_COMMAND_OPTIONS_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_COMMAND_OPTIONS_H

#include <Eigen/Core>

#include <string>
#include <vector>

namespace parallel_aspects {

/// A word of a command line, in quotation marks where a shell needs them.
std::string shell_word(const std::string& word);

/// The option of `aspects setup` that stands for a key of the YAML, as "--actuated" for "actuated_joints";
/// the key where the YAML alone can say it.
std::string option_name(const std::string& key);

/// The option with its values, as "--actuated 'a b'".
std::string option_for(const std::string& key, const std::vector<std::string>& values);

/// A coordinate or an angle, "0.4": what is but rounding is zero.
std::string coordinate_text(double value);

/// A place in the frame of a link [m], as "rod_2@0.4:0:0".
std::string placed_name(const std::string& link, const Eigen::Vector3d& xyz);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_COMMAND_OPTIONS_H
