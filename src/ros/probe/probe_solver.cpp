// SPDX-License-Identifier: BSD-3-Clause
#include "ros/probe/probe_solver.h"

#include "ask/question_parts.h"
#include "model/spherical_links.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/configurations.h"
#include "ros/messages/conversions.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

std::string with_unit(const Manipulator& manipulator, double length) {
  constexpr int digits = 3;
  return distance_text(manipulator, length, digits);
}

// Why the wanted pose is not in reach.
std::string reason_of(const Manipulator& robot, const ProbeQuestion& question) {
  const InverseSolution solution = inverse(robot, question.wanted, question.mode);
  const Leg& leg = robot.leg(solution.leg);
  switch (solution.status) {
    case InverseStatus::out_of_reach:
      return "The pose is out of reach of " + leg.name;
    case InverseStatus::outside_limits:
      return "At the pose " + leg.actuated_joint + " is beyond its limits in working mode " +
             to_string(question.mode);
    case InverseStatus::solved:
      break;
  }
  return "At the pose a leg is stretched or folded";
}

Status status_of(const Manipulator& robot, const ProbeFinding& finding) {
  if (!finding.reached)
    return make_status(Status::NO_SOLUTION,
                       reason_of(robot, finding.question) + "; no pose of this working mode was found.");
  if (finding.reached->distance == 0.0) return {};
  return make_status(Status::NO_SOLUTION, reason_of(robot, finding.question) + "; the probe stays " +
                                              with_unit(robot, finding.reached->distance) +
                                              " away, at the nearest pose that was found.");
}

std::vector<JointVector> other_modes(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  std::vector<JointVector> others;
  for (const InverseSolution& solution : inverse_in_all_modes(robot, pose))
    if (solution && solution.mode != mode) others.push_back(solution.q);
  return others;
}

std::string aspect_text(const SolvedConfiguration& configuration) {
  switch (configuration.aspect_status) {
    case SolvedConfiguration::INSIDE:
      return "aspect " + std::to_string(configuration.aspect);
    case SolvedConfiguration::UNDECIDED:
      return "too near to a boundary to name the aspect";
    case SolvedConfiguration::OUTSIDE:
      return "in no aspect: a constraint does not hold";
    case SolvedConfiguration::NOT_MAPPED:
      return "outside the region of the map";
    case SolvedConfiguration::NO_MAP:
      if (configuration.roadmap_component != 0)
        return "component " + std::to_string(configuration.roadmap_component) + " of the roadmap";
      return "joined to no component of the roadmap";
    default:  // of a number in a message
      return "no map yet";
  }
}

std::string boundary_text(const Manipulator& manipulator, const char* what, const MetricDistance& distance) {
  const std::string start = std::string(what) + " ";
  if (distance.status == MetricDistance::ABSENT) return start + "none";
  if (std::isfinite(distance.upper)) return start + with_unit(manipulator, distance.upper);
  return start +
         (std::isfinite(distance.lower) ? "over " + with_unit(manipulator, distance.lower) : "unknown");
}

}  // namespace

ProbeSolver::ProbeSolver(std::shared_ptr<const Manipulator> manipulator)
    : manipulator_(std::move(manipulator)), nearest_(manipulator_), meter_(manipulator_) {}

ProbeFinding ProbeSolver::find(const ProbeQuestion& question, const KnownAspects& known,
                               const ros::Time& now) {
  const Manipulator& robot = *manipulator_;
  ProbeFinding finding;
  finding.question = question;
  finding.reached = nearest_.find(question.wanted, question.mode, last_);
  ProbeState& state = finding.state;
  state.header.stamp = now;
  state.header.frame_id = robot.base_frame();
  state.wanted = pose_message(platform_in_base(robot, question.wanted));
  state.working_mode = signs_message(question.mode);
  state.off = finding.reached ? finding.reached->distance : not_a_number;
  state.status = status_of(robot, finding);
  if (!finding.reached) return finding;
  last_ = finding.reached->pose;
  fill_report(known, finding);
  if (question.others) finding.others = other_modes(robot, *last_, question.mode);
  return finding;
}

void ProbeSolver::fill_report(const KnownAspects& known, ProbeFinding& finding) {
  ask::LocatedConfiguration located =
      ask::configuration_of(*manipulator_, finding.reached->pose, finding.reached->q);
  ask::locate_in(*manipulator_, known.map.get(), known.roadmap.get(), located);
  meter_.use(known.distances_of(manipulator_));
  finding.distances = meter_.measure(located.pose, finding.question.mode);
  finding.state.report =
      report_message(*manipulator_, located, finding.distances, finding.state.header.stamp);
  if (const std::uint32_t id = finding.state.report.configuration.aspect; known.map && id > 0)
    finding.color = aspect_colors(known.map->aspects())[id - 1];
}

std::string fault_of(const geometry_msgs::Pose& pose) {
  const geometry_msgs::Point& p = pose.position;
  const geometry_msgs::Quaternion& q = pose.orientation;
  const std::array<std::pair<const char*, double>, 7> numbers{{{"position.x", p.x},
                                                               {"position.y", p.y},
                                                               {"position.z", p.z},
                                                               {"orientation.x", q.x},
                                                               {"orientation.y", q.y},
                                                               {"orientation.z", q.z},
                                                               {"orientation.w", q.w}}};
  for (const auto& [name, value] : numbers)
    if (!std::isfinite(value))
      return std::string(name) + " is " + std::to_string(value) + "; it must be finite.";
  const double length = std::hypot(std::hypot(q.x, q.y), std::hypot(q.z, q.w));
  if (std::abs(length - 1.0) <= 1e-3) return {};
  return "orientation has the length " + std::to_string(length) +
         "; it must be a unit quaternion, such as x 0, y 0, z 0, w 1.";
}

bool is_near(const Manipulator& manipulator, const PoseSlice& section, const Pose& pose) noexcept {
  constexpr double share = 0.01;  // of a turn, or of the robot's size
  const TaskSpace space = manipulator.task_space();
  const double whole = has_rotation(space) ? 2.0 * EIGEN_PI : manipulator.size();
  return level_difference(space, section.level(), PoseSlice::through(space, pose).level()) <= share * whole;
}

std::string words_of(const Manipulator& manipulator, const ProbeFinding& finding) {
  const ProbeState& state = finding.state;
  if (!finding.reached) return "probe: " + state.status.message;
  const SingularityReport& report = state.report;
  std::string words = "probe: " + aspect_text(report.configuration) + ", " +
                      branch_text(finding.question.mode, report.configuration.determinant_sign) + "\n";
  if (finding.section)
    words += PoseSlice::through(manipulator.task_space(), finding.reached->pose).text() +
             ", but aspects are drawn at " + finding.section->text() + "\n";
  words += boundary_text(manipulator, "parallel", report.parallel_distance) + ", " +
           boundary_text(manipulator, "serial", report.serial_distance) + ", " +
           boundary_text(manipulator, "limit", report.limit_distance);
  if (finding.reached->distance > 0.0)
    words += "\nout of reach: it stays at the nearest pose found, " +
             with_unit(manipulator, finding.reached->distance) + " from " +
             to_string(manipulator.task_space(), finding.question.wanted);
  return words;
}

}  // namespace parallel_aspects
