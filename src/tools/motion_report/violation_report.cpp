// SPDX-License-Identifier: BSD-3-Clause
#include "tools/motion_report/violation_report.h"

namespace parallel_aspects::tools {

using nlohmann::json;

const char* name_of(Violation kind) {
  switch (kind) {
    case Violation::singularity:
      return "parallel_singularity";
    case Violation::out_of_reach:
      return "serial_singularity";
    case Violation::joint_limit:
      return "actuated_limit";
    case Violation::constraint:
      return "constraint";
    case Violation::none:
      break;
  }
  return "none";
}

json json_violation(const Manipulator& manipulator, const TrajectoryViolation& violation) {
  return {{"kind", name_of(violation.kind)},
          {"leg", violation.leg ? json(manipulator.leg(*violation.leg).name) : json()},
          {"constraint", violation.constraint ? json(name(*violation.constraint)) : json()},
          {"after", violation.after},
          {"before", violation.before}};
}

}  // namespace parallel_aspects::tools
