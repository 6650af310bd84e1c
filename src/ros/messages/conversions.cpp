// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/conversions.h"

#include "ask/question_parts.h"
#include "model/linear_algebra.h"
#include "model/spherical_links.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/ask/jacobian.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/motion_guard.h"
#include "ros/messages/hazard_messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

static_assert(static_cast<std::uint8_t>(ask::JacobianStatus::both) == Jacobian::BOTH);

int sign_of(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

Eigen::Vector3d vector(const geometry_msgs::Point& point) { return {point.x, point.y, point.z}; }

std_msgs::Header header_in_base(const Manipulator& manipulator, const ros::Time& stamp) {
  std_msgs::Header header;
  header.frame_id = manipulator.base_frame();
  header.stamp = stamp;
  return header;
}

template <typename Vector>
std::vector<double> to_vector(const Vector& values) {
  return {values.data(), values.data() + values.size()};
}

std::vector<double> by_rows(const std::optional<TaskMatrix>& matrix) {
  return matrix ? to_vector(TaskMatrix(matrix->transpose())) : std::vector<double>();
}

std::uint8_t status_of(LocationStatus status) {
  return status == LocationStatus::inside      ? SolvedConfiguration::INSIDE
         : status == LocationStatus::undecided ? SolvedConfiguration::UNDECIDED
         : status == LocationStatus::outside   ? SolvedConfiguration::OUTSIDE
                                               : SolvedConfiguration::NOT_MAPPED;
}

std::uint8_t status_of(DistanceStatus status) {
  switch (status) {
    case DistanceStatus::tight:
      return MetricDistance::TIGHT;
    case DistanceStatus::loose:
      return MetricDistance::LOOSE;
    case DistanceStatus::no_witness:
      return MetricDistance::NO_WITNESS;
    case DistanceStatus::absent:
      return MetricDistance::ABSENT;
    case DistanceStatus::touching:
      return MetricDistance::TOUCHING;
    case DistanceStatus::unavailable:
      break;
  }
  return MetricDistance::UNAVAILABLE;
}

// Between the rod and its crank, or the normal of its rail: 0 where B_jj = 0. A strut is never near.
std::vector<double> leg_angles(const Manipulator& manipulator, const SolvedPose& solved) {
  const TaskVector entries = inverse_diagonal(manipulator, solved.pose, solved.q);
  std::vector<double> angles;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const double entry = std::abs(entries[static_cast<Eigen::Index>(j)]);
    const double largest = manipulator.leg(j).largest_entry();
    angles.push_back(entry < largest ? std::asin(entry / largest) : 0.5 * EIGEN_PI);
  }
  return angles;
}

std::uint8_t kind_of(TransitionKind kind) {
  switch (kind) {
    case TransitionKind::working_mode:
      return AspectTransition::WORKING_MODE;
    case TransitionKind::aspect:
      return AspectTransition::ASPECT;
    case TransitionKind::assembly_mode:
      return AspectTransition::ASSEMBLY_MODE;
    case TransitionKind::found:
      return AspectTransition::FOUND;
    case TransitionKind::lost:
      break;
  }
  return AspectTransition::LOST;
}

std::string aspect_text(std::uint32_t id) { return id == 0 ? "unknown" : std::to_string(id); }

std::string cause_of(const AspectTransition& t, const Transition& transition, bool stated_anew) {
  const std::string number = std::to_string(transition.leg + 1);
  switch (t.kind) {
    case AspectTransition::WORKING_MODE:
      return "B_" + number + number + " of " + t.leg + " (" + t.joint + ") crossed zero";
    case AspectTransition::LOST:
      return reason(transition.ambiguity);
    case AspectTransition::FOUND:
      return std::string("the assembly mode was not known, as ") + reason(transition.ambiguity) +
             "; it is proved to be the same, the only one wherever the actuated joints can have been "
             "meanwhile";
    case AspectTransition::ASSEMBLY_MODE:
      return t.first_assembly_mode
                 ? "the actuated joints are back, and the platform is in its first assembly mode again"
                 : "the actuated joints are back, and the platform is in another assembly mode";
    default:
      if (!t.determinant_crossed) return "the aspect became known";
      return stated_anew ? "the assembly mode was stated anew" : "det A has changed its sign";
  }
}

std::string message_of(const AspectTransition& t, const Transition& transition, bool stated_anew) {
  const std::string before = branch_text(transition.mode_before, transition.determinant_sign_before);
  const std::string after = branch_text(transition.mode_after, transition.determinant_sign_after);
  const std::string aspects = "aspect " + aspect_text(t.aspect_before) + " -> " + aspect_text(t.aspect_after);
  const bool same = before == after || transition.determinant_sign_before == 0;
  const std::string branches = t.kind == AspectTransition::LOST ? before
                               : same                           ? after
                                                                : before + " -> " + after;
  return aspects + ": " + cause_of(t, transition, stated_anew) + "; " + branches;
}

}  // namespace

