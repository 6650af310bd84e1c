// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_SOURCE_NAMES_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_SOURCE_NAMES_H

#include <string>

namespace parallel_aspects {

/// Names of files or parameters, for messages.
struct SourceNames {
  std::string urdf;
  std::string config;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_SOURCE_NAMES_H
