// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_arguments.h"
#include "tools/sweep/sweep_file.h"

#include "python/asking.h"
#include "python/bindings.h"

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

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
