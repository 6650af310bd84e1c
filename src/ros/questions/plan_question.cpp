// SPDX-License-Identifier: BSD-3-Clause
#include "ros/questions/plan_question.h"

#include "model/message_text.h"
#include "motion/choose/plan_around_cusp.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/conversions.h"
#include "ros/messages/motion_messages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr int poses_of_a_segment = 32;

std::set<std::size_t> regions_along(const PlannedPath& path, const PoseBetween& between,
                                    const Uniqueness& uniqueness) {
  std::set<std::size_t> regions;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k <= poses_of_a_segment; ++k) {
      const double t = static_cast<double>(k) / poses_of_a_segment;
      const Pose pose = between(path.points[i].pose, path.points[i + 1].pose, t);
      if (const auto region = uniqueness.locate(pose, path.points[i].mode)) regions.insert(*region);
    }
  return regions;
}

bool has_two_apart(const std::set<std::size_t>& regions, const Uniqueness& uniqueness) {
  for (const std::size_t a : regions)
    for (const std::size_t b : regions)
      if (a < b && uniqueness.sharing(a, b) == DomainSharing::apart) return true;
  return false;
}

std::vector<std::size_t> domains_of_all(const std::set<std::size_t>& regions, const Uniqueness& uniqueness) {
  std::vector<std::size_t> common;
  for (const std::size_t region : regions) {
    const std::vector<std::size_t> domains = uniqueness.domains_of(region);  // rising
    std::vector<std::size_t> both;
    std::set_intersection(common.begin(), common.end(), domains.begin(), domains.end(),
                          std::back_inserter(both));
    common = region == *regions.begin() ? domains : both;
  }
  return common;
}

bool is_proved(const PlannedPath& path, const Uniqueness& uniqueness) {
  if (!uniqueness.regions_along || !path.crossings.empty()) return false;
  std::vector<Pose> poses;
  for (const PathPoint& point : path.points) poses.push_back(point.pose);
  return uniqueness.regions_along(poses).has_value();
}

PathDomains in_regions(const PlannedPath& path, const PoseBetween& between, const Uniqueness& uniqueness,
                       bool in_slice) {
  const std::set<std::size_t> regions = regions_along(path, between, uniqueness);
  if (has_two_apart(regions, uniqueness))
    return {
        SameAspect::no, {}, "two of its poses lie in basic regions that no uniqueness domain holds both."};
  PathDomains result;
  result.domains = domains_of_all(regions, uniqueness);
  if (!in_slice && is_proved(path, uniqueness)) {
    result.in_one = SameAspect::yes;
    return result;
  }
  result.message = result.domains.empty()
                       ? "no uniqueness domain is known that holds all of it."
                       : "that it stays in one uniqueness domain was seen at 32 poses a segment, and is not "
                         "proved of what lies between.";
  return result;
}

}  // namespace

PathDomains domains_along(const PlannedPath& path, const PoseBetween& between, const KnownDomains& known,
                          bool in_slice) {
  if (!path) return {};
  if (known.known == UniquenessState::ASPECTS) {
    if (path.crossings.empty()) return {SameAspect::yes, {}, ""};
    return {SameAspect::no, {}, "it leaves an aspect, and with that its uniqueness domain."};
  }
  if (known.uniqueness) return in_regions(path, between, *known.uniqueness, in_slice);
  return {SameAspect::unknown, {}, "uniqueness domains are not known. " + known.message};
}

void write_domains(const PathDomains& domains, PlanPathResult& result) {
  result.in_one_domain = domains.in_one == SameAspect::yes  ? PlanPathResult::YES
                         : domains.in_one == SameAspect::no ? PlanPathResult::NO
                                                            : PlanPathResult::UNKNOWN;
  for (const std::size_t domain : domains.domains)
    result.domains.push_back(static_cast<std::uint32_t>(domain + 1));
}

namespace {

/// As the fields of a goal.
std::string message_field(const std::string& field) {
  if (field == "slice") return "held_names and held_values, or held_joint";
  if (field == "start_mode" || field == "goal_mode")
    return field.substr(0, field.find('_')) + ".working_mode";
  return field;
}

/// Actuated values of the start, in its working mode; nothing where it has several.
std::optional<JointVector> values_of(const Manipulator& manipulator, const ask::EndQuestion& start) {
  if (start.tracked) return start.tracked->q;
  const auto modes = working_modes(manipulator);
  if (!start.mode && modes.size() != 1) return std::nullopt;
  const InverseSolution found = inverse(manipulator, *start.pose, start.mode.value_or(modes.front()));
  return found.q.allFinite() ? std::make_optional(found.q) : std::nullopt;
}

/// The joint with its value at the start.
Status hold_joint(const Manipulator& manipulator, const std::string& joint, const ask::EndQuestion& start,
                  std::vector<HeldCoordinate>& held) {
  const auto values = values_of(manipulator, start);
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    if (manipulator.leg(j).actuated_joint != joint) continue;
    if (!values)
      return invalid_request(
          "The start has no actuated values, or several; give a pose in reach and working_mode.");
    held.push_back({joint, (*values)[static_cast<Eigen::Index>(j)]});
    return {};
  }
  return invalid_request("held_joint is '" + joint.substr(0, 100) +
                         "'; give the name of an actuated joint, such as " +
                         manipulator.leg(0).actuated_joint + ".");
}

