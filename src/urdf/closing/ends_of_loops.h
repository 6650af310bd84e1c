// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CLOSING_ENDS_OF_LOOPS_H
#define PARALLEL_ASPECTS_URDF_CLOSING_ENDS_OF_LOOPS_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/chain.h"
#include "urdf/description/closure.h"
#include "urdf/description/tree.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The message that an open tree is a serial arm, one chain on its root with any frames and fingers on it,
/// and so has no loop; nothing for other trees.
std::optional<std::string> serial_arm_text(const Tree& tree, const std::string& urdf_name);

/// What keeps the ends of a mechanism from its loops: faults, what to write against each, and how the base,
/// the operational point and the actuated joints are once all of that is written.
struct WrongEnds {
  struct Wrong {
    std::string fault, remedy;
  };

  std::vector<Wrong> found;
  std::size_t base = 0;  // link
  ActuatedJoints actuated_joints;

  /// "FAULT; REMEDY.", each.
  Problems problems() const;
};

/// The base and the operational point must be on bodies of the loops: serial joints that are in between, as
/// of a turntable or a wrist, are wrong, and so are actuated joints outside of the loops. Needs no assembled
/// configuration.
WrongEnds find_wrong_ends(const ClosureSystem& system, const ActuatedJoints& actuated_joints,
                          const SourceNames& files);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CLOSING_ENDS_OF_LOOPS_H
