// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_PLATFORM_CANDIDATES_H
#define PARALLEL_ASPECTS_URDF_SETUP_PLATFORM_CANDIDATES_H

#include "urdf/setup/body_graph.h"
#include "urdf/setup/setup.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A body that may be the platform.
struct Platform {
  std::size_t body = 0;
  std::vector<std::size_t> links;            ///< best operational point first
  std::vector<std::vector<GraphPart>> legs;  ///< all of them; then without one passive chain
};

/// Bodies between which and the base legs are. Those that as many legs as possible share come first, then
/// those whose names say so, then those that a closure holds.
std::vector<Platform> platform_candidates(const Tree& tree, const Bodies& bodies, const BodyGraph& graph,
                                          std::size_t base, const std::vector<Closure>& closures,
                                          const SetupAnswers& answers);

/// The one body in the loops whose names say that it is the base, where those of `base`, at which the tree
/// starts, say that it is the platform.
std::optional<std::size_t> base_by_name(const Tree& tree, const Bodies& bodies, const BodyGraph& graph,
                                        std::size_t base);

/// Whether a closure holds a link.
bool is_closed(const std::vector<Closure>& closures, std::size_t link);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_PLATFORM_CANDIDATES_H
