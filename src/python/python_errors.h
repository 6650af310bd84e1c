// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PYTHON_PYTHON_ERRORS_H
#define PARALLEL_ASPECTS_PYTHON_PYTHON_ERRORS_H

#include "parallel_aspects/model/problems.h"

#include <pybind11/pybind11.h>

namespace parallel_aspects::python {

/// Makes `InvalidDescription` a `ValueError` of the module, with all `problems`.
void bind_errors(pybind11::module& module);

/// Throws `InvalidDescription` where there are any, with keyword arguments for options such as
/// "--aspect-ratio".
void refuse_any(const Problems& problems);

}  // namespace parallel_aspects::python

#endif  // PARALLEL_ASPECTS_PYTHON_PYTHON_ERRORS_H
