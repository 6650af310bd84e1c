// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "urdf/corrections/edits.h"
#include "urdf/description/xml_values.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double shortest_that_is_meant =
    1.0 / 150.0;  // of slides of a robot that loads: piezo stages have 1/100

constexpr double most_radians = 6.9;           // that somebody writes for an angle: a turn and a tenth
constexpr double most_turns = 6.0 * EIGEN_PI;  // of round angles that are computed, as 3 turns
constexpr double same_angle = 1e-6;            // to which angles are written [rad]
constexpr double rounded_angle = 2e-4;         // by four digits or more [rad]
constexpr double radians_of_degree = EIGEN_PI / 180.0, five_degrees = 5.0 * radians_of_degree;
constexpr int max_half_degrees = 2 * 360;  // a turn

// The farther of two limits, or nothing where there are none.
std::optional<double> farther_limit(const JointLimits& limits) {
  const double lower = std::abs(limits.lower), upper = std::abs(limits.upper);
  return std::isfinite(lower) && std::isfinite(upper) ? std::optional<double>(std::max(lower, upper))
                                                      : std::nullopt;
}

// Of slides: in millimetres where the robot is in metres, or the other way round.
Edits metres_for_limits(const Subject& s, const LoopJoints& joints, bool too_long, double shortest) {
  std::vector<Change> changes;
  std::vector<std::string> names;
  const double metres = too_long ? millimetre : 1.0 / millimetre;
  for (const std::size_t joint : joints.all()) {
    const TreeJoint& slide = s.tree.joints[joint];
    const double farther = farther_limit(slide.limits).value_or(0.0);
    const bool is_out = too_long ? farther > out_of_scale * s.size() : farther < shortest * s.size();
    if (slide.motion != JointMotion::prismatic || farther == 0.0 || !is_out) continue;
    changes.emplace_back(LimitsChange{joint, metres * slide.limits.lower, metres * slide.limits.upper});
    names.push_back(slide.name);
  }
  if (changes.empty()) return {};
  return {edit_of(s,
                  s.files.urdf + " is " + number_text(s.size(), 3) + " m wide, but has limits of slides, " +
                      listed_names(names) + (too_long ? ", as if in millimetres" : ", as if divided by 1000"),
                  std::move(changes), true)};
}

Edits metres_for_lengths(const Subject& s) {
  std::vector<Change> changes;
  for (std::size_t k = 0; k < s.tree.joints.size(); ++k)
    if (const Eigen::Vector3d place = s.tree.joints[k].origin.translation(); !place.isZero(0.0))
      changes.emplace_back(OriginChange{k, millimetre * place, std::nullopt});
  const std::size_t count = changes.size();
  if (count == 0) return {};
  Edit edit = edit_of(s, s.files.urdf + " is " + number_text(s.size(), 3) + " m wide, as if in millimetres",
                      std::move(changes), true);
  if (count > 1) edit.remedy = "write a thousandth of each xyz in the origins of its joints";
  return {edit};
}

double shortest_length(const Subject& s) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const std::size_t joint : s.loops.all())
    if (const double length = s.tree.joints[joint].origin.translation().norm(); length > 0.0)
      shortest = std::min(shortest, length);
  return shortest;
}

// Of several joints that stand out, as those of one leg; of a single one among the edits of its origin. Half
// of a robot with two legs is in one of them: where it is wide as none is, the short lengths are those that
// are meant.
Edits metres_for_origins(const Subject& s) {
  const double usual = s.size() > widest_robot ? shortest_length(s) : s.loops.usual_length();
  std::vector<Change> changes;
  std::vector<std::string> names;
  for (const std::size_t joint : s.loops.all()) {
    const Eigen::Vector3d place = s.tree.joints[joint].origin.translation();
    if (!(usual > 0.0 && place.norm() > out_of_scale * usual)) continue;
    changes.emplace_back(OriginChange{joint, millimetre * place, std::nullopt});
    names.push_back(s.tree.joints[joint].name);
  }
  if (changes.size() < 2) return {};
  return {edit_of(s,
                  s.files.urdf + " has origins of joints far beyond the others, " + listed_names(names) +
                      ", as if in millimetres",
                  std::move(changes), true)};
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

// One for all, as who writes degrees does so throughout: as few as can be no radians, and else whole numbers
// beside these, too.
Edits radians_for_joints(const Subject& s, const LoopJoints& joints, bool with_whole) {
  std::vector<Change> changes;
  std::string names;
  bool any_whole = false;
  for (const std::size_t joint : joints.all()) {
    const auto& written = s.tree.joints[joint].wide_angles;
    const auto few = written ? as_if_in_degrees(*written, false) : std::nullopt;
    if (!few) continue;
    const auto whole = with_whole ? as_if_in_degrees(*written, true) : std::nullopt;
    any_whole = any_whole || whole;
    changes.emplace_back(OriginChange{joint, std::nullopt, whole.value_or(*few).radians});
    names += (names.empty() ? "" : ", ") + s.joint(joint) + " by rpy " + in_brackets(*written);
  }
  if (changes.empty() || any_whole != with_whole) return {};
  return {edit_of(s, s.files.urdf + " turns the origin of " + names + " rad, as if in degrees",
                  std::move(changes), true)};
}

// Of a frame beside its link. What a URDF writes has other words.
Edits radians_for_closures(const Subject& s) {
  Edits found;
  if (!s.resolved.closure_dialect.empty()) return found;
  for (std::size_t k = 0; k < s.resolved.closures.size(); ++k)
    for (const std::size_t end : {0, 1}) {
      LinkFrame frame = s.resolved.closures[k].frames[end];
      const auto angles = as_if_in_degrees(Eigen::Matrix3d(frame.in_link.linear()));
      if (!angles) continue;
      frame.in_link.linear() = rotation_of(angles->radians);
      const std::string where = " in link " + s.link(frame.link) + " of " + s.closure(k);
      found.push_back(edit_of(s,
                              s.files.config + " turns the frame" + where + " by rpy " +
                                  in_brackets(angles->written) + " rad, as if in degrees",
                              {FrameChange{k, end, frame}}, true));
      found.back().remedy = "write rpy: " + as_list(angles->radians) + where;
    }
  return found;
}

// One for all, as who writes millimetres does so throughout.
Edits metres_for_closures(const Subject& s) {
  const double usual = s.loops.usual_length();
  std::vector<Change> changes;
  std::string faults;
  for (const PlacedEnd& end : placed_ends(s.resolved.closures)) {
    if (!(usual > 0.0 && end.place.norm() > out_of_scale * usual)) continue;
    changes.emplace_back(moved(s, end, millimetre * end.place));
    faults += (faults.empty() ? " " : " and ") + place_text(s, end);
  }
  if (changes.empty()) return {};
  return {edit_of(s, s.file() + faults + ", as if in millimetres", std::move(changes), true)};
}

}  // namespace

Edits unit_edits(const Subject& subject, const LoopJoints& joints, bool loads) {
  const bool is_wide = subject.size() > widest_robot;
  const double shortest = loads ? shortest_that_is_meant : 1.0 / out_of_scale;
  Edits found = metres_for_limits(subject, joints, true, shortest);
  const auto append = [&](Edits more) { std::move(more.begin(), more.end(), std::back_inserter(found)); };
  append(is_wide ? metres_for_lengths(subject) : metres_for_limits(subject, joints, false, shortest));
  if (!loads) append(metres_for_origins(subject));
  append(radians_for_joints(subject, joints, true));
  append(radians_for_joints(subject, joints, false));
  append(radians_for_closures(subject));
  append(metres_for_closures(subject));
  return found;
}

}  // namespace parallel_aspects
