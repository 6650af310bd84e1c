// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/shared_ends.h"

#include <algorithm>
#include <map>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_anchors = 3;  // in which two chains meet each

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

}  // namespace parallel_aspects
