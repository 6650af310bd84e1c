// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings.h"

#include <exception>
#include <pybind11/stl.h>
#include <string>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

// Lives as long as the interpreter.
PyObject* invalid_description = nullptr;

constexpr std::chrono::milliseconds between_looks{50};

void raise(const InvalidDescription& invalid) {
  const py::object type = py::reinterpret_borrow<py::object>(invalid_description);
  const py::object error = type(std::string(invalid.what()));
  error.attr("problems") = invalid.problems();
  PyErr_SetObject(invalid_description, error.ptr());
}

}  // namespace

void bind_errors(py::module& module) {
  invalid_description = PyErr_NewExceptionWithDoc(
      "parallel_aspects.InvalidDescription",
      "A robot, a file or an argument that is refused.\n\n"
      "problems: list of str, all that is wrong; each names its cause and what to do about it.",
      PyExc_ValueError, nullptr);
  module.attr("InvalidDescription") = py::reinterpret_borrow<py::object>(invalid_description);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InvalidDescription& invalid) {
      raise(invalid);
    }
  });
}

void refuse_any(const Problems& problems) {
  if (!problems.empty()) throw InvalidDescription(problems);
}

void attend(LongCall& call, const py::object& progress,
            const std::function<bool(std::chrono::milliseconds)>& is_done) {
  const auto done = [&is_done] {
    const py::gil_scoped_release unlocked;
    return is_done(between_looks);
  };
  double told = 0.0;
  try {
    while (!done()) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      const double share = call.share;
      if (!progress.is_none() && share != told) progress(share);
      told = share;
    }
    if (!progress.is_none()) progress(1.0);
  } catch (...) {
    call.cancelled = true;
    while (!done()) {
    }
    throw;
  }
}

}  // namespace parallel_aspects::python
