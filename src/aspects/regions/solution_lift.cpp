// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/regions/solution_lift.h"

#include "interval/rounding.h"

#include <tbb/parallel_for.h>

#include <deque>
#include <utility>

namespace parallel_aspects {

SolutionLift::SolutionLift(const SolutionTracker& tracker, const ActuatedSpace& space,
                           const LinksByPiece& links, const SolutionSet& set, const MapControl& control)
    : tracker_(tracker), space_(space), links_(links), set_(set), same_(set.solutions->size()) {
  assert_rounding_upward();
  spread(control);
  compare_links(control);
  for (std::uint32_t k = 0; k < same_.size(); ++k) labels_.push_back(same_.find(k));
  for (const PieceIndex piece : set_.pieces)
    if (at(piece) != nullptr)
      measure_ = (Interval(measure_) + Interval(space_.pieces()[piece].measure)).lower();
}

const SolutionLift::Solutions* SolutionLift::at(PieceIndex piece) const {
  const auto found = over_.find(piece);
  return found == over_.end() ? nullptr : &found->second;
}

// Whole cells first, from which it is easier.
void SolutionLift::spread(const MapControl& control) {
  over_[set_.largest] = *set_.solutions;
  std::deque<PieceIndex> whole{set_.largest}, others;
  while (!(whole.empty() && others.empty()) && !is_cancelled(control)) {
    std::deque<PieceIndex>& open = whole.empty() ? others : whole;
    const PieceIndex from = open.front();
    open.pop_front();
    for (const std::size_t link : links_[from]) {
      const auto entered = enter(link, from);
      if (entered) (is_whole(*entered) ? whole : others).push_back(*entered);
    }
  }
}

std::optional<PieceIndex> SolutionLift::enter(std::size_t index, PieceIndex from) {
  const PieceLink& link = space_.links()[index];
  const std::size_t end = link.pieces[0] == from ? 0 : 1;
  const PieceIndex to = link.pieces[1 - end];
  if (over_.count(to) > 0) return std::nullopt;
  auto there = across(link, end);
  if (!there) return std::nullopt;
  over_.emplace(to, std::move(*there));
  has_parts_beyond_.insert(from);
  entered_by_.insert(index);
  return to;
}

std::vector<std::size_t> SolutionLift::links_inside() const {
  std::vector<std::size_t> result;
  for (const PieceIndex piece : set_.pieces)
    for (const std::size_t link : links_[piece])
      if (space_.links()[link].pieces[0] == piece && entered_by_.count(link) == 0 && at(piece) != nullptr &&
          at(space_.links()[link].pieces[1]) != nullptr)
        result.push_back(link);
  return result;
}

void SolutionLift::compare_links(const MapControl& control) {
  const std::vector<std::size_t> inside = links_inside();
  std::vector<Comparison> comparisons(inside.size());
  tbb::parallel_for(std::size_t{0}, inside.size(), [&](std::size_t i) {
    const RoundingUpward rounding;
    if (!is_cancelled(control)) comparisons[i] = compared(space_.links()[inside[i]]);
  });
  for (std::size_t i = 0; i < inside.size(); ++i) take(space_.links()[inside[i]], comparisons[i]);
}

/// Which solution at the second piece each one at the first leads to.
SolutionLift::Comparison SolutionLift::compared(const PieceLink& link) const {
  const auto there = across(link, 0);
  if (!there) return std::nullopt;
  std::vector<std::size_t> result;
  for (const Box& box : *there) {
    const auto same = SolutionTracker::find(box, over_.at(link.pieces[1]));
    if (!same) return std::nullopt;
    result.push_back(*same);
  }
  return result;
}

/// Where it is not known where a link leads, a piece is left out again that nothing was reached from.
void SolutionLift::take(const PieceLink& link, const Comparison& comparison) {
  const auto& [first, second] = link.pieces;
  if (at(first) == nullptr || at(second) == nullptr) return;
  if (comparison) {
    for (std::uint32_t k = 0; k < comparison->size(); ++k)
      same_.unite(k, static_cast<std::uint32_t>((*comparison)[k]));
  } else if (has_parts_beyond_.count(second) == 0) {
    over_.erase(second);
  } else if (has_parts_beyond_.count(first) == 0) {
    over_.erase(first);
  } else {
    consistent_ = false;
  }
}

/// From one end of a link to the other; nothing where one of the solutions can not be followed.
std::optional<SolutionLift::Solutions> SolutionLift::across(const PieceLink& link, std::size_t from) const {
  const PieceIndex start = link.pieces[from], end = link.pieces[1 - from];
  const ActuatedValues &near = link.common[from], &far = link.common[1 - from];
  Solutions result;
  for (const Box& box : over_.at(start)) {
    auto next = tracker_.follow(box, space_.point_of(start), near);
    if (next && near != far) next = tracker_.widened(*next, far, turn_slack);  // a turn apart
    if (next) next = tracker_.follow(*next, far, space_.point_of(end));
    if (!next) return std::nullopt;
    result.push_back(*next);
  }
  return result;
}

}  // namespace parallel_aspects
