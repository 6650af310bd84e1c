// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_FACTS_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_FACTS_H

#include "urdf/closing/assembly.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/description/messages.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// What is true of a mechanism that is not recognised, by the ranks of its loops and legs in configurations
/// that close them.
///
/// That it is a linkage of one degree of freedom, as a four-bar, and
/// not one in T1. `assembled`: with its closures as stated. One actuated joint that closures hold still by
/// their axes counts as free.
std::optional<std::string> linkage_of_one_degree_of_freedom(const std::shared_ptr<const Tree>& tree,
                                                            const ResolvedConfig& resolved,
                                                            const AssemblyResult& assembled,
                                                            const SourceNames& files);

/// That a chain between base and platform without an actuated joint lets the platform move, by its rank, in
/// fewer ways than joints are actuated.
std::optional<std::string> chain_that_holds_too_much(const ClosureSystem& system,
                                                     const Eigen::VectorXd& values,
                                                     const ActuatedJoints& actuated_joints,
                                                     const SourceNames& files);

/// That actuated joints can move while the others are locked, and leave the platform where it is.
std::optional<std::string> actuated_joints_that_move_nothing(const ClosureSystem& system,
                                                             const AssemblyResult& assembled,
                                                             const ActuatedJoints& actuated_joints,
                                                             const SourceNames& files);

/// That closures leave fewer degrees of freedom than there are actuated joints, by the axes about which their
/// links turn with balls in their place. `assembled`: with its closures as stated.
std::optional<std::string> closures_that_hold_too_much(const std::shared_ptr<const Tree>& tree,
                                                       const ResolvedConfig& resolved,
                                                       const AssemblyResult& assembled,
                                                       const SourceNames& files);

/// That a robot has legs and a platform that moves, but that its actuated joints do not hold this in any of
/// the random poses in which it was assembled.
std::optional<std::string> singular_everywhere(const std::shared_ptr<const Tree>& tree,
                                               const ResolvedConfig& resolved, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_FACTS_H
