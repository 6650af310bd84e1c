// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/batches/box_requests.h"

#include "aspects/batches/lane_classifier.h"
#include "aspects/batches/lane_examiner.h"
#include "aspects/batches/lane_index.h"
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

/// False where the classifier is for another chart, or for a robot with constraints that lanes do not treat.
template <class Chart>
bool are_examined_in_lanes(const BoxClassifier& classifier, std::size_t mode, int sign,
                           const std::vector<SharedFace>& boxes, std::vector<Examined>& examined,
                           InstructionSet instructions) {
  const auto* of_chart = dynamic_cast<const ChartClassifier<Chart>*>(&classifier);
  if (of_chart == nullptr || !of_chart->is_limited_only()) return false;
  examine_in_lanes(of_chart->chart(), of_chart->signs()[mode], sign, classifier.policy().shells, boxes,
                   examined.data(), instructions);
  return true;
}

/// False where the classifier is for another chart.
template <class Chart>
bool are_bounded_in_lanes(const BoxClassifier& classifier, std::size_t mode, int sign, ParallelIndex index,
                          const std::vector<IndexRequest>& boxes, std::vector<Interval>& ranges,
                          InstructionSet instructions) {
  const auto* of_chart = dynamic_cast<const ChartClassifier<Chart>*>(&classifier);
  if (of_chart == nullptr) return false;
  std::vector<EnclosedIndex> enclosed(boxes.size());
  enclose_index_in_lanes({of_chart->chart(), of_chart->margins(), of_chart->signs()[mode], sign, index},
                         boxes, enclosed.data(), instructions);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Interval& known = enclosed[i].range;
    ranges[i] = enclosed[i].may_be_closer
                    ? of_chart->enclose_index_on_arcs(boxes[i].root, boxes[i].box, mode, sign, index, known)
                    : known;
  }
  return true;
}

std::vector<Examined> examine(const BoxClassifier& classifier, std::size_t mode, int sign,
                              const std::vector<SharedFace>& boxes, InstructionSet instructions) {
  std::vector<Examined> examined(boxes.size(), {LeafState(), Monotonicity::unknown(), std::nullopt});
  if (instructions != InstructionSet::none &&
      (are_examined_in_lanes<T2Chart>(classifier, mode, sign, boxes, examined, instructions) ||
       are_examined_in_lanes<SE2Chart>(classifier, mode, sign, boxes, examined, instructions)))
    return examined;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    examined[i] = classifier.examine(boxes[i].root, boxes[i].box, mode, sign);
  return examined;
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

std::vector<Interval> enclose_index(const BoxClassifier& classifier, std::size_t mode, int sign,
                                    ParallelIndex index, const std::vector<IndexRequest>& boxes,
                                    InstructionSet instructions) {
  std::vector<Interval> ranges(boxes.size());
  if (instructions != InstructionSet::none && boxes.size() > 1 &&
      (are_bounded_in_lanes<T2Chart>(classifier, mode, sign, index, boxes, ranges, instructions) ||
       are_bounded_in_lanes<SE2Chart>(classifier, mode, sign, index, boxes, ranges, instructions) ||
       are_bounded_in_lanes<T3Chart>(classifier, mode, sign, index, boxes, ranges, instructions) ||
       are_bounded_in_lanes<SO3Chart>(classifier, mode, sign, index, boxes, ranges, instructions)))
    return ranges;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    ranges[i] = classifier.enclose_index(boxes[i].root, boxes[i].box, mode, sign, index, boxes[i].share);
  return ranges;
}

std::vector<Part> find_parts(const BoxClassifier& classifier, std::size_t mode, int sign,
                             std::vector<SharedFace> boxes, InstructionSet instructions) {
  std::vector<Part> parts(boxes.size());
  std::vector<std::size_t> open(boxes.size());  // which part each of the boxes is for
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
  while (!boxes.empty()) {
    const std::vector<Examined> examined = examine(classifier, mode, sign, boxes, instructions);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      SharedFace& at = boxes[i];
      if (const auto part = part_or_flatten(classifier, mode, sign, at.root, examined[i], at.box)) {
        parts[open[i]] = *part;
        continue;
      }
      open[kept] = open[i];
      boxes[kept++] = at;
    }
    boxes.resize(kept);
  }
  return parts;
}

}  // namespace parallel_aspects
