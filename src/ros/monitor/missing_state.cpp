// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/missing_state.h"

#include "ask/question_parts.h"
#include "model/message_text.h"
#include "model/spherical_links.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/joint_states/joint_merger.h"
#include "ros/messages/configurations.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

// The text where the last sample was merged of several messages; else empty.
std::string merged_joints(const JointVector& uncertainty) {
  if (uncertainty.size() == 0 || !(uncertainty.maxCoeff() > 0.0)) return {};
  return " The actuated joints come in several messages, which leaves their values uncertain; publish all of "
         "them in one message, or more often.";
}

bool is_near_singular(const std::vector<AssemblyMode>& solutions) {
  return std::any_of(solutions.begin(), solutions.end(),
                     [](const AssemblyMode& mode) { return mode.near_singular; });
}

// Why a robot with these actuated joints is not at a pose: nothing reaches it, or how far the nearest
// assembly mode is from it.
std::string why_not_at(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  std::string failure;
  if (ask::configurations_at(manipulator, pose, {}, failure).empty())
    return "It cannot be reached in any working mode. " + failure;
  double nearest = std::numeric_limits<double>::infinity();
  for (const AssemblyMode& solution : direct(manipulator, q).solutions)
    nearest = std::min(nearest, anchor_distance(manipulator, pose, solution.pose));
  return std::isfinite(nearest) ? "The nearest assembly mode of these actuated joints is " +
                                      distance_text(manipulator, nearest) + " away."
                                : "With these actuated joints the robot does not assemble.";
}

// What to do where the assembly mode is not known.
std::string how_to_start(bool read_only) {
  const std::string set = "set start/pose or start/determinant_sign as the robot is ";
  return read_only ? set + "and restart the node; being read_only, it refuses set_assembly_mode and reload."
                   : "call set_assembly_mode, or " + set + "and call reload.";
}

}  // namespace

std::string fault_of_stamp(const ros::Time& stamp, const ros::Time& last, const ros::Time& now,
                           double timeout) {
  if (stamp.isZero()) return "its stamp is zero; set header.stamp.";
  if (stamp == last) return "its stamp is that of the message before, but the actuated joints are elsewhere.";
  if (stamp < last)
    return "its stamp is " + number_text(seconds_between(stamp, last)) +
           " s before that of the message before.";
  if (seconds_between(now, stamp) > timeout)
    return "its stamp is " + number_text(seconds_between(now, stamp)) +
           " s ahead of this computer's clock; synchronise the clocks.";
  return {};
}

std::string some_joints(const std::string& missing) {
  return "A message of joint_states holds some of the actuated joints, and the others have not come within "
         "joint_states_window: " +
         missing +
         " Where this lasts, publish all of them in one message, or each more often than every "
         "joint_states_window.";
}

Status not_started_status(const std::string& why, bool read_only) {
  const std::string known = why.empty() ? "The assembly mode is not known" : why;
  return make_status(Status::NOT_STARTED,
                     known + (known.back() == '.' ? " To go on, " : "; ") + how_to_start(read_only));
}

std::string why_not_near(const Manipulator& manipulator, const JointVector& q, const Pose& pose,
                         double tolerance, const std::string& place, const JointVector& uncertainty) {
  return "The actuated joints do not assemble within " + distance_text(manipulator, tolerance) + " of " +
         place + ". " + why_not_at(manipulator, pose, q) +
         (is_near_singular(direct(manipulator, q).solutions) ? "" : merged_joints(uncertainty));
}

std::string why_not_with_sign(const Manipulator& manipulator, const JointVector& q, int determinant_sign,
                              const JointVector& uncertainty) {
  const auto solutions = direct(manipulator, q).solutions;
  const auto fit = std::count_if(solutions.begin(), solutions.end(), [&](const AssemblyMode& mode) {
    return mode.determinant * determinant_sign > 0.0;
  });
  const bool singular = is_near_singular(solutions);
  return "The actuated joints do not have exactly one assembly mode with the sign " +
         std::to_string(determinant_sign) + " of det A: there are " + std::to_string(fit) +
         (singular  ? ", and a parallel singularity is near."
          : fit > 1 ? "; give a pose near that of the robot instead." + merged_joints(uncertainty)
                    : "." + merged_joints(uncertainty));
}

