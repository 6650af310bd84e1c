// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/velocity_guard.h"

#include "model/message_text.h"
#include "model/task_space_traits.h"
#include "ros/joint_states/joint_merger.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

// Of a component that the robot does not have, over the length of its vector: what turning into another
// frame leaves.
constexpr double rounding = 1e-6;

// The node searches for old commands that often within their timeout.
constexpr double looks = 4.0;

static_assert(static_cast<std::uint8_t>(GuardReason::none) + 1 == GuardState::NONE);
static_assert(static_cast<std::uint8_t>(GuardReason::too_many_commands) + 1 == GuardState::TOO_MANY_COMMANDS);

std::uint8_t reason_message(GuardReason reason) { return static_cast<std::uint8_t>(reason) + 1; }

std::array<double, hazard_count> stops_of(const DistanceThresholds::Options& thresholds) {
  std::array<double, hazard_count> stops{};
  for (std::size_t i = 0; i < hazard_count; ++i) stops[i] = thresholds[i].stop;
  return stops;
}

GuardOptions guard_options(const NodeOptions& options, DistanceUnit unit) {
  const GuardParameters& given = options.guard;
  GuardOptions guard;
  guard.latency = given.latency;
  guard.period = given.command_timeout * (1.0 + 1.0 / looks);
  guard.sample_age = given.sample_age;
  // Of motions that the robot does not have, none is asked for.
  if (given.linear_deceleration > 0.0) guard.linear_deceleration = given.linear_deceleration;
  if (given.angular_deceleration > 0.0) guard.angular_deceleration = given.angular_deceleration;
  guard.recovery = given.recovery;
  guard.stop = stops_of(thresholds_of(options.thresholds, unit));
  return guard;
}

Eigen::Vector3d point_of(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

Eigen::Vector3d vector_of(const geometry_msgs::Vector3& vector) { return {vector.x, vector.y, vector.z}; }

geometry_msgs::Vector3 scaled_vector(double scale, geometry_msgs::Vector3 vector) {
  // Zero times what is not a number would not be zero.
  if (scale == 0.0) return {};
  vector.x *= scale;
  vector.y *= scale;
  vector.z *= scale;
  return vector;
}

// The first axis along which a vector points though the robot does not move there; -1 for none.
int missing_axis(const Eigen::Vector3d& vector, const std::array<bool, 3>& has) {
  const double negligible = rounding * vector.norm();
  for (int i = 0; i < 3; ++i)
    if (!has[static_cast<std::size_t>(i)] && std::abs(vector[i]) > negligible) return i;
  return -1;
}

}  // namespace

TurnedTwist turned_twist(const geometry_msgs::Twist& twist, const Eigen::Matrix3d& to_base) {
  return {to_base * vector_of(twist.angular), to_base * vector_of(twist.linear), {}};
}

VelocityGuard::VelocityGuard(std::shared_ptr<const Manipulator> manipulator, const NodeOptions& options)
    : manipulator_(manipulator),
      timeout_(options.guard.command_timeout),
      reference_point_(point_of(options.guard.reference_point)),
      guard_(manipulator, guard_options(options, DistanceUnit(*manipulator))) {
  state_.reason = GuardState::NO_COMMAND;
  state_.message = "No command has come yet.";
}

GuardedCommand VelocityGuard::guard(const geometry_msgs::TwistStamped& command, const TurnedTwist& turned,
                                    const KnownToGuard& known, const ros::Time& now,
                                    const ros::SteadyTime& wall) {
  came_ = wall;
  state_.stamp = command.header.stamp;
  const double time = seconds_between(known.epoch, now);
  const std::string fault = fault_of(command, turned, now);
  if (!fault.empty()) return halted(command.header, time, GuardReason::invalid_command, fault);
  if (known.status.code != Status::OK)
    return halted(command.header, time, GuardReason::unknown_state, known.status.message);
  const GuardedMotion motion =
      guard_.guard(known.tracked, known.proved, task_twist(turned, known.tracked.pose), time);
  return scaled(command, motion);
}

std::optional<GuardedCommand> VelocityGuard::expire(const KnownToGuard& known, const ros::Time& now,
                                                    const ros::SteadyTime& wall) {
  if (came_.isZero() || (wall - came_).toSec() <= timeout_) return std::nullopt;
  came_ = ros::SteadyTime();
  std_msgs::Header header;
  header.stamp = now;
  header.frame_id = manipulator_->base_frame();
  GuardedCommand command = halted(header, seconds_between(known.epoch, now), GuardReason::unknown_state,
                                  "The last command is older than guard/command_timeout.");
  state_.reason = GuardState::NO_COMMAND;
  command.warning.clear();
  return command;
}

void VelocityGuard::set_thresholds(const DistanceThresholds::Options& thresholds) noexcept {
  guard_.set_stop(stops_of(thresholds));
}

void VelocityGuard::forget() { guard_.forget(); }

