// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_ROADMAP_PATHS_H
#define PARALLEL_ASPECTS_MOTION_PLAN_ROADMAP_PATHS_H

#include "aspects/roadmap/roadmap_growth.h"
#include "motion/plan/path_shape.h"
#include "motion/shortest_paths.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace parallel_aspects {

/// The poses of one side of a roadmap and two ends, each beside its nearest. The links of the roadmap are a
/// forest and have one path between two poses; here there are many, of which those are proved that are taken.
class PoseGraph {
 public:
  /// `segments` outlives it.
  PoseGraph(const PoseRoadmap& roadmap, const RoadmapSide& side, const Pose& from, const Pose& to,
            const SegmentsInMode& segments);

  /// Poses from the one end to the other, each segment between two proved; empty where none was found. The
  /// path is short, or keeps this parallel index at its poses where one does, else as large a one as it can.
  std::vector<Pose> find(double wanted_index);

 private:
  static constexpr std::size_t start = 0, goal = 1;

  const std::vector<std::size_t>& beside(std::size_t vertex);
  double distance(std::size_t a, std::size_t b) const { return (points_[a] - points_[b]).norm(); }
  std::vector<std::size_t> search(double wanted_index);

  const SegmentsInMode& segments_;
  std::vector<Pose> poses_;
  std::vector<AnchorPoint> points_;
  std::vector<double> indices_;
  std::vector<std::vector<std::size_t>> beside_;  // empty while not asked for
  ProvedEdges edges_;
};

/// Where one leg changes its posture. Proved: the segment from `outer` to `inner` is free in either working
/// mode, and the straight motion of the actuated joints from those at `inner` in the one mode to those in the
/// other leads back to `inner`, with det A not zero, within all constraints in both postures of the leg, and
/// of all B_jj through zeros of that of `leg` alone.
struct RoadmapGate {
  std::size_t leg = 0;
  Pose outer, inner;
};

/// The working mode in which this leg alone has the other sign.
WorkingMode with_other_posture(const WorkingMode& mode, std::size_t leg);

/// Looks for serial gates where there is no map: from poses of one side of a roadmap, and from the ends of a
/// path, towards random poses as far as the legs reach.
class RoadmapGates {
 public:
  /// The roadmap outlives it.
  explicit RoadmapGates(const PoseRoadmap& roadmap) : roadmap_(roadmap) {}

  /// Visits gates of these legs that lead out of the working mode at `from`, the nearest on the path to `to`
  /// first, until the visitor returns true; false where it never does. `sign` is that of det A.
  bool visit(const PoseInMode& from, const Pose& to, int sign, const std::vector<std::size_t>& legs,
             const std::function<bool(const RoadmapGate&)>& visitor) const;

  /// Where a leg stops reaching: a pose before, and one beyond.
  struct Candidate {
    double length = 0.0;  // of the way over it, where paths are searched for
    std::size_t leg = 0;
    Pose outer, beyond;
  };

  /// In plain floating point: where a leg first stops reaching on the straight way from the base to the
  /// target, with det A of this sign up to there; false where none does.
  bool find_end(const PoseInMode& base, const Pose& target, int sign, Candidate& found) const;

  /// Whether the gate there is proved, out of this mode; then `gate` is that.
  bool prove(const Candidate& candidate, const WorkingMode& mode, RoadmapGate& gate) const;

 private:
  std::vector<Pose> bases(const PoseInMode& from, const Pose& to, int sign) const;
  bool passes(const Pose& inner, const WorkingMode& before, const WorkingMode& after, std::size_t leg) const;

  const PoseRoadmap& roadmap_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_ROADMAP_PATHS_H
