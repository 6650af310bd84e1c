// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/distance/boundary_distances.h"

#include "python/arrays.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include <array>
#include <cmath>
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

using Boundaries = std::array<std::pair<const char*, const BoundaryDistance*>, 3>;

Boundaries boundaries_of(const BoundaryDistances& distances) {
  return {{{"parallel", &distances.parallel},
           {"serial", &distances.serial},
           {"actuated_limit", &distances.actuated_limit}}};
}

py::dict distance_dict(const Manipulator& manipulator, const BoundaryDistance& distance) {
  const bool has_witness = std::isfinite(distance.upper);
  py::dict result;
  result["status"] = name(distance.status);
  result["lower"] = distance.lower;
  result["upper"] = distance.upper;
  result["upper_proved"] = distance.upper_proved;
  result["witness"] =
      has_witness ? py::object(array_of(manipulator.task_space(), distance.witness)) : py::none();
  result["witness_q"] = has_witness ? py::object(array_of(distance.witness_q)) : py::none();
  result["joint_displacement"] = has_witness ? py::object(array_of(distance.joint_displacement)) : py::none();
  return result;
}

py::dict distance(const CoreRobot& robot, const Array& values, const std::string& text, double tolerance,
                  int boxes) {
  const Manipulator& manipulator = *robot.manipulator;
  const Pose pose = pose_of("pose", manipulator, values);
  const WorkingMode mode = mode_of("mode", manipulator, text);
  BoundaryDistanceMeter meter(robot.manipulator, {tolerance, boxes});
  const auto measured = run_long(py::none(), [&](const MapControl&) { return meter.measure(pose, mode); });
  py::dict result;
  result["status"] = name(measured.status);
  for (const auto& [key, boundary] : boundaries_of(measured))
    result[key] = distance_dict(manipulator, *boundary);
  return result;
}

/// Shape (n, 3, 2): to parallel and serial singularities and limits, each a lower and an upper bound.
Array distances(const CoreRobot& robot, const Array& values, const std::string& text, double tolerance,
                int boxes, const py::object& progress) {
  const Manipulator& manipulator = *robot.manipulator;
  const std::vector<Pose> poses = poses_of("poses", manipulator, values);
  const WorkingMode mode = mode_of("mode", manipulator, text);
  Array result = empty_array({static_cast<py::ssize_t>(poses.size()), 3, 2});
  double* bounds = result.mutable_data();
  run_long(progress, [&](const MapControl& control) {
    BoundaryDistanceMeter meter(robot.manipulator, {tolerance, boxes});
    double* next = bounds;
    for (std::size_t i = 0; i < poses.size() && !is_cancelled(control); ++i) {
      const BoundaryDistances measured = meter.measure(poses[i], mode);
      for (const auto& [key, boundary] : boundaries_of(measured)) {
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

void bind_distance(RobotClass& robot) {
  robot.def("distance", distance);
  robot.def("distances", distances);
}

}  // namespace parallel_aspects::python
