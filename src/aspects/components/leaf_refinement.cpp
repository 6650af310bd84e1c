// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/leaf_refinement.h"

#include "aspects/components/contacts.h"
#include "aspects/simd/box_requests.h"
#include "interval/interval.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <set>

namespace parallel_aspects {
namespace {

std::size_t undecided_leaves(const PoseTree& tree, std::size_t mode) noexcept {
  std::size_t count = 0;
  for (NodeIndex node = 0; node < tree.node_count(); ++node) count += tree.state(node, mode).is_undecided();
  return count;
}

/// Classifies nodes in one mode, as many at once as suits the processor and a user who cancels.
class BoxBatches {
 public:
  BoxBatches(PoseTree& tree, const BoxClassifier& classifier, std::size_t mode, const MapControl& control)
      : tree_(tree), classifier_(classifier), mode_(mode), control_(control) {}

  void add(NodeIndex node, Detail detail) {
    if (detail != detail_ || requests_.size() == most) classify();
    detail_ = detail;
    requests_.push_back({tree_.place(node).root, tree_.box(node), ModeSet{1} << mode_, tree_.states(node)});
  }

  /// What was added since; nothing when cancelled.
  void classify() {
    if (!is_cancelled(control_)) parallel_aspects::classify(classifier_, requests_, detail_);
    requests_.clear();
  }

 private:
  static constexpr std::size_t most = 256;

  PoseTree& tree_;
  const BoxClassifier& classifier_;
  std::size_t mode_;
  const MapControl& control_;
  Detail detail_ = Detail::states;
  BoxRequests requests_;
};

std::size_t max_leaves_of_a_point(const LeafGraph& graph, const ComponentPolicy& policy) {
  return graph.looks_everywhere() ? policy.max_leaves_of_a_point : policy.max_leaves_of_a_point_between;
}

/// What one working mode wants divided.
class ModeRefinement {
 public:
  ModeRefinement(PoseTree& tree, const BoxClassifier& classifier, LeafGraph& graph, std::uint32_t base_level,
                 std::uint32_t deepest_level, const MapControl& control, const ComponentPolicy& policy)
      : tree_(tree),
        classifier_(classifier),
        graph_(graph),
        control_(control),
        policy_(policy),
        deepest_level_(deepest_level),
        base_level_(base_level),
        positive_contacts_(tree, base_level, max_leaves_of_a_point(graph, policy), policy),
        negative_contacts_(tree, base_level, max_leaves_of_a_point(graph, policy), policy),
        positive_search_(tree, graph.mode(), graph.of(1), control, policy),
        negative_search_(tree, graph.mode(), graph.of(-1), control, policy),
        budget_(policy.least_budget +
                undecided_leaves(tree, graph.mode()) / policy.undecided_leaves_for_one) {}

  /// Looks into leaves again, and finds those to divide next; false when done.
  bool find_requests() {
    const RoundingUpward rounding;
    requests_.clear();
    has_examined_ = false;
    if (done_) return false;
    for (const int sign : {1, -1}) {
      if (is_cancelled(control_)) return false;
      graph_.of(sign).settle_faces(tree_, classifier_);
      request_bare(sign);
      request_contested(sign);
      if (graph_.looks_everywhere() && policy_.searches_indeterminate) request_indeterminate(sign);
    }
    make_unique(requests_);
    if (requests_.size() > budget_) requests_.clear();
    budget_ -= requests_.size();
    done_ = requests_.empty() && !has_examined_;
    return !done_;
  }

  /// After the requested leaves were divided.
  void take_in_children() {
    const RoundingUpward rounding;
    BoxBatches batches(tree_, classifier_, mode(), control_);
    for (const NodeIndex node : requests_) {
      const NodeIndex first = tree_.first_child(node);
      for (NodeIndex child = first; child < first + tree_.children_per_node(); ++child)
        batches.add(child, detail(first));
    }
    batches.classify();
    for (const NodeIndex node : requests_)
      if (!is_cancelled(control_)) graph_.replace(tree_, node);
  }

  std::size_t mode() const noexcept { return graph_.mode(); }
  const std::vector<NodeIndex>& requests() const noexcept { return requests_; }

 private:
  static void make_unique(std::vector<NodeIndex>& nodes) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }

  Detail detail(NodeIndex node) const {
    if (!graph_.looks_everywhere()) return Detail::centers;
    const bool thorough = tree_.dimension() <= policy_.max_degrees_of_freedom_to_look_everywhere ||
                          tree_.place(node).level >= base_level_ + policy_.levels_before_all_parts;
    return thorough ? Detail::all_parts : Detail::parts;
  }

  void examine(const std::vector<NodeIndex>& nodes) {
    std::vector<LeafState> before;
    BoxBatches batches(tree_, classifier_, mode(), control_);
    for (const NodeIndex node : nodes) {
      before.push_back(tree_.state(node, mode()));
      batches.add(node, Detail::all_parts);
    }
    batches.classify();
    for (std::size_t i = 0; i < nodes.size() && !is_cancelled(control_); ++i) take_in(nodes[i], before[i]);
  }

