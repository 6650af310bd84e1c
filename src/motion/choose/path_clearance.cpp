// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/path_clearance.h"

#include "motion/choose/path_pieces.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace parallel_aspects {
namespace {

constexpr double aimed_gap = 0.05;

/// What rounding may take from a length; a few thousand times what it does.
constexpr double rounding = 1e-12;

/// No less than how far the platform gets from either end, in the metric, anywhere on a segment: the
/// orientation turns by no more than the angle between both ends, as quaternions of one great circle do.
double largest_motion(double anchor_radius, const Pose& from, const Pose& to) {
  const double angle = 2.0 * std::atan2((from.orientation.conjugate() * to.orientation).vec().norm(),
                                        std::abs(from.orientation.dot(to.orientation)));
  return ((to.position - from.position).norm() + anchor_radius * angle) * (1.0 + rounding);
}

double radius_of_anchors(const Manipulator& manipulator) {
  double sum = 0.0;
  for (const Leg& leg : manipulator.legs()) sum += leg.anchor.squaredNorm();
  return std::sqrt(sum / static_cast<double>(manipulator.leg_count()));
}

struct Measured {
  PoseWaypoint at;
  double distance = 0.0;  // proved
};

/// Part of a segment of the path, and what is proved to be the least distance in it, where it is not
/// negative.
struct Piece {
  Measured from, to;
  double bound = 0.0;

  bool operator<(const Piece& other) const { return bound > other.bound; }  // the nearest comes first
};

class Clearance {
 public:
  Clearance(BoundaryDistanceMeter& meter, const Manipulator& manipulator, const WorkingMode& mode)
      : meter_(meter), mode_(mode), anchor_radius_(radius_of_anchors(manipulator)) {}

  PathClearance run(const std::vector<PoseWaypoint>& waypoints, int measures) {
    Measured last = measure(waypoints.front());
    if (waypoints.size() == 1) add(last, last);
    for (std::size_t i = 1; i < waypoints.size(); ++i) {
      const Measured next = measure(waypoints[i]);
      add(last, next);
      last = next;
    }
    while (least_.measures < static_cast<std::size_t>(measures) && is_open(pieces_.top())) halve();
    least_.lower = std::max(0.0, pieces_.top().bound);
    return least_;
  }

 private:
  bool is_open(const Piece& piece) const { return piece.bound < (1.0 - aimed_gap) * least_.measured; }

  Measured measure(const PoseWaypoint& at) {
    const BoundaryDistances found = meter_.measure(at.pose, mode_);
    const bool serial = found.serial.lower < found.parallel.lower;
    const BoundaryDistance& nearest = serial ? found.serial : found.parallel;
    ++least_.measures;
    if (nearest.lower < least_.measured) {
      least_.measured = nearest.lower;
      least_.time = at.time;
      least_.serial = serial;
      least_.leg = serial ? nearest.leg : 0;
    }
    return {at, nearest.lower};
  }

  void add(const Measured& from, const Measured& to) {
    const double motion = largest_motion(anchor_radius_, from.at.pose, to.at.pose);
    const double bound = 0.5 * (1.0 - rounding) * (from.distance + to.distance - motion);
    pieces_.push({from, to, std::min({bound, from.distance, to.distance})});
  }

  void halve() {
    const Piece piece = pieces_.top();
    pieces_.pop();
    const Measured middle = measure(waypoint_between({piece.from.at, piece.to.at}, 0, 0.5));
    add(piece.from, middle);
    add(middle, piece.to);
  }

  BoundaryDistanceMeter& meter_;
  const WorkingMode& mode_;
  double anchor_radius_;
  PathClearance least_;
  std::priority_queue<Piece> pieces_;
};

}  // namespace

PathClearance measure_clearance(BoundaryDistanceMeter& meter, const Manipulator& manipulator,
                                const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode,
                                int measures) {
  return Clearance(meter, manipulator, mode).run(waypoints, measures);
}

}  // namespace parallel_aspects
