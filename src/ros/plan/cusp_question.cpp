// SPDX-License-Identifier: BSD-3-Clause
#include "ros/plan/cusp_question.h"

#include "model/number_text.h"
#include "motion/choose/plan_around_cusp.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "ros/messages/conversions.h"

#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

Status read_what_goes_with_it(const PlanPathGoal& goal) {
  if (goal.around_cusp == 0)
    return invalid_request(
        "held_joint is for around_cusp, and that is 0; give the number of a cusp, from 1.");
  if (goal.policy != PlanPathGoal::STAY || goal.prefer != PlanPathGoal::SHORT || goal.parallel_margin != 0.0)
    return invalid_request(
        "A path around a cusp stays in one aspect and keeps away from singularities; give policy 0 (stay), "
        "prefer 0 (short) and parallel_margin 0.");
  if (goal.stay_in_domain)
    return invalid_request("Around a cusp no path stays in one uniqueness domain; leave out stay_in_domain.");
  return {};
}

/// Actuated values of the start, in its working mode; nothing where it has several.
std::optional<JointVector> values_of(const Manipulator& manipulator, const PathEnd& from) {
  if (from.q) return from.q;
  const auto modes = working_modes(manipulator);
  if (!from.mode && modes.size() != 1) return std::nullopt;
  const InverseSolution found = inverse(manipulator, from.pose, from.mode.value_or(modes.front()));
  return found.q.allFinite() ? std::make_optional(found.q) : std::nullopt;
}

/// Which cusps there are.
std::string list_of(const Manipulator& manipulator, const CuspQuestion& question, const CuspList& list) {
  std::string text = "There is no cusp " + std::to_string(question.cusp + 1) + " with " +
                     to_string(question.slice) + "; there are " + std::to_string(list.cusps.size());
  for (std::size_t k = 0; k < list.cusps.size(); ++k) {
    text += (k == 0 ? ": " : "; ") + std::to_string(k + 1) + " at";
    for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
      text += " " + number_text(list.cusps[k].actuated[static_cast<Eigen::Index>(j)]);
  }
  return text + ".";
}

constexpr int digits = 10;  // they take a pose onto the slice again

std::string listed(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_text(value, digits);
  return text;
}

/// As the fields of a `Configuration`, with the actuated values.
std::string fields_of(const Manipulator& manipulator, const PathPoint& point) {
  const geometry_msgs::Pose pose = pose_message(platform_in_base(manipulator, point.pose));
  const auto& at = pose.position;
  const auto& turned = pose.orientation;
  const auto signs = signs_message(point.mode);
  return "position (" + listed({at.x, at.y, at.z}) + ") and orientation (" +
         listed({turned.x, turned.y, turned.z, turned.w}) + ") in the base frame, working_mode [" +
         listed({signs.begin(), signs.end()}) + "], where the actuated values are " +
         listed({point.q.data(), point.q.data() + point.q.size()});
}

/// Where to begin in place of a start without a path.
std::string other_start_text(const Manipulator& manipulator, const CuspStart& start, std::size_t cusp) {
  if (start.aspect == 0) return "";
  const std::string text = " Cusp " + std::to_string(cusp + 1) + " belongs to component " +
                           std::to_string(start.aspect) + " of the slice";
  if (!start.point) return text + ", but from no pose beside it a path is found.";
  return text + "; a start of that component with a path is " + fields_of(manipulator, *start.point) + ".";
}

}  // namespace

Status read_cusp(const Manipulator& manipulator, const PlanPathGoal& goal, PathEnd& from,
                 std::optional<CuspQuestion>& question) {
  const Status status = read_what_goes_with_it(goal);
  if (status.code != Status::OK) return status;
  const auto values = values_of(manipulator, from);
  if (!values)
    return invalid_request(
        "The start has no actuated values, or several; give a pose in reach and working_mode.");
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    if (manipulator.leg(j).actuated_joint != goal.held_joint) continue;
    Problems problems;
    UniquenessOptions options;
    options.slice =
        make_slice(manipulator, {{goal.held_joint, (*values)[static_cast<Eigen::Index>(j)]}}, problems);
    if (problems.empty())
      if (const std::string why = find_uniqueness_problem(manipulator, options); !why.empty())
        problems.push_back(why);
    if (!problems.empty()) return invalid_request(problems.front());
    from.pose = circle_of_anchor(manipulator, *options.slice->joint).nearest(from.pose);
    question = CuspQuestion{*options.slice, goal.around_cusp - 1};
    return {};
  }
  return invalid_request("held_joint is '" + goal.held_joint.substr(0, 100) +
                         "'; give the name of an actuated joint, such as " +
                         manipulator.leg(0).actuated_joint + ".");
}

std::string several_cusps(const std::vector<int>& turns) {
  std::string list;
  int count = 0;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    if (turns[k] == 0) continue;
    list += (count++ == 0 ? "" : ", ") + std::to_string(k + 1);
  }
  return count > 1 ? "The actuated values go around several cusps: " + list + "." : "";
}

CuspPath plan_around_cusp(const std::shared_ptr<const Manipulator>& manipulator, const PathEnd& from,
                          const CuspQuestion& question, const MapControl& control) {
  CuspPath result;
  const CuspList list = find_cusps(*manipulator, *question.slice.joint, control);
  if (is_cancelled(control)) return result;
  if (question.cusp >= list.cusps.size()) {
    result.status = invalid_request(list_of(*manipulator, question, list));
    return result;
  }
  MapOptions options;
  options.slice = question.slice;
  const MapResult map = compute_aspect_map(manipulator, options, control);
  if (!map) {
    result.status = make_status(Status::FAILED, "There is no map of the slice: " + map.message);
    return result;
  }
  const auto planner = std::make_shared<CuspPlanner>(map.map, list.cusps);
  result.path = planner->plan(from, question.cusp, control);
  result.path.message +=
      result.path
          ? " " + noise_text(planner->followed_noise(result.path))
          : other_start_text(*manipulator, planner->find_start(question.cusp, control), question.cusp);
  result.turns_around_cusps = planner->turns_around_cusps(result.path);
  result.between = [planner](const Pose& a, const Pose& b, double t) { return planner->between(a, b, t); };
  return result;
}

}  // namespace parallel_aspects
