// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_CONSTRAINT_KEY_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_CONSTRAINT_KEY_H

#include "parallel_aspects/model/constraints.h"

#include <string>

namespace parallel_aspects {

/// A name that stays in its line: control characters become "?".
std::string printable(std::string text);

/// The part of a `map_key` that tells the constraints: every number of them with all its digits, a line each;
/// empty where there are none.
std::string constraint_key(const Constraints& constraints);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_CONSTRAINT_KEY_H
