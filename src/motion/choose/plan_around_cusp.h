// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_PLAN_AROUND_CUSP_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_PLAN_AROUND_CUSP_H

#include "motion/plan/map_segments.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/motion/plan_path.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Plans changes of the assembly mode on purpose, in one aspect of a slice that holds an actuated joint:
/// paths at whose end the actuated joints are back where they were at the start, and the platform is not.
/// Every segment is proved as those of `PathPlanner` are.
class CuspPlanner {
 public:
  /// The map of the slice, and its cusps, as `find_cusps` lists them.
  CuspPlanner(std::shared_ptr<const AspectMap> map, std::vector<Cusp> cusps);

  /// A path from there around the cusp with this index, to another pose of the same actuated values in the
  /// aspect: of those that are found the one with the largest `least_room`, whatever other cusps it goes
  /// around; of several with as much, around the fewest. `unknown` where none is found.
  PlannedPath plan(const PathEnd& from, std::size_t cusp, const MapControl& control = {}) const;

  /// A start from which `plan` has a path: of those beside the cusp the farthest one. It takes a plan for
  /// each that is tried.
  CuspStart find_start(std::size_t cusp, const MapControl& control = {}) const;

  /// The least of `room_at` along a path, seen at 32 poses a segment [rad or m].
  double least_room(const PlannedPath& path) const;

  /// An estimate of the largest `SampleOptions::encoder_noise` with which a tracker follows a path: what
  /// `StandOff` estimates for a robot that stands still, at 32 poses a segment, to a tenth. 0 where it is
  /// less than 1e-7.
  double followed_noise(const PlannedPath& path) const;

  /// How often the actuated values of a path that brings them back go around each cusp, counter-clockwise in
  /// the plane of the two joints that are not held; 0 for all where they are not back. Seen at 32 poses a
  /// segment.
  std::vector<int> turns_around_cusps(const PlannedPath& path) const;

  /// The pose at t, 0 to 1, from a point of a path to the next.
  Pose between(const Pose& from, const Pose& to, double t) const { return segments_.between(from, to, t); }

 private:
  class Search;
  using Look = std::function<void(const Pose&, const WorkingMode&)>;

  void look_along(const PlannedPath& path, const Look& look) const;

  std::shared_ptr<const AspectMap> map_;
  std::vector<Cusp> cusps_;
  MapSegments segments_;
};

/// A sentence about the result of `followed_noise`.
std::string noise_text(double noise);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_PLAN_AROUND_CUSP_H
