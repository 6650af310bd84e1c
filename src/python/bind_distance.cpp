// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/distance.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include "python/long_call.h"

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

}  // namespace parallel_aspects::python
