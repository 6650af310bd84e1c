// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/path_measures.h"

#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace parallel_aspects {

PoseWaypoint waypoint_between(const Motions& motions, const std::vector<PoseWaypoint>& waypoints,
                              std::size_t segment, double share) {
  const PoseWaypoint &from = waypoints[segment], &to = waypoints[segment + 1];
  return {from.time + share * (to.time - from.time), pose_between(motions, from.pose, to.pose, share)};
}

std::vector<PoseWaypoint> divided_path(const Motions& motions, const std::vector<PoseWaypoint>& waypoints,
                                       std::size_t pieces) {
  std::vector<PoseWaypoint> divided;
  const std::size_t segments = waypoints.size() - 1;
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t parts = 1 + (pieces - 1) / segments;
    divided.push_back(waypoints[i]);
    for (std::size_t k = 1; k < parts; ++k)
      divided.push_back(
          waypoint_between(motions, waypoints, i, static_cast<double>(k) / static_cast<double>(parts)));
  }
  divided.push_back(waypoints.back());
  return divided;
}

namespace {

constexpr std::size_t samples = 400;

}  // namespace

int rank(TrajectoryAnswer answer) noexcept {
  return answer == TrajectoryAnswer::safe ? 0 : answer == TrajectoryAnswer::unknown ? 1 : 2;
}

PathEffort effort_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     const WorkingMode& mode) {
  PathEffort effort{std::vector<double>(manipulator.leg_count(), 0.0), 0.0};
  JointVector last;
  for (const PoseWaypoint& waypoint : divided_path(manipulator.motions(), waypoints, samples)) {
    const JointVector q = inverse(manipulator, waypoint.pose, mode).q;
    if (last.size() > 0) {
      const JointVector change = joint_change(manipulator, last, q).cwiseAbs();
      double time = 0.0;
      for (std::size_t j = 0; j < effort.travel.size(); ++j) {
        const double moved = change[static_cast<Eigen::Index>(j)];
        effort.travel[j] += moved;
        time = std::max(time, moved / manipulator.leg(j).limits.velocity);
      }
      effort.least_time += time;
    }
    last = q;
  }
  return effort;
}

namespace {

constexpr double aimed_gap = 0.05;

/// Allowance for the rounding of a length; a few thousand times what it needs.
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

/// A pose of the path: a share of the way from one waypoint to the next.
struct PlaceOnPath {
  std::size_t segment = 0;
  double share = 0.0;
};

struct Measured {
  PlaceOnPath place;
  double distance = 0.0;  // proved
};

/// Part of the path, and what is proved to be the least distance in it, where it is not negative.
struct Piece {
  Measured from, to;
  double bound = 0.0;

  bool operator<(const Piece& other) const { return bound > other.bound; }  // the nearest comes first
};

/// How far the platform moves along the path, at least.
class PathLengths {
 public:
  PathLengths(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints) : sums_{0.0} {
    const double radius = radius_of_anchors(manipulator);
    for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
      sums_.push_back(sums_.back() + largest_motion(radius, waypoints[i].pose, waypoints[i + 1].pose));
  }

  /// Within one segment its share; over several all of them, with what sums of so many are off by.
  double between(const PlaceOnPath& from, const PlaceOnPath& to) const {
    if (from.segment == to.segment) return (to.share - from.share) * of(from.segment) + slack();
    return at(to) - at(from) + slack();
  }

  /// In the middle of a segment, or at the waypoint nearest to half of the length.
  PlaceOnPath middle(const PlaceOnPath& from, const PlaceOnPath& to) const {
    const std::size_t last = to.share > 0.0 ? to.segment : to.segment - 1;
    if (last == from.segment) return {last, 0.5 * (from.share + (to.segment == last ? to.share : 1.0))};
    const double half = 0.5 * (at(from) + at(to));
    const auto found = std::lower_bound(sums_.begin(), sums_.end(), half) - sums_.begin();
    return {std::clamp(static_cast<std::size_t>(found), from.segment + 1, last), 0.0};
  }

  /// The last waypoint.
  PlaceOnPath end() const { return {sums_.size() - 1, 0.0}; }

 private:
  double of(std::size_t segment) const {
    return segment + 1 < sums_.size() ? sums_[segment + 1] - sums_[segment] : 0.0;
  }
  double at(const PlaceOnPath& place) const { return sums_[place.segment] + place.share * of(place.segment); }
  double slack() const { return 0x1p-50 * static_cast<double>(sums_.size()) * sums_.back(); }

  std::vector<double> sums_;  // to each waypoint
};

class Clearance {
 public:
  Clearance(BoundaryDistanceMeter& meter, const Manipulator& manipulator,
            const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode)
      : meter_(meter),
        motions_(manipulator.motions()),
        waypoints_(waypoints),
        mode_(mode),
        lengths_(manipulator, waypoints) {}

  PathClearance run(int measures, const MapControl& control) {
    const Measured first = measure({});
    add(first, waypoints_.size() == 1 ? first : measure(lengths_.end()));
    while (least_.measures < static_cast<std::size_t>(measures) && is_open(pieces_.top()) &&
           !is_cancelled(control))
      halve();
    least_.lower = std::max(0.0, pieces_.top().bound);
    return least_;
  }

 private:
  bool is_open(const Piece& piece) const { return piece.bound < (1.0 - aimed_gap) * least_.measured; }

  PoseWaypoint waypoint(const PlaceOnPath& place) const {
    return place.share > 0.0 ? waypoint_between(motions_, waypoints_, place.segment, place.share)
                             : waypoints_[place.segment];
  }

  Measured measure(const PlaceOnPath& place) {
    const PoseWaypoint at = waypoint(place);
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
    return {place, nearest.lower};
  }

  void add(const Measured& from, const Measured& to) {
    const double motion = lengths_.between(from.place, to.place);
    const double bound = 0.5 * (1.0 - rounding) * (from.distance + to.distance - motion);
    pieces_.push({from, to, std::min({bound, from.distance, to.distance})});
  }

  void halve() {
    const Piece piece = pieces_.top();
    pieces_.pop();
    const Measured middle = measure(lengths_.middle(piece.from.place, piece.to.place));
    add(piece.from, middle);
    add(middle, piece.to);
  }

  BoundaryDistanceMeter& meter_;
  Motions motions_;
  const std::vector<PoseWaypoint>& waypoints_;
  const WorkingMode& mode_;
  PathLengths lengths_;
  PathClearance least_;
  std::priority_queue<Piece> pieces_;
};

}  // namespace

PathClearance measure_clearance(BoundaryDistanceMeter& meter, const Manipulator& manipulator,
                                const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode,
                                int measures, const MapControl& control) {
  return Clearance(meter, manipulator, waypoints, mode).run(measures, control);
}

}  // namespace parallel_aspects
