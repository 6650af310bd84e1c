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

/// Whether a name is one of these.
bool contains(const std::vector<std::string>& names, const std::string& name);

/// A name that something else was written for.
struct MeantName {
  std::string name, written;
};

/// The names of `expected` that are not among those `written`, each with the one of these that is near to it:
/// with none that is one of `own`, and none twice.
std::vector<MeantName> meant_names(const std::vector<std::string>& expected,
                                   const std::vector<std::string>& written,
                                   const std::vector<std::string>& own);

/// For the end of a message: "; did you mean 'NAME'?" where a name is near, else the names, where they are
/// few; so for the first of many `problems` only, since comparing one with all others takes long where both
/// are many.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_NEAREST_NAME_H
