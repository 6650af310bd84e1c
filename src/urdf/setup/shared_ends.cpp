// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/open_ends.h"

#include <algorithm>
#include <map>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_anchors = 3;       // in which two chains meet each, as in an octahedral hexapod
constexpr double same_place = 1e-6;          // to which lengths are written [m]
constexpr std::size_t max_in_one_point = 3;  // chains: more actuate no point
constexpr std::size_t crowd = 4;  // of closures in one place, with the leg that carries it five legs

bool all_hold(const std::vector<EndPair>& pairs, std::size_t link) {
  return std::all_of(pairs.begin(), pairs.end(),
                     [link](const EndPair& pair) { return pair.one == link || pair.other == link; });
}

std::optional<std::size_t> crowded_link(const std::vector<EndPair>& pairs) {
  if (pairs.size() < crowd) return std::nullopt;
  for (const std::size_t link : {pairs.front().one, pairs.front().other})
    if (all_hold(pairs, link)) return link;
  return std::nullopt;
}

// Nothing where a second one is not much farther.
std::optional<std::size_t> neighbour(std::size_t end, std::vector<std::size_t> ends,
                                     const DistanceOfEnds& distance) {
  ends.erase(std::find(ends.begin(), ends.end(), end));
  std::partial_sort(ends.begin(), ends.begin() + 2, ends.end(), [&](std::size_t one, std::size_t two) {
    return distance(end, one) < distance(end, two);
  });
  const bool is_told = distinct * distance(end, ends[0]) < distance(end, ends[1]);
  return is_told ? std::optional<std::size_t>(ends[0]) : std::nullopt;
}

// Whether its origin is a knee, on a crank, and not the far end of a rod, which two joints move at least.
bool is_at_knee(const Tree& tree, std::size_t link) {
  int moving = 0;
  double off = 0.0;
  for (auto above = tree.joint_above[link]; above; above = tree.joint_above[tree.joints[*above].parent]) {
    const TreeJoint& joint = tree.joints[*above];
    if (joint.variable && (off > same_place || joint.motion == JointMotion::prismatic)) ++moving;
    off += joint.origin.translation().norm();
  }
  return moving < 2;
}

}  // namespace

bool meets_in_pairs(const Pairing& pairing, std::size_t chains) {
  std::map<std::size_t, int> counts;
  for (const EndPair& pair : pairing.pairs) ++counts[pair.one];
  const auto with = [&](int count) {
    return static_cast<std::size_t>(
        std::count_if(counts.begin(), counts.end(), [&](const auto& each) { return each.second == count; }));
  };
  return pairing.pairs.size() == chains && with(2) > 0 && with(1) <= 1 && with(1) + with(2) == counts.size();
}

EqualPairings in_one_point(const std::vector<std::size_t>& anchors,
                           const std::vector<std::vector<std::size_t>>& tips) {
  if (anchors.size() != 1 || tips.size() < 2) return {};
  Pairing pairing{{}, "each is the only open end of its chain"};
  for (const auto& ends : tips) {
    if (ends.size() != 1) return {};
    pairing.pairs.push_back({anchors.front(), ends.front()});
  }
  return {pairing};
}

EqualPairings shared_orders(std::vector<std::size_t> anchors,
                            const std::vector<std::vector<std::size_t>>& tips,
                            std::optional<std::size_t> carried) {
  const std::size_t count = anchors.size(), carriers = carried ? 1 : 0;
  if (count < 2 || count > max_anchors || tips.size() + carriers != 2 * count) return {};
  EqualPairings orders;
  std::sort(anchors.begin(), anchors.end());
  do {
    for (const std::size_t first : {0, 1}) {
      const auto anchor_of = [&](std::size_t chain) { return anchors[(chain + first) / 2 % count]; };
      if (carried && anchor_of(0) != *carried) continue;
      Pairing pairing{{}, "two neighbours in one joint, without evidence for their order"};
      for (std::size_t k = 0; k < tips.size(); ++k)
        pairing.pairs.push_back({anchor_of(k + carriers), tips[k].front()});
      orders.push_back(pairing);
    }
  } while (std::next_permutation(anchors.begin(), anchors.end()));
  return orders;
}

EqualPairings two_by_two(const std::vector<std::size_t>& ends, const DistanceOfEnds& distance) {
  if (ends.size() <= max_in_one_point) return {};
  Pairing pairing{{}, "their last joints are nearest to each other while all joints are zero"};
  for (const std::size_t end : ends) {
    const auto other = neighbour(end, ends, distance);
    if (!other || neighbour(*other, ends, distance) != end) return {};
    if (end < *other) pairing.pairs.push_back({end, *other});
  }
  return {pairing};
}

std::optional<SetupQuestion> question_of_places(const Tree& tree, const OpenEnds& ends,
                                                const std::string& urdf_name) {
  if (ends.pairings.empty() || ends.pairings.front().size() != 1) return std::nullopt;
  const std::vector<EndPair>& pairs = ends.pairings.front().front().pairs;
  const auto link = crowded_link(pairs);
  if (!link) return std::nullopt;
  const std::string& name = tree.links[*link];
  const auto is_rod = [&](std::size_t end) {
    const bool slides = tree.joints[*tree.joint_above[end]].motion == JointMotion::prismatic;
    return std::count(ends.without_tip_frame.begin(), ends.without_tip_frame.end(), end) > 0 &&
           (slides || is_at_knee(tree, end));
  };
  const bool any_rod = std::any_of(pairs.begin(), pairs.end(), [&](const EndPair& pair) {
    return is_rod(pair.one == *link ? pair.other : pair.one);
  });
  SetupQuestion question{
      "closures",
      urdf_name + " does not say where its loops are closed; " + std::to_string(pairs.size()) +
          " chains end at link '" + name + "', which has no frames for them" +
          (any_rod
               ? ", and their rods have none at the far end: give the place of each in the frame of its link"
               : ": give the place of each in the frame of '" + name + "'") +
          " as X:Y:Z [m]; ends that are in no loop, as fingers, are left out of --closures",
      {},
      {}};
  for (const EndPair& pair : pairs) {
    const std::size_t end = pair.one == *link ? pair.other : pair.one;
    question.example.push_back(name + "@X:Y:Z=" + tree.links[end] + (is_rod(end) ? "@X:Y:Z" : ""));
  }
  return question;
}

}  // namespace parallel_aspects
