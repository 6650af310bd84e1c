// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_PLANAR_LAYERS_H
#define PARALLEL_ASPECTS_URDF_CLOSING_PLANAR_LAYERS_H

#include "urdf/description/closure.h"
#include "urdf/description/messages.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The axis that all these joints turn about, or slide across, at the configuration of the poses; nothing
/// where they do not or none turns. They move all points in planes across it.
std::optional<Eigen::Vector3d> common_normal(const Tree& tree, const Poses& poses,
                                             const std::vector<std::size_t>& joints);

/// Planar legs in layers: where all joints of a loop move in parallel planes, the distance of the frames of
/// its closure across these is the same in all configurations, and no matter of kinematics. Takes it out of
/// the `closures`, with a note each. `platform`: a link whose frames stay where they are.
std::vector<std::string> join_layers(const Tree& tree, std::size_t platform, const SourceNames& files,
                                     std::vector<Closure>& closures);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_PLANAR_LAYERS_H