Status make_status(std::uint8_t code, std::string message) {
  Status status;
  status.code = code;
  status.message = std::move(message);
  return status;
}

Status invalid_request(std::string message) {
  return make_status(Status::INVALID_REQUEST, std::move(message));
}

Status refused_as_read_only() {
  return make_status(
      Status::READ_ONLY,
      "The node was started with ~read_only, so that nothing changes it while it runs; set what it is to be "
      "started with and restart it.");
}

Eigen::Isometry3d platform_in_base(const Manipulator& manipulator, const Pose& pose) {
  return manipulator.task_frame() * Eigen::Translation3d(pose.position) * pose.orientation;
}

geometry_msgs::Pose pose_message(const Eigen::Isometry3d& isometry) {
  const Eigen::Vector3d position = isometry.translation();
  const Eigen::Quaterniond orientation(isometry.linear());
  geometry_msgs::Pose message;
  message.position.x = position.x();
  message.position.y = position.y();
  message.position.z = position.z();
  message.orientation.x = orientation.x();
  message.orientation.y = orientation.y();
  message.orientation.z = orientation.z();
  message.orientation.w = orientation.w();
  return message;
}

geometry_msgs::Transform transform_message(const Eigen::Isometry3d& isometry) {
  const geometry_msgs::Pose pose = pose_message(isometry);
  geometry_msgs::Transform message;
  message.translation.x = pose.position.x;
  message.translation.y = pose.position.y;
  message.translation.z = pose.position.z;
  message.rotation = pose.orientation;
  return message;
}

std::optional<Pose> pose_from_base(const Manipulator& manipulator, const geometry_msgs::Pose& message) {
  const TaskSpace space = manipulator.task_space();
  Pose pose;
  pose.position = manipulator.task_frame().inverse() * vector(message.position);
  if (has_rotation(space)) {
    const geometry_msgs::Quaternion& q = message.orientation;
    const Eigen::Quaterniond orientation(q.w, q.x, q.y, q.z);
    if (!(orientation.norm() > 0.5 && orientation.norm() < 2.0)) return std::nullopt;
    pose.orientation =
        Eigen::Quaterniond(manipulator.task_frame().linear().transpose()) * orientation.normalized();
  }
  return pose_from_coordinates(manipulator.motions(), pose_coordinates(space, pose));
}

double distance_off_task_space(const Manipulator& manipulator, const geometry_msgs::Pose& message) {
  const auto projected = pose_from_base(manipulator, message);
  if (!projected) return not_a_number;
  return (manipulator.task_frame().inverse() * vector(message.position) - projected->position).norm();
}

std::vector<std::int8_t> signs_message(const WorkingMode& mode) {
  const std::vector<int> signs = mode.signs();
  return {signs.begin(), signs.end()};
}

std::string branch_text(const WorkingMode& mode, int determinant_sign) {
  return to_string(mode) + ", det A " + (determinant_sign > 0 ? "> 0" : determinant_sign < 0 ? "< 0" : "= 0");
}

const char* inverse_entry_unit(const Leg& leg) {
  if (spherical_links(leg)) return "1/rad";
  return leg.actuated_by_angle() ? "m^2/rad" : "m";
}

SolvedConfiguration solved_message(const Manipulator& manipulator, const ask::LocatedConfiguration& located,
                                   const ros::Time& stamp) {
  SolvedConfiguration message;
  message.header = header_in_base(manipulator, stamp);
  message.pose = pose_message(platform_in_base(manipulator, located.pose));
  for (const Leg& leg : manipulator.legs()) message.joint_names.push_back(leg.actuated_joint);
  message.joint_positions = to_vector(located.q);
  const TaskVector diagonal = inverse_diagonal(manipulator, located.pose, located.q);
  for (const double entry : coefficients_of(diagonal))
    message.working_mode.push_back(static_cast<std::int8_t>(sign_of(entry)));
  message.determinant_sign = static_cast<std::int8_t>(located.determinant_sign);
  if (!has_map(manipulator.task_space())) message.aspect_status = SolvedConfiguration::NO_MAP;
  if (located.location) message.aspect_status = status_of(located.location->status);
  if (located.location) message.aspect = static_cast<std::uint32_t>(located.location->aspect);
  if (located.component) message.roadmap_component = *located.component + 1;
  return message;
}

