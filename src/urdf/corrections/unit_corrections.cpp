// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/unit_corrections.h"

#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "urdf/corrections/closure_end_corrections.h"
#include "urdf/corrections/correction.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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
constexpr double most_turns = 6.0 * EIGEN_PI;
constexpr double same_angle = 1e-6;     // [rad]
constexpr double rounded_angle = 2e-4;  // by four digits or more [rad]
constexpr double radians_of_degree = EIGEN_PI / 180.0, five_degrees = 5.0 * radians_of_degree;
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
  std::vector<std::string> slide_names;
  std::string remedy;
  for (const std::size_t joint : slides) {
    const JointLimits& limits = tree.joints[joint].limits;
    slide_names.push_back(tree.joints[joint].name);
    remedy += (remedy.empty() ? "write lower=\"" : " and write lower=\"") +
              number_text(metres * limits.lower) + "\" upper=\"" + number_text(metres * limits.upper) +
              "\" for joint '" + tree.joints[joint].name + "'";
  }
  const Note names = listed_names(slide_names);
  return {("limits of " + names).text(),
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

// Whether that is no angle that somebody computed in radians, as 420 degrees are.
bool is_in_degrees(double angle) {
  const bool is_round = std::abs(std::remainder(angle, five_degrees)) < rounded_angle;
  return std::abs(angle) > most_radians && !(is_round && std::abs(angle) < most_turns);
}

bool is_whole(double angle) { return angle != 0.0 && angle == std::round(angle); }

// Roll, pitch and yaw as they are written, and in radians.
struct Angles {
  Eigen::Vector3d written, radians;
};

// Each angle that can be no radians, and where `with_whole` the whole numbers beside it. Nothing where all
// may be radians.
std::optional<Angles> as_if_in_degrees(const Eigen::Vector3d& written, bool with_whole) {
  Angles angles{written, written};
  bool any = false, changes = !with_whole;
  for (double& angle : coefficients_of(angles.radians)) {
    const bool is_out = is_in_degrees(angle), goes_along = with_whole && !is_out && is_whole(angle);
    any = any || is_out;
    changes = changes || goes_along;
    if (is_out || goes_along) angle *= radians_of_degree;
  }
  return any && changes ? std::optional<Angles>(angles) : std::nullopt;
}

// The degrees, in halves, that an angle between -pi and pi came of which was read as radians; the angle
// itself where it is a round one.
double degrees_or_radians(double radians) {
  if (std::abs(std::remainder(radians, radians_of_degree)) < rounded_angle) return radians;
  for (int halves = -max_half_degrees; halves <= max_half_degrees; ++halves) {
    const double degrees = 0.5 * halves;
    if (std::abs(degrees) > most_radians &&
        std::abs(std::remainder(degrees - radians, 2.0 * EIGEN_PI)) < same_angle)
      return degrees;
  }
  return radians;
}

// One rotation has two sets of angles.
std::optional<Angles> as_if_in_degrees(const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d angles = roll_pitch_yaw(rotation);
  const Eigen::Vector3d others(angles.x() + EIGEN_PI, EIGEN_PI - angles.y(), angles.z() + EIGEN_PI);
  for (const Eigen::Vector3d& set : {angles, others}) {
    Eigen::Vector3d written;
    for (Eigen::Index k = 0; k < 3; ++k)
      written[k] = degrees_or_radians(std::remainder(set[k], 2.0 * EIGEN_PI));
    if (const auto found = as_if_in_degrees(written, false)) return found;
  }
  return std::nullopt;
}

struct Turned {
  std::size_t joint;  // of the tree
  Angles angles;
};

// One for all, as who writes degrees does so throughout.
Correction radians_for_angles(const Tree& tree, const std::vector<Turned>& all, const SourceNames& files) {
  std::string names, remedy;
  for (const auto& [joint, angles] : all) {
    const std::string name = "joint '" + tree.joints[joint].name + "'";
    names += (names.empty() ? "" : ", ") + name + " by rpy " + in_brackets(angles.written);
    remedy += (remedy.empty() ? "write rpy=\"" : " and write rpy=\"") + as_attribute(angles.radians) +
              "\" in the origin of " + name;
  }
  const bool is_one = all.size() == 1;
  return {is_one ? "joint '" + tree.joints[all.front().joint].name + "'" : "angles",
          files.urdf + " turns the origin of " + names + " rad, as if in degrees", remedy, true,
          [all](Tree& changed, ResolvedConfig&) {
            for (const auto& [joint, angles] : all)
              changed.joints[joint].origin.linear() = rotation_of(angles.radians);
          }};
}

// As few as can be no radians, and else whole numbers beside these, too.
Corrections radians_for_joints(const Tree& tree, const LoopJoints& loops, const SourceNames& files) {
  std::vector<Turned> few, with_whole;
  bool any_whole = false;
  for (const std::size_t joint : loops.all()) {
    const auto& written = tree.joints[joint].wide_angles;
    const auto angles = written ? as_if_in_degrees(*written, false) : std::nullopt;
    if (!angles) continue;
    const auto whole = as_if_in_degrees(*written, true);
    any_whole = any_whole || whole;
    few.push_back({joint, *angles});
    with_whole.push_back({joint, whole.value_or(*angles)});
  }
  Corrections found;
  if (any_whole) found.push_back(radians_for_angles(tree, with_whole, files));
  if (!few.empty()) found.push_back(radians_for_angles(tree, few, files));
  return found;
}

// Of a frame beside its link. What a URDF writes has other words.
Corrections radians_for_closures(const Tree& tree, const ResolvedConfig& resolved, const SourceNames& files) {
  Corrections found;
  if (!resolved.closure_dialect.empty()) return found;
  for (std::size_t k = 0; k < resolved.closures.size(); ++k)
    for (const std::size_t end : {0, 1}) {
      const Closure& closure = resolved.closures[k];
      const LinkFrame& frame = closure.frames[end];
      const auto angles = as_if_in_degrees(Eigen::Matrix3d(frame.in_link.linear()));
      if (!angles) continue;
      const std::string element = "closure '" + closure.name + "'";
      found.push_back({element,
                       files.config + " turns the frame in link '" + tree.links[frame.link] + "' of " +
                           element + " by rpy " + in_brackets(angles->written) + " rad, as if in degrees",
                       "write rpy: " + as_list(angles->radians) + " in link '" + tree.links[frame.link] +
                           "' of " + element,
                       true, [k, end, radians = angles->radians](Tree&, ResolvedConfig& changed) {
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
  for (Corrections& more :
       std::array{radians_for_joints(tree, loops, files), radians_for_closures(tree, resolved, files),
                  closure_unit_corrections(tree, resolved, loops, files)})
    std::move(more.begin(), more.end(), std::back_inserter(found));
  return found;
}

}  // namespace

Corrections unit_corrections(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                             double size, const SourceNames& files) {
  return all_corrections(tree, resolved, loops, size, files, 1.0 / limits_out_of_scale);
}

Corrections unit_doubts(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                        double size, const SourceNames& files) {
  return all_corrections(tree, resolved, loops, size, files, shortest_that_is_meant);
}

}  // namespace parallel_aspects
