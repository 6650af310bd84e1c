// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_OPTION_NAME_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_OPTION_NAME_H

#include <string>

namespace parallel_aspects::tools {

/// The option of a field: "around_cusp" is --around-cusp. The ends of a path are --from and --to, of which
/// the first is no name in Python.
std::string option_name(const std::string& field);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_OPTION_NAME_H
