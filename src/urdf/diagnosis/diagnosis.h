// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_DIAGNOSIS_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_DIAGNOSIS_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/ends_of_loops.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/description/tree.h"
#include "urdf/diagnosis/edit_search.h"

#include <memory>
#include <optional>
#include <string>

namespace parallel_aspects {

/// Why a description is refused, in one message with a remedy that was tried and works; nothing where no
/// known remedy works. A mechanism of one degree of freedom is reported as none of the robots that are
/// treated.
std::optional<Diagnosis> diagnosis_of(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                      const SourceNames& files, const Attempt& attempt);

/// The same where the ends are not those of the loops, or where no joint is in a loop; nothing there alone.
/// Names remedies only where all together work.
std::optional<Diagnosis> diagnosis_of_ends(const std::shared_ptr<const Tree>& tree,
                                           const ResolvedConfig& resolved, const WrongEnds& ends,
                                           const SourceNames& files, const Attempt& attempt);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_DIAGNOSIS_H
