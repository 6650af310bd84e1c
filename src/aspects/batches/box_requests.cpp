// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/batches/box_requests.h"

#include "aspects/batches/lane_classifier.h"
#include "aspects/boxes/chart_classifier.h"

#include <atomic>

namespace parallel_aspects {
namespace {

std::atomic<InstructionSet> in_use{widest_instructions()};

/// Whether more may be shown of an undecided box one by one.
bool is_open(LeafState state) noexcept {
  return state.is_undecided() &&
         ((state.may_be(1) && !state.is_whole(1)) || (state.may_be(-1) && !state.is_whole(-1)));
}

void classify_open(const BoxClassifier& classifier, std::size_t mode_count, const BoxRequests& requests,
                   Detail detail) noexcept {
  for (const BoxRequest& each : requests) {
    ModeSet open = 0;
    for (std::size_t mode = 0; mode < mode_count; ++mode)
      if ((each.modes >> mode & 1U) != 0 && is_open(each.states[mode])) open |= ModeSet{1} << mode;
    if (open != 0) classifier.classify(each.root, each.box, open, detail, each.states);
  }
}

/// False where the classifier is for another chart, or for a robot with constraints that lanes do not treat,
/// and where slopes are asked for that have no lanes: then little would be saved.
template <class Chart>
bool are_done_in_lanes(const BoxClassifier& classifier, const BoxRequests& requests, Detail detail,
                       InstructionSet instructions) noexcept {
  const auto* of_chart = dynamic_cast<const ChartClassifier<Chart>*>(&classifier);
  const bool has_stages = has_slope_lanes<Chart> || detail == Detail::states || detail == Detail::centers;
  if (of_chart == nullptr || !of_chart->is_limited_only() || !has_stages) return false;
  classify_in_lanes(of_chart->chart(), of_chart->signs(), requests, detail, instructions);
  if (detail == Detail::all_parts) classify_open(classifier, of_chart->signs().size(), requests, detail);
  return true;
}

}  // namespace

InstructionSet instructions_in_use() noexcept { return in_use; }

void use_instructions(InstructionSet instructions) noexcept { in_use = instructions; }

void classify(const BoxClassifier& classifier, const BoxRequests& requests, Detail detail,
              InstructionSet instructions) noexcept {
  if (instructions != InstructionSet::none &&
      (are_done_in_lanes<T2Chart>(classifier, requests, detail, instructions) ||
       are_done_in_lanes<SE2Chart>(classifier, requests, detail, instructions) ||
       are_done_in_lanes<T3Chart>(classifier, requests, detail, instructions) ||
       are_done_in_lanes<SO3Chart>(classifier, requests, detail, instructions)))
    return;
  for (const BoxRequest& each : requests)
    classifier.classify(each.root, each.box, each.modes, detail, each.states);
}

}  // namespace parallel_aspects
