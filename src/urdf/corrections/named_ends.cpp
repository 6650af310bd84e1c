// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/edits.h"
#include "urdf/description/name_words.h"

#include <algorithm>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

using Names = std::vector<std::string>;

constexpr int least_likeness = 3;  // of two ends that share a number, a letter or a word that counts legs

// A closure that holds a leg to the platform.
struct HeldLeg {
  std::size_t closure = 0;
  std::size_t anchor = 0;  // which of its frames is on the platform
};

bool are_distinct(const Names& names) {
  return std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

class NamedEnds {
 public:
  NamedEnds(const Tree& tree, const ResolvedConfig& resolved) : tree_(tree), resolved_(resolved) {
    const std::size_t platform = body_of(tree, resolved.actuated_joints.platform_link);
    for (std::size_t k = 0; k < resolved.closures.size(); ++k) {
      const auto& frames = resolved.closures[k].frames;
      const bool first = body_of(tree, frames[0].link) == platform;
      if (first != (body_of(tree, frames[1].link) == platform)) legs_.push_back({k, first ? 0U : 1U});
    }
  }

  const std::vector<HeldLeg>& legs() const { return legs_; }

  // Of each leg, the one that has its anchor by the names that decide first; nothing where none do.
  std::vector<std::size_t> pairing() const {
    if (legs_.size() < 2) return {};
    for (const Names& tips : tip_names())
      for (const Names& anchors : anchor_names()) {
        std::vector<std::size_t> pairs = paired(tips, anchors);
        if (!pairs.empty()) return pairs;
      }
    return {};
  }

 private:
  std::size_t link_of(const HeldLeg& leg, bool anchor) const {
    return resolved_.closures[leg.closure].frames[anchor ? leg.anchor : 1 - leg.anchor].link;
  }

  template <class Name>
  Names names_by(Name name) const {
    Names names;
    for (const HeldLeg& leg : legs_) names.push_back(name(leg));
    return names;
  }

  // Those that closures in a list call their ends by, too.
  std::string end_name(const HeldLeg& leg, bool anchor) const {
    const std::string& both = resolved_.closures[leg.closure].name;
    const std::size_t middle = both.find(" - ");
    if (!resolved_.closure_dialect.empty() || middle == std::string::npos)
      return tree_.links[link_of(leg, anchor)];
    return anchor == (leg.anchor == 0) ? both.substr(0, middle) : both.substr(middle + 3);
  }

  std::string joint_above(std::size_t link) const {
    const auto joint = tree_.joint_above[link];
    return joint ? tree_.joints[*joint].name : tree_.links[link];
  }

  // The link that the first joint of the chain carries.
  std::size_t start_of_chain(std::size_t link) const {
    const std::size_t base = body_of(tree_, resolved_.base);
    for (auto joint = tree_.joint_above[link]; joint && body_of(tree_, tree_.joints[*joint].parent) != base;
         joint = tree_.joint_above[link])
      link = tree_.joints[*joint].parent;
    return link;
  }

  // The names of the ends themselves come first.
  std::vector<Names> tip_names() const {
    return {
        names_by([this](const HeldLeg& leg) { return end_name(leg, false); }),
        names_by([this](const HeldLeg& leg) { return tree_.links[body_of(tree_, link_of(leg, false))]; }),
        names_by([this](const HeldLeg& leg) { return joint_above(body_of(tree_, link_of(leg, false))); }),
        names_by([this](const HeldLeg& leg) { return joint_above(start_of_chain(link_of(leg, false))); })};
  }

  std::vector<Names> anchor_names() const {
    return {names_by([this](const HeldLeg& leg) { return end_name(leg, true); }),
            names_by([this](const HeldLeg& leg) { return joint_above(link_of(leg, true)); })};
  }

  // Each with that which is most like it, either way round.
  static std::vector<std::size_t> paired(const Names& tips, const Names& anchors) {
    if (!are_distinct(tips) || !are_distinct(anchors)) return {};
    const std::size_t count = tips.size();
    Tree named;
    named.links = tips;
    named.links.insert(named.links.end(), anchors.begin(), anchors.end());
    std::vector<std::size_t> ends(2 * count);
    for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = k;
    const auto middle = ends.begin() + static_cast<std::ptrdiff_t>(count);
    const EndLikeness likeness(named, {ends.begin(), middle}, {middle, ends.end()});
    std::vector<std::size_t> pairs;
    for (std::size_t tip = 0; tip < count; ++tip) {
      const auto anchor = likest(count, [&](std::size_t k) { return likeness.between(tip, count + k); });
      if (!anchor) return {};
      const auto back = likest(count, [&](std::size_t k) { return likeness.between(k, count + *anchor); });
      if (back != tip) return {};
      pairs.push_back(*anchor);
    }
    return pairs;
  }

  // Nothing where two are as like.
  template <class Likeness>
  static std::optional<std::size_t> likest(std::size_t count, Likeness likeness) {
    std::optional<std::size_t> best;
    int most = least_likeness - 1;
    for (std::size_t k = 0; k < count; ++k) {
      const int value = likeness(k);
      if (value == most) best.reset();
      if (value > most) best = k;
      most = std::max(most, value);
    }
    return best;
  }

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  std::vector<HeldLeg> legs_;
};

}  // namespace

Edits ends_paired_by_names(const Subject& subject) {
  const NamedEnds named(subject.tree, subject.resolved);
  const std::vector<std::size_t> pairing = named.pairing();
  std::vector<Change> changes;
  for (std::size_t k = 0; k < pairing.size(); ++k) {
    if (pairing[k] == k) continue;
    const auto& [closure, end] = named.legs()[k];
    const auto& [other, other_end] = named.legs()[pairing[k]];
    changes.emplace_back(FrameChange{closure, end, subject.resolved.closures[other].frames[other_end]});
  }
  if (changes.empty()) return {};
  Edit edit = edit_of(subject, "", std::move(changes), true);
  edit.fault = subject.file() + " has the ends of " + edit.element + " crossed";
  return {edit};
}

}  // namespace parallel_aspects
