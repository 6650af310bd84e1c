// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_ROBOT_DESCRIPTION_H
#define PARALLEL_ASPECTS_ASK_ROBOT_DESCRIPTION_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/design.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace parallel_aspects::ask {

/// What is recognised in the description of a robot, of which the session knows the mechanism. It has no
/// fields.
struct DescribeQuestion {};

/// The question has no fields.
template <class Visit>
void describe(Visit& /*visit*/, DescribeQuestion& /*question*/) {}

/// From where to where one coordinate can move away from a pose while the others stay [m or rad].
struct CoordinateRange {
  double lower = 0.0;  ///< end below it
  double upper = 0.0;  ///< end above it
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const CoordinateRange& range) {
  visit({"lower", "m or rad", "lower end"}, range.lower);
  visit({"upper", "m or rad", "upper end"}, range.upper);
}

/// Where the workspace is: what the legs reach, in any working mode, singular or not; about, not proved.
struct RobotReach {
  int drawn = 0;              ///< random poses where a flood has been
  int reached = 0;            ///< of them, those that are reached
  std::optional<Pose> from;   ///< where it began; nothing without a pose that is reached
  bool is_from_home = false;  ///< whether that is the home pose
  NamedValues lower;          ///< bounds of the operational point, over all orientations [m]
  NamedValues upper;          ///< likewise
  std::vector<std::pair<std::string, CoordinateRange>> alone;  ///< where the platform turns
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const RobotReach& reach) {
  visit({"drawn_poses", "", "that were drawn where the flood has been, or all over"}, reach.drawn);
  visit({"reached_poses", "", "of these, that are reached"}, reach.reached);
  if (!reach.from) return;
  visit({"from", "", "where the flood began"}, reach.from);
  visit({"lower", "m", "of the operational point, over all orientations"}, reach.lower);
  visit({"upper", "m", "likewise"}, reach.upper);
  visit({"alone", "", "how far each coordinate moves from there while the others stay"}, reach.alone);
}

/// A cone that a rod must stay in.
struct ConeOfRod {
  BallJointCone cone;    ///< see there
  std::string fixed_in;  ///< "base", "crank" or "platform"
  std::string joint;     ///< for whose limit it stands; empty where it is stated
};

/// All of a robot.
std::vector<ConeOfRod> cones_of(const Manipulator& robot);

/// x, y and z.
inline std::vector<double> components(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

/// Its fields.
template <class Visit>
void describe(Visit& visit, const ConeOfRod& cone) {
  visit({"leg", "", "whose rod"}, LegIndex{cone.cone.leg});
  visit({"end", "", "`base` or `platform`"}, cone.cone.end);
  visit({"fixed_in", "", "what the axis is fixed in"}, cone.fixed_in);
  visit({"axis", "", "unit vector there"}, components(cone.cone.axis));
  visit({"angle", "rad", "half the opening"}, cone.cone.angle);
  visit({"joint", "", "of the URDF, for whose limit it stands"}, only_if(!cone.joint.empty(), cone.joint));
}

/// What is recognised.
struct RobotDescription {
  std::shared_ptr<const Mechanism> mechanism;  ///< never null in an answer
  AssembledConfiguration home;                 ///< as `inverse` solves it from `home_digits` digits
  int home_digits = 0;                         ///< that it takes to be solved
  std::optional<RobotReach> reach;             ///< nothing where nothing bounds it
};

/// Where a frame is in another.
struct FrameIn {
  Eigen::Isometry3d frame;  ///< [m]
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const FrameIn& in) {
  const Eigen::Quaterniond turn(in.frame.rotation());
  visit({"position", "m", "of its origin"}, components(in.frame.translation()));
  visit({"quaternion_xyzw", "", "its orientation"},
        std::vector<double>{turn.x(), turn.y(), turn.z(), turn.w()});
}

/// Its fields.
template <class Visit>
void describe(Visit& visit, const RobotDescription& answer) {
  const Mechanism& mechanism = *answer.mechanism;
  const Manipulator& robot = *mechanism.manipulator();
  std::vector<std::pair<std::string, JointLimits>> limits;
  for (std::size_t k = 0; k < mechanism.joint_names().size(); ++k)
    limits.emplace_back(mechanism.joint_names()[k], mechanism.joint_limits()[k]);
  std::vector<std::pair<std::string, DesignParameter>> parameters;
  for (const DesignParameter& each : design_parameters(*mechanism.mapped_manipulator()))
    parameters.emplace_back(each.name, each);
  NamedValues margins;
  for (const NamedMargin& each : named_margins)
    if (const double margin = robot.constraints().margins.*each.member; margin > 0.0)
      margins.emplace_back(std::string(each.name), margin);
  visit({"mechanism", "", "its name"}, robot.name());
  visit({"task_space", "", "how the platform moves"}, robot.task_space());
  visit({"mobility", "", "degrees of freedom of the closed mechanism"}, mechanism.mobility());
  visit({"idle_degrees_of_freedom", "",
         "those of them that move neither an actuated joint nor the platform, as a rod that spins"},
        mechanism.idle_degrees_of_freedom());
  visit({"base_frame", "", "link of the URDF"}, robot.base_frame());
  visit({"task_frame", "",
         "where pose coordinates are counted from, in the base frame: `position` [m], `quaternion_xyzw`"},
        FrameIn{robot.task_frame()});
  visit({"platform_link", "", "link of the URDF, whose origin is the operational point"},
        mechanism.platform_link());
  visit({"size", "m", "longest distance between two base points plus the longest reach of a leg"},
        robot.size());
  visit({"legs", "",
         "`name`, `kind`, `actuated_joint`, `unit` of the actuated joint (`rad` or `m`), `anchor` in the "
         "platform frame [m], `limits` (`null` for none), and the lengths [m], points [m] and directions of "
         "that kind"},
        robot.legs());
  visit({"home", "",
         "where the robot is shown, within the limits of all joints: `start/pose` of the YAML, or else the "
         "pose in which the loops were closed, near zero; `pose`, as `ik` solves it, and `joints`, values of "
         "the actuated joints"},
        answer.home);
  visit({"workspace", "",
         "what the legs reach, in any working mode, singular or not; about, not proved. A grid of poses is "
         "flooded from the home pose (`from`), as fine as some ten thousand poses allow, and `drawn_poses` "
         "are drawn where the flood has been, of which `reached_poses` are reached: `lower` and `upper` "
         "bounds of the operational point [m] over all orientations, with poses drawn all over besides. "
         "Where the platform turns, `alone`: how far each coordinate moves from there while the others stay, "
         "`x`, `y`, `z` [m], and `roll`, `pitch`, `yaw` [rad] about the axes of the task frame through the "
         "operational point. `null` where nothing bounds it"},
        answer.reach);
  visit({"joints", "", "every movable joint of the URDF"}, mechanism.joint_names());
  visit({"joint_limits", "rad or m", "`lower` and `upper` of each of them by name; `null` for none"}, limits);
  visit({"cones", "",
         "those that the rods must stay in ([constraints.md](../howto/constraints.md)): `leg`, `end`, "
         "`fixed_in` (`base`, `crank` or `platform`), unit vector `axis` there, `angle` [rad], and the "
         "`joint` of "
         "the URDF whose limit it stands for, `null` where it is stated"},
        cones_of(robot));
  visit({"working_modes", "", "all that the kinds of the legs allow"}, working_modes(robot));
  visit({"parameters", "",
         "lengths and coordinates that `sweep --vary` takes, by name: `value` [m], and `tied`, names of "
         "those that follow"},
        parameters);
  visit({"margins", "", "from singularities, by name; empty without any"}, margins);
  visit({"notes", "", "what was taken where the description left a choice; messages"}, mechanism.notes());
}

/// Looks at it.
Outcome<RobotDescription> answer(Session& session, const DescribeQuestion& question,
                                 const Control& control = {});

}  // namespace parallel_aspects::ask

