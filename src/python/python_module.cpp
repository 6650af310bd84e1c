// SPDX-License-Identifier: BSD-3-Clause
// The compiled part of the Python module. Functions take texts as the command does, and arrays; they return
// arrays and dictionaries, of which the module makes its own objects.
#include "parallel_aspects/model/wings.h"

#include "python/bindings.h"

PYBIND11_MODULE(_core, module) {
  namespace pa = parallel_aspects::python;
  module.doc() = "The compiled part of parallel_aspects; use that.";
  pa::bind_errors(module);
  pa::bind_loading(module);
  pa::RobotClass robot(module, "Robot");
  pa::MapClass map(module, "Map");
  pa::bind_robot(robot);
  if constexpr (parallel_aspects::wings::sweep) pa::bind_sweep(robot);
  pa::bind_map(robot, map);
  pa::bind_questions(module, robot, map);
}
