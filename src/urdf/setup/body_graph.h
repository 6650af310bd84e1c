// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_SETUP_BODY_GRAPH_H
#define PARALLEL_ASPECTS_URDF_SETUP_BODY_GRAPH_H

#include "urdf/description/closure.h"
#include "urdf/description/tree.h"

#include <optional>
#include <vector>

namespace parallel_aspects {

/// Links that are fixed to one another are a body; the root is in body 0.
class Bodies {
 public:
  explicit Bodies(const Tree& tree);

  std::size_t count() const noexcept { return links_.size(); }
  std::size_t of(std::size_t link) const { return body_[link]; }
  const std::vector<std::size_t>& links(std::size_t body) const { return links_[body]; }

 private:
  std::vector<std::size_t> body_;                // by link
  std::vector<std::vector<std::size_t>> links_;  // by body, the first nearest to the root
};

/// From the root to a link, of the tree's.
std::vector<std::size_t> movable_joints_to(const Tree& tree, std::size_t link);

/// How many of these closures hold two bodies together that one of the others does.
std::size_t closed_again(const Bodies& bodies, const std::vector<Closure>& closures,
                         const std::vector<Closure>& others);

/// What is between base and platform, apart from everything else.
struct GraphPart {
  std::vector<std::size_t> variables;  ///< joints that a loop moves, those nearest to the base first
  std::vector<std::size_t> depths;     ///< of each: joints and closures between it and the base
  bool closed = false;                 ///< whether it holds a closure
};

/// Bodies, and what joins them in loops: movable joints and closures.
class BodyGraph {
 public:
  BodyGraph(const Tree& tree, const Bodies& bodies, const std::vector<Closure>& closures);

  /// The body nearest to the root from which more than one way leads into the loops; nothing without loops.
  std::optional<std::size_t> base() const;

  /// Bodies that a loop moves, apart from `base`.
  std::vector<std::size_t> moving_bodies(std::size_t base) const;

  /// Joints that a loop moves, for each joint value.
  const std::vector<bool>& in_loop() const noexcept { return in_loop_; }

 private:
  struct Edge {
    std::size_t from = 0, to = 0;  // bodies
  };

  bool touches_loop(std::size_t body) const;

  const Bodies& bodies_;
  std::vector<bool> in_loop_;
  std::vector<Edge> edges_;           // those of the loops
  std::vector<std::size_t> carrier_;  // of each body: the one that carries it
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_BODY_GRAPH_H