std::string VelocityGuard::fault_of(const geometry_msgs::TwistStamped& command, const TurnedTwist& turned,
                                    const ros::Time& now) const {
  if (!turned.fault.empty()) return turned.fault;
  if (has_hinges(manipulator_->task_space()))
    return "Velocities are not guarded yet of robots whose poses are angles of passive joints; check their "
           "trajectories by ~check_trajectory, and watch the level of ~state.";
  const ros::Time& stamp = command.header.stamp;
  if (stamp.isZero()) return "The command's stamp is zero; set header.stamp.";
  const double age = seconds_between(stamp, now);
  if (!(std::abs(age) <= timeout_))
    return "The command's stamp is " + number_text(std::abs(age)) + " s " +
           (age > 0.0 ? "old; publish faster, raise guard/command_timeout, or synchronise the clocks."
                      : "ahead of this computer's clock; synchronise the clocks.");
  if (!turned.angular.allFinite() || !turned.linear.allFinite())
    return "A number of the command is not finite; correct its twist.";
  const Eigen::Matrix3d to_task = manipulator_->task_frame().linear().transpose();
  return fault_of_components(to_task * turned.angular, to_task * turned.linear);
}

std::string VelocityGuard::fault_of_components(const Eigen::Vector3d& angular,
                                               const Eigen::Vector3d& linear) const {
  const TaskSpaceTraits& space = traits(manipulator_->task_space());
  const bool all = space.rotations == 3;
  const auto moves = static_cast<int>(space.translations);
  const int turn = missing_axis(angular, {all, all, space.rotations > 0});
  const int move = missing_axis(linear, {moves > 0, moves > 1, moves > 2});
  if (turn < 0 && move < 0) return {};
  const bool turns = turn >= 0;
  const std::string axis(1, "xyz"[turns ? turn : move]);
  const double value = turns ? angular[turn] : linear[move];
  return "The command asks for " + number_text(value) + (turns ? " rad/s about " : " m/s along ") + axis +
         " of the task frame, but the platform of " + manipulator_->name() + " moves in " +
         std::string(space.name) + " and has no such " + (turns ? "rotation" : "translation") +
         "; command none.";
}

// Of the operational point, as far as the task space goes.
TaskVector VelocityGuard::task_twist(const TurnedTwist& turned, const Pose& pose) const {
  const TaskSpaceTraits& space = traits(manipulator_->task_space());
  const Eigen::Matrix3d to_task = manipulator_->task_frame().linear().transpose();
  const Eigen::Vector3d angular = to_task * turned.angular;
  const Eigen::Vector3d linear = to_task * turned.linear - angular.cross(pose.orientation * reference_point_);
  TaskVector twist(static_cast<Eigen::Index>(space.degrees_of_freedom()));
  const auto turns = static_cast<Eigen::Index>(space.rotations),
             moves = static_cast<Eigen::Index>(space.translations);
  if (turns == 1) twist[0] = angular.z();
  if (turns == 3) twist.head<3>() = angular;
  twist.tail(moves) = linear.head(moves);
  return twist;
}

std::string VelocityGuard::message_of(const GuardedMotion& motion) const {
  const std::string hazard = std::string("a ") + name(motion.hazard);
  switch (motion.reason) {
    case GuardReason::none:
      return {};
    case GuardReason::hazard:
      return "The motion would come too near to " + hazard + ".";
    case GuardReason::inside_threshold:
      return "The robot is too near to " + hazard +
             ", and the command does not provably lead away; escape_twist does.";
    case GuardReason::escape:
      return "The robot is too near to " + hazard + ", and the command leads away.";
    case GuardReason::joint_velocity:
      return "Joint " + manipulator_->leg(motion.leg).actuated_joint + " would be faster than its limit of " +
             number_text(manipulator_->leg(motion.leg).limits.velocity) + ".";
    case GuardReason::recovery:
      return "The scale rises again.";
    case GuardReason::unknown_state:
      return "The last joint_states are older than guard/sample_age.";
    case GuardReason::invalid_command:
      return "The command cannot be used.";
    case GuardReason::too_many_commands:
      break;
  }
  return "Commands come faster than can be kept for guard/latency and braking; publish fewer.";
}

GuardedCommand VelocityGuard::halted(const std_msgs::Header& header, double time, GuardReason reason,
                                     const std::string& message) {
  geometry_msgs::TwistStamped command;
  command.header = header;
  GuardedCommand result = scaled(command, guard_.halt(time, reason));
  state_.message = message;
  result.warning = "~guarded_velocity is zero: " + message;
  return result;
}

GuardedCommand VelocityGuard::scaled(const geometry_msgs::TwistStamped& command,
                                     const GuardedMotion& motion) {
  state_.reason = reason_message(motion.reason);
  state_.scale = motion.scale;
  state_.message = message_of(motion);
  GuardedCommand result;
  result.twist.header = command.header;
  result.twist.twist.linear = scaled_vector(motion.scale, command.twist.linear);
  result.twist.twist.angular = scaled_vector(motion.scale, command.twist.angular);
  result.joint_velocities = array_of(motion.joint_velocities);
  if (motion.reason == GuardReason::unknown_state || motion.reason == GuardReason::too_many_commands)
    result.warning = "~guarded_velocity is zero: " + state_.message;
  return result;
}

std_msgs::Float64MultiArray VelocityGuard::array_of(const JointVector& velocities) const {
  std_msgs::Float64MultiArray message;
  message.layout.dim.resize(1);
  auto& dimension = message.layout.dim.front();
  for (const Leg& leg : manipulator_->legs())
    dimension.label += (dimension.label.empty() ? "" : ",") + leg.actuated_joint;
  dimension.size = dimension.stride = static_cast<std::uint32_t>(velocities.size());
  message.data.assign(velocities.data(), velocities.data() + velocities.size());
  return message;
}

}  // namespace parallel_aspects
