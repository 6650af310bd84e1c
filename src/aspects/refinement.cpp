// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/refinement.h"

#include "parallel_aspects/aspects/interval.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

// Contacts at points keep a number of leaves that does not grow with depth, those along curves double it with
// each level.
constexpr std::size_t most_leaves_of_a_point = 1000;
constexpr std::uint32_t levels_to_see_growth = 1;

// Aspects smaller than a leaf could hide in open leaves beside another component. Where open leaves are few
// they are divided down to this level.
constexpr std::uint32_t level_of_open_leaves = 10;

// Up to two freedoms what stays open lies at points, and is divided until nothing can hide.
constexpr std::size_t most_freedoms_to_count = 2;

// With more freedoms most contacts end within a few levels, and the work for all parts does not pay there.
constexpr std::uint32_t levels_before_all_parts = 3;

// What one working mode may divide: a share of what the base map has left undecided.
constexpr std::size_t least_budget = 10000;
constexpr std::size_t undecided_leaves_for_one = 8;

/// What one working mode wants divided.
class ModeRefinement {
 public:
  ModeRefinement(PoseTree& tree, const BoxClassifier& classifier, LeafGraph& graph, std::uint32_t base_level,
                 std::uint32_t deepest_level, const MapControl& control)
      : tree_(tree),
        classifier_(classifier),
        graph_(graph),
        control_(control),
        base_level_(base_level),
        deepest_level_(deepest_level),
        budget_(least_budget + undecided_leaves() / undecided_leaves_for_one) {}

  /// The leaves to divide next; none when done.
  const std::vector<NodeIndex>& find_requests() {
    const RoundingUpward rounding;
    if (done_) return requests_;
    requests_.clear();
    for (const int sign : {1, -1}) {
      if (is_cancelled(control_)) return requests_;
      graph_.of(sign).settle_faces(tree_, classifier_);
      request_bare(sign);
      request_contested(sign);
      request_open(sign);
    }
    std::sort(requests_.begin(), requests_.end());
    requests_.erase(std::unique(requests_.begin(), requests_.end()), requests_.end());
    if (requests_.size() > budget_) requests_.clear();
    budget_ -= requests_.size();
    done_ = requests_.empty();
    return requests_;
  }

  /// After the requested leaves were divided.
  void take_in_children() {
    const RoundingUpward rounding;
    for (const NodeIndex node : requests_) {
      if (is_cancelled(control_)) return;
      const NodeIndex first = tree_.first_child(node);
      for (NodeIndex child = first; child < first + tree_.children_per_node(); ++child)
        classifier_.classify(tree_.place(child).root, tree_.box(child), ModeSet{1} << graph_.mode(),
                             detail(child), tree_.states(child));
    }
    for (const NodeIndex node : requests_)
      if (!is_cancelled(control_)) graph_.replace(tree_, node);
  }

  std::size_t mode() const noexcept { return graph_.mode(); }
  const std::vector<NodeIndex>& requests() const noexcept { return requests_; }

 private:
  std::size_t undecided_leaves() const {
    std::size_t count = 0;
    for (NodeIndex node = 0; node < tree_.node_count(); ++node)
      count += tree_.state(node, graph_.mode()).is_undecided();
    return count;
  }

  Detail detail(NodeIndex node) const {
    const bool thorough = tree_.dimension() <= most_freedoms_to_count ||
                          tree_.place(node).level >= base_level_ + levels_before_all_parts;
    return thorough ? Detail::all_parts : Detail::parts;
  }

  void request(NodeIndex node) {
    if (tree_.place(node).level < deepest_level_) requests_.push_back(node);
  }

  void request_bare(int sign) {
    for (const NodeIndex node : graph_.of(sign).climb_from_new(tree_, classifier_)) request(node);
  }

  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  Pair components(const SignGraph::Contact& contact, SignGraph& graph) const {
    return std::minmax(graph.component(contact.leaf), graph.component(contact.other_leaf));
  }

  void request_contested(int sign) {
    SignGraph& graph = graph_.of(sign);
    SignGraph::Meeting meeting = graph.meeting();
    std::map<Pair, std::vector<NodeIndex>> contested;
    for (const SignGraph::Contact& contact : meeting.contacts) {
      auto& leaves = contested[components(contact, graph)];
      leaves.insert(leaves.end(), {contact.node, contact.other_node});
    }
    for (auto& [pair, leaves] : contested) request_all(leaves);
    if (meeting.hidden.size() <= most_leaves_of_a_point) request_all(meeting.hidden);
  }

  void request_open(int sign) {
    std::vector<NodeIndex> leaves;
    const std::uint32_t level =
        tree_.dimension() <= most_freedoms_to_count ? deepest_level_ : level_of_open_leaves;
    for (const SignGraph::OpenLeaf& open : graph_.of(sign).open_leaves())
      if (open.node != no_node && tree_.place(open.node).level < level) leaves.push_back(open.node);
    if (leaves.size() <= most_leaves_of_a_point) request_all(leaves);
  }

  /// The coarsest of them, unless they seem endless.
  void request_all(std::vector<NodeIndex>& leaves) {
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    std::uint32_t coarsest = deepest_level_;
    for (const NodeIndex node : leaves) coarsest = std::min(coarsest, tree_.place(node).level);
    if (coarsest >= base_level_ + levels_to_see_growth && leaves.size() > most_leaves_of_a_point) return;
    for (const NodeIndex node : leaves)
      if (tree_.place(node).level == coarsest) request(node);
  }

  PoseTree& tree_;
  const BoxClassifier& classifier_;
  LeafGraph& graph_;
  const MapControl& control_;
  std::uint32_t base_level_, deepest_level_;
  std::size_t budget_;  // of leaves to divide
  bool done_ = false;
  std::vector<NodeIndex> requests_;
};

}  // namespace

bool refine_contested(PoseTree& tree, const BoxClassifier& classifier,
                      const std::vector<std::unique_ptr<LeafGraph>>& graphs, std::uint32_t base_level,
                      std::uint32_t deepest_level, const MapControl& control) {
  std::vector<ModeRefinement> modes;
  for (const auto& graph : graphs)
    modes.emplace_back(tree, classifier, *graph, base_level, deepest_level, control);
  for (bool busy = true; busy;) {
    if (is_cancelled(control)) return false;
    tbb::parallel_for(std::size_t{0}, modes.size(), [&](std::size_t i) { modes[i].find_requests(); });
    if (is_cancelled(control)) return false;
    busy = false;
    for (const ModeRefinement& mode : modes) {
      busy = busy || !mode.requests().empty();
      for (const NodeIndex node : mode.requests())
        tree.divide(node, [&mode](std::size_t each) { return each == mode.mode(); });
    }
    tbb::parallel_for(std::size_t{0}, modes.size(), [&](std::size_t i) { modes[i].take_in_children(); });
  }
  return true;
}

}  // namespace parallel_aspects
