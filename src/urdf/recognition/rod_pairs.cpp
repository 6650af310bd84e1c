// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/rod_pairs.h"

#include "model/number_text.h"
#include "urdf/closing/assembly.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

// The joints that only one of the chains has, from the first to the last.
Chain own_part(const Chain& chain, const Chain& other) {
  Chain own;
  for (const Pivot& pivot : chain)
    if (std::none_of(other.begin(), other.end(), [&](const Pivot& one) { return one.name == pivot.name; }))
      own.push_back(pivot);
  return own;
}

// Of two rods: how far apart they are at both ends, and how long [m].
struct RodPair {
  Chain one, other;

  double apart_at_start() const { return (one.front().point - other.front().point).norm(); }
  double apart_at_end() const { return (one.back().point - other.back().point).norm(); }
  static double length(const Chain& rod) { return (rod.back().point - rod.front().point).norm(); }

  double misfit() const {
    return std::max(std::abs(apart_at_start() - apart_at_end()), std::abs(length(one) - length(other)));
  }
};

std::string text_of(const RodPair& pair) {
  return "the rods from '" + pair.one.front().name + "' to '" + pair.one.back().name + "' and from '" +
         pair.other.front().name + "' to '" + pair.other.back().name + "' are " +
         number_text(RodPair::length(pair.one), 4) + " and " + number_text(RodPair::length(pair.other), 4) +
         " m long, and their ends " + number_text(pair.apart_at_start(), 4) + " and " +
         number_text(pair.apart_at_end(), 4) + " m apart";
}

}  // namespace

std::optional<std::string> reason_to_turn(const std::vector<LegChains>& legs, double size) {
  std::optional<RodPair> worst;
  for (const LegChains& leg : legs) {
    if (leg.chains.size() != 2) continue;
    RodPair pair{own_part(leg.chains[0], leg.chains[1]), own_part(leg.chains[1], leg.chains[0])};
    if (pair.one.size() < 2 || pair.other.size() < 2) continue;
    if (!worst || pair.misfit() > worst->misfit()) worst = std::move(pair);
  }
  if (!worst) return std::nullopt;
  return worst->misfit() > closing_tolerance * size
             ? text_of(*worst) + "; make them equal, by the origins of their frames"
             : std::string(
                   "the pairs are parallelograms, but turned against each other on base and platform; "
                   "compare "
                   "the rpy of the frames of each leg there, and which ends its closures hold");
}

}  // namespace parallel_aspects
