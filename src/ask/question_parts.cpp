// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"

#include "model/message_text.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects::ask {
namespace {

std::string text_of(const NamedRange& range) {
  return "'" + range.name + "=" + number_text(range.lower) + ":" + number_text(range.upper) + "'";
}

}  // namespace

bool has_map(const std::optional<MapSlice>& slice, const Manipulator& robot) noexcept {
  return slice || robot.task_space() != TaskSpace::SE3;
}

void check_sources(bool has_map, const MapSource& map, const RoadmapSource& roadmap, ProblemList& problems) {
  if (!has_map && !map.is_default())
    problems.push_back({ProblemKind::robot, "resolution",
                        "{resolution}, {load} and {save} are for maps, and in SE3 only slices have these",
                        "give {slice}, or leave them out"});
  if (has_map && !roadmap.is_default())
    problems.push_back({ProblemKind::robot, "samples",
                        "{samples} and {seed} are for roadmaps, in SE3 without {slice}", "leave them out"});
}

std::string counted(std::size_t number, const std::string& noun, const std::string& plural) {
  const std::string several = plural.empty() ? noun + "s" : plural;
  return std::to_string(number) + ' ' + (number == 1 ? noun : several);
}

NamedValues margins_of(const Margins& margins) {
  NamedValues values;
  for (const NamedMargin& each : named_margins)
    if (margins.*each.member > 0.0) values.emplace_back(each.name, margins.*each.member);
  return values;
}

std::vector<NamedRange> ranges_of(const std::vector<std::string>& names, const Box& box) {
  std::vector<NamedRange> ranges;
  for (std::size_t i = 0; i < box.dimension; ++i) ranges.push_back({names[i], box.lower[i], box.upper[i]});
  return ranges;
}

std::string example_of_ranges(const std::vector<std::string>& names) {
  std::string text;
  bool has_angle = false;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : " ") + name + "=-1:1";
    has_angle = has_angle || (name != "x" && name != "y" && name != "z");
  }
  return "\"" + text + (has_angle ? "\", in m and rad" : "\", in m");
}

Box box_of(const std::string& field, const std::vector<std::string>& names,
           const std::vector<NamedRange>& ranges, ProblemList& problems) {
  Box box{names.size(), {}, {}};
  std::vector<bool> given(names.size(), false);
  const auto refuse = [&](const std::string& fault, const std::string& remedy) {
    problems.push_back({ProblemKind::value, field, "{" + field + "} " + fault, remedy});
  };
  const std::string example = "give " + example_of_ranges(names);
  for (const NamedRange& range : ranges) {
    const auto name = std::find(names.begin(), names.end(), range.name);
    if (name == names.end()) {
      refuse("has " + text_of(range), example);
      continue;
    }
    const auto i = static_cast<std::size_t>(name - names.begin());
    if (given[i]) refuse("names " + *name + " twice", "give one range");
    given[i] = true;
    if (!std::isfinite(range.lower) || !std::isfinite(range.upper))
      refuse("has " + text_of(range) + ", which is not finite", example);
    else if (!(range.lower < range.upper))
      refuse("has " + text_of(range) + ", whose lower end is not below the upper", example);
    box.lower[i] = range.lower;
    box.upper[i] = range.upper;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!given[i]) refuse("does not say where " + names[i] + " may be", example);
  return box;
}

namespace {

/// The orientation of the slice that is nearest: of a turn from the held one, the part about the axis.
Eigen::Quaterniond nearest_about_axis(const MapSlice& slice, const Eigen::Quaterniond& orientation) {
  constexpr double rounding = 1e-9;  // as maps of slices allow [rad]
  const Eigen::Vector3d axis = slice.axis.normalized();
  const Eigen::Quaterniond turn = orientation * slice.held.orientation.conjugate();
  const double along = turn.vec().dot(axis);
  if ((turn.vec() - along * axis).norm() <= rounding) return orientation;
  return Eigen::AngleAxisd(2.0 * std::atan2(along, turn.w()), axis) * slice.held.orientation;
}

Pose nearest_of(const MapSlice& slice, const Manipulator& robot, const Pose& pose) {
  if (slice.joint) return circle_of_anchor(robot, *slice.joint).nearest(pose);
  Pose nearest = pose;
  for (std::size_t i = 0; i < slice.moves.size(); ++i)
    if (!slice.moves[i])
      nearest.position[static_cast<Eigen::Index>(i)] = slice.held.position[static_cast<Eigen::Index>(i)];
  if (slice.rotation == MapSlice::Rotation::none) nearest.orientation = slice.held.orientation;
  if (slice.rotation == MapSlice::Rotation::about_axis)
    nearest.orientation = nearest_about_axis(slice, pose.orientation);
  return nearest;
}

double distance_to(const MapSlice& slice, const Manipulator& robot, const Pose& pose) {
  if (slice.joint) return std::abs(circle_of_anchor(robot, *slice.joint).distance(pose));
  const Pose nearest = nearest_of(slice, robot, pose);
  return std::hypot((pose.position - nearest.position).norm(),
                    robot.characteristic_length() * pose.orientation.angularDistance(nearest.orientation));
}

/// How far a pose of the slice is from it at most once its numbers are rounded as tables have them, to six
/// digits: each then differs by half a unit of the last one.
double tolerance_at(const Manipulator& robot, const Pose& pose) {
  constexpr double rounding = 5.0001e-6;  // of a number at most, and as it is rounded itself
  constexpr double largest_share = 1e-4;  // of the robot's size, however far off its frame is
  const PoseCoordinates coordinates = pose_coordinates(robot.task_space(), pose);
  const Eigen::Index moves = traits(robot.task_space()).translations;
  const double lengths = coordinates.head(moves).lpNorm<1>(),
               turned = coordinates.tail(coordinates.size() - moves).lpNorm<1>();
  // A quaternion turns by twice as much as its numbers differ, and no anchor is much farther out than this.
  const double rounded = rounding * (lengths + 2.0 * robot.characteristic_length() * turned);
  return held_joint_tolerance + std::min(rounded, largest_share * robot.size());
}

}  // namespace

