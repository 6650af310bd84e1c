// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/option_name.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::tools {

std::string option_name(const std::string& field) {
  std::string words = field;
  const bool has_goal = field.rfind("start_pose", 0) != 0 && field.rfind("start_sign", 0) != 0;
  for (const auto& [end, word] : {std::pair{"start", "from"}, std::pair{"goal", "to"}}) {
    const std::string name = end;
    if (!has_goal) break;  // a trajectory starts, but has none
    if (words == name || words.rfind(name + "_", 0) == 0) words.replace(0, name.size(), word);
  }
  std::replace(words.begin(), words.end(), '_', '-');
  return "--" + words;
}

}  // namespace parallel_aspects::tools
