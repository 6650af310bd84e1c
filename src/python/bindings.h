// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PYTHON_BINDINGS_H
#define PARALLEL_ASPECTS_PYTHON_BINDINGS_H

#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/manipulator.h"

#include <memory>
#include <mutex>
#include <pybind11/pybind11.h>
#include <utility>

namespace parallel_aspects::python {

/// `_core.Robot`: what Robot of the module stands on. Arguments are checked, and documented, there.
struct CoreRobot {
  std::shared_ptr<const Manipulator> manipulator;  ///< never null
};

/// Questions, one at a time.
struct SharedSession {
  explicit SharedSession(std::shared_ptr<const Manipulator> robot) : session(std::move(robot)) {}
  std::mutex busy;       ///< held while one is answered
  ask::Session session;  ///< keeps what answers have in common
};

/// `_core.Map`.
struct CoreMap {
  std::shared_ptr<const AspectMap> map;      ///< never null
  std::shared_ptr<SharedSession> questions;  ///< that know it

  explicit CoreMap(std::shared_ptr<const AspectMap> computed)
      : map(std::move(computed)), questions(std::make_shared<SharedSession>(map->manipulator())) {
    questions->session.know(map);
  }

  const Manipulator& robot() const { return *map->manipulator(); }
};

using RobotClass = pybind11::class_<CoreRobot>;
using MapClass = pybind11::class_<CoreMap>;

/// Each adds functions to the module or methods to the class.
void bind_loading(pybind11::module& module);
void bind_robot(RobotClass& robot);
void bind_distance(RobotClass& robot);
void bind_motion(pybind11::module& module, RobotClass& robot, MapClass& map);
void bind_map(RobotClass& robot, MapClass& map);
void bind_design(RobotClass& robot);

}  // namespace parallel_aspects::python

#endif  // PARALLEL_ASPECTS_PYTHON_BINDINGS_H
