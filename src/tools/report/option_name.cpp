// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/option_name.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::tools {
namespace {

/// A trajectory starts, but has no goal.
bool is_start_of_trajectory(const std::string& field) {
  return field.rfind("start_pose", 0) == 0 || field.rfind("start_sign", 0) == 0;
}

}  // namespace

std::string option_name(const std::string& field) {
  std::string words = field;
  for (const auto& [end, word] : {std::pair{"start", "from"}, std::pair{"goal", "to"}}) {
    const std::string name = end;
    const bool is_end = words == name || words.rfind(name + "_", 0) == 0;
    if (is_end && !is_start_of_trajectory(field)) words.replace(0, name.size(), word);
  }
  std::replace(words.begin(), words.end(), '_', '-');
  return "--" + words;
}

}  // namespace parallel_aspects::tools
