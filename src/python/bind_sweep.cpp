// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_arguments.h"
#include "tools/sweep/sweep_file.h"

#include "python/asking.h"
#include "python/bindings.h"

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

<<<<<<< HEAD:src/python/bind_designs.cpp
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

=======
>>>>>>> fddf1880 (Lengths of robots stay without sweeps, since describe lists them):src/python/bind_sweep.cpp
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

void bind_sweep(RobotClass& robot) { robot.def("sweep", sweep); }

}  // namespace parallel_aspects::python
