// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_REGIONS_SOLUTION_LIFT_H
#define PARALLEL_ASPECTS_ASPECTS_REGIONS_SOLUTION_LIFT_H

#include "aspects/components/disjoint_sets.h"
#include "aspects/solutions/actuated_space.h"
#include "aspects/solutions/solution_regions.h"
#include "aspects/solutions/solution_tracker.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// By piece, the indices of its links.
using LinksByPiece = std::vector<std::vector<std::size_t>>;

/// The solutions of one set of actuated values over its pieces. In each piece every solution is a continuous
/// function of the values, since the piece is convex and no singular pose leads there. These are followed
/// from piece to piece. Needs a live `RoundingUpward`.
class SolutionLift {
 public:
  using Solutions = std::vector<Box>;

  /// What it is given must outlive it.
  SolutionLift(const SolutionTracker& tracker, const ActuatedSpace& space, const LinksByPiece& links,
               const SolutionSet& set, const MapControl& control);

  /// At the point of a piece, in the order of the set; null where they were not followed to.
  const Solutions* at(PieceIndex piece) const;

  /// Of the pieces that were followed to, a lower bound [m^2 or m^3].
  double measure() const noexcept { return measure_; }

  /// Whether it is known of every link between these pieces where it leads each solution.
  bool is_consistent() const noexcept { return consistent_; }

  /// The least solution that links lead this one to.
  std::size_t label(std::size_t solution) const { return labels_[solution]; }

 private:
  using Comparison = std::optional<std::vector<std::size_t>>;

  void spread(const MapControl& control);
  std::optional<PieceIndex> enter(std::size_t index, PieceIndex from);
  void compare_links(const MapControl& control);
  std::vector<std::size_t> links_inside() const;
  void take(const PieceLink& link, const Comparison& comparison);
  Comparison compared(const PieceLink& link) const;
  std::optional<Solutions> across(const PieceLink& link, std::size_t from) const;
  bool is_whole(PieceIndex piece) const { return space_.pieces()[piece].side == 0; }

  const SolutionTracker& tracker_;
  const ActuatedSpace& space_;
  const LinksByPiece& links_;
  const SolutionSet& set_;
  std::unordered_map<PieceIndex, Solutions> over_;
  std::unordered_set<PieceIndex> has_parts_beyond_;
  std::unordered_set<std::size_t> entered_by_;  // links that led to a piece first
  DisjointSets same_;
  std::vector<std::size_t> labels_;
  double measure_ = 0.0;
  bool consistent_ = true;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_REGIONS_SOLUTION_LIFT_H
