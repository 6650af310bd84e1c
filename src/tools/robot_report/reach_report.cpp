// SPDX-License-Identifier: BSD-3-Clause
#include "tools/robot_report/reach_report.h"

#include "aspects/roadmap/pose_sampler.h"
#include "model/angles.h"
#include "model/message_text.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "tools/robot_report/reached_poses.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

struct TypedHome {
  AssembledConfiguration configuration;  // of what is typed
  int digits = exact_digits;
};

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

TypedHome typed_home(const Mechanism& mechanism) {
  const AssembledConfiguration home = mechanism.home();
  for (const int digits : {6, pose_digits, exact_digits}) {
    const auto pose = as_typed(mechanism.manipulator()->task_space(), home.pose, digits);
    if (!pose) continue;
    if (const auto q = solved_at(mechanism, *pose, home.q)) return {{*pose, *q}, digits};
  }
  return {home, exact_digits};
}

}  // namespace

Report report_home(const Mechanism& mechanism) {
  const TaskSpace space = mechanism.manipulator()->task_space();
  const TypedHome home = typed_home(mechanism);
  std::string named;
  const PoseCoordinates coordinates =
      pose_coordinates(space, home.configuration.pose).unaryExpr(&without_noise);
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    named += (k == 0 ? "" : ", ") + coordinate_names(space)[static_cast<std::size_t>(k)] + ' ' +
             shown(coordinates[k]);
  const TaskVector q = home.configuration.q.unaryExpr(&without_noise);
  const json object = {{"pose", json_pose(space, home.configuration.pose)},
                       {"joints", json_numbers(home.configuration.q)}};
  return {object, "home pose: " + named + " (--pose \"" +
                      pose_numbers(space, home.configuration.pose, home.digits) +
                      "\"), at the joint values " + shown(q) + "\n"};
}

namespace {

using nlohmann::json;

constexpr int samples = 4000, most_samples = 40000;
constexpr std::uint64_t seed = 1;

struct Reach {
  ReachedPoses poses;
  std::optional<Pose> from;  // where the flood began; nothing without a pose that is reached
  bool is_from_home = false;
  std::vector<CoordinateRange> alone;  // from there, where the platform turns
};

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

// Nothing where it is not bounded.
std::optional<Reach> find_reach(const Mechanism& mechanism) {
  const Manipulator& manipulator = *mechanism.manipulator();
  PoseSampler sampler(mechanism.manipulator(), seed, std::nullopt, EIGEN_PI);
  if (!sampler.is_bounded()) return std::nullopt;
  Reach reach;
  const Pose home = mechanism.home().pose;
  reach.is_from_home = is_reached(manipulator, home);
  if (reach.is_from_home) reach.from = home;
  reach.poses = drawn_all_over(manipulator, sampler, reach.from);
  if (!reach.from) return reach;
  if (has_translation(manipulator.task_space())) {
    const ReachedPoses flooded = flooded_from(manipulator, *reach.from);
    reach.poses = {reach.poses.positions.merged(flooded.positions), flooded.drawn, flooded.count};
  }
  if (!has_rotation(manipulator.task_space())) return reach;
  reach.alone = ranges_alone(manipulator, *reach.from);
  const std::size_t turns = rotational_degrees_of_freedom(manipulator.task_space());
  for (std::size_t k = turns; k < reach.alone.size(); ++k)
    for (const double moved : {reach.alone[k].lower, reach.alone[k].upper})
      reach.poses.positions.extend(reach.from->position +
                                   moved * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k - turns)));
  return reach;
}

// By entry of a twist.
std::vector<std::string> names_alone(TaskSpace space) {
  std::vector<std::string> names{"roll", "pitch", "yaw"};
  if (is_planar(space)) names = {"phi"};
  const std::vector<std::string> axes{"x", "y", "z"};
  names.insert(names.end(), axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(directions(space)));
  return names;
}

std::string range_text(const std::string& name, double lower, double upper) {
  return name + " from " + shown_briefly(lower) + " to " + shown_briefly(upper);
}

std::string positions_text(TaskSpace space, const Eigen::AlignedBox3d& positions) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::string text;
  for (std::size_t i = 0; i < directions(space); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    text += (text.empty() ? "" : ", ") + range_text(axes[i], positions.min()[k], positions.max()[k]);
  }
  return text + " m, about" + (has_rotation(space) ? ", over all orientations" : "");
}

// Positions first, as people write poses.
std::string alone_text(TaskSpace space, const Reach& reach) {
  const std::vector<std::string> names = names_alone(space);
  const auto turns = static_cast<std::size_t>(rotational_degrees_of_freedom(space));
  std::string lengths, angles;
  for (std::size_t k = 0; k < reach.alone.size(); ++k) {
    const CoordinateRange& range = reach.alone[k];
    std::string& text = k < turns ? angles : lengths;
    const double unit = k < turns ? 180.0 / pi : 1.0;
    text += (text.empty() ? "" : ", ") + range_text(names[k], unit * range.lower, unit * range.upper);
  }
  return "one coordinate alone, from " +
         (reach.is_from_home ? "the home pose" : to_string(space, *reach.from)) + ": " +
         (lengths.empty() ? "" : lengths + " m, ") + angles + " degrees, about\n";
}

std::string reach_text(TaskSpace space, const Reach& reach) {
  const std::string share = "the legs reach " + std::to_string(reach.poses.count) + " of " +
                            std::to_string(reach.poses.drawn) + " random poses";
  if (!reach.from) return "workspace: " + share + "\n";
  const std::string alone = has_rotation(space) ? alone_text(space, reach) : "";
  if (!has_translation(space)) return "workspace: " + share + "\n" + alone;
  return "workspace: " + positions_text(space, reach.poses.positions) + "; " + share +
         " where a flood from " + (reach.is_from_home ? "the home pose" : "one of them") + " has been\n" +
         alone;
}

json json_reach(TaskSpace space, const Reach& reach) {
  json object = {{"drawn_poses", reach.poses.drawn}, {"reached_poses", reach.poses.count}};
  if (!reach.from) return object;
  object["from"] = json_pose(space, *reach.from);
  json lower = json::object(), upper = json::object(), alone = json::object();
  const std::vector<std::string> names = names_alone(space);
  for (std::size_t k = 0; k < reach.alone.size(); ++k)
    alone[names[k]] = {{"lower", reach.alone[k].lower}, {"upper", reach.alone[k].upper}};
  for (std::size_t i = 0; i < directions(space); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    lower[coordinate_names(space)[i]] = reach.poses.positions.min()[k];
    upper[coordinate_names(space)[i]] = reach.poses.positions.max()[k];
  }
  object["lower"] = lower;
  object["upper"] = upper;
  object["alone"] = alone;
  return object;
}

}  // namespace

Report report_reach(const Mechanism& mechanism) {
  const auto reach = find_reach(mechanism);
  const TaskSpace space = mechanism.manipulator()->task_space();
  if (!reach)
    return {nullptr,
            "workspace: not bounded by the legs; limit the actuated joints, or give a workspace or a "
            "region\n"};
  return {json_reach(space, *reach), reach_text(space, *reach)};
}

}  // namespace parallel_aspects::tools
