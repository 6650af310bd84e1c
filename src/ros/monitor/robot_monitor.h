// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_ROBOT_MONITOR_H
#define PARALLEL_ASPECTS_ROS_MONITOR_ROBOT_MONITOR_H

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "ros/joint_states/joint_merger.h"
#include "ros/joint_states/joint_name_watch.h"
#include "ros/joint_states/joint_sample.h"
#include "ros/joint_states/publisher_watch.h"
#include "ros/messages/configurations.h"
#include "ros/messages/conversions.h"
#include "ros/monitor/assembly_search.h"
#include "ros/monitor/hazard_watch.h"
#include "ros/monitor/known_domains.h"
#include "ros/monitor/missing_state.h"
#include "ros/monitor/velocity_guard.h"
#include "ros/parameters/node_options.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/AssemblyCandidates.h>

#include <ros/time.h>

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What one message of joint_states led to.
struct MonitorUpdate {
  std::optional<AspectState>
      state;            ///< to publish; nothing for another robot's message once this one is known
  std::string warning;  ///< to log, throttled; empty when all is well
  std::vector<AspectTransition> transitions;
  std::optional<TrackedState> tracked;  ///< what the state was made of, while tracking
};

/// What is known of the robot now.
struct CurrentConfiguration {
  Status status;      ///< OK, or why nothing is known
  ros::Time stamp;    ///< of the joint sample
  SolvedPose solved;  ///< valid if OK
  TrackedState tracked;
};

/// Messages since the start.
struct MonitorCounts {
  std::uint64_t usable = 0, invalid = 0, foreign = 0;
  std::uint64_t lost = 0;  ///< on the path to the node, by gaps in header.seq
  bool counted = false;    ///< whether the publisher sets header.seq, so that losses show
};

/// Guards a tracker against everything that joint_states may bring, and against threads. Knows no topics.
///
/// `update` is for the thread of joint_states; what takes longer, as measuring distances, looking for the
/// assembly mode and comparing passive joints, is left to `work`, for another thread.
class RobotMonitor {
 public:
  /// `options` must have passed `problems_of`. `topic`: what joint_states is called, for messages.
  RobotMonitor(std::shared_ptr<const Mechanism> mechanism, const NodeOptions& options,
               const std::string& topic = "joint_states");

  /// The next message, received at `now` from the node `publisher`.
  MonitorUpdate update(const sensor_msgs::JointState& message, const ros::Time& now,
                       const std::string& publisher = {});

  /// This process runs. To be called before `update`, so that what waited while it stood still is not taken
  /// for old.
  void beat(const ros::SteadyTime& wall);

  /// Every joint of the URDF in a tracked configuration; nothing where the passive joints do not close it.
  std::optional<sensor_msgs::JointState> complete(const TrackedState& tracked, const ros::Time& stamp) const;

  /// The state to publish when the last usable sample has become stale; nothing while it has not, or that was
  /// published. To be called again and again: a simulated clock may stand still, so `wall` measures how long
  /// no sample came.
  std::optional<AspectState> expire(const ros::Time& now, const ros::SteadyTime& wall);

  /// Measures distances at the last sample, or searches for the assembly mode; to be called again and again
  /// from one thread. The assembly modes that remain, where their number has changed.
  std::optional<AssemblyCandidates> work();

  /// What `work` does where the robot is not followed, in parts: a search to run, while samples come, or
  /// nothing where the robot is followed.
  std::optional<AssemblySearch> begin_search();

  /// Takes what the last search has found, with the samples that came meanwhile; drops it where the assembly
  /// mode was stated or found since, the clock went back, or another map came.
  void take(AssemblySearch search);

  /// Scales a velocity, where the guard is on; `turned`: the command in the base frame, or why not.
  GuardedCommand guard(const geometry_msgs::TwistStamped& command, const TurnedTwist& turned,
                       const ros::Time& now, const ros::SteadyTime& wall);

  /// Zero, when the last command has become old; nothing while it has not, or that was published. Where
  /// the guard is on. To be called again and again.
  std::optional<GuardedCommand> expire_command(const ros::Time& now, const ros::SteadyTime& wall);

  CurrentConfiguration current(const ros::Time& now) const;
  MonitorFindings findings() const;
  MonitorCounts counts() const;
  UniquenessState uniqueness() const;  ///< that of the last state

  void set_map(std::shared_ptr<const AspectMap> map);

  /// What `work` measures distances with; null for none. To be called by the thread that calls `work`.
  void set_distance_map(const std::shared_ptr<const DistanceMap>& map);

