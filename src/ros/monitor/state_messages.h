// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_STATE_MESSAGES_H
#define PARALLEL_ASPECTS_ROS_MONITOR_STATE_MESSAGES_H

#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "parallel_aspects/urdf/passive_joints.h"
#include "ros/joint_states/joint_name_watch.h"
#include "ros/messages/conversions.h"

#include <ros/time.h>

#include <string>

namespace parallel_aspects {

/// What is wrong with the stamp of a message that comes at `now`, or empty. `last`: stamp of the one before,
/// zero where messages may overtake one another.
std::string fault_of_stamp(const ros::Time& stamp, const ros::Time& last, const ros::Time& now,
                           double timeout);

/// That messages hold some of the actuated joints, and make no configuration yet. `missing`: what is.
std::string some_joints(const std::string& missing);

/// That it is not known where tracking starts: `why`, if there is more to say, and what to do. `read_only`:
/// whether the node refuses set_assembly_mode.
Status not_started_status(const std::string& why, bool read_only);

/// Why these actuated joints do not start near a pose, which is called `place`. `uncertainty`: of merged
/// actuated joints.
std::string why_not_near(const Manipulator& manipulator, const JointVector& q, const Pose& pose,
                         double tolerance, const std::string& place, const JointVector& uncertainty);

/// Why they do not start with a sign of det A.
std::string why_not_with_sign(const Manipulator& manipulator, const JointVector& q, int determinant_sign,
                              const JointVector& uncertainty);

/// That the robot is in more than one assembly mode, as far as is known. `start`: why it could not start as
/// configured; empty where it did, or nothing is configured.
Status ambiguous_status(Ambiguity ambiguity, const JointVector& uncertainty, const std::string& start,
                        bool read_only);

/// That measured passive joints contradict the pose.
Status inconsistent_status(const Mechanism& mechanism, const PassiveResidual& residual);

/// That nothing usable came for `timeout` [s], and which joints came since.
Status silent_status(double timeout, const JointNameWatch& names);

/// That some of the actuated joints do not come any more. `overdue`: which, and for how long.
/// `names`: what came since the last usable sample.
Status overdue_status(const std::string& overdue, const JointNameWatch& names);

/// That nothing did while the clock stood still.
Status halted_status(double timeout);

/// That the process itself stood still for so long [s].
Status paused_status(double pause);

/// That what comes is older than that.
Status late_status(double timeout);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_STATE_MESSAGES_H