  /// Keeps what the graph has proved of the leaf.
  void take_in(NodeIndex node, LeafState before) {
    LeafState& state = tree_.state(node, mode());
    // What was known may have come from the parent or from a search in the leaf, which this does not repeat.
    for (const int sign : {1, -1}) {
      if (!before.may_be(sign) && state.may_be(sign)) state = state.without(sign);
      if (before.is_whole(sign) && state.is_undecided() && state.may_be(sign)) state = state.with_whole(sign);
    }
    graph_.take_in_proof(tree_, node);
    has_examined_ = true;
  }

  void request(NodeIndex node) {
    if (tree_.place(node).level < deepest_level_) requests_.push_back(node);
  }

  void request_bare(int sign) {
    for (const NodeIndex node : graph_.of(sign).climb_from_new(tree_, classifier_, graph_.looks_everywhere()))
      if (graph_.looks_everywhere()) request(node);
  }

  void request_contested(int sign) {
    SignGraph& graph = graph_.of(sign);
    ContactChoice& choice = sign > 0 ? positive_contacts_ : negative_contacts_;
    if (graph_.looks_everywhere()) {
      if (policy_.searches_meetings)
        for (const NodeIndex node : choice.choose(graph, graph.meeting().contacts)) request(node);
      return;
    }
    if (!policy_.searches_contacts) return;
    ContactSearch& search = sign > 0 ? positive_search_ : negative_search_;
    const std::vector<NodeIndex> chosen = choice.choose(graph, search.run());
    std::vector<NodeIndex> examined;
    std::set<NodeIndex> seen;
    for (const NodeIndex node : chosen) {
      const bool is_new = policy_.examines && graph.is_unexamined(node) && seen.insert(node).second;
      if (is_new) examined.push_back(node);
    }
    examine(examined);
    auto next = examined.begin();
    for (const NodeIndex node : chosen) {
      const bool is_new = next != examined.end() && *next == node;
      if (is_new) ++next;
      if (!is_new || !graph.is_settled(node)) request(node);
    }
  }

  void request_indeterminate(int sign) {
    std::vector<NodeIndex> leaves;
    const std::uint32_t level = tree_.dimension() <= policy_.max_degrees_of_freedom_to_look_everywhere
                                    ? deepest_level_
                                    : policy_.level_of_indeterminate_leaves;
    const IndeterminateLeaves& open = graph_.of(sign).indeterminate_leaves();
    for (std::size_t v = 0; v < open.size(); ++v)
      if (open.node(v) != no_node && tree_.place(open.node(v)).level < level) leaves.push_back(open.node(v));
    if (leaves.size() > policy_.max_indeterminate_leaves) return;
    for (const NodeIndex node : coarsest_of(tree_, leaves)) request(node);
  }

  PoseTree& tree_;
  const BoxClassifier& classifier_;
  LeafGraph& graph_;
  const MapControl& control_;
  const ComponentPolicy& policy_;
  std::uint32_t deepest_level_, base_level_;
  ContactChoice positive_contacts_, negative_contacts_;
  ContactSearch positive_search_, negative_search_;
  std::size_t budget_;  // of leaves to divide
  bool done_ = false, has_examined_ = false;
  std::vector<NodeIndex> requests_;
};

}  // namespace

bool looks_everywhere(const PoseTree& tree, std::size_t mode, const ComponentPolicy& policy) noexcept {
  return tree.dimension() <= policy.max_degrees_of_freedom_to_look_everywhere ||
         undecided_leaves(tree, mode) <= policy.max_leaves_to_look_into;
}

void look_into_leaves(PoseTree& tree, const BoxClassifier& classifier, std::size_t mode,
                      const MapControl& control) {
  if (detail_of_base_map(tree.dimension()) != Detail::centers) return;
  const RoundingUpward rounding;
  BoxBatches batches(tree, classifier, mode, control);
  for (NodeIndex node = 0; node < tree.node_count() && !is_cancelled(control); ++node)
    if (tree.state(node, mode).is_undecided()) batches.add(node, Detail::parts);
  batches.classify();
}

bool refine_contested(PoseTree& tree, const BoxClassifier& classifier,
                      const std::vector<std::unique_ptr<LeafGraph>>& graphs, std::uint32_t base_level,
                      std::uint32_t deepest_level, const MapControl& control, const ComponentPolicy& policy) {
  std::vector<ModeRefinement> modes;
  for (const auto& graph : graphs)
    modes.emplace_back(tree, classifier, *graph, base_level, deepest_level, control, policy);
  for (bool busy = true; busy;) {
    if (is_cancelled(control)) return false;
    std::atomic<bool> found = false;
    tbb::parallel_for(std::size_t{0}, modes.size(), [&](std::size_t i) {
      if (modes[i].find_requests()) found = true;
    });
    if (is_cancelled(control)) return false;
    // Division may move all nodes, so that it waits until no mode looks.
    busy = found;
    for (const ModeRefinement& mode : modes) {
      for (const NodeIndex node : mode.requests())
        tree.divide(node, [&mode](std::size_t each) { return each == mode.mode(); });
    }
    tbb::parallel_for(std::size_t{0}, modes.size(), [&](std::size_t i) { modes[i].take_in_children(); });
  }
  return true;
}

}  // namespace parallel_aspects
