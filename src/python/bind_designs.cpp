// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/design.h"
#include "tools/sweep/sweep_arguments.h"
#include "tools/sweep/sweep_file.h"

#include "python/asking.h"
#include "python/bindings.h"
#include <pybind11/stl.h>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

py::dict lengths_of_robot(const CoreRobot& robot) {
  py::dict lengths;
  for (const DesignParameter& parameter : design_parameters(*robot.manipulator))
    lengths[py::str(parameter.name)] = parameter.value;
  return lengths;
}

CoreRobot with_lengths(const CoreRobot& robot, const DesignValues& values, bool keep_ties) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  refuse_any(problems_of(*robot.manipulator, names, keep_ties));
  return {with_design(*robot.manipulator, values, keep_ties), nullptr, robot.acceleration};
}

void sweep(const CoreRobot& robot, const std::string& file, const py::dict& keywords, unsigned threads,
           const py::object& progress) {
  tools::Shard shard;
  Problems problems;
  const auto arguments = read_question<tools::SweepArguments>(*robot.manipulator, keywords);
  const tools::SweepPlan plan =
      tools::plan_sweep(robot.manipulator, arguments, ask::plain_name, shard, problems);
  refuse_any(problems);
  tools::SweepFile rows(plan, shard, file);
  run_long(progress, [&](const MapControl& control) {
    const auto tell = [&control](std::size_t done, std::size_t of) {
      control.progress(static_cast<double>(done) / static_cast<double>(of));
    };
    tools::run_sweep(plan, shard, threads, control, tell, rows);
    return true;
  });
}

}  // namespace

void bind_designs(RobotClass& robot) {
  robot.def_property_readonly("lengths", lengths_of_robot);
  robot.def("with_lengths", with_lengths);
  robot.def("sweep", sweep);
}

}  // namespace parallel_aspects::python