namespace parallel_aspects {

/// Fields of limits.
template <class Visit>
void describe(Visit& visit, const JointLimits& limits) {
  visit({"lower", "rad or m", "lower end; infinite, in JSON null, for none"}, limits.lower);
  visit({"upper", "rad or m", "upper end, likewise"}, limits.upper);
}

/// The fields of a length that designs may vary.
template <class Visit>
void describe(Visit& visit, const DesignParameter& parameter) {
  visit({"value", "m", "of this robot"}, parameter.value);
  visit({"tied", "", "names of those that follow"}, parameter.tied);
}

/// The fields of a configuration.
template <class Visit>
void describe(Visit& visit, const AssembledConfiguration& configuration) {
  visit({"pose", "", "of the platform"}, configuration.pose);
  visit({"joints", "rad or m", "values of the actuated joints"}, configuration.q);
}

/// The fields of a crank and its rod.
template <class Visit>
void describe_actuation(Visit& visit, const Leg& leg, const RevoluteActuation& actuation) {
  visit({"center", "m", "of the circle of the crank's end"}, ask::components(actuation.center));
  visit({"axis", "", "of the joint"}, ask::components(actuation.axis));
  visit({"zero_direction", "", "of the crank where the joint is at 0"},
        ask::components(actuation.zero_direction));
  visit({"crank_length", "m", ""}, actuation.radius);
  visit({"rod_length", "m", ""}, leg.rod_length);
}

/// The fields of a rail and the rod on its slide.
template <class Visit>
void describe_actuation(Visit& visit, const Leg& leg, const PrismaticActuation& actuation) {
  visit({"origin", "m", "of the slide where the joint is at 0"}, ask::components(actuation.origin));
  visit({"direction", "", "of the rail"}, ask::components(actuation.direction));
  visit({"rod_length", "m", ""}, leg.rod_length);
}

/// The fields of a strut.
template <class Visit>
void describe_actuation(Visit& visit, const Leg& /*leg*/, const StrutActuation& actuation) {
  visit({"base", "m", "where it begins"}, ask::components(actuation.base));
  visit({"length_at_zero", "m", ""}, actuation.length_at_zero);
  visit({"sense", "", "1 where it becomes longer with the joint value, else -1"}, actuation.sense);
}

/// The fields of two links with an actuated elbow.
template <class Visit>
void describe_actuation(Visit& visit, const Leg& /*leg*/, const ElbowActuation& actuation) {
  visit({"base", "m", "where it begins"}, ask::components(actuation.base));
  visit({"inner_length", "m", ""}, actuation.inner_length);
  visit({"outer_length", "m", ""}, actuation.outer_length);
  visit({"angle_at_zero", "rad", "between them where the joint is at 0"}, actuation.angle_at_zero);
  visit({"sense", "", "of the joint"}, actuation.sense);
}

/// The fields of a leg.
template <class Visit>
void describe(Visit& visit, const Leg& leg) {
  visit({"name", "", ""}, leg.name);
  visit({"kind", "", "of leg"}, std::string(leg.kind().name));
  visit({"actuated_joint", "", "its name"}, leg.actuated_joint);
  visit({"unit", "", "of that"}, std::string(leg.actuated_by_angle() ? "rad" : "m"));
  visit({"anchor", "m", "in the platform frame"}, ask::components(leg.anchor));
  visit({"limits", "", "of the actuated joint"}, leg.limits);
  std::visit([&](const auto& actuation) { describe_actuation(visit, leg, actuation); }, leg.actuation);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_ROBOT_DESCRIPTION_H