Status ambiguous_status(Ambiguity ambiguity, const JointVector& uncertainty, const std::string& start,
                        bool read_only) {
  const std::string known = std::string("The assembly mode is not known: ") + reason(ambiguity);
  return make_status(Status::AMBIGUOUS,
                     start.empty() ? known + "; " + how_to_start(read_only) + merged_joints(uncertainty)
                                   : known + ". " + start);
}

Status inconsistent_status(const Mechanism& mechanism, const PassiveResidual& residual) {
  if (residual.compared == 0)
    return make_status(Status::INCONSISTENT, "Measured passive joints contradict the pose.");
  return make_status(Status::INCONSISTENT,
                     "Joint " + mechanism.joint_names()[residual.joint] + " is measured " +
                         number_text(residual.difference) +
                         " rad or m off the value that belongs to the pose; check the encoders, and the "
                         "dimensions in the URDF.");
}

Status silent_status(double timeout, const JointNameWatch& names) {
  return make_status(
      Status::STALE,
      "The last usable joint_states are older than " + number_text(timeout) + " s" +
          (names.lacks_an_actuated_joint() ? ", and by their names, " + names.comparison() : "."));
}

Status overdue_status(const std::string& overdue, const JointNameWatch& names) {
  return make_status(Status::STALE, names.with_guess("Of the actuated joints, " + overdue +
                                                     ", while others arrive; look at the driver."));
}

Status halted_status(double timeout) {
  return make_status(Status::STALE, "The clock stands still, and no usable joint_states came for " +
                                        number_text(timeout) +
                                        " s of wall time: the simulation is paused, or has ended. What is "
                                        "known of the robot is kept for its next sample.");
}

Status paused_status(double pause) {
  return make_status(Status::STALE, "This node stood still for " + number_text(pause) +
                                        " s, as it was stopped or got no processor time, so that what it "
                                        "knows of the robot is old. It goes on with the joint_states that "
                                        "come; where nobody stopped it, relieve the computer.");
}

Status late_status(double timeout) {
  return make_status(Status::STALE, "joint_states arrive, but their stamps are more than " +
                                        number_text(timeout) +
                                        " s behind this computer's clock; synchronise the clocks, or play "
                                        "bags with --clock and use_sim_time.");
}

void SampleAge::take(const ros::Time& stamp, const ros::Time& now) {
  stamp_ = stamp;
  came_ = now;
  fresh_ = true;
  halted_ = false;
}

void SampleAge::beat(const ros::SteadyTime& wall) {
  const double pause = beaten_.isZero() ? 0.0 : (wall - beaten_).toSec();
  beaten_ = wall;
  if (!(pause > timeout_)) return;
  resumed_ = wall;
  paused_ = pause;
}

void SampleAge::look(const ros::SteadyTime& wall) {
  beat(wall);
  if (fresh_) looked_ = wall;
  fresh_ = false;
  halted_ = (wall - looked_).toSec() > timeout_;
}

void SampleAge::forget() noexcept { stamp_ = came_ = ros::Time(); }

double SampleAge::silence(const ros::Time& now) const { return seconds_between(came_, now); }

bool SampleAge::too_old(const ros::Time& now) const {
  return !stamp_.isZero() && (halted_ || silence(now) > timeout_ || seconds_between(stamp_, now) > timeout_);
}

// What came while this process stood still waited for it, so that says nothing of the clocks of others.
Status SampleAge::status(const ros::Time& now, const JointNameWatch& names) const {
  const bool just_resumed = !resumed_.isZero() && (beaten_ - resumed_).toSec() <= timeout_;
  if (just_resumed) return paused_status(paused_);
  const bool arrive = silence(now) <= timeout_;
  if (arrive && seconds_between(stamp_, came_) > timeout_) return late_status(timeout_);
  if (arrive && seconds_between(stamp_, now) <= timeout_) return halted_status(timeout_);
  return silent_status(timeout_, names);
}

}  // namespace parallel_aspects
