// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/distance.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/workspace.h"
#include "parallel_aspects/motion/check_joint_trajectory.h"
#include "tools/report/answer_json.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "python/python_errors.h"
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

using Times = std::vector<double>;

void require_as_many(const Times& times, std::size_t count, const std::string& name) {
  if (times.size() != count)
    throw InvalidDescription({"times has " + std::to_string(times.size()) + " entries, and " + name + " " +
                              std::to_string(count) + "; give as many."});
}

std::vector<PoseWaypoint> waypoints_of(const Manipulator& manipulator, const Times& times,
                                       const Array& values) {
  const std::vector<Pose> poses = poses_of("poses", manipulator, values);
  require_as_many(times, poses.size(), "poses");
  std::vector<PoseWaypoint> waypoints;
  for (std::size_t i = 0; i < poses.size(); ++i) waypoints.push_back({times[i], poses[i]});
  return waypoints;
}

py::object leg_name(const Manipulator& manipulator, const std::optional<std::size_t>& leg) {
  return leg ? py::object(py::str(manipulator.leg(*leg).name)) : py::none();
}

py::dict crossing_dict(const Manipulator& manipulator, const TrajectoryCrossing& crossing) {
  py::dict result;
  result["kind"] = name(crossing.kind);
  result["leg"] = leg_name(manipulator, crossing.leg);
  result["after"] = crossing.after;
  result["before"] = crossing.before;
  result["mode"] = crossing.mode ? py::object(py::str(to_string(*crossing.mode))) : py::none();
  result["determinant_sign"] = crossing.determinant_sign;
  return result;
}

py::dict samples_dict(const Manipulator& manipulator, const std::vector<TrajectorySample>& samples) {
  std::vector<double> times, parallel;
  std::vector<Pose> poses;
  std::vector<TaskVector> q, serial;
  for (const TrajectorySample& sample : samples) {
    times.push_back(sample.time);
    parallel.push_back(sample.parallel_index);
    poses.push_back(sample.pose);
    q.push_back(sample.q);
    serial.push_back(sample.serial_indices);
  }
  py::dict result;
  result["times"] = array_of(times);
  result["poses"] = array_of(manipulator.task_space(), poses);
  result["q"] = array_of(q, manipulator.leg_count());
  result["parallel_index"] = array_of(parallel);
  result["serial_indices"] = array_of(serial, manipulator.leg_count());
  return result;
}

/// Shape (legs, 2): each actuated joint is at least once so fast, and never faster.
Array speeds_of(const TrajectoryCheck& check) {
  std::vector<TaskVector> rows;
  for (const FastestMotion& speed : check.speeds)
    rows.emplace_back(Eigen::Vector2d(speed.value, speed.bound));
  return array_of(rows, 2);
}

py::dict check_dict(const Manipulator& manipulator, const TrajectoryCheck& check) {
  if (check.refused) throw InvalidDescription({check.reason});
  py::list crossings;
  for (const TrajectoryCrossing& crossing : check.crossings)
    crossings.append(crossing_dict(manipulator, crossing));
  py::dict result;
  result["answer"] = name(check.answer);
  result["reason"] = check.reason;
  result["free_until"] = check.free_until;
  result["violation"] =
      check.violation ? object_of(tools::JsonWriter(manipulator).json_of(*check.violation)) : py::none();
  result["crossings"] = crossings;
  result["least_parallel_index"] = check.parallel_index.value;
  result["least_serial_index"] = check.serial_index.value;
  result["speeds"] = speeds_of(check);
  result["samples"] = samples_dict(manipulator, check.samples);
  return result;
}

TrajectoryCheckOptions check_options(const MapControl& control) {
  TrajectoryCheckOptions options;
  options.keep_samples = true;
  options.control = control;
  return options;
}

