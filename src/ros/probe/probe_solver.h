// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PROBE_PROBE_SOLVER_H
#define PARALLEL_ASPECTS_ROS_PROBE_PROBE_SOLVER_H

#include "draw/plane/map_pictures.h"
#include "draw/plane/palette.h"
#include "motion/nearest_reachable.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "ros/monitor/map_worker.h"

#include <parallel_aspects/ProbeState.h>

#include <geometry_msgs/Pose.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What somebody asks of the probe.
struct ProbeQuestion {
  Pose wanted;          ///< in the task frame
  WorkingMode mode;     ///< chosen
  bool others = false;  ///< whether the other working modes are of interest too
};

/// What is known of it.
struct ProbeFinding {
  ProbeQuestion question;
  std::optional<ReachedPose> reached;  ///< where the probe is; nothing where no pose was found
  BoundaryDistances distances;         ///< there
  std::vector<JointVector> others;     ///< joint values of the same pose in the other working modes
  ProbeState state;                    ///< the same, to publish
  std::optional<Rgb> color;            ///< of the aspect that holds it, where that is known
  std::optional<PoseSlice> section{};  ///< that aspects are drawn at, where the pose is beside it
};

/// Answers for the probe, apart from what the robot does. For one thread.
class ProbeSolver {
 public:
  explicit ProbeSolver(std::shared_ptr<const Manipulator> manipulator);

  /// `known`: what names aspects. `now`: stamp of the state.
  ProbeFinding find(const ProbeQuestion& question, const KnownAspects& known, const ros::Time& now);

 private:
  void fill_report(const KnownAspects& known, ProbeFinding& finding);

  std::shared_ptr<const Manipulator> manipulator_;
  NearestReachable nearest_;
  BoundaryDistanceMeter meter_;
  std::optional<Pose> last_;  // where the probe was
};

/// Which number of a pose in the base frame cannot be used, as a sentence; empty where all can.
std::string fault_of(const geometry_msgs::Pose& pose);

/// Whether a section holds a pose, or passes it so near that both have the same colours.
bool is_near(const Manipulator& manipulator, const PoseSlice& section, const Pose& pose) noexcept;

/// What there is to say of the probe, in lines.
std::string words_of(const Manipulator& manipulator, const ProbeFinding& finding);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PROBE_PROBE_SOLVER_H
