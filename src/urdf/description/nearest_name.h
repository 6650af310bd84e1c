// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H

#include "parallel_aspects/model/problems.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// The entry of `known` that looks most like `word`, by the number of letters to change; empty where none is
/// near: neither is a part of the other, and more than a third of the letters differ.
std::string similar_name(const std::string& word, const std::vector<std::string>& known);

/// For the end of a message: "; did you mean 'NAME'?" where a name is near, else the names, where they are
/// few; so for the first of many `problems` only, since comparing one with all others takes long where both
/// are many.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H
