// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings.h"

#include <algorithm>
#include <exception>
#include <pybind11/stl.h>
#include <regex>
#include <string>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

// Lives as long as the interpreter.
PyObject* invalid_description = nullptr;

void raise(const InvalidDescription& invalid) {
  const py::object type = py::reinterpret_borrow<py::object>(invalid_description);
  const py::object error = type(std::string(invalid.what()));
  error.attr("problems") = invalid.problems();
  PyErr_SetObject(invalid_description, error.ptr());
}

std::string with_keywords(const std::string& problem) {
  static const std::regex option("--([a-z]+(?:-[a-z]+)*)");
  std::string text;
  auto at = problem.begin();
  for (std::sregex_iterator match(problem.begin(), problem.end(), option), end; match != end; ++match) {
    std::string name = (*match)[1];
    std::replace(name.begin(), name.end(), '-', '_');
    text.append(at, (*match)[0].first).append(name);
    at = (*match)[0].second;
  }
  return text.append(at, problem.end());
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
  Problems told;
  for (const std::string& problem : problems) told.push_back(with_keywords(problem));
  if (!told.empty()) throw InvalidDescription(std::move(told));
}

namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds between_looks{50};

}  // namespace

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
