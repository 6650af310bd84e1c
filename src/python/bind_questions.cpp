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
#include <map>
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

/// A question by its name: its fields, and who answers it.
struct Asked {
  py::list (*fields)();
  py::dict (*ask)(SharedSession& shared, const py::dict& keywords, const py::object& progress);
};

template <class Question>
Asked asked() {
  return {fields_of<Question>,
          [](SharedSession& shared, const py::dict& keywords, const py::object& progress) {
            const Manipulator& robot = *shared.session.robot();
            return dict_of(robot, answered(shared, read_question<Question>(robot, keywords), progress));
          }};
}

const std::map<std::string, Asked>& questions() {
  static const std::map<std::string, Asked> all{{"check", asked<ask::CheckQuestion>()},
                                                {"choose", asked<ask::ChooseQuestion>()},
                                                {"connect", asked<ask::ConnectQuestion>()},
                                                {"describe", asked<ask::DescribeQuestion>()},
                                                {"direct", asked<ask::DirectQuestion>()},
                                                {"distance", asked<ask::DistanceQuestion>()},
                                                {"graph", asked<ask::GraphQuestion>()},
                                                {"inverse", asked<ask::InverseQuestion>()},
                                                {"jacobian", asked<ask::JacobianQuestion>()},
                                                {"locate", asked<ask::LocateQuestion>()},
                                                {"map", asked<ask::MapQuestion>()},
                                                {"plan", asked<ask::PlanQuestion>()},
                                                {"uniqueness", asked<ask::UniquenessQuestion>()},
                                                {"workspace", asked<ask::LargestShapeQuestion>()}};
  return all;
}

/// By the class of the module that holds it.
const std::map<std::string, py::list (*)()>& answers() {
  static const std::map<std::string, py::list (*)()> all{{"Aspect", fields_of<ask::MappedAspect>},
                                                         {"BoundaryDistance", fields_of<ask::DistanceTo>},
                                                         {"Check", fields_of<ask::CheckAnswer>},
                                                         {"Configuration", fields_of<ask::InverseInMode>},
                                                         {"DirectSolutions", fields_of<ask::DirectAnswer>},
                                                         {"Distances", fields_of<ask::DistancesInMode>},
                                                         {"Jacobian", fields_of<ask::JacobianAt>},
                                                         {"Jacobians", fields_of<ask::JacobianAnswer>},
                                                         {"Map", fields_of<ask::MapAnswer>},
                                                         {"Path", fields_of<ask::PlanAnswer>},
                                                         {"Roadmap", fields_of<ask::SampledAspects>},
                                                         {"Workspace", fields_of<ask::ShapeInAspect>}};
  return all;
}

py::list fields(const std::string& name) {
  const auto question = questions().find(name);
  return question != questions().end() ? question->second.fields() : answers().at(name)();
}

py::dict ask_robot(const CoreRobot& robot, const std::string& question, const py::dict& keywords,
                   const py::object& progress) {
  SharedSession shared(robot);
  return questions().at(question).ask(shared, keywords, progress);
}

py::dict ask_map(const CoreMap& map, const std::string& question, const py::dict& keywords,
                 const py::object& progress) {
  return questions().at(question).ask(*map.questions, keywords, progress);
}

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

void bind_questions(py::module& module, RobotClass& robot, MapClass& map) {
  module.def("fields", fields);
  robot.def("ask", ask_robot);
  robot.def("distances", distances);
  map.def("ask", ask_map);
}

}  // namespace parallel_aspects::python
