// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_SETUP_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_SETUP_REPORT_H

#include "tools/report/report.h"
#include "urdf/setup/setup.h"

#include <string>

namespace parallel_aspects::tools {

/// A question, its candidates numbered, and how to answer it with an option of `aspects setup URDF`.
Report report_question(const SetupResult& result, const std::string& urdf_file);

/// What was written; empty where nothing was, as no launch file for a robot that has no URDF.
struct SetupFiles {
  std::string config, launch;
};

/// What was found.
Report report_setup(const SetupResult& result, const std::string& urdf_file, const SetupFiles& written);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_SETUP_REPORT_H
