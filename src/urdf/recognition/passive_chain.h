// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_CHAIN_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_CHAIN_H

#include "parallel_aspects/model/manipulator.h"
#include "urdf/closing/chain.h"
#include "urdf/recognition/platform_motion.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A chain without an actuated joint that couples no coordinates: slides along fixed directions, then joints
/// that turn. It has a configuration for every pose that its directions allow, and only one but for turns of
/// its slides against each other, so that the legs' distance equations stand beside it as they are. So they
/// do beside one that couples coordinates and lets the platform move in all six ways, as a telescopic shaft.
struct PassiveChain {
  Chain slides;            ///< any number, from the base on
  Chain rotations;         ///< up to three revolute joints, or one ball joint
  Chain follower;          ///< else, joints of any kind that follow the platform wherever it goes
  bool restricts = false;  ///< whether the platform could move in more ways without it
};

/// The chain as such a one; nothing, and the `reason`, as "has ...", when it couples coordinates.
std::optional<PassiveChain> recognise_passive_chain(const PassiveChains& found, std::string& reason);

/// What the limits of slides say of the operational point.
struct SlideBounds {
  std::optional<WorkspaceBox> box;  ///< in the task frame [m]; none where no slide is limited
  std::vector<std::size_t> slides;  ///< the limited slides whose limits are exactly that
};

/// `values` are those of all joints at the assembled configuration of `motion` [rad or m]. Limits of slides
/// that are not along the axes of the task frame, or whose chain turns the operational point about something
/// else, are left out. Where a direction has no limit, the box goes beyond what `legs` can reach.
SlideBounds slide_bounds(const std::vector<PassiveChain>& chains, const ClosureSystem& system,
                         const Eigen::VectorXd& values, const PlatformMotion& motion,
                         const std::vector<Leg>& legs);

/// What a user should know of these chains, a message each.
Notes notes_on(const std::vector<PassiveChain>& chains, const SlideBounds& bounds, const Tree& tree,
               TaskSpace space);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_PASSIVE_CHAIN_H
