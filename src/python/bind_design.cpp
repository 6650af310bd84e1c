// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"
#include "tools/arguments.h"
#include "tools/report/uniqueness_report.h"
#include "tools/sweep/sweep_arguments.h"
#include "tools/sweep/sweep_file.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

/// Of `uniqueness`.
struct UniquenessKeywords {
  UniquenessOptions options;
};

template <class Visit>
void describe(Visit& visit, UniquenessKeywords& keywords) {
  visit({"slice", "", ""}, keywords.options.slice);
  visit({"resolution", "", ""}, keywords.options.resolution);
}

void sweep(const CoreRobot& robot, const std::string& file, const py::dict& keywords, unsigned threads,
           const py::object& progress) {
  tools::Shard shard;
  Problems problems;
  const auto arguments = read_question<tools::SweepArguments>(*robot.manipulator, keywords);
  const tools::SweepPlan plan = tools::plan_sweep(robot.manipulator, arguments, shard, problems);
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

py::object uniqueness(const CoreRobot& robot, const py::dict& keywords, const py::object& progress) {
  const auto asked = read_question<UniquenessKeywords>(*robot.manipulator, keywords);
  const auto result = run_long(progress, [&](const MapControl& control) {
    return compute_uniqueness(robot.manipulator, asked.options, control);
  });
  if (!result) throw InvalidDescription({result.message});
  return object_of(tools::report_uniqueness(*result.uniqueness).json);
}

py::object cusp_curves(const CoreRobot& robot, const std::string& over, const py::object& progress) {
  Problems problems;
  const HeldRange range = tools::parse_held_range("over", *robot.manipulator, over, problems);
  refuse_any(problems);
  const CuspCurves found = run_long(progress, [&](const MapControl& control) {
    return find_cusp_curves(*robot.manipulator, range, control);
  });
  return object_of(tools::report_cusp_curves(*robot.manipulator, found).json);
}

}  // namespace

void bind_design(RobotClass& robot) {
  robot.def("sweep", sweep);
  robot.def("uniqueness", uniqueness);
  robot.def("cusp_curves", cusp_curves);
}

}  // namespace parallel_aspects::python
