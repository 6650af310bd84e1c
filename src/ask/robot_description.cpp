// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/robot_description.h"

#include "ask/reached_poses.h"
#include "aspects/roadmap/pose_sampler.h"
#include "model/message_text.h"
#include "model/task_space_traits.h"

#include <cstdint>

namespace parallel_aspects::ask {
namespace {

// All joints inside their limits, in the working mode of `home` if that is possible.
std::optional<JointVector> solved_at(const Mechanism& mechanism, const Pose& pose, const JointVector& home) {
  std::optional<JointVector> best;
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism.joint_names().size()));
  for (const InverseSolution& solution : inverse_in_all_modes(*mechanism.manipulator(), pose)) {
    if (solution.status != InverseStatus::solved || !mechanism.complete(pose, solution.q, positions) ||
        mechanism.joint_outside_limits(positions))
      continue;
    if (!best || (solution.q - home).norm() < (*best - home).norm()) best = solution.q;
  }
  return best;
}

void set_home(const Mechanism& mechanism, RobotDescription& result) {
  result.home = mechanism.home();
  result.home_digits = exact_digits;
  for (const int digits : {6, pose_digits, exact_digits}) {
    const auto pose = as_typed(mechanism.manipulator()->motions(), mechanism.home().pose, digits);
    if (!pose) continue;
    const auto q = solved_at(mechanism, *pose, result.home.q);
    if (!q) continue;
    result.home = {*pose, *q};
    result.home_digits = digits;
    return;
  }
}

constexpr int samples = 4000, most_samples = 40000;
constexpr std::uint64_t seed = 1;

// All over, so that what the flood cannot come to is there, too.
ReachedPoses drawn_all_over(const Manipulator& manipulator, PoseSampler& sampler, std::optional<Pose>& from) {
  ReachedPoses reached;
  for (; reached.drawn < samples || (!from && reached.drawn < most_samples); ++reached.drawn) {
    const std::optional<Pose> pose = sampler.draw();
    if (!pose || !is_reached(manipulator, *pose)) continue;
    ++reached.count;
    reached.positions.extend(pose->position);
    if (!from) from = pose;
  }
  return reached;
}

// By entry of a twist.
std::vector<std::string> names_alone(TaskSpace space) {
  if (has_hinges(space)) return coordinate_names(space);
  std::vector<std::string> names{"roll", "pitch", "yaw"};
  if (is_planar(space)) names = {"phi"};
  const std::vector<std::string> axes{"x", "y", "z"};
  names.insert(names.end(), axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(directions(space)));
  return names;
}

// How far each coordinate moves alone, where the positions become larger by that.
void add_alone(const Manipulator& manipulator, RobotReach& reach, Eigen::AlignedBox3d& positions) {
  const TaskSpace space = manipulator.task_space();
  const std::vector<CoordinateRange> ranges = ranges_alone(manipulator, *reach.from);
  const std::vector<std::string> names = names_alone(space);
  const std::size_t turns = rotational_degrees_of_freedom(space);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    reach.alone.emplace_back(names[k], ranges[k]);
    if (k < turns) continue;
    for (const double moved : {ranges[k].lower, ranges[k].upper})
      positions.extend(reach.from->position +
                       moved * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k - turns)));
  }
}

// Nothing where nothing bounds it.
std::optional<RobotReach> find_reach(const Mechanism& mechanism) {
  const Manipulator& manipulator = *mechanism.manipulator();
  const TaskSpace space = manipulator.task_space();
  PoseSampler sampler(mechanism.manipulator(), seed, std::nullopt, EIGEN_PI);
  if (!sampler.is_bounded()) return std::nullopt;
  RobotReach reach;
  const Pose home = mechanism.home().pose;
  reach.is_from_home = is_reached(manipulator, home);
  if (reach.is_from_home) reach.from = home;
  ReachedPoses poses = drawn_all_over(manipulator, sampler, reach.from);
  if (reach.from && has_translation(space)) {
    const ReachedPoses flooded = flooded_from(manipulator, *reach.from);
    poses = {poses.positions.merged(flooded.positions), flooded.drawn, flooded.count};
  }
  reach.drawn = poses.drawn;
  reach.reached = poses.count;
  if (!reach.from) return reach;
  if (has_rotation(space)) add_alone(manipulator, reach, poses.positions);
  for (std::size_t i = 0; i < directions(space); ++i) {
    reach.lower.emplace_back(coordinate_names(space)[i], poses.positions.min()[static_cast<Eigen::Index>(i)]);
    reach.upper.emplace_back(coordinate_names(space)[i], poses.positions.max()[static_cast<Eigen::Index>(i)]);
  }
  return reach;
}

}  // namespace

std::vector<ConeOfRod> cones_of(const Manipulator& robot) {
  std::vector<ConeOfRod> cones;
  const auto add = [&](const BallJointCone& cone, const std::string& joint) {
    const char* const held = robot.leg(cone.leg).kind().has_crank ? "crank" : "base";
    cones.push_back({cone, cone.end == LegEnd::platform ? "platform" : held, joint});
  };
  for (const BallJointCone& cone : robot.constraints().cones) add(cone, "");
  for (const PassiveCone& limit : robot.constraints().passive_cones) add(limit.cone, limit.joint);
  return cones;
}

Outcome<RobotDescription> answer(Session& session, const DescribeQuestion& /*question*/,
                                 const Control& control) {
  RobotDescription result;
  result.mechanism = session.mechanism();
  if (!result.mechanism)
    return outcome_of(
        {{ProblemKind::robot, "", "Lengths or constraints of this robot differ from its description",
          "ask the robot as it was loaded"}},
        control, std::move(result));
  set_home(*result.mechanism, result);
  result.reach = find_reach(*result.mechanism);
  return outcome_of({}, control, std::move(result));
}

}  // namespace parallel_aspects::ask
