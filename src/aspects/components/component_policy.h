// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_COMPONENT_POLICY_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_COMPONENT_POLICY_H

#include "aspects/boxes/box_classifier.h"

#include <cstddef>
#include <cstdint>

namespace parallel_aspects {

/// How a `Climb` goes.
struct ClimbPolicy {
  /// Length of a step, as a share of the ellipsoid in which no condition, were it linear, changes its sign.
  /// Below 1, as conditions are curved.
  double share_of_ellipsoid = 0.7;

  /// Where steps are shorter, in the measure of that ellipsoid, the climb has come to its top.
  double shortest_step = 1e-3;

  /// Directions that are tried for a step, each with so many times the damping of the one before: eight of
  /// them span twelve decades, from Newton's direction to that of steepest ascent.
  int max_trials = 8;
  double more_damping = 30.0;

  /// Halvings of the boxes that cover a step; where more are needed a shorter step is tried.
  int max_halvings = 4;

  /// Steps of one climb, so that it ends.
  int max_steps = 100;
};

/// What is done to join the components of a working mode or to prove them apart, how much of it, and in which
/// order. None of this can make a proof wrong: less work leaves more unresolved. Numbers without a reason
/// were found by trial. The switches are there to measure what each is good for:
/// `benchmark/component_ablation` turns them off one by one, and docs/development/benchmarks.md has the
/// table.
struct ComponentPolicy {
  BoxPolicy boxes;
  ClimbPolicy climb;

  // Joining components.

  /// Whole parts are joined where their common face is proved to hold poses of both.
  bool joins_across_faces = true;
  bool climbs = true;

  // Where a mode looks into all undecided leaves, and where only between components.

  /// With so many degrees of freedom undecided leaves are few enough to look into all. Boundaries meet at
  /// points, so that dividing what is indeterminate ends.
  std::size_t max_degrees_of_freedom_to_look_everywhere = 2;

  /// With more of them a mode looks into all undecided leaves where it has no more than these, so that
  /// the time for it stays bounded.
  std::size_t max_leaves_to_look_into = 50000;

  /// Levels below the base map from which `Detail::all_parts` is asked of divided leaves, in modes of more
  /// degrees of freedom that look everywhere. Most contacts end before, and the work does not pay there.
  std::uint32_t levels_before_all_parts = 3;

  // Searches for leaves to work on.

  bool searches_meetings = true;       ///< contacts of all components, in modes that look everywhere
  bool searches_indeterminate = true;  ///< any indeterminate leaf, in these modes
  bool searches_contacts = true;       ///< contacts seen from small components, in all other modes
  bool examines = true;  ///< looks into a contested leaf with `Detail::all_parts` before dividing it
  bool tries = true;     ///< divides a few of many contested leaves first, to see whether that helps

  /// Of indeterminate leaves, where they are divided. Where they are more they lie along a curve, and double
  /// with each level.
  std::size_t max_indeterminate_leaves = 1000;

  /// Down to here leaves that are merely indeterminate are divided with more than
  /// `max_degrees_of_freedom_to_look_everywhere`; below, curves of them would use up the budget.
  std::uint32_t level_of_indeterminate_leaves = 10;

  /// Leaves that `ContactSearch` examines: these, and so many for each leaf of a small component. What lies
  /// nearest is worked on first, and more is examined when that is settled.
  std::size_t least_leaves_to_search = 2000;
  std::size_t leaves_to_search_for_one = 8;

  // Contacts of two components.

  /// A contact of at most so many leaves is worked on all at once. At a point the number of leaves does not
  /// grow with depth, along a curve it doubles with each level: this number makes the difference. In modes
  /// that do not look everywhere, leaves are examined first, and fewer are left.
  std::size_t max_leaves_of_a_point = 1000;
  std::size_t max_leaves_of_a_point_between = 400;

  /// Leaves of a larger contact that are tried first, how many times more when these are settled, and the
  /// levels below the base map that they are divided to.
  std::size_t first_tries = 16;
  std::size_t more_tries = 8;
  std::uint32_t levels_of_a_try = 3;

  /// A contact whose tries came to nothing is examined as a whole if it has no more leaves, and then given
  /// up.
  std::size_t max_leaves_to_examine = 2000;

  // Stars in leaves that are left indeterminate (see `complete_leaves`).

  /// Boxes that are examined for a mode and sign where they are searched for by default: with one and two
  /// degrees of freedom, where few leaves are left for most robots.
  std::size_t max_boxes_for_stars = 200;

  /// Levels below a leaf to which its parts are examined, and how many parts are.
  std::uint32_t levels_of_stars = 14;
  std::size_t max_parts_for_stars = 30000;

  /// Of the edges of a leaf: where boxes begin to grow about a pose that no climb leads from.
  double smallest_rise = 0x1p-14;

  // What one mode may divide in all: so many leaves, and one for so many that the base map left undecided.
  std::size_t least_budget = 10000;
  std::size_t undecided_leaves_for_one = 8;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_COMPONENT_POLICY_H