py::dict check(const CoreRobot& robot, const Times& times, const Array& values, const std::string& text) {
  const Manipulator& manipulator = *robot.manipulator;
  const std::vector<PoseWaypoint> waypoints = waypoints_of(manipulator, times, values);
  const WorkingMode mode = mode_of("mode", manipulator, text);
  refuse_any(problems_of(manipulator, waypoints, mode));
  return check_dict(manipulator, run_long(py::none(), [&](const MapControl& control) {
                      return check_trajectory(SegmentCertifier(robot.manipulator), waypoints, mode,
                                              check_options(control));
                    }));
}

py::dict check_joints(const CoreRobot& robot, const Times& times, const Array& values,
                      const py::object& start_pose, int start_sign, bool pass_serial) {
  const Manipulator& manipulator = *robot.manipulator;
  const std::vector<JointVector> joints = joints_of("q", manipulator, values);
  require_as_many(times, joints.size(), "q");
  std::vector<JointWaypoint> waypoints;
  for (std::size_t i = 0; i < joints.size(); ++i) waypoints.push_back({times[i], joints[i], {}, {}});
  TrajectoryStart start;
  if (!start_pose.is_none()) start.pose = pose_of("start_pose", manipulator, start_pose.cast<Array>());
  start.determinant_sign = start_sign;
  refuse_any(problems_of(manipulator, waypoints, start));
  return check_dict(manipulator, run_long(py::none(), [&](const MapControl& control) {
                      TrajectoryCheckOptions options = check_options(control);
                      options.pass_serial = pass_serial;
                      return check_trajectory(SegmentCertifier(robot.manipulator), waypoints, start, options);
                    }));
}

/// Of a path, where there are times, and else of a region.
py::dict choose(const CoreRobot& robot, const py::object& times, const py::object& values,
                const py::dict& keywords, const py::object& map, const py::object& progress) {
  auto question = read_question<ask::ChooseQuestion>(*robot.manipulator, keywords);
  if (!times.is_none())
    question.path = waypoints_of(*robot.manipulator, times.cast<Times>(), values.cast<Array>());
  if (map.is_none()) {
    SharedSession questions(robot.manipulator);
    return ask_session(questions, question, progress);
  }
  const auto& known = map.cast<const CoreMap&>();
  if (known.map->manipulator() != robot.manipulator)
    throw InvalidDescription({"map is of another robot; give one that this robot's map() returned."});
  return ask_session(*known.questions, question, progress);
}

template <class Question>
py::dict ask_robot(const CoreRobot& robot, const py::dict& keywords, const py::object& progress) {
  SharedSession questions(robot.manipulator);
  return ask_session(questions, read_question<Question>(*robot.manipulator, keywords), progress);
}

template <class Question>
py::dict ask_map(const CoreMap& map, const py::dict& keywords, const py::object& progress) {
  return ask_session(*map.questions, read_question<Question>(map.robot(), keywords), progress);
}

template <class Question, class Answer>
void bind_question(const std::string& name, py::module& module, RobotClass& robot, MapClass& map) {
  module.def((name + "_question").c_str(), fields_of<Question>);
  module.def((name + "_answer").c_str(), fields_of<Answer>);
  robot.def(name.c_str(), ask_robot<Question>);
  map.def(name.c_str(), ask_map<Question>);
}

}  // namespace

void bind_motion(py::module& module, RobotClass& robot, MapClass& map) {
  robot.def("check", check);
  robot.def("check_joints", check_joints);
  robot.def("choose", choose);
  bind_question<ask::PlanQuestion, ask::PlanAnswer>("plan", module, robot, map);
  bind_question<ask::ConnectQuestion, ask::ConnectAnswer>("connect", module, robot, map);
  bind_question<ask::DistanceQuestion, ask::DistancesInMode>("distance", module, robot, map);
  module.def("choose_question", fields_of<ask::ChooseQuestion>);
  module.def("distance_to", fields_of<ask::DistanceTo>);
  bind_question<ask::LargestShapeQuestion, ask::ShapeInAspect>("workspace", module, robot, map);
}

}  // namespace parallel_aspects::python