double put_onto_slice(const MapSlice& slice, const Manipulator& robot, const std::string& field, Pose& pose,
                      ProblemList& problems) {
  const Pose nearest = nearest_of(slice, robot, pose);
  const double distance = distance_to(slice, robot, pose), tolerance = tolerance_at(robot, pose);
  if (!(distance <= tolerance))
    problems.push_back(
        {ProblemKind::value, field,
         "{" + field + "} lies " + number_text(distance) + " m from the slice " + given(to_string(slice)),
         "give a pose within " + number_text(tolerance, 4) + " m of it. The nearest in the task frame is \"" +
             pose_numbers(robot.task_space(), nearest, pose_digits) + "\""});
  if (distance > 0.0) pose = nearest;
  return distance;
}

namespace {

constexpr double largest_number = 1e12;  // [m or rad], as elsewhere: beyond it proofs do not reach

double distance(const Manipulator& robot, const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() +
         robot.characteristic_length() * a.orientation.angularDistance(b.orientation);
}

std::string listed(const Manipulator& robot, const JointVector& q,
                   const std::vector<AssemblyMode>& solutions) {
  std::string text;
  for (const AssemblyMode& each : solutions) {
    const auto mode = working_mode(robot, each.pose, q);
    text += (text.empty() ? "" : ", ") + to_string(robot.task_space(), each.pose) +
            (mode ? " in " + to_string(*mode) : "");
  }
  return text;
}

/// Of the assembly modes that belong to a working mode, and to the one that is asked for.
std::vector<AssemblyMode> candidates(const Manipulator& robot, const JointVector& q,
                                     const std::optional<WorkingMode>& wanted) {
  std::vector<AssemblyMode> result;
  for (const AssemblyMode& each : direct(robot, q).solutions) {
    const auto mode = each.serially_singular ? std::nullopt : working_mode(robot, each.pose, q);
    if (mode && (!wanted || *mode == *wanted)) result.push_back(each);
  }
  return result;
}

/// The end at this pose. Angles without limits keep the turn that they are given in; of one with limits there
/// is one turn in which the pose is reached.
PathEnd in_turn(const std::string& field, const Manipulator& robot, const JointVector& q, const Pose& pose,
                ProblemList& problems) {
  const std::optional<WorkingMode> mode = working_mode(robot, pose, q);
  const JointVector reached = inverse(robot, pose, mode.value()).q;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const Leg& leg = robot.leg(j);
    const auto k = static_cast<Eigen::Index>(j);
    if (leg.actuated_by_angle() && leg.limits.limited() && std::abs(q[k] - reached[k]) > EIGEN_PI)
      problems.push_back({ProblemKind::value, field,
                          "{" + field + "} has " + number_text(q[k]) + " for '" + given(leg.actuated_joint) +
                              "', whose limits are " + number_text(leg.limits.lower) + " to " +
                              number_text(leg.limits.upper) + " rad",
                          "give " + number_text(reached[k]) + ", where the leg is the same"});
  }
  return {pose, mode, q};
}

