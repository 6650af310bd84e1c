// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/reports.h"
#include "tools/subcommands.h"

namespace parallel_aspects::tools {

Report report_robots(const std::vector<std::string>& names) {
  Report report{{{"robots", names}}, ""};
  for (const std::string& name : names) report.text += name + '\n';
  return report;
}

Subcommand robots_subcommand() {
  return {"robots", "List the shipped robots", {}, [](const Surroundings&) {
            return report_robots(shipped_robots(share_folder()));
          }};
}

}  // namespace parallel_aspects::tools
