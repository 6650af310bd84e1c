// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H

#include "parallel_aspects/model/problems.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// The entry of `known` that looks most like `word`, by the number of letters to change; empty when there is
/// none.
std::string nearest_name(const std::string& word, const std::vector<std::string>& known);

/// "; did you mean 'NAME'?" with the nearest name, for the end of a message; only for the first of many
/// `problems`, since comparing one with all others takes long where both are many.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const Problems& problems);

/// As `nearest_name`, but empty also where more than half of the letters differ.
std::string similar_name(const std::string& word, const std::vector<std::string>& known);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H
