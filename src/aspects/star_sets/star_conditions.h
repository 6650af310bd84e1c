// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_CONDITIONS_H
#define PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_CONDITIONS_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/box_stage.h"
#include "aspects/boxes/evaluated_legs.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// The kinds of the legs of a manipulator.
template <std::size_t Legs>
using LegTypes = std::array<LegType, Legs>;

/// Whether the direction of the rod depends on |B_jj| besides the pose.
inline bool rod_depends_on_entry(LegType type) noexcept {
  return type == LegType::revolute || type == LegType::prismatic;
}

/// The functions that are all positive in S(signs, sign) and nowhere else, over one kind of enclosures; but
/// for obstacles and collisions, and for B_jj^2 of struts, which vanishes with det A only.
template <class Chart, class Scalar>
class StarConditions {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count;
  using Signs = std::array<int, leg_count>;
  using Entries = std::array<Scalar, leg_count>;

  StarConditions(const ChartBox<Chart>& at, const LegTypes<leg_count>& types,
                 const PlacedLegs<Chart, Scalar>& placed, const Entries& entries)
      : at_(at), types_(types), placed_(placed), legs_(at.chart, placed, entries) {}

  /// Calls `take` with each function, and with the legs of which it takes |B_jj|. False where a condition is
  /// not that some functions are positive, all of them.
  template <class Take>
  bool visit(const Signs& signs, int sign, LegSet without_square, const Take& take) const {
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (types_[j] != LegType::strut && (without_square & BoxFacts::bit(j)) == 0)
        take(placed_.squared_b_entry(j), LegSet{0});
      const LegSet entry = types_[j] == LegType::strut ? LegSet{0} : BoxFacts::bit(j);
      if (!visit_limits(at_.chart.limits(j, placed_.legs[j].displacement, legs_.entry(j), signs[j]), entry,
                        take))
        return false;
    }
    const LegSet rods = legs_with_turning_rods();
    const Scalar determinant = legs_.determinant(signs);
    take(Interval(sign) * determinant, rods);
    visit_margins(determinant, signs, rods, take);
    return at_.tests.none() || visit_points(signs, take);
  }

 private:
  LegSet legs_with_turning_rods() const {
    LegSet result = 0;
    for (std::size_t j = 0; j < leg_count; ++j)
      if (rod_depends_on_entry(types_[j])) result |= BoxFacts::bit(j);
    return result;
  }

  /// Of limits of which one is enough, it is that one where the other holds nowhere in the box.
  template <class Take>
  static bool visit_limits(const LimitFunctions<Scalar>& limits, LegSet entry, const Take& take) {
    std::size_t open = 0;
    for (std::size_t k = 0; k < limits.count; ++k) {
      const Interval range = range_of(limits.values[k]);
      if (limits.any && range.positive()) return true;
      open += !(range.upper() <= 0.0);
    }
    if (limits.any && open > 1) return false;
    for (std::size_t k = 0; k < limits.count; ++k)
      if (!limits.any || open == 0 || !(range_of(limits.values[k]).upper() <= 0.0))
        take(limits.values[k], entry);
    return true;
  }

  template <class Take>
  void visit_margins(const Scalar& determinant, const Signs& signs, LegSet rods, const Take& take) const {
    const auto& margins = at_.tests.margins();
    for (std::size_t j = 0; j < leg_count; ++j)
      margins.for_each_serial_function(j, placed_.squared_b_entry(j),
                                       [&take](const Scalar& f) { take(f, LegSet{0}); });
    if (margins.has_parallel())
      margins.for_each_parallel_function(square(determinant), legs_, signs,
                                         [&take, rods](const Scalar& f) { take(f, rods); });
  }

  /// Of the operational point, of the chain that holds the platform, and of passive joints.
  template <class Take>
  bool visit_points(const Signs& signs, const Take& take) const {
    const auto take_of_pose = [&take](const Scalar& f) { take(f, LegSet{0}); };
    at_.tests.for_each_workspace_function(legs_.position(), take_of_pose);
    at_.tests.for_each_hinge_function(legs_, take_of_pose);
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (!at_.tests.has_passive_limits(j) && !at_.tests.has_cones(j)) continue;
      const auto* points = legs_.points(j, signs[j]);
      if (points == nullptr) return false;
      const LegSet entry = BoxFacts::bit(j);
      bool all = true;
      at_.tests.for_each_passive_limit(j, *points, legs_, [&](const LimitFunctions<Scalar>& limits) {
        all = visit_limits(limits, entry, take) && all;
      });
      if (!all) return false;
      at_.tests.for_each_cone(j, *points, legs_, [&](const Scalar& f) { take(f, entry); });
    }
    return true;
  }

  const ChartBox<Chart>& at_;
  const LegTypes<leg_count>& types_;
  const PlacedLegs<Chart, Scalar>& placed_;
  EvaluatedLegs<Chart, Scalar> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_CONDITIONS_H
