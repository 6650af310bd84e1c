// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/options.h"

#include <utility>

namespace parallel_aspects {

std::string options_for(const SetupDraft& draft) {
  std::string text;
  for (const auto& [key, candidate] :
       {std::pair<const char*, const SetupCandidate*>{"closures", &draft.closures},
        {"base_link", &draft.base_link},
        {"operational_point", &draft.operational_point},
        {"actuated_joints", &draft.actuated_joints}})
    if (!candidate->values.empty()) text += (text.empty() ? "" : " ") + option_for(key, candidate->values);
  return text;
}

}  // namespace parallel_aspects
