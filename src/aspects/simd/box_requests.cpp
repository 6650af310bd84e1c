// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/simd/box_requests.h"

#include "aspects/boxes/chart_classifier.h"
#include "aspects/simd/chart_lanes.h"
#include "interval/lanes.h"

#include <atomic>

namespace parallel_aspects {
namespace {

std::atomic<InstructionSet> in_use{widest_instructions()};

/// False where the classifier is for another chart, or for a robot with constraints that lanes do not treat.
template <class Chart>
bool are_examined_in_lanes(const BoxClassifier& classifier, std::size_t mode, int sign,
                           const std::vector<SharedFace>& boxes, std::vector<Examined>& examined,
                           InstructionSet instructions) {
  const auto* of_chart = dynamic_cast<const ChartClassifier<Chart>*>(&classifier);
  if (of_chart == nullptr || !of_chart->is_limited_only()) return false;
  ChartLanes<Chart>::examine(*of_chart, mode, sign, boxes, examined.data(), instructions);
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
  ChartLanes<Chart>::enclose_index(*of_chart, mode, sign, index, boxes, enclosed.data(), instructions);
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
       are_examined_in_lanes<SE2Chart>(classifier, mode, sign, boxes, examined, instructions) ||
       are_examined_in_lanes<T3Chart>(classifier, mode, sign, boxes, examined, instructions)))
    return examined;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    examined[i] = classifier.examine(boxes[i].root, boxes[i].box, mode, sign);
  return examined;
}

/// A box that is to be examined in one working mode and sign, and where what is found is to be kept.
struct OpenBox {
  SharedFace at;
  LeafState* state;
};

/// Pushes S(mode, sign) onto faces of the boxes, edges and corners as far as it grows to them, where
/// `faces_too`, and keeps of which boxes that shows them to be whole. Returns the others. See
/// BoxSlopes::is_whole.
std::vector<OpenBox> find_whole(const BoxClassifier& classifier, std::size_t mode, int sign, bool faces_too,
                                const std::vector<OpenBox>& boxes, InstructionSet instructions) {
  std::vector<OpenBox> rest;
  std::vector<SharedFace> faces;
  std::vector<std::size_t> of;  // which of the boxes each is a face of
  for (const OpenBox& each : boxes) {
    of.push_back(faces.size());
    faces.push_back(each.at);
  }
  while (!faces.empty()) {
    const std::vector<Examined> examined = examine(classifier, mode, sign, faces, instructions);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto& [state, monotonicity, shell] = examined[i];
      SharedFace& face = faces[i];
      if (!state.may_be(sign) || state.is_inside() || monotonicity.along_all(face.box) || shell) {
        *boxes[of[i]].state = boxes[of[i]].state->with_whole(sign);
      } else if (faces_too && monotonicity.flatten(face.box)) {
        of[kept] = of[i];
        faces[kept++] = face;
      } else {
        rest.push_back(boxes[of[i]]);
      }
    }
    faces.resize(kept);
  }
  return rest;
}

/// What slopes, faces and wedges show to be whole in boxes of which all else is known.
void add_whole_parts(const BoxClassifier& classifier, const BoxRequests& requests, Detail detail,
                     InstructionSet instructions) {
  const bool all = detail == Detail::all_parts;
  ModeSet modes = 0;
  for (const BoxRequest& each : requests) modes |= each.modes;
  for (std::size_t mode = 0; mode < most_modes && modes >> mode != 0; ++mode)
    for (const int sign : {1, -1}) {
      std::vector<OpenBox> open;
      for (const BoxRequest& each : requests)
        if (LeafState& state = each.states[mode];
            (each.modes >> mode & 1U) != 0 && state.is_undecided() && state.may_be(sign))
          open.push_back({{each.root, each.box}, &state});
      for (const OpenBox& each :
           find_whole(classifier, mode, sign, all && classifier.policy().faces, open, instructions))
        if (all && classifier.find_wedge(each.at.root, each.at.box, mode, sign))
          *each.state = each.state->with_whole(sign);
    }
}

/// False where the classifier is for another chart, or for a robot with constraints that lanes do not treat,
/// and where slopes are asked for that have no lanes: then little would be saved.
template <class Chart>
bool are_done_in_lanes(const BoxClassifier& classifier, const BoxRequests& requests, Detail detail,
                       InstructionSet instructions) noexcept {
  const auto* of_chart = dynamic_cast<const ChartClassifier<Chart>*>(&classifier);
  const bool needs_parts = detail == Detail::parts || detail == Detail::all_parts;
  if (of_chart == nullptr || !of_chart->is_limited_only() || (needs_parts && !has_part_lanes<Chart>))
    return false;
  const bool apart = detail == Detail::all_parts || (detail == Detail::parts && !has_slope_lanes<Chart>);
  ChartLanes<Chart>::classify(*of_chart, requests, apart ? Detail::centers : detail, instructions);
  if (apart) add_whole_parts(classifier, requests, detail, instructions);
  return true;
}

}  // namespace

bool has_instructions(InstructionSet instructions) noexcept {
  if (instructions != InstructionSet::avx2) return true;
#ifdef PARALLEL_ASPECTS_HAS_WIDE_LANES
  __builtin_cpu_init();  // this may run before other initialisation
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

InstructionSet widest_instructions() noexcept {
  return has_instructions(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::sse2;
}

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
