// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PYTHON_PYTHON_ERRORS_H
#define PARALLEL_ASPECTS_PYTHON_PYTHON_ERRORS_H

#include "parallel_aspects/model/problems.h"

#include <pybind11/pybind11.h>

namespace parallel_aspects::python {

/// Makes `InvalidDescription` a `ValueError` of the module, with all `problems`.
void bind_errors(pybind11::module& module);

/// Problems that name options of the command, as "--aspect-ratio", with keyword arguments in their place.
Problems with_keywords(const Problems& problems);

/// Throws `InvalidDescription` where there are any, with keyword arguments for options.
void refuse_any(const Problems& problems);

/// What `ask()` returns; the problems that it throws name keyword arguments.
template <class Ask>
auto asked_by_keywords(const Ask& ask) {
  try {
    return ask();
  } catch (const InvalidDescription& invalid) {
    throw InvalidDescription(with_keywords(invalid.problems()));
  }
}

}  // namespace parallel_aspects::python

#endif  // PARALLEL_ASPECTS_PYTHON_PYTHON_ERRORS_H
