// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_GATE_LEAVES_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_GATE_LEAVES_H

#include "aspects/map/gate_crossings.h"
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// The aspects that undecided leaves lie at: those of the inside leaves from which the fewest steps over
/// faces lead to them, through undecided leaves. Says where it pays to look, and proves nothing.
class NearestAspects {
 public:
  /// In the modes that are needed.
  NearestAspects(const AspectMap::Contents& map, const GateClasses& classes, const MapControl& control = {});

  /// By id; 0 where there is none.
  int of(NodeIndex leaf, std::size_t mode, int sign) const noexcept {
    return nearest_[2 * mode + (sign > 0 ? 1 : 0)][leaf];
  }

  /// Leaves where det A = 0 lies on faces: of two that share one, each with one sign alone, the smaller one,
  /// and the nearest aspects of both.
  struct Touching {
    NodeIndex leaf;
    int positive, negative;
  };
  const std::vector<Touching>& touching(std::size_t mode) const noexcept { return touching_[mode]; }

 private:
  std::vector<std::vector<int>> nearest_;  // by mode and sign, and by leaf
  std::vector<std::vector<Touching>> touching_;
};

/// The same of one working mode and sign alone, by leaf.
std::vector<int> nearest_aspects(const AspectMap::Contents& map, std::size_t mode, int sign,
                                 const MapControl& control = {});

/// Undecided leaves of one working mode that lie at the same two aspects; and leaves that lie at the one
/// alone and share a face with such of the other, which det A = 0 then lies on.
struct GateLeaves {
  Crossing crossing = Crossing::parallel;
  std::size_t leg = 0;   ///< whose sign differs, where serial
  std::size_t mode = 0;  ///< of the leaves; of a serial one, the mode in which the leg has the sign +1
  int sign = 1;          ///< of det A in both aspects, where serial
  std::vector<NodeIndex> leaves;  ///< rising

  GateClass gate_class() const noexcept { return {crossing, mode, leg}; }
};

/// All of the classes that are searched, as undecided leaves show them, in an order of their own.
std::vector<GateLeaves> find_gate_leaves(const AspectMap::Contents& map, const GateClasses& classes,
                                         const NearestAspects& nearest, const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_GATE_LEAVES_H