/// Where the joints assemble: next to the pose, if one is given.
PathEnd assembled(const std::string& name, const Manipulator& robot, const EndQuestion& question,
                  ProblemList& problems) {
  const JointVector& q = *question.joints;
  const std::string field = name + "_joints";
  std::vector<AssemblyMode> found = candidates(robot, q, question.mode);
  if (question.pose)
    std::sort(found.begin(), found.end(), [&](const AssemblyMode& a, const AssemblyMode& b) {
      return distance(robot, a.pose, *question.pose) < distance(robot, b.pose, *question.pose);
    });
  if (found.empty())
    problems.push_back({ProblemKind::value, field,
                        "{" + field + "} assemble in no pose" +
                            (question.mode ? " in the working mode " + to_string(*question.mode) : ""),
                        "give values that have a direct solution"});
  else if (found.size() > 1 && !question.pose)
    problems.push_back({ProblemKind::value, field,
                        "{" + field + "} assemble in several poses: " + listed(robot, q, found),
                        "say with {" + name + "} which one is meant"});
  else
    return in_turn(field, robot, q, found.front().pose, problems);
  return {};
}

void refuse_beyond(const std::string& field, double value, ProblemList& problems) {
  if (!(std::abs(value) <= largest_number))
    problems.push_back({ProblemKind::value, field,
                        "{" + field + "} has " + number_text(value) + ", but numbers reach to " +
                            number_text(largest_number) + " m or rad",
                        "give a smaller one"});
}

void refuse_beyond(const std::string& name, const EndQuestion& question, ProblemList& problems) {
  if (question.joints)
    for (Eigen::Index j = 0; j < question.joints->size(); ++j)
      refuse_beyond(name + "_joints", (*question.joints)[j], problems);
  if (question.pose)
    for (int i = 0; i < 3; ++i) refuse_beyond(name, question.pose->position[i], problems);
}

}  // namespace

PathEnd path_end(const std::string& field, const Manipulator& robot, const EndQuestion& question,
                 ProblemList& problems) {
  const std::size_t known = problems.size();
  if (question.tracked) return *question.tracked;
  if (question.aspect && (question.pose || question.mode || question.joints))
    problems.push_back({ProblemKind::together, field + "_aspect",
                        "{" + field + "_aspect} determines pose and working mode",
                        "leave out {" + field + "}, {" + field + "_mode} and {" + field + "_joints}"});
  if (question.aspect) return {};
  if (!question.pose && !question.joints)
    problems.push_back({ProblemKind::missing, field, "{" + field + "} is required",
                        "give a pose, or {" + field + "_joints}, or {" + field + "_aspect}"});
  refuse_beyond(field, question, problems);
  if (problems.size() > known) return {};
  if (question.joints) return assembled(field, robot, question, problems);
  return {*question.pose, question.mode, {}};
}

void place_in_aspect(const std::string& field, const AspectMap& map, const EndQuestion& question,
                     PathEnd& end, ProblemList& problems) {
  if (!question.aspect) return;
  const std::size_t count = map.aspects().size();
  const unsigned id = question.aspect->value;
  if (id > count) {
    const std::string name = field + "_aspect";
    problems.push_back(
        {ProblemKind::value, name, "{" + name + "} is " + std::to_string(id),
         count == 0 ? "the map has no aspect" : "the map has the aspects 1 to " + std::to_string(count)});
    return;
  }
  const Aspect& aspect = map.aspects()[id - 1];
  end = {aspect.deepest, aspect.mode, {}};
}

JointColumns::JointColumns(const Manipulator& robot, const std::vector<std::string>& names, std::string what,
                           Problems& problems)
    : what_(std::move(what)), count_(names.size()) {
  std::vector<std::string> actuated;
  for (const Leg& leg : robot.legs()) actuated.push_back(leg.actuated_joint);
  // First, since a face may tell the first problem alone, and a joint that is misspelt is missing, too.
  for (const std::string& name : names)
    if (!contains(actuated, name))
      problems.push_back(what_ + " has the unknown joint '" + name + "'" + suggestion(name, actuated, {}));
  for (const std::string& joint : actuated) {
    const auto found = std::find(names.begin(), names.end(), joint);
    columns_.push_back(static_cast<std::size_t>(found - names.begin()));
    if (std::count(names.begin(), names.end(), joint) != 1)
      problems.push_back(what_ + " does not have the joint '" + joint + "' once; name every actuated joint.");
  }
}

JointVector JointColumns::ordered(const std::vector<double>& values, const std::string& where,
                                  Problems& problems) const {
  if (values.empty()) return {};
  JointVector result = JointVector::Zero(static_cast<Eigen::Index>(columns_.size()));
  if (values.size() != count_)
    problems.push_back(what_ + " has " + std::to_string(values.size()) + " numbers in " + where +
                       "; give one a joint.");
  else
    for (std::size_t j = 0; j < columns_.size(); ++j)
      result[static_cast<Eigen::Index>(j)] = values[columns_[j]];
  return result;
}

}  // namespace parallel_aspects::ask
