// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/check.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/distance.h"
#include "parallel_aspects/ask/inverse_direct.h"
#include "parallel_aspects/ask/jacobian.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/robot_description.h"
#include "parallel_aspects/ask/uniqueness_question.h"
#include "parallel_aspects/ask/workspace.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

/// Shape (n, 3, 2): to parallel and serial singularities and limits, each a lower and an upper bound.
Array distances(const CoreRobot& robot, const Array& values, const py::dict& keywords,
                const py::object& progress) {
  const Manipulator& manipulator = *robot.manipulator;
  const std::vector<Pose> poses = poses_of("poses", manipulator, values);
  const auto question = read_question<ask::DistanceQuestion>(manipulator, keywords);
  if (!question.mode) throw InvalidDescription({"mode is None; give a working mode, such as \"(+,-)\"."});
  Array result = empty_array({static_cast<py::ssize_t>(poses.size()), 3, 2});
  double* bounds = result.mutable_data();
  run_long(progress, [&](const MapControl& control) {
    BoundaryDistanceMeter meter(robot.manipulator, question.options());
    double* next = bounds;
    for (std::size_t i = 0; i < poses.size() && !is_cancelled(control); ++i) {
      const BoundaryDistances measured = meter.measure(poses[i], *question.mode);
      for (const BoundaryDistance* boundary :
           {&measured.parallel, &measured.serial, &measured.actuated_limit}) {
        *next++ = boundary->lower;
        *next++ = boundary->upper;
      }
      control.progress(static_cast<double>(i + 1) / static_cast<double>(poses.size()));
    }
    return true;
  });
  return result;
}

}  // namespace

void bind_distance(RobotClass& robot) { robot.def("distances", distances); }

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

/// With its samples.
py::dict check(const CoreRobot& robot, ask::CheckQuestion question, const py::object& progress) {
  question.keep_samples = true;
  SharedSession questions(robot.manipulator);
  return ask_session(questions, question, progress);
}

py::dict check_poses(const CoreRobot& robot, const Times& times, const Array& values,
                     const py::dict& keywords, const py::object& progress) {
  auto question = read_question<ask::CheckQuestion>(*robot.manipulator, keywords);
  question.path = waypoints_of(*robot.manipulator, times, values);
  return check(robot, std::move(question), progress);
}

py::dict check_joints(const CoreRobot& robot, const Times& times, const Array& values,
                      const py::dict& keywords, const py::object& progress) {
  auto question = read_question<ask::CheckQuestion>(*robot.manipulator, keywords);
  const std::vector<JointVector> joints = joints_of("q", *robot.manipulator, values);
  require_as_many(times, joints.size(), "q");
  question.trajectory.emplace();
  for (std::size_t i = 0; i < joints.size(); ++i)
    question.trajectory->push_back({times[i], joints[i], {}, {}});
  return check(robot, std::move(question), progress);
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
  questions.session.know(robot.mechanism);
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
  robot.def("check", check_poses);
  robot.def("check_joints", check_joints);
  robot.def("choose", choose);
  robot.def("configurations", ask_robot<ask::InverseQuestion>);
  robot.def("direct", ask_robot<ask::DirectQuestion>);
  robot.def("describe", ask_robot<ask::DescribeQuestion>);
  robot.def("jacobian", ask_robot<ask::JacobianQuestion>);
  robot.def("uniqueness", ask_robot<ask::UniquenessQuestion>);
  module.def("uniqueness_question", fields_of<ask::UniquenessQuestion>);
  module.def("inverse_answer", fields_of<ask::InverseInMode>);
  module.def("direct_answer", fields_of<ask::DirectAnswer>);
  module.def("jacobian_question", fields_of<ask::JacobianQuestion>);
  module.def("jacobian_at", fields_of<ask::JacobianAt>);
  module.def("jacobian_answer", fields_of<ask::JacobianAnswer>);
  bind_question<ask::PlanQuestion, ask::PlanAnswer>("plan", module, robot, map);
  module.def("map_question", fields_of<ask::MapQuestion>);
  module.def("map_answer", fields_of<ask::MapAnswer>);
  module.def("aspect_answer", fields_of<ask::MappedAspect>);
  bind_question<ask::GraphQuestion, ask::GraphAnswer>("graph", module, robot, map);
  bind_question<ask::ConnectQuestion, ask::ConnectAnswer>("connect", module, robot, map);
  bind_question<ask::DistanceQuestion, ask::DistancesInMode>("distance", module, robot, map);
  robot.def("locate", ask_robot<ask::LocateQuestion>);
  module.def("locate_question", fields_of<ask::LocateQuestion>);
  module.def("check_question", fields_of<ask::CheckQuestion>);
  module.def("check_answer", fields_of<ask::CheckAnswer>);
  module.def("choose_question", fields_of<ask::ChooseQuestion>);
  module.def("distance_to", fields_of<ask::DistanceTo>);
  bind_question<ask::LargestShapeQuestion, ask::ShapeInAspect>("workspace", module, robot, map);
}

}  // namespace parallel_aspects::python
