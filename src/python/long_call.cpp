// SPDX-License-Identifier: BSD-3-Clause
#include "python/long_call.h"

namespace parallel_aspects::python {
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