  /// Of what `work` looks up where the robot is. To be called by the thread that calls `work`.
  void set_domains(const KnownDomains& known);

  void set_thresholds(const DistanceThresholds::Options& thresholds);

  /// Starts at the direct solution of the last sample that is closest to `pose`, or that has the stated sign
  /// of det A. Where that solution contradicts what is stated it is refused, and nothing changes.
  Status start_near(const Pose& pose, const ros::Time& now, const StatedSigns& stated = {});
  Status start_with_sign(const StatedSigns& stated, const ros::Time& now);

 private:
  /// Why the robot is followed.
  enum class Beginning {
    followed,  ///< by samples alone
    stated,    ///< where it is was stated
    found      ///< in the assembly mode of before
  };

  MonitorUpdate pass_over(bool new_names);
  std::string fault_of(const JointSample& sample, const ros::Time& stamp, const ros::Time& now) const;
  MonitorUpdate take(const JointSample& sample, const ros::Time& stamp, const ros::Time& now);
  MonitorUpdate refuse(std::uint8_t code, const std::string& message, const ros::Time& stamp,
                       const ros::Time& now);
  MonitorUpdate wait_for_joints(const JointSample& sample, const ros::Time& now);
  MonitorUpdate accept(const JointSample& sample, const MergedJoints& merged, const ros::Time& now);
  Status follow(const MergedJoints& merged, bool first);
  Status start_as_configured(double time, const JointVector& q);
  bool failed_start() const;
  JointVector uncertainty_to_report() const;
  Status status_of_tracker() const;
  Status status_at(const ros::Time& now) const;
  KnownToGuard known_to_guard(const ros::Time& now) const;
  std::string overdue_joints(const ros::Time& now) const;
  template <class Start>
  Status start_by(const ros::Time& now, const StatedSigns& stated, const Start& start);
  void fill_tracked(const ros::Time& stamp, MonitorUpdate& update);
  void keep(const Transition& transition);
  void keep_transitions();
  AspectState lost_state(const Status& status, const ros::Time& stamp);
  void note_start(Beginning how);
  void fill_domains(AspectState& state) const;
  void look_for_domain(const TrackedState& tracked, const TrackingStart& start);
  void measure(const TrackedState& tracked, const JointVector& bend, const Eigen::VectorXd& readings);
  void look_for_assembly_mode();
  void use(AssemblySearch& search);
  std::optional<AssemblyCandidates> new_candidates();
  void forget();

  const std::shared_ptr<const Mechanism> mechanism_;
  const JointSampleReader reader_;
  JointNameWatch names_;  // of what arrives since the last usable sample
  const StartOptions start_;
  const double start_tolerance_;
  const bool read_only_;  // whether set_assembly_mode is refused
  const PassiveJoints passive_;
  BoundaryDistanceMeter meter_;  // of `work` alone
  const StandOff stand_off_;
  DomainReport domains_;  // of `work` alone

  mutable std::mutex mutex_;
  JointMerger merger_;
  Tracker tracker_;
  SamplesMeanwhile meanwhile_;  // of a search that is on
  Status status_;
  Status not_started_;                    // why, where the first sample could not start
  ros::Time epoch_;                       // of the tracker's clock
  SampleAge age_;                         // of the last usable sample
  ros::Time last_received_;               // when any message came
  ros::Time last_refused_;                // when one was that could not be used, or one of two publishers'
  std::array<ros::Time, max_legs> came_;  // when each actuated joint last did; zero for never
  ros::Time waiting_since_;               // for the other actuated joints, before the first one; zero for not
  std::optional<JointVector> last_q_;
  JointVector last_uncertainty_;
  std::vector<AspectTransition> transitions_;  // still to be published
  bool stated_anew_ = false;                   // the assembly mode, since the last transition
  bool said_stale_ = false;
  bool said_names_ = false;
  bool clock_went_back_ = false;  // though it was not a simulation that began anew
  MonitorCounts counts_;
  PublisherWatch publishers_;

  std::optional<TrackingStart> tracking_start_;  // while the robot is followed
  std::optional<TrackingStart> lost_start_;      // the last one, while it is not
  std::uint64_t tracking_starts_ = 0;
  UniquenessState uniqueness_;  // as `work` last found it
  HazardWatch hazards_;
  std::optional<VelocityGuard> guard_;  // where it is on
  Eigen::VectorXd readings_;            // of all joints, from the last usable sample
  PassiveResidual residual_;
  std::size_t reported_candidates_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_ROBOT_MONITOR_H
