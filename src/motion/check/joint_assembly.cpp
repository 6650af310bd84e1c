// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/joint_assembly.h"

#include "interval/path_form.h"
#include "legs/link_points.h"
#include "legs/spatial_leg.h"
#include "model/message_text.h"
#include "motion/check/check_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "tracking/assembly_modes.h"
#include "tracking/continuation.h"
#include "tracking/leg_enclosure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double full_turn = 2.0 * static_cast<double>(EIGEN_PI);
constexpr int most_steps = 1000;  // from the stated pose to the first waypoint

/// How far the nearest joint value that the pose asks for is off `q`, modulo whole turns; infinite where the
/// leg does not reach.
double misfit(const Leg& leg, const Pose& pose, double q) {
  double least = std::numeric_limits<double>::infinity();
  for (const int sign : {1, -1}) {
    if (!leg.has_branch(sign)) continue;
    const double off = joint_value(leg, pose.transform(leg.anchor), sign) - q;
    const double turned = leg.actuated_by_angle() ? std::remainder(off, full_turn) : off;
    if (std::abs(turned) < std::abs(least)) least = turned;
  }
  return least;
}

/// From the stated pose the platform is followed to the first waypoint, so that no other assembly mode is
/// taken.
bool follow_to_start(const Manipulator& manipulator, const PoseCertifier& certifier, const Pose& pose,
                     const JointVector& q, CertifiedPoint& point) {
  JointVector at = q;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    at[k] += misfit(manipulator.leg(j), pose, q[k]);
  }
  CertifiedPoint from;
  if (!at.allFinite() || !certify_solution(certifier, pose, at, from)) return false;
  Continuation way(certifier, from, q);
  if (way.run(most_steps) != ContinuationStatus::finished) return false;
  point = way.at();
  return true;
}

std::string problem_of(const Candidates& candidates, const std::vector<std::size_t>& possible) {
  if (possible.empty())
    return "The robot is not found to assemble at the first waypoint; correct its joint values.";
  if (possible.size() > 1)
    return "The first waypoint has " + std::to_string(possible.size()) + " assembly modes; state which.";
  if (candidates.complete() && candidates[possible.front()].followed) return "";
  return "The first waypoint is too near to det A = 0 to know the assembly mode; state the start pose.";
}

}  // namespace

bool is_near_start(const Manipulator& manipulator, std::size_t leg, double off) noexcept {
  const double unit = manipulator.leg(leg).actuated_by_angle() ? 1.0 : manipulator.size();
  return std::abs(off) <= start_tolerance * unit;
}

int telling_sign(const std::vector<PossibleStart>& starts, std::size_t which) noexcept {
  const int sign = starts[which].determinant_sign;
  const auto fitting = std::count_if(starts.begin(), starts.end(), [sign](const PossibleStart& each) {
    return each.determinant_sign != -sign;
  });
  return fitting == 1 ? sign : 0;
}

StartAssembly find_start(const Manipulator& manipulator, const PoseCertifier& certifier, const JointVector& q,
                         const TrajectoryStart& start) {
  StartAssembly found;
  if (start.pose) {
    if (!follow_to_start(manipulator, certifier, *start.pose, q, found.point))
      found.problem =
          "The first waypoint is not proved to belong to the start pose: it is too near to det A = 0; start "
          "farther from it.";
  } else {
    Candidates candidates;
    candidates.find(manipulator, certifier, q);
    std::vector<std::size_t> possible;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (start.determinant_sign == 0 || candidates[i].determinant_sign != -start.determinant_sign)
        possible.push_back(i);
    found.problem = problem_of(candidates, possible);
    if (found.problem.empty()) found.point = candidates[possible.front()].point;
    for (const std::size_t i : possible)
      found.possible.push_back({candidates[i].point.pose, candidates[i].determinant_sign});
  }
  if (found.problem.empty()) {
    found.problem = missed_at_start(manipulator, found.point.pose, q);
    found.possible.clear();
  }
  return found;
}

