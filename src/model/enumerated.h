// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_ENUMERATED_H
#define PARALLEL_ASPECTS_MODEL_ENUMERATED_H

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// "a", "a and b", "a, b and c".
inline std::string enumerated(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_ENUMERATED_H
