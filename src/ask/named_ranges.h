// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_NAMED_RANGES_H
#define PARALLEL_ASPECTS_ASK_NAMED_RANGES_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/box.h"

#include <string>
#include <vector>

namespace parallel_aspects::ask {

/// "x=-1:1 y=-1:1", in quotes and with units.
std::string example_of_ranges(const std::vector<std::string>& names);

/// The box with these ranges, one for each of the names. Where there are problems it is of no meaning.
Box box_of(const std::string& field, const std::vector<std::string>& names,
           const std::vector<NamedRange>& ranges, ProblemList& problems);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_NAMED_RANGES_H