AssemblyCandidates candidates_message(const Manipulator& manipulator, const TrackedState& tracked,
                                      const PossibleAssemblyModes& candidates, const ros::Time& stamp) {
  AssemblyCandidates message;
  message.header = header_in_base(manipulator, stamp);
  message.message = "The assembly mode is known.";
  message.complete = true;
  if (tracked.followed()) return message;
  message.complete = candidates.complete();
  const std::size_t count = candidates.size();
  for (std::size_t i = 0; i < count; ++i)
    message.candidates.push_back(solved_message(
        manipulator, ask::configuration_of(manipulator, candidates[i].pose, candidates[i].q), stamp));
  const std::string why = reason(tracked.ambiguity);
  if (count == 0 && !message.complete) {
    message.message =
        "Which assembly modes are possible is not known yet" + (why.empty() ? "." : ": " + why + ".");
    return message;
  }
  const bool one = count == 1 && message.complete;
  message.message = std::to_string(count) + (message.complete ? "" : " or more") +
                    (one ? " assembly mode is possible: " : " assembly modes are possible: ") + why + ".";
  return message;
}

std::int64_t count_at_most(const AspectMap& map) noexcept {
  const auto most = map.count_at_most();
  return most ? static_cast<std::int64_t>(*most) : -1;
}

std::vector<AspectSummary> summary_messages(const std::shared_ptr<const AspectMap>& map) {
  std::vector<AspectSummary> messages;
  for (const ask::MappedAspect& mapped : ask::answer_of(map).aspects) {
    const Aspect& aspect = mapped.aspect;
    AspectSummary& message = messages.emplace_back();
    message.id = static_cast<std::uint32_t>(aspect.id);
    message.working_mode = signs_message(aspect.mode);
    message.determinant_sign = static_cast<std::int8_t>(aspect.determinant_sign);
    message.measure = aspect.measure;
    message.measure_lower = aspect.measure_lower;
    message.measure_upper = aspect.measure_upper;
    message.unit = mapped.unit;
    message.inside_leaves = aspect.inside_leaves;
    for (const ask::NamedRange& each : mapped.bounds) {
      message.coordinate_names.push_back(each.name);
      message.lower.push_back(each.lower);
      message.upper.push_back(each.upper);
    }
    message.deepest_pose = pose_message(platform_in_base(*map->manipulator(), aspect.deepest));
    message.deepest_clearance = aspect.deepest_clearance;
    message.unresolved_with.assign(aspect.unresolved_with.begin(), aspect.unresolved_with.end());
  }
  return messages;
}

MetricDistance distance_message(const Manipulator& manipulator, const SolvedPose& solved,
                                const BoundaryDistance& distance, bool of_leg) {
  MetricDistance message;
  message.status = status_of(distance.status);
  const bool available = distance.status != DistanceStatus::unavailable;
  message.lower = available ? distance.lower : not_a_number;
  message.upper = available ? distance.upper : not_a_number;
  message.upper_proved = distance.upper_proved;
  if (!available || !std::isfinite(distance.upper)) return message;
  message.witness = pose_message(platform_in_base(manipulator, distance.witness));
  message.joint_positions = to_vector(distance.witness_q);
  message.joint_displacements = to_vector(distance.joint_displacement);
  message.direction = to_vector(distance.direction);
  if (const auto escape = escape_direction(manipulator, solved.pose, solved.q, distance)) {
    message.escape_twist = to_vector(escape->twist);
    message.escape_joint_velocities = to_vector(escape->joint_rate);
  }
  if (!of_leg) return message;
  message.leg = manipulator.leg(distance.leg).name;
  message.joint = manipulator.leg(distance.leg).actuated_joint;
  return message;
}

SingularityReport report_message(const Manipulator& manipulator, const ask::LocatedConfiguration& located,
                                 const BoundaryDistances& distances, const ros::Time& stamp) {
  const SolvedPose solved{located.pose, located.q};
  const SingularityIndices indices = singularity_indices(manipulator, solved.pose, solved.q);
  SingularityReport message;
  message.configuration = solved_message(manipulator, located, stamp);
  message.parallel_distance = distance_message(manipulator, solved, distances.parallel, false);
  message.serial_distance = distance_message(manipulator, solved, distances.serial, true);
  message.limit_distance = distance_message(manipulator, solved, distances.actuated_limit, true);
  if (!message.limit_distance.leg.empty()) message.limit_distance.limit = name(distances.actuated_limit.end);
  message.determinant = indices.determinant;
  message.determinant_unit = moves_on_unit_sphere(manipulator)
                                 ? "1"
                                 : std::string(traits(manipulator.task_space()).determinant_unit);
  message.inverse_diagonal = to_vector(indices.inverse_diagonal);
  for (const Leg& leg : manipulator.legs()) message.inverse_diagonal_units.push_back(inverse_entry_unit(leg));
  message.smallest_singular_value = indices.smallest_singular_value;
  message.inverse_condition_number = indices.inverse_condition_number;
  message.leg_angles = leg_angles(manipulator, solved);
  return message;
}

