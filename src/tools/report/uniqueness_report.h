// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H

#include "parallel_aspects/ask/uniqueness_question.h"

#include <string>

namespace parallel_aspects::tools {

/// Aspects, cusps and uniqueness domains.
std::string uniqueness_text(const Manipulator& robot, const std::shared_ptr<const Uniqueness>& found);

/// Of a slice of SO3: cusps, and numbers of direct solutions.
std::string uniqueness_text(const Manipulator& robot, const ask::CuspsInSlice& answer);

/// Curves of cusps.
std::string uniqueness_text(const Manipulator& robot, const ask::CuspsOverJoint& answer);

/// Of a roadmap: which of its poses have the same actuated values as others of their aspect.
std::string uniqueness_text(const Manipulator& robot, const ask::SurveyOfRoadmap& answer);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_UNIQUENESS_REPORT_H
