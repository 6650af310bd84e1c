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

/// Facts about a mechanism that is not recognised, from the ranks of its loops and legs in configurations
/// that close them: a sentence, or nothing where the fact does not hold.
///
/// It is a linkage of one degree of freedom, as a four-bar, and not one in T1. `assembled`: with its closures
/// as stated. One actuated joint that closures hold still by their axes counts as free.
std::optional<std::string> linkage_of_one_degree_of_freedom(const std::shared_ptr<const Tree>& tree,
                                                            const ResolvedConfig& resolved,
                                                            const AssemblyResult& assembled,
                                                            const SourceNames& files);

/// A chain between base and platform without an actuated joint lets the platform move, by its rank, in fewer
/// ways than there are actuated joints.
std::optional<std::string> chain_that_holds_too_much(const ClosureSystem& system,
                                                     const Eigen::VectorXd& values,
                                                     const ActuatedJoints& actuated_joints,
                                                     const SourceNames& files);

/// The robot has legs and a platform that moves, but the actuated joints do not hold the platform in any of
/// the random poses in which it was assembled.
std::optional<std::string> singular_everywhere(const std::shared_ptr<const Tree>& tree,
                                               const ResolvedConfig& resolved, const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_FACTS_H
