// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/shared_ends.h"

#include <algorithm>
#include <map>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_anchors = 3;  // in which two chains meet each
constexpr std::size_t crowd = 4;        // of closures in one place, with the leg that carries it five legs

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
    pairing.pairs.push_back({anchors.front(), ends.front(), ""});
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
      Pairing pairing{{}, "two neighbours in one joint, for whose order nothing else speaks"};
      for (std::size_t k = 0; k < tips.size(); ++k)
        pairing.pairs.push_back({anchor_of(k + carriers), tips[k].front(), ""});
      orders.push_back(pairing);
    }
  } while (std::next_permutation(anchors.begin(), anchors.end()));
  return orders;
}

std::optional<SetupQuestion> question_of_places(const Tree& tree, const OpenEnds& ends,
                                                const std::string& urdf_name) {
  if (ends.pairings.empty() || ends.pairings.front().size() != 1) return std::nullopt;
  const std::vector<EndPair>& pairs = ends.pairings.front().front().pairs;
  const auto link = crowded_link(pairs);
  if (!link) return std::nullopt;
  const std::string& name = tree.links[*link];
  SetupQuestion question{
      "closures",
      urdf_name + " does not tell where its loops are closed; " + std::to_string(pairs.size()) +
          " chains end at link '" + name +
          "', which has no frames for them: give the place of each in the frame of '" + name +
          "' as X:Y:Z [m]; ends that are in no loop, as fingers, are left out of --closures",
      {},
      {}};
  for (const EndPair& pair : pairs)
    question.example.push_back(name + "@X:Y:Z=" + tree.links[pair.one == *link ? pair.other : pair.one]);
  return question;
}

}  // namespace parallel_aspects
