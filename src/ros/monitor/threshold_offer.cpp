// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/threshold_offer.h"

#include "model/message_text.h"
#include "model/spherical_links.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double stopping_time = 0.1;  // of the example [s]
constexpr int digits = 2;              // of what is offered

// To so many digits; positive values.
double rounded_up(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) + 1.0 - digits);
  return unit * std::ceil(value / unit);
}

// Of the anchors for a twist (w, v), root mean square, as in the metric of distances [m/s].
double anchor_speed(const Manipulator& robot, const Pose& pose, const TaskVector& twist) {
  const auto moves = static_cast<Eigen::Index>(directions(robot.task_space()));
  const Eigen::Index turns = twist.size() - moves;
  Vector3d velocity = Vector3d::Zero(), turn = Vector3d::Zero();
  velocity.head(moves) = twist.tail(moves);
  if (turns == 1) turn.z() = twist[0];
  if (turns == 3) turn = twist.head<3>();
  double squares = 0.0;
  for (const Leg& leg : robot.legs())
    squares += (velocity + turn.cross(pose.orientation * leg.anchor)).squaredNorm();
  return std::sqrt(squares / static_cast<double>(robot.leg_count()));
}

// The anchors are no faster where the mechanism is assembled, with every actuated joint within its velocity
// limit; not finite where one has none [m/s].
double speed_limit(const Manipulator& robot, const AssembledConfiguration& at) {
  const Eigen::MatrixXd twists = direct_matrix(robot, at.pose, at.q).inverse();
  const TaskVector diagonal = inverse_diagonal(robot, at.pose, at.q);
  double sum = 0.0;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    const TaskVector twist = twists.col(column) * diagonal[column];
    sum += robot.leg(j).limits.velocity * anchor_speed(robot, at.pose, twist);
  }
  return sum;
}

}  // namespace

ThresholdParameters offered_thresholds(const Manipulator& robot, const StandOffEstimate& stand_off) {
  const double share = robot.leg_count() == 6 ? 0.005 : 0.02;
  ThresholdParameters offered;
  const DistanceUnit unit(robot);
  offered.serial_stop = offered.limit_stop = rounded_up(unit.displayed(share * robot.size()));
  offered.parallel_stop = rounded_up(unit.displayed(std::max(share * robot.size(), stand_off.largest)));
  return offered;
}

std::string threshold_offer(const Mechanism& mechanism, const StandOffEstimate& stand_off) {
  const Manipulator& robot = *mechanism.manipulator();
  const ThresholdParameters offered = offered_thresholds(robot, stand_off);
  const std::string unit = DistanceUnit(robot).name();
  const auto written = [](double value) { return number_text(value, digits); };
  const std::string text =
      "No threshold is set; for example thresholds: {parallel_stop: " + written(offered.parallel_stop) +
      ", serial_stop: " + written(offered.serial_stop) + ", limit_stop: " + written(offered.limit_stop) +
      "} [" + unit + "]; a robot at " + written(offered.serial_stop / stopping_time) + " " + unit +
      "/s goes " + written(offered.serial_stop) + " " + unit + " in " + written(stopping_time) + " s";
  const double limit = speed_limit(robot, mechanism.assembled());
  if (!std::isfinite(limit)) return text + ".";
  return text + ", and its velocity limits allow up to " + written(limit) + " " + unit +
         "/s where it is assembled.";
}

}  // namespace parallel_aspects
