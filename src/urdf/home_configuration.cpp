// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "urdf/mechanism_recognition.h"

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

// How far a pose on a limit is moved to be inside, at first and at last, in sizes of the robot and rad.
constexpr double nearest_step = 1e-9, farthest_step = 1e-2, growth = 4.0;
constexpr int tries_of_a_step = 200;  // in random directions: a corner of six limits has one in 64
constexpr unsigned home_seed = 3;

class HomeSearch {
 public:
  explicit HomeSearch(const Mechanism::Contents& contents)
      : contents_(contents),
        robot_(*contents.manipulator),
        mode_(working_mode(robot_, contents.completion.reference_pose(),
                           contents.completion.reference_joints())) {}

  /// There with all joints inside their limits, in the working mode that was recognised if that is possible.
  std::optional<AssembledConfiguration> at(const Pose& pose) const {
    std::optional<AssembledConfiguration> found;
    for (const InverseSolution& solution : inverse_in_all_modes(robot_, pose)) {
      const bool is_usual = mode_ && solution.mode == *mode_;
      if (solution.status != InverseStatus::solved || (found && !is_usual)) continue;
      if (is_inside(pose, solution.q)) found = AssembledConfiguration{pose, solution.q};
    }
    return found;
  }

  /// There, or near enough that only a limit is left; a pose that is typed with few digits.
  std::optional<AssembledConfiguration> near(const Pose& pose) const {
    if (auto found = at_typed(pose)) return found;
    std::mt19937 random(home_seed);
    for (double step = nearest_step; step < farthest_step; step *= growth)
      for (int k = 0; k < tries_of_a_step; ++k)
        if (auto found = at_typed(beside(pose, step, random))) return found;
    return std::nullopt;
  }

 private:
  std::optional<AssembledConfiguration> at_typed(const Pose& pose) const {
    const auto typed = as_typed(robot_.motions(), pose, pose_digits);
    return typed ? at(*typed) : std::nullopt;
  }

  bool is_inside(const Pose& pose, const JointVector& q) const {
    Eigen::VectorXd positions(static_cast<Eigen::Index>(contents_.joint_names.size()));
    return contents_.complete(pose, q, positions) && !contents_.joint_outside_limits(positions);
  }

  Pose beside(const Pose& pose, double step, std::mt19937& random) const {
    std::uniform_real_distribution<double> entries(-step, step);
    TaskVector twist(static_cast<Eigen::Index>(robot_.leg_count()));
    for (double& entry : coefficients_of(twist)) entry = entries(random);
    const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot_.task_space()));
    twist.tail(twist.size() - turns) *= robot_.size();
    return displaced(robot_.motions(), pose, twist);
  }

  const Mechanism::Contents& contents_;
  const Manipulator& robot_;
  std::optional<WorkingMode> mode_;
};

std::optional<Pose> stated_start(const MechanismConfig& config, const Motions& motions) {
  if (config.start.empty() || config.start.size() > PoseCoordinates::MaxRowsAtCompileTime)
    return std::nullopt;
  return pose_from_coordinates(
      motions,
      Eigen::Map<const Eigen::VectorXd>(config.start.data(), static_cast<Eigen::Index>(config.start.size())));
}

}  // namespace

void find_home(const MechanismConfig& config, const SourceNames& files, Mechanism::Contents& contents) {
  const HomeSearch search(contents);
  const auto start = stated_start(config, contents.manipulator->motions());
  if (start) contents.home = search.at(*start);
  if (start && !contents.home) contents.home = search.near(*start);
  if (contents.home) return;
  if (start)
    contents.notes.push_back(
        files.config + " states a start.pose that the joints of " + files.urdf +
        " do not reach within their limits; its home is the pose in which the loops were closed.");
  contents.home = search.near(contents.completion.reference_pose());
}

}  // namespace parallel_aspects
