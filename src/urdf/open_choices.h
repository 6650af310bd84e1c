// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_OPEN_CHOICES_H
#define PARALLEL_ASPECTS_URDF_OPEN_CHOICES_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/mechanism_contents.h"

#include <functional>
#include <memory>

namespace parallel_aspects {

/// Recognises a mechanism whose closures all have a type; nothing, and problems, where it is no manipulator.
using Recognise = std::function<std::unique_ptr<Mechanism::Contents>(const ResolvedConfig&, Problems&)>;

/// The mechanism, where the description leaves open what joint a closure is, which end of a weld turns, or
/// which of many joints are actuated: the choices under which it is a manipulator. Notes say what was chosen.
/// Nothing, and problems, where there are none, or two that make different robots.
std::unique_ptr<Mechanism::Contents> recognise_open(const std::shared_ptr<const Tree>& tree,
                                                    const ResolvedConfig& resolved,
                                                    const Recognise& recognise, const SourceNames& files,
                                                    Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_OPEN_CHOICES_H
