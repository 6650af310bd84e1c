// SPDX-License-Identifier: BSD-3-Clause
#include "ask/constraint_choice.h"
#include "parallel_aspects/aspects/design.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "tools/shipped_robots.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include <array>
#include <limits>
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct ShippedRobot {
  const char* name;
  SharedMechanism (*load)();
};

constexpr std::array<ShippedRobot, 16> shipped_robots{{{"agile_eye", models::agile_eye},
                                                       {"ankle", models::ankle},
                                                       {"bipod", models::bipod},
                                                       {"delta", models::delta},
                                                       {"five_bar", models::five_bar},
                                                       {"four_bar", models::four_bar},
                                                       {"hexa", models::hexa},
                                                       {"linear_delta", models::linear_delta},
                                                       {"six_pus", models::six_pus},
                                                       {"skew_wrist", models::skew_wrist},
                                                       {"spherical_3rrr", models::spherical_3rrr},
                                                       {"stewart", models::stewart},
                                                       {"three_prr", models::three_prr},
                                                       {"three_rpr", models::three_rpr},
                                                       {"three_rrr", models::three_rrr},
                                                       {"tilt_table", models::tilt_table}}};

std::vector<std::string> robots() {
  std::vector<std::string> names;
  for (const ShippedRobot& robot : shipped_robots) names.emplace_back(robot.name);
  return names;
}

py::tuple loaded(const SharedMechanism& mechanism) {
  return py::make_tuple(CoreRobot{mechanism->mapped_manipulator(), mechanism, mechanism->acceleration()},
                        mechanism->notes());
}

py::tuple load(const std::string& name) {
  for (const ShippedRobot& robot : shipped_robots)
    if (name == robot.name) return loaded(robot.load());
  throw InvalidDescription({tools::no_such_robot(name, robots(), "a URDF and a YAML file")});
}

py::tuple load_files(const std::string& urdf, const std::string& config) {
  return loaded(load_mechanism_files(urdf, config));
}

Array joint_limits(const CoreRobot& robot) {
  std::vector<TaskVector> rows;
  for (const Leg& leg : robot.manipulator->legs())
    rows.push_back(Eigen::Vector2d(leg.limits.lower, leg.limits.upper));
  return array_of(rows, 2);
}

template <class Name>
std::vector<std::string> names_of_legs(const CoreRobot& robot, const Name& name) {
  std::vector<std::string> names;
  for (const Leg& leg : robot.manipulator->legs()) names.push_back(name(leg));
  return names;
}

std::vector<std::string> mode_texts(const CoreRobot& robot) {
  std::vector<std::string> texts;
  for (const WorkingMode& mode : working_modes(*robot.manipulator)) texts.push_back(to_string(mode));
  return texts;
}

std::vector<std::string> constraints_of(const CoreRobot& robot) {
  std::vector<std::string> names;
  const ConstraintKinds kinds = robot.manipulator->constraint_kinds();
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kinds[index_of(kind)]) names.emplace_back(name(kind));
  return names;
}

py::dict lengths_of_robot(const CoreRobot& robot) {
  py::dict lengths;
  for (const DesignParameter& parameter : design_parameters(*robot.manipulator))
    lengths[py::str(parameter.name)] = parameter.value;
  return lengths;
}

CoreRobot constrained(const CoreRobot& robot, const py::dict& keywords) {
  ask::ProblemList problems;
  const auto choice = read_question<ask::ConstraintChoice>(*robot.manipulator, keywords);
  auto chosen = ask::constrained(robot.manipulator, choice, problems);
  refuse_any(texts_of(problems, ask::plain_name));
  return {std::move(chosen), nullptr, robot.acceleration};
}

CoreRobot with_lengths(const CoreRobot& robot, const DesignValues& values, bool keep_ties) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  refuse_any(problems_of(*robot.manipulator, names, keep_ties));
  return {with_design(*robot.manipulator, values, keep_ties), nullptr, robot.acceleration};
}

/// Shape (n, legs); rows of NaN where the mode does not reach the pose within limits.
Array inverse_of(const CoreRobot& robot, const Array& values, const py::object& signs) {
  const Manipulator& manipulator = *robot.manipulator;
  const std::vector<Pose> poses = poses_of("poses", manipulator, values);
  const WorkingMode mode = mode_of("mode", manipulator, signs);
  const auto rows = run_long(py::none(), [&](const MapControl& control) {
    std::vector<TaskVector> solved;
    solved.reserve(poses.size());
    for (const Pose& pose : poses) {
      if (is_cancelled(control)) break;
      const InverseSolution solution = inverse(manipulator, pose, mode);
      solved.push_back(
          solution ? solution.q
                   : TaskVector::Constant(static_cast<Eigen::Index>(manipulator.leg_count()), not_a_number));
    }
    return solved;
  });
  return array_of(rows, manipulator.leg_count());
}

/// The parallel index of each pose, shape (n,), and the serial indices, shape (n, legs); NaN where not
/// reached.
py::tuple indices_of(const CoreRobot& robot, const Array& values, const py::object& signs) {
  const Manipulator& manipulator = *robot.manipulator;
  const WorkingMode mode = mode_of("mode", manipulator, signs);
  std::vector<double> parallel;
  std::vector<TaskVector> serial;
  for (const Pose& pose : poses_of("poses", manipulator, values)) {
    const InverseSolution solution = inverse(manipulator, pose, mode);
    parallel.push_back(solution ? parallel_index(manipulator, pose, solution.q) : not_a_number);
    serial.push_back(
        solution ? serial_indices(manipulator, pose, solution.q)
                 : TaskVector::Constant(static_cast<Eigen::Index>(manipulator.leg_count()), not_a_number));
  }
  return py::make_tuple(array_of(parallel), array_of(serial, manipulator.leg_count()));
}

}  // namespace

void bind_loading(py::module& module) {
  module.def("robots", robots);
  module.def("load", load);
  module.def("load_files", load_files);
}

void bind_robot(RobotClass& robot) {
  const auto property = [&robot](const char* name, auto get) {
    robot.def_property_readonly(name, [get](const CoreRobot& self) { return get(*self.manipulator); });
  };
  property("name", [](const Manipulator& m) { return m.name(); });
  property("task_space", [](const Manipulator& m) { return std::string(name(m.task_space())); });
  property("coordinates", [](const Manipulator& m) { return coordinate_names(m.task_space()); });
  property("characteristic_length", [](const Manipulator& m) { return m.characteristic_length(); });
  property("size", [](const Manipulator& m) { return m.size(); });
  property("base_frame", [](const Manipulator& m) { return m.base_frame(); });
  robot.def_property_readonly("legs", [](const CoreRobot& self) {
    return names_of_legs(self, [](const Leg& leg) { return leg.name; });
  });
  robot.def_property_readonly("actuated_joints", [](const CoreRobot& self) {
    return names_of_legs(self, [](const Leg& leg) { return leg.actuated_joint; });
  });
  robot.def_property_readonly("joint_limits", joint_limits);
  robot.def_property_readonly("working_modes", mode_texts);
  robot.def_property_readonly("constraints", constraints_of);
  robot.def_property_readonly("lengths", lengths_of_robot);
  robot.def("constrained", constrained);
  robot.def("with_lengths", with_lengths);
  robot.def("inverse", inverse_of);
  robot.def("indices", indices_of);
}

}  // namespace parallel_aspects::python
