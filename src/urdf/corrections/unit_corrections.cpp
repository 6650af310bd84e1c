// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/unit_corrections.h"

#include "model/number_text.h"
#include "urdf/corrections/correction_text.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double limits_out_of_scale = 30.0;            // of limits in mm against the robot in m, at least
constexpr double shortest_that_is_meant = 1.0 / 150.0;  // of slides of a robot that loads, of its size
constexpr double millimetre = 1e-3;                     // [m]
constexpr double widest_robot = 100.0;                  // [m]; wider ones are taken for such in millimetres

constexpr double most_radians = 6.9;  // that somebody writes for an angle
constexpr double same_angle = 1e-6;   // [rad]
constexpr int max_half_degrees = 2 * 360;

// The farther of two limits, or nothing where there are none.
std::optional<double> farther_limit(const JointLimits& limits) {
  const double lower = std::abs(limits.lower), upper = std::abs(limits.upper);
  return std::isfinite(lower) && std::isfinite(upper) ? std::optional<double>(std::max(lower, upper))
                                                      : std::nullopt;
}

// In millimetres where the robot is in metres, or the other way round.
enum class Unit { millimetres, kilometres };

bool is_in(Unit unit, const JointLimits& limits, double size, double shortest) {
  const auto farther = farther_limit(limits);
  if (!farther || *farther == 0.0) return false;
  return unit == Unit::millimetres ? *farther > limits_out_of_scale * size : *farther < shortest * size;
}

std::vector<std::size_t> slides_in(Unit unit, const Tree& tree, const LoopJoints& loops, double size,
                                   double shortest) {
  std::vector<std::size_t> slides;
  for (const std::size_t joint : loops.all())
    if (tree.joints[joint].motion == JointMotion::prismatic &&
        is_in(unit, tree.joints[joint].limits, size, shortest))
      slides.push_back(joint);
  return slides;
}

Correction metres_for_limits(Unit unit, const Tree& tree, const std::vector<std::size_t>& slides, double size,
                             const SourceNames& files) {
  const double metres = unit == Unit::millimetres ? millimetre : 1.0 / millimetre;
  std::string names, remedy;
  for (const std::size_t joint : slides) {
    const JointLimits& limits = tree.joints[joint].limits;
    names += (names.empty() ? "'" : ", '") + tree.joints[joint].name + "'";
    remedy += (remedy.empty() ? "write lower=\"" : " and write lower=\"") +
              number_text(metres * limits.lower) + "\" upper=\"" + number_text(metres * limits.upper) +
              "\" for joint '" + tree.joints[joint].name + "'";
  }
  return {"limits of " + names,
          files.urdf + " is " + number_text(size, 3) + " m wide, but has limits of slides, " + names +
              (unit == Unit::millimetres ? ", as if in millimetres" : ", as if divided by 1000"),
          remedy, true, [slides, metres](Tree& changed, ResolvedConfig&) {
            for (const std::size_t joint : slides) {
              JointLimits& limits = changed.joints[joint].limits;
              limits.lower *= metres;
              limits.upper *= metres;
            }
          }};
}

// The joint whose origin alone has a length, by name.
Correction metres_for_lengths(const Tree& tree, double size, const SourceNames& files) {
  std::vector<const TreeJoint*> lengths;
  for (const TreeJoint& joint : tree.joints)
    if (!joint.origin.translation().isZero(0.0)) lengths.push_back(&joint);
  const bool is_one = lengths.size() == 1;
  const std::string element = is_one ? "joint '" + lengths.front()->name + "'" : "lengths";
  return {element, files.urdf + " is " + number_text(size, 3) + " m wide, as if in millimetres",
          is_one ? "write xyz=\"" + as_attribute(millimetre * lengths.front()->origin.translation()) +
                       "\" in the origin of " + element
                 : "write a thousandth of each xyz in the origins of its joints",
          true, [](Tree& changed, ResolvedConfig&) {
            for (TreeJoint& joint : changed.joints) joint.origin.translation() *= millimetre;
          }};
}

// The degrees, in halves, that an angle read as radians came of; small ones may be radians.
std::optional<double> degrees_of(double radians) {
  if (std::abs(radians) < same_angle) return 0.0;
  for (int halves = -max_half_degrees; halves <= max_half_degrees; ++halves) {
    const double degrees = 0.5 * halves;
    if (std::abs(degrees) > most_radians &&
        std::abs(std::remainder(degrees - radians, 2.0 * EIGEN_PI)) < same_angle)
      return degrees;
  }
  return std::nullopt;
}

