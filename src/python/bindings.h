// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PYTHON_BINDINGS_H
#define PARALLEL_ASPECTS_PYTHON_BINDINGS_H

#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <pybind11/pybind11.h>
#include <utility>

namespace parallel_aspects::python {

/// `_core.Robot`: what Robot of the module stands on. Arguments are checked, and documented, there.
struct CoreRobot {
  std::shared_ptr<const Manipulator> manipulator;  ///< never null
  std::shared_ptr<const Mechanism> mechanism{};    ///< of a robot as it was loaded; else null
  JointVector acceleration{};                      ///< see `Mechanism::acceleration`
};

/// Questions, one at a time.
struct SharedSession {
  explicit SharedSession(const CoreRobot& robot) : session(robot.manipulator) {
    session.know(robot.mechanism);
    session.set_acceleration({robot.acceleration});
  }
  std::mutex busy;       ///< held while one is answered
  ask::Session session;  ///< keeps what answers have in common
};

/// `_core.Map`.
struct CoreMap {
  std::shared_ptr<const AspectMap> map;      ///< never null
  pybind11::dict fields;                     ///< of the answer that it came in
  std::shared_ptr<SharedSession> questions;  ///< that know it

  CoreMap(const CoreRobot& robot, std::shared_ptr<const AspectMap> computed, pybind11::dict answer)
      : map(std::move(computed)),
        fields(std::move(answer)),
        questions(std::make_shared<SharedSession>(robot)) {
    questions->session.know(map);
  }

  const Manipulator& robot() const { return *map->manipulator(); }
};

using RobotClass = pybind11::class_<CoreRobot>;
using MapClass = pybind11::class_<CoreMap>;

/// Each adds functions to the module or methods to the class.
void bind_loading(pybind11::module& module);
void bind_robot(RobotClass& robot);
void bind_sweep(RobotClass& robot);
void bind_questions(pybind11::module& module, RobotClass& robot, MapClass& map);
void bind_map(RobotClass& robot, MapClass& map);

/// Makes `InvalidDescription` a `ValueError` of the module, with all `problems`.
void bind_errors(pybind11::module& module);

/// Throws `InvalidDescription` where there are any.
void refuse_any(const Problems& problems);

/// What a computation in another thread and the thread of Python's call tell each other.
struct LongCall {
  std::atomic<bool> cancelled{false};
  std::atomic<double> share{0.0};  ///< done, 0 to 1

  MapControl control() {
    return {[this](double done) { share = done; }, &cancelled};
  }
};

/// Waits for a computation without the interpreter's lock. Now and then it takes the lock to ask for signals
/// and to call `progress(share)`, which may be None. What these raise, as KeyboardInterrupt at Ctrl-C,
/// cancels the computation and is raised once that has ended. `is_done` waits for so long at most.
void attend(LongCall& call, const pybind11::object& progress,
            const std::function<bool(std::chrono::milliseconds)>& is_done);

/// `compute(const MapControl&)` in a thread of its own, attended. It must not touch Python. What it throws is
/// thrown.
template <class Compute>
auto run_long(const pybind11::object& progress, const Compute& compute) {
  LongCall call;
  auto result = std::async(std::launch::async, [&] { return compute(call.control()); });
  attend(call, progress, [&result](std::chrono::milliseconds most) {
    return result.wait_for(most) == std::future_status::ready;
  });
  return result.get();
}

}  // namespace parallel_aspects::python

#endif  // PARALLEL_ASPECTS_PYTHON_BINDINGS_H
