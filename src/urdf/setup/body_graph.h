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

/// How many of these closures hold two bodies together that one of the others does.
std::size_t closed_again(const Bodies& bodies, const std::vector<Closure>& closures,
                         const std::vector<Closure>& others);

/// What is between base and platform, apart from everything else.
struct GraphPart {
  std::vector<std::size_t> variables;  ///< joints that a loop moves, those nearest to the base first
  std::vector<std::size_t> depths;     ///< of each: joints and closures between it and the base
  bool closed = false;                 ///< whether it holds a closure
};

/// Bodies, and what joins them: movable joints and closures.
class BodyGraph {
 public:
  BodyGraph(const Tree& tree, const Bodies& bodies, const std::vector<Closure>& closures);

  /// The body nearest to the root from which more than one way leads into the loops; nothing without loops.
  std::optional<std::size_t> base() const;

  /// What lies between these bodies and touches both: the legs, where they are base and platform.
  std::vector<GraphPart> parts_between(std::size_t base, std::size_t platform) const;

  /// Bodies that a loop moves, apart from `base`.
  std::vector<std::size_t> moving_bodies(std::size_t base) const;

  /// Joints that a loop moves, for each joint value.
  const std::vector<bool>& in_loop() const noexcept { return in_loop_; }

 private:
  struct Edge {
    std::size_t from = 0, to = 0;
    std::optional<std::size_t> variable;  // none for a closure
  };

  bool touches_loop(std::size_t body) const;
  bool any_at(const std::vector<std::size_t>& edges, std::size_t body) const;

  // Bodies that are joined without these two have one mark.
  std::vector<std::size_t> marks_without(std::size_t base, std::size_t platform) const;
  std::vector<std::size_t> depths_from(std::size_t base, std::size_t platform) const;
  GraphPart part_of(std::vector<std::size_t> edges, const std::vector<std::size_t>& depths) const;

  const Bodies& bodies_;
  std::vector<bool> in_loop_;
  std::vector<Edge> edges_;           // those of the loops
  std::vector<std::size_t> carrier_;  // of each body: the one that carries it
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_SETUP_BODY_GRAPH_H
