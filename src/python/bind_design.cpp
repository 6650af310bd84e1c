// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"
#include "tools/held_range.h"
#include "tools/report/uniqueness_report.h"
#include "tools/sweep/sweep_arguments.h"
#include "tools/sweep/sweep_file.h"
#include "tools/sweep/sweep_run.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "python/python_errors.h"
#include <map>
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

/// Keyword arguments as text; empty where not given.
using Texts = std::map<std::string, std::string>;

std::string text_of(const Texts& texts, const char* name) {
  const auto found = texts.find(name);
  return found == texts.end() ? "" : found->second;
}

tools::SweepArguments sweep_arguments(const ask::ShapeQuestion& shape, const Texts& texts, bool untied) {
  tools::SweepArguments arguments;
  arguments.shape = shape;
  arguments.vary = text_of(texts, "vary");
  arguments.sample = text_of(texts, "sample");
  arguments.designs = text_of(texts, "designs");
  arguments.figures = text_of(texts, "report");
  arguments.shard = text_of(texts, "shard");
  arguments.resolution = text_of(texts, "resolution");
  arguments.slice = text_of(texts, "slice");
  arguments.modes = text_of(texts, "mode");
  arguments.untied = untied;
  return arguments;
}

void sweep(const CoreRobot& robot, const std::string& file, const Texts& texts, const py::dict& shape,
           bool untied, unsigned threads, const py::object& progress) {
  tools::Shard shard;
  const auto asked = read_question<ask::ShapeQuestion>(*robot.manipulator, shape);
  const tools::SweepPlan plan = asked_by_keywords([&] {
    const tools::SweepArguments arguments = sweep_arguments(asked, texts, untied);
    Problems problems;
    tools::SweepPlan parsed = tools::parse_sweep(arguments, shard, problems);
    refuse_any(problems);
    tools::set_robot(robot.manipulator, arguments, parsed, problems);
    refuse_any(problems);
    return parsed;
  });
  tools::SweepFile rows(plan, shard, file);
  run_long(progress, [&](const MapControl& control) {
    const auto tell = [&control](std::size_t done, std::size_t of) {
      control.progress(static_cast<double>(done) / static_cast<double>(of));
    };
    tools::run_sweep(plan, shard, threads, control, tell, rows);
    return true;
  });
}

py::object uniqueness(const CoreRobot& robot, const std::string& slice, const py::object& resolution,
                      const py::object& progress) {
  UniquenessOptions options;
  options.slice = slice_of(*robot.manipulator, slice);
  if (!resolution.is_none()) options.resolution = resolution.cast<double>();
  const auto result = run_long(progress, [&](const MapControl& control) {
    return compute_uniqueness(robot.manipulator, options, control);
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
