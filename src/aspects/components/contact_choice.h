// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACT_CHOICE_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACT_CHOICE_H

#include "aspects/components/sign_graph.h"
#include "aspects/tree/pose_tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// The leaves of the lowest level among some.
std::vector<NodeIndex> coarsest_of(const PoseTree& tree, const std::vector<NodeIndex>& leaves);

/// Chooses leaves to work on where components of one mode and sign could meet, round by round.
///
/// Where two components meet in few leaves, these are all worked on. Where the leaves are many, the two may
/// touch along a curve or a surface, and then no depth tells them apart; or one leaf of the many may join
/// them. So a few of the leaves are tried first, some levels deep. More follow where those were settled;
/// where they were not, the components are given up.
class ContactChoice {
 public:
  /// `max_leaves_of_a_point`: see ComponentPolicy, which must outlive this.
  ContactChoice(const PoseTree& tree, std::uint32_t base_level, std::size_t max_leaves_of_a_point,
                const ComponentPolicy& policy)
      : tree_(tree),
        base_level_(base_level),
        max_leaves_of_a_point_(max_leaves_of_a_point),
        policy_(policy),
        tries_(policy.first_tries) {}

  std::vector<NodeIndex> choose(SignGraph& graph, const std::vector<SignGraph::Contact>& contacts);

 private:
  std::vector<NodeIndex> choose_of_pair(const SignGraph& graph, const std::vector<NodeIndex>& leaves);
  /// What is left to do of a contact of many leaves that does not seem to end.
  std::vector<NodeIndex> of_many(const SignGraph& graph, const std::vector<NodeIndex>& leaves) const;
  std::vector<NodeIndex> spread(const std::vector<NodeIndex>& leaves) const;

  const PoseTree& tree_;
  std::uint32_t base_level_;
  std::size_t max_leaves_of_a_point_;
  const ComponentPolicy& policy_;
  std::size_t tries_;
  bool asks_for_more_ = false;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACT_CHOICE_H
