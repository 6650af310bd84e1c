// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_MAP_SEGMENTS_H
#define PARALLEL_ASPECTS_MOTION_PLAN_MAP_SEGMENTS_H

#include "aspects/tree/pose_space.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/model/pose.h"

#include <memory>
#include <vector>

namespace parallel_aspects {

/// Segments between poses of a map: as `pose_between` says, or, in a slice that holds an actuated joint,
/// straight in the coordinates of the map, the shorter way round, so that they stay in the slice.
class MapSegments {
 public:
  explicit MapSegments(std::shared_ptr<const AspectMap> map);

  const SegmentCertifier& certifier() const noexcept { return certifier_; }

  /// The pose at t, 0 to 1.
  Pose between(const Pose& from, const Pose& to, double t) const;

  /// The largest angle that the segment turns by: of the platform, or of the rod that is held [rad].
  double turn(const Pose& from, const Pose& to) const;

  /// Whether the segment is proved free, with det A of this sign.
  bool is_free(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const;

  /// How much of it is proved free from its start on.
  double free_share(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const;

 private:
  /// Straight in one root box.
  struct Piece {
    MapPosition from;
    MapPoint to;
  };

  bool holds_joint() const;
  bool looks_free(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const;
  MapPoint unrolled(const MapPosition& from, const MapPosition& to) const;
  std::vector<Piece> pieces(const Pose& from, const Pose& to) const;
  bool pieces_are_free(const Pose& from, const Pose& to, const WorkingMode& mode, int sign) const;

  std::shared_ptr<const AspectMap> map_;
  SegmentCertifier certifier_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_MAP_SEGMENTS_H