Status read_hold(const Manipulator& manipulator, const PlanPathGoal& goal, ask::PlanQuestion& question) {
  if (goal.held_names.size() != goal.held_values.size())
    return invalid_request("held_names and held_values differ in length; give a value for each name.");
  std::vector<HeldCoordinate> held;
  for (std::size_t i = 0; i < goal.held_names.size(); ++i)
    held.push_back({goal.held_names[i], goal.held_values[i]});
  if (!goal.held_joint.empty()) {
    const Status status = hold_joint(manipulator, goal.held_joint, question.start, held);
    if (status.code != Status::OK) return status;
  }
  if (held.empty()) return {};
  Problems problems;
  question.map.hold = make_slice(manipulator, held, problems);
  return problems.empty() ? Status() : invalid_request(problems.front());
}

/// A sentence that lists the cusps which a path goes around, from 1, where these are several; else nothing.
std::string several_cusps(const std::vector<int>& turns) {
  std::string list;
  int count = 0;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    if (turns[k] == 0) continue;
    list += (count++ == 0 ? "" : ", ") + std::to_string(k + 1);
  }
  return count > 1 ? " The actuated values go around several cusps: " + list + "." : "";
}

std::string listed(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_text(value, pose_digits);
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

/// Where to begin in place of a start without a path around a cusp.
std::string other_start_text(const Manipulator& manipulator, const ask::PlanAnswer& answer) {
  const CuspStart& start = answer.other_start;
  if (start.aspect == 0) return "";
  const std::string text = " Cusp " + std::to_string(answer.around_cusp->value) + " belongs to component " +
                           std::to_string(start.aspect) + " of the slice";
  if (!start.point) return text + ", but from no pose beside it a path is found.";
  return text + "; a start of that component with a path is " + fields_of(manipulator, *start.point) + ".";
}

std::string reason_of(const Manipulator& manipulator, const ask::PlanAnswer& answer) {
  std::string text = answer.path.message + other_start_text(manipulator, answer);
  if (answer.encoder_noise) text += " " + noise_text(*answer.encoder_noise);
  for (const std::string& each : answer.remarks) text += " " + ask::with_names(each, message_field);
  if (answer.turns_around_cusps) text += several_cusps(*answer.turns_around_cusps);
  return text;
}

}  // namespace

Status read_wish(const Manipulator& manipulator, const PlanPathGoal& goal, ask::PlanQuestion& question) {
  if (goal.policy > PlanPathGoal::ANY)
    return invalid_request("policy must be 0 (stay), 1 (serial) or 2 (any).");
  if (goal.prefer > PlanPathGoal::QUICK)
    return invalid_request("prefer must be 0 (short), 1 (clear), 2 (fast) or 3 (quick).");
  question.policy = choices(PathPolicy())[goal.policy];
  question.prefer = choices(PathPreference())[goal.prefer];
  if (goal.path_only && question.prefer == PathPreference::fast)
    return invalid_request("prefer 2 (fast) needs the path in time; leave out path_only.");
  if (!goal.path_only) question.timed_for = "Without {path_only} the path in time";
  if (goal.around_cusp > decltype(question.around_cusp)::value_type::upper)
    return invalid_request("around_cusp is " + std::to_string(goal.around_cusp) +
                           "; give the number of a cusp, from 1.");
  if (goal.around_cusp > 0) question.around_cusp.emplace().value = goal.around_cusp;
  if (goal.around_cusp > 0 && goal.stay_in_domain)
    return invalid_request("Around a cusp no path stays in one uniqueness domain; leave out stay_in_domain.");
  if (goal.around_cusp > 0 && goal.parallel_margin > 0.0)
    return invalid_request("A path around a cusp keeps no margin; give parallel_margin 0.");
  return read_hold(manipulator, goal, question);
}

Status refused(const ask::ProblemList& problems) {
  std::string text;
  for (const std::string& each : texts_of(problems, message_field)) text += (text.empty() ? "" : " ") + each;
  return invalid_request(text);
}

void write_answer(const Manipulator& manipulator, const ask::PlanAnswer& answer, PlanPathResult& result) {
  write_path(manipulator, answer.path, result);
  result.reason = reason_of(manipulator, answer);
  if (answer.path) result.between_points = ask::between_points(answer);
  result.moved_onto_slice = answer.moved_onto_slice.value_or(0.0);
  result.encoder_noise = answer.encoder_noise.value_or(0.0);
  if (answer.turns_around_cusps)
    result.turns_around_cusps.assign(answer.turns_around_cusps->begin(), answer.turns_around_cusps->end());
  if (answer.timed) write_timing(manipulator, *answer.timed, result);
}

}  // namespace parallel_aspects
