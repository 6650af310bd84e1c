// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/edits.h"

#include <algorithm>
#include <array>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using Pair = std::array<std::size_t, 2>;  // of closures

constexpr std::size_t max_in_two_legs = 6;  // closures, of which the ends of two legs are exchanged: 15 pairs

bool are_same(const LinkFrame& one, const LinkFrame& other) {
  return one.link == other.link && one.in_link.isApprox(other.in_link, rank_tolerance);
}

Edit with_type(const Subject& s, std::size_t index, ClosureType type) {
  const auto count = [&](ClosureType wanted) {
    return std::count_if(s.resolved.closures.begin(), s.resolved.closures.end(),
                         [&](const Closure& other) { return other.type == wanted; });
  };
  const ClosureType present = s.resolved.closures[index].type;
  const bool have_others = count(present) == 1 && count(type) > 1;
  return edit_of(s,
                 s.file() + " has type " + type_word(s.resolved, present) + " for " + s.closure(index) +
                     (have_others ? ", where others have type " + type_word(s.resolved, type) : ""),
                 {TypeChange{index, type}},
                 have_others || present == ClosureType::fixed);  // which makes one link of two
}

}  // namespace

Edits closure_edits(const Subject& subject) {
  const std::vector<Closure>& closures = subject.resolved.closures;
  Edits found;
  for (std::size_t k = 0; k < closures.size(); ++k)
    for (const ClosureType type : {ClosureType::point, ClosureType::revolute, ClosureType::universal})
      if (closures[k].type != ClosureType::automatic && type != closures[k].type)
        found.push_back(with_type(subject, k, type));
  std::stable_partition(found.begin(), found.end(), [](const Edit& edit) { return edit.like_others; });
  return found;
}

namespace {

bool holds_link(const Closure& closure) {
  return closure.frames[1].in_link.isApprox(Eigen::Isometry3d::Identity());
}

bool may_exchange(const Closure& one, const Closure& other, bool with_places_at_zero) {
  if (holds_link(one) && holds_link(other)) return one.frames[1].link != other.frames[1].link;
  return !are_same(one.frames[1], other.frames[1]) &&
         (with_places_at_zero || !(one.at_zero || other.at_zero));
}

// What is written of them differs from one dialect to the other: closing frames are the names of links.
std::string exchange_text(const Subject& s, const std::vector<Pair>& pairs) {
  const bool by_names = s.resolved.closure_dialect == "closing frames";
  std::string remedy;
  for (const auto& [one, other] : pairs) {
    const auto text = [&](std::size_t k) {
      return by_names ? s.link(s.resolved.closures[k].frames[1].link) : s.closure(k);
    };
    remedy += (remedy.empty() ? (by_names ? "exchange the names of links " : "exchange the second ends of ")
                              : " and of ") +
              text(one) + " and " + text(other);
  }
  return remedy;
}

Edit exchange(const Subject& s, const std::vector<Pair>& pairs) {
  std::vector<Change> changes;
  bool hold_links = true;
  for (const auto& [one, other] : pairs)
    for (const auto& [at, from] : {std::pair{one, other}, std::pair{other, one}}) {
      changes.emplace_back(FrameChange{at, 1, s.resolved.closures[from].frames[1]});
      hold_links = hold_links && holds_link(s.resolved.closures[at]);
    }
  Edit edit = edit_of(s, "", std::move(changes));
  edit.fault = s.file() + " has the ends of " + edit.element + " crossed";
  if (!hold_links || s.resolved.closure_dialect == "closing frames") edit.remedy = exchange_text(s, pairs);
  return edit;
}

bool are_apart(const Pair& one, const Pair& other) {
  return one[0] != other[0] && one[0] != other[1] && one[1] != other[0] && one[1] != other[1];
}

}  // namespace

// Those of two, and those of two legs with two closures each.
Edits exchanged_ends(const Subject& subject, bool with_places_at_zero) {
  const std::vector<Closure>& closures = subject.resolved.closures;
  std::vector<Pair> pairs;
  Edits found;
  for (std::size_t k = 0; k < closures.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      if (may_exchange(closures[k], closures[other], with_places_at_zero)) pairs.push_back({other, k});
  for (const Pair& pair : pairs) found.push_back(exchange(subject, {pair}));
  if (closures.size() > max_in_two_legs) return found;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      if (are_apart(pairs[k], pairs[other])) found.push_back(exchange(subject, {pairs[other], pairs[k]}));
  return found;
}

// Where the first end follows from the second, that alone is written.
std::vector<PlacedEnd> placed_ends(const std::vector<Closure>& closures) {
  std::vector<PlacedEnd> ends;
  for (std::size_t k = 0; k < closures.size(); ++k)
    for (const std::size_t end : {0, 1}) {
      const Vector3d place = closures[k].frames[end].in_link.translation();
      if (!(closures[k].at_zero && end == 0) && !place.isZero(0.0)) ends.push_back({k, end, place});
    }
  return ends;
}

std::string place_text(const Subject& subject, const PlacedEnd& end) {
  return "puts the end of " + subject.closure(end.closure) + " in link " +
         subject.link(subject.resolved.closures[end.closure].frames[end.end].link) + " at " +
         in_brackets(end.place) + " m";
}

FrameChange moved(const Subject& subject, const PlacedEnd& end, const Vector3d& place) {
  FrameChange change{end.closure, end.end, subject.resolved.closures[end.closure].frames[end.end]};
  change.frame.in_link.translation() = place;
  return change;
}

Edits closure_place_edits(const Subject& subject, const std::vector<std::size_t>& closures) {
  Edits found;
  for (const PlacedEnd& end : placed_ends(subject.resolved.closures)) {
    if (std::count(closures.begin(), closures.end(), end.closure) == 0) continue;
    const auto add = [&](const Vector3d& place) {
      if ((place - end.place).norm() > rank_tolerance * end.place.norm())
        found.push_back(
            edit_of(subject, subject.file() + " " + place_text(subject, end), {moved(subject, end, place)}));
    };
    for (Eigen::Index k = 0; k < 3; ++k) {
      Vector3d mirrored = end.place, exchanged = end.place;
      mirrored[k] = -mirrored[k];
      std::swap(exchanged[k], exchanged[(k + 1) % 3]);
      add(mirrored);
      add(exchanged);
    }
  }
  return found;
}

}  // namespace parallel_aspects