std::string start_misfit(const Manipulator& manipulator, const JointVector& q, const TrajectoryStart& start) {
  if (!start.pose) return "";
  if (!start.pose->position.allFinite() || !start.pose->orientation.coeffs().allFinite())
    return "The start pose has a number that is not finite; correct it.";
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const double off = misfit(leg, *start.pose, q[static_cast<Eigen::Index>(j)]);
    if (!is_near_start(manipulator, j, off))
      return "The start pose does not fit the first waypoint: joint '" + leg.actuated_joint + "' is off by " +
             number_text(std::abs(off)) + (leg.actuated_by_angle() ? " rad" : " m") +
             "; correct one of the two.";
  }
  return "";
}

namespace {

/// The sphere on which a leg keeps the operational point: |X - center|^2 = squared_radius.
struct Sphere {
  IntervalVector center;
  Interval squared_radius;
};

/// With the platform at the origin, the vector from proximal point to anchor is u = -center. The deviation of
/// `q` from its middle moves the center at most with the speed of the proximal point, and changes rho^2 at
/// most as 2 B_jj does.
Sphere sphere_of(const Leg& leg, const Interval& q) {
  const LegForm form(leg);
  const double middle = 0.5 * (q.lower() + q.upper());
  const double off = magnitude(q - Interval(middle));
  const LegEnclosure at = form.enclose(EnclosedPose{}, middle);
  const double moved = form.point_speed() * off;
  const Interval squared_distance = squared_norm(at.u);
  const double rod = square_root(squared_distance).upper() + moved;
  const double grown = 2.0 * off * (magnitude(at.inverse_diagonal) + form.joint_curvature(rod) * off);
  Sphere sphere;
  for (std::size_t i = 0; i < 3; ++i) sphere.center[i] = Interval(-moved, moved) - at.u[i];
  sphere.squared_radius = squared_distance - Interval(2.0) * at.half_residual + Interval(-grown, grown);
  return sphere;
}

/// The section of a sphere with the line or plane that the operational point stays in.
Sphere section(Sphere sphere, std::size_t moved) {
  for (std::size_t i = moved; i < 3; ++i) {
    sphere.squared_radius = sphere.squared_radius - square(sphere.center[i]);
    sphere.center[i] = Interval(0.0);
  }
  return sphere;
}

/// Of the center of another sphere from the first, e, and of e.Y for a common point that is Y from the first
/// center.
struct Direction {
  IntervalVector e;
  Interval product;
};

Direction direction(const Sphere& first, const Sphere& other) {
  const IntervalVector e = other.center - first.center;
  return {e, Interval(0.5) * (dot(e, e) + first.squared_radius - other.squared_radius)};
}

}  // namespace

// For a common point Y the Gram determinant of Y and the directions is not negative, with |Y|^2 the squared
// radius of the first sphere.
bool proved_unassembled(const Manipulator& manipulator, const std::array<Interval, max_legs>& q) noexcept {
  assert_rounding_upward();
  if (has_rotation(manipulator.task_space())) return false;
  const std::size_t n = manipulator.leg_count();
  std::array<Sphere, 3> spheres;
  for (std::size_t j = 0; j < n; ++j) spheres[j] = section(sphere_of(manipulator.leg(j), q[j]), n);
  const Interval& squared = spheres[0].squared_radius;
  if (n == 1) return squared.negative();
  const Direction a = direction(spheres[0], spheres[1]);
  if (n == 2) return (squared * dot(a.e, a.e) - square(a.product)).negative();
  const Direction b = direction(spheres[0], spheres[2]);
  const Interval aa = dot(a.e, a.e), bb = dot(b.e, b.e), ab = dot(a.e, b.e);
  const Interval gram = aa * bb - square(ab);
  const Interval least =
      square(a.product) * bb - Interval(2.0) * (a.product * b.product) * ab + square(b.product) * aa;
  return (squared * gram - least).negative();
}

}  // namespace parallel_aspects
