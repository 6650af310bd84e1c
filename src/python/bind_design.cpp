// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/regular_workspace.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "tools/held_range.h"
#include "tools/report/uniqueness_report.h"
#include "tools/report/workspace_report.h"
#include "tools/shape_arguments.h"
#include "tools/sweep/sweep_arguments.h"
#include "tools/sweep/sweep_file.h"
#include "tools/sweep/sweep_run.h"

#include "python/arrays.h"
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

tools::ShapeArguments shape_of(const Texts& texts) {
  return {text_of(texts, "shape"), text_of(texts, "center"), text_of(texts, "aspect_ratio"),
          text_of(texts, "orientation"), text_of(texts, "gap")};
}

py::dict workspace_dict(const AspectMap& map, const WorkspaceQuestion& question,
                        const RegularWorkspace& found) {
  const std::size_t free = free_positions(*map.manipulator(), map.slice());
  py::dict lengths;
  for (const auto& [name, length] : lengths_of(map, question, found.lower)) lengths[py::str(name)] = length;
  py::dict result;
  result["aspect"] = found.aspect;
  result["center"] = array_of(
      std::vector<double>(found.center.begin(), found.center.begin() + static_cast<std::ptrdiff_t>(free)));
  result["lower"] = found.lower;
  result["upper"] = found.upper;
  result["proved"] = found.proved;
  result["lengths"] = lengths;
  return result;
}

py::list workspaces(const CoreMap& map, const Texts& texts, std::vector<int> aspects,
                    const py::object& progress) {
  Problems problems;
  const tools::ShapeArguments arguments = shape_of(texts);
  WorkspaceOptions options;
  options.gap = tools::parse_gap(arguments, problems);
  const WorkspaceQuestion question = tools::parse_shape(arguments, map.robot(), map.map->slice(), problems);
  const auto count = static_cast<int>(map.map->aspects().size());
  for (const int id : aspects)
    if (id < 1 || id > count)
      problems.push_back("aspects has " + std::to_string(id) + "; the map has " + std::to_string(count) +
                         ", counted from 1.");
  refuse_any(problems);
  if (aspects.empty())
    for (const Aspect& aspect : map.map->aspects()) aspects.push_back(aspect.id);
  const auto found = run_long(progress, [&](const MapControl& control) {
    options.control = control;
    return find_regular_workspaces(*map.map, aspects, question, options);
  });
  py::list result;
  for (const RegularWorkspace& each : *found) result.append(workspace_dict(*map.map, question, each));
  return result;
}

tools::SweepArguments sweep_arguments(const Texts& texts, bool untied) {
  tools::SweepArguments arguments;
  arguments.shape = shape_of(texts);
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

void sweep(const CoreRobot& robot, const std::string& file, const Texts& texts, bool untied, unsigned threads,
           const py::object& progress) {
  tools::Shard shard;
  const tools::SweepPlan plan = asked_by_keywords([&] {
    const tools::SweepArguments arguments = sweep_arguments(texts, untied);
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

void bind_design(RobotClass& robot, MapClass& map) {
  map.def("workspace", workspaces);
  robot.def("sweep", sweep);
  robot.def("uniqueness", uniqueness);
  robot.def("cusp_curves", cusp_curves);
}

}  // namespace parallel_aspects::python