// Nothing where some are not, or all are zero. One rotation has two sets of angles.
std::optional<Eigen::Vector3d> as_if_in_degrees(const Eigen::Vector3d& angles) {
  if (angles.norm() < same_angle) return std::nullopt;
  const Eigen::Vector3d others(angles.x() + EIGEN_PI, EIGEN_PI - angles.y(), angles.z() + EIGEN_PI);
  for (const Eigen::Vector3d& radians : {angles, others}) {
    Eigen::Vector3d degrees = Eigen::Vector3d::Zero();
    bool all = true;
    for (Eigen::Index k = 0; k < 3 && all; ++k) {
      const auto found = degrees_of(std::remainder(radians[k], 2.0 * EIGEN_PI));
      all = all && found;
      degrees[k] = found.value_or(0.0);
    }
    if (all && !degrees.isZero(0.0)) return degrees;
  }
  return std::nullopt;
}

struct Turned {
  std::size_t joint;        // of the tree
  Eigen::Vector3d degrees;  // roll, pitch and yaw that were read as radians
};

// One for all, as who writes degrees does so throughout.
Correction radians_for_angles(const Tree& tree, const std::vector<Turned>& all, const SourceNames& files) {
  std::string names, remedy;
  for (const Turned& turned : all) {
    const std::string name = "joint '" + tree.joints[turned.joint].name + "'";
    names += (names.empty() ? "" : ", ") + name + " by rpy " + in_brackets(turned.degrees);
    remedy += (remedy.empty() ? "write rpy=\"" : " and write rpy=\"") +
              as_attribute(turned.degrees * EIGEN_PI / 180.0) + "\" in the origin of " + name;
  }
  const bool is_one = all.size() == 1;
  return {is_one ? "joint '" + tree.joints[all.front().joint].name + "'" : "angles",
          files.urdf + " turns the origin of " + names + " rad, as if in degrees", remedy, true,
          [all](Tree& changed, ResolvedConfig&) {
            for (const Turned& turned : all)
              changed.joints[turned.joint].origin.linear() = rotation_of(turned.degrees * EIGEN_PI / 180.0);
          }};
}

std::vector<Turned> turned_in_degrees(const Tree& tree, const LoopJoints& loops) {
  std::vector<Turned> turned;
  for (const std::size_t joint : loops.all()) {
    const TreeJoint& of = tree.joints[joint];
    const auto degrees =
        of.wide_angles ? of.wide_angles : as_if_in_degrees(roll_pitch_yaw(of.origin.linear()));
    if (degrees) turned.push_back({joint, *degrees});
  }
  return turned;
}

// Of a frame beside its link. What a URDF writes has other words.
Corrections radians_for_closures(const Tree& tree, const ResolvedConfig& resolved, const SourceNames& files) {
  Corrections found;
  if (!resolved.closure_dialect.empty()) return found;
  for (std::size_t k = 0; k < resolved.closures.size(); ++k)
    for (const std::size_t end : {0, 1}) {
      const Closure& closure = resolved.closures[k];
      const LinkFrame& frame = closure.frames[end];
      const auto degrees = as_if_in_degrees(roll_pitch_yaw(frame.in_link.linear()));
      if (!degrees) continue;
      const std::string element = "closure '" + closure.name + "'";
      const Eigen::Vector3d radians = *degrees * EIGEN_PI / 180.0;
      found.push_back(
          {element,
           files.config + " turns the frame in link '" + tree.links[frame.link] + "' of " + element +
               " by rpy " + in_brackets(*degrees) + " rad, as if in degrees",
           "write rpy: " + as_list(radians) + " in link '" + tree.links[frame.link] + "' of " + element, true,
           [k, end, radians](Tree&, ResolvedConfig& changed) {
             changed.closures[k].frames[end].in_link.linear() = rotation_of(radians);
           }});
    }
  return found;
}

// `shortest`: of the slides, of the size of the robot.
Corrections all_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                            double size, const SourceNames& files, double shortest) {
  Corrections found;
  for (const Unit unit : {Unit::millimetres, Unit::kilometres}) {
    if (unit == Unit::kilometres && size > widest_robot) continue;
    const std::vector<std::size_t> slides = slides_in(unit, tree, loops, size, shortest);
    if (!slides.empty()) found.push_back(metres_for_limits(unit, tree, slides, size, files));
  }
  if (size > widest_robot) found.push_back(metres_for_lengths(tree, size, files));
  const std::vector<Turned> turned = turned_in_degrees(tree, loops);
  if (!turned.empty()) found.push_back(radians_for_angles(tree, turned, files));
  for (Correction& correction : radians_for_closures(tree, resolved, files))
    found.push_back(std::move(correction));
  return found;
}

}  // namespace

Corrections unit_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                             double size, const SourceNames& files) {
  return all_corrections(tree, resolved, loops, size, files, 1.0 / limits_out_of_scale);
}

std::vector<std::string> unit_notes(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                                    double size, const SourceNames& files) {
  std::vector<std::string> notes;
  for (const Correction& correction :
       all_corrections(tree, resolved, loops, size, files, shortest_that_is_meant))
    notes.push_back(correction.fault + "; if so, " + correction.remedy + ".");
  return notes;
}

}  // namespace parallel_aspects
