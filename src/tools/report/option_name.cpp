// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/option_name.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::tools {

std::string option_name(const std::string& field) {
  if (field == "start_pose" || field == "start_sign")  // of a trajectory, which has no goal
    return field == "start_pose" ? "--start-pose" : "--start-sign";
  std::string words = field;
  for (const auto& [end, word] : {std::pair{"start", "from"}, std::pair{"goal", "to"}}) {
    const std::string name = end;
    if (words == name || words.rfind(name + "_", 0) == 0) words.replace(0, name.size(), word);
  }
  std::replace(words.begin(), words.end(), '_', '-');
  return "--" + words;
}

}  // namespace parallel_aspects::tools
