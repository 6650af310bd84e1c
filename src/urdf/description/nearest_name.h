// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H

#include "parallel_aspects/model/problems.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// The entry of `known` that looks most like `word`, by the number of letters to change; empty where more
/// than half of them differ, or there is none.
std::string similar_name(const std::string& word, const std::vector<std::string>& known);

/// "; did you mean 'NAME'?" with the similar name, for the end of a message; without one, what there is.
/// Names are compared for the first of many `problems` only, since that takes long where both are many.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const Problems& problems);

/// Those of `known` that are not in use, and so may be meant by another word.
std::vector<std::string> others(const std::vector<std::string>& known, const std::vector<std::string>& used);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H