Jacobian jacobian_message(const Manipulator& manipulator, const ask::LocatedConfiguration& located,
                          const ros::Time& stamp) {
  const ask::JacobianAt at = ask::jacobian_at(manipulator, located.pose, located.q);
  const ask::JacobianAnswer units = ask::jacobian_units(manipulator);
  Jacobian message;
  message.configuration = solved_message(manipulator, located, stamp);
  message.task_frame = pose_message(manipulator.task_frame());
  message.status = static_cast<std::uint8_t>(at.status);
  message.reason = at.reason;
  message.twist = units.twist;
  message.twist_units = units.twist_units;
  message.wrench = units.wrench;
  message.wrench_units = units.wrench_units;
  message.rate_units = units.rate_units;
  message.effort_units = units.effort_units;
  message.a = by_rows(at.a);
  message.b_jj = to_vector(at.b.value());
  message.jacobian = by_rows(at.jacobian);
  message.inverse_jacobian = by_rows(at.inverse_jacobian);
  message.force_transmission = by_rows(at.force_transmission);
  if (at.singular_values) message.singular_values = to_vector(*at.singular_values);
  message.condition_number = at.condition_number.value_or(not_a_number);
  return message;
}

AspectState state_message(const Manipulator& manipulator, const TrackedState& state, const ros::Time& stamp) {
  AspectState message;
  message.header = header_in_base(manipulator, stamp);
  message.pose = pose_message(platform_in_base(manipulator, state.pose));
  message.working_mode = signs_message(state.mode);
  message.determinant_sign = static_cast<std::int8_t>(state.determinant_sign);
  message.aspect = static_cast<std::uint32_t>(state.aspect);
  message.stand_off = not_a_number;
  message.level = AspectState::UNKNOWN;
  message.last_hazard = hazard_message(std::nullopt, {});
  message.determinant = direct_determinant(manipulator, state.pose, state.q);
  message.inverse_diagonal = to_vector(inverse_diagonal(manipulator, state.pose, state.q));
  return message;
}

AspectState unknown_state(const Manipulator& manipulator, const Status& status, const ros::Time& stamp) {
  AspectState message;
  message.header = header_in_base(manipulator, stamp);
  message.status = status;
  message.level = AspectState::UNKNOWN;
  message.last_hazard = hazard_message(std::nullopt, {});
  message.pose.position.x = message.pose.position.y = message.pose.position.z = not_a_number;
  message.pose.orientation.x = message.pose.orientation.y = not_a_number;
  message.pose.orientation.z = message.pose.orientation.w = not_a_number;
  message.determinant = not_a_number;
  for (DistanceBounds* bounds :
       {&message.parallel_distance, &message.serial_distance, &message.limit_distance})
    bounds->lower = bounds->upper = bounds->speed = not_a_number;
  message.residual = message.stand_off = not_a_number;
  message.reason = reason_of(std::nullopt, DistanceUnit(manipulator));
  return message;
}

AspectTransition transition_message(const Manipulator& manipulator, const Transition& transition,
                                    const ros::Time& stamp, bool stated_anew) {
  AspectTransition message;
  message.header = header_in_base(manipulator, stamp);
  const bool changes_mode = transition.kind == TransitionKind::working_mode;
  message.kind = kind_of(transition.kind);
  if (changes_mode) {
    message.leg = manipulator.leg(transition.leg).name;
    message.joint = manipulator.leg(transition.leg).actuated_joint;
  }
  message.determinant_crossed = transition.determinant;
  message.first_assembly_mode = transition.first_again;
  message.working_mode_before = signs_message(transition.mode_before);
  message.working_mode_after = signs_message(transition.mode_after);
  message.determinant_sign_before = static_cast<std::int8_t>(transition.determinant_sign_before);
  message.determinant_sign_after = static_cast<std::int8_t>(transition.determinant_sign_after);
  message.aspect_before = static_cast<std::uint32_t>(transition.aspect_before);
  message.aspect_after = static_cast<std::uint32_t>(transition.aspect_after);
  message.message = message_of(message, transition, stated_anew);
  return message;
}

}  // namespace parallel_aspects
