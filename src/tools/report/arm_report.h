// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_ARM_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_ARM_REPORT_H

#include "parallel_aspects/ask/arm.h"

#include <string>

namespace parallel_aspects::tools {

/// Answers about a serial arm for people.
std::string arm_text(const ask::ArmSession& session, const ask::ArmDescribed& answer);
std::string arm_text(const ask::ArmSession& session, const ask::ArmMapAnswer& answer);         ///< likewise
std::string arm_text(const ask::ArmSession& session, const ask::ArmPlace& answer);             ///< likewise
std::string arm_text(const ask::ArmSession& session, const ask::ArmInverseAnswer& answer);     ///< likewise
std::string arm_text(const ask::ArmSession& session, const ask::ArmConnectAnswer& answer);     ///< likewise
std::string arm_text(const ask::ArmSession& session, const ask::ArmUniquenessAnswer& answer);  ///< likewise

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_ARM_REPORT_H
