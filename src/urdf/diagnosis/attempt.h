// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_ATTEMPT_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_ATTEMPT_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/description/tree.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// What a description would be recognised as: "T2" and so on; nothing where it is refused.
using Attempt =
    std::function<std::optional<std::string>(const std::shared_ptr<const Tree>&, const ResolvedConfig&)>;

/// Why a description makes no robot.
struct Diagnosis {
  Problems problems;
  bool has_remedy = false;  ///< whether they name corrections of it that were tried and make a robot
};

/// With one problem.
inline Diagnosis with_remedy(const Note& problem) { return {{problem.text()}, true}; }
inline Diagnosis without_remedy(const std::string& problem) { return {{problem}, false}; }  ///< likewise

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_ATTEMPT_H
