// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_SHORTEST_PATHS_H
#define PARALLEL_ASPECTS_MOTION_SHORTEST_PATHS_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// No node of a graph.
inline constexpr std::size_t no_graph_node = std::numeric_limits<std::size_t>::max();

/// The cheapest paths from some nodes of a graph, by Dijkstra's algorithm, or by A* where estimates are costs
/// with a bound of what is left (P. Hart, N. Nilsson and B. Raphael, IEEE Transactions on Systems Science and
/// Cybernetics 4, 1968). The caller enters the first nodes, takes one node after another and enters those
/// that it leads to. Nodes are numbered from 0. `<` orders costs; along a path they do not fall.
template <class Cost>
class ShortestPaths {
 public:
  /// Enters a node from the one before. False where a path to it is known that is as cheap, or it was taken.
  bool enter(std::size_t node, std::size_t before, const Cost& cost, const Cost& estimate) {
    if (!is_cheaper(node, cost)) return false;
    if (node >= nodes_.size()) nodes_.resize(node + 1);
    nodes_[node] = {cost, before, true, false};
    open_.push({estimate, node});
    return true;
  }

  bool enter(std::size_t node, std::size_t before, const Cost& cost) {
    return enter(node, before, cost, cost);
  }

  /// The entered node with the least estimate, which is taken: its path stays. `no_graph_node` where all are.
  std::size_t take() {
    while (!open_.empty()) {
      const std::size_t node = open_.top().node;
      open_.pop();
      if (std::exchange(nodes_[node].is_taken, true)) continue;
      return node;
    }
    return no_graph_node;
  }

  /// Whether a path of this cost would be the cheapest that is known to the node.
  bool is_cheaper(std::size_t node, const Cost& cost) const {
    if (node >= nodes_.size() || !nodes_[node].is_entered) return true;
    return !nodes_[node].is_taken && cost < nodes_[node].cost;
  }

  bool is_taken(std::size_t node) const { return node < nodes_.size() && nodes_[node].is_taken; }

  /// Of the path to an entered node.
  const Cost& cost(std::size_t node) const { return nodes_[node].cost; }

  /// The nodes of the path to an entered node, this one included; none to `no_graph_node`.
  std::vector<std::size_t> path_to(std::size_t node) const {
    std::vector<std::size_t> path;
    for (; node != no_graph_node; node = nodes_[node].before) path.push_back(node);
    std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  struct Node {
    Cost cost{};
    std::size_t before = no_graph_node;
    bool is_entered = false, is_taken = false;
  };

  struct Open {
    Cost estimate;
    std::size_t node;

    /// The queue has its largest first.
    friend bool operator<(const Open& a, const Open& b) {
      if (b.estimate < a.estimate) return true;
      return !(a.estimate < b.estimate) && b.node < a.node;
    }
  };

  std::vector<Node> nodes_;
  std::priority_queue<Open> open_;
};

/// The cost of paths of which the widest is wanted, and of equally wide ones the shortest.
struct WidthAndLength {
  double width = 0.0, length = 0.0;

  friend bool operator<(const WidthAndLength& a, const WidthAndLength& b) {
    return a.width != b.width ? a.width > b.width : a.length < b.length;
  }
};

/// Edges of a graph whose proofs take long: they are proved where a path goes, and one that fails is barred
/// for the next search.
class ProvedEdges {
 public:
  bool is_barred(std::size_t a, std::size_t b) const { return barred_.count(std::minmax(a, b)) > 0; }

  /// Whether all edges of the path are proved, by `prove(from, to)`, which is asked once an edge.
  template <class Prove>
  bool hold(const std::vector<std::size_t>& path, const Prove& prove) {
    bool all = true;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const Edge edge = std::minmax(path[i], path[i + 1]);
      if (proved_.count(edge) > 0) continue;
      const bool is_proved = prove(path[i], path[i + 1]);
      (is_proved ? proved_ : barred_).insert(edge);
      all = all && is_proved;
    }
    return all;
  }

 private:
  using Edge = std::pair<std::size_t, std::size_t>;  // the lower node first

  std::set<Edge> proved_, barred_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_SHORTEST_PATHS_H
