// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PARAMETERS_LOAD_OPTIONS_H
#define PARALLEL_ASPECTS_ROS_PARAMETERS_LOAD_OPTIONS_H

#include "parallel_aspects/urdf/mechanism.h"
#include "ros/parameters/node_options.h"

#include <ros/node_handle.h>

#include <XmlRpcValue.h>
#include <string>

namespace parallel_aspects {

/// Everything that the node needs before it starts.
struct NodeSetup {
  SharedMechanism mechanism;
  NodeOptions options;
  std::string urdf{};  ///< that the mechanism was loaded from
};

/// The options in a struct of private parameters. Wrong types and unknown keys are added to `problems`.
NodeOptions options_from(const XmlRpc::XmlRpcValue& parameters, const std::string& prefix,
                         Problems& problems);

/// A tree of parameters as YAML text.
std::string yaml_text(const XmlRpc::XmlRpcValue& value);

/// Reads `robot_description` and the private parameters. Throws `InvalidDescription` with every problem found
/// in the URDF, the description of the mechanism, and the options.
NodeSetup load_setup(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PARAMETERS_LOAD_OPTIONS_H
