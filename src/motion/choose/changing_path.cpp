// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "motion/choose/path_measures.h"
#include "motion/choose/posture_change.h"
#include "motion/shortest_paths.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <algorithm>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t first_pieces = 96;
constexpr int max_halvings = 6;     // of a piece that no working mode is proved for
constexpr int parts_of_piece = 60;  // of its proof

/// Fewer changes are better, then shorter detours [m].
using Cost = std::pair<int, double>;

using Path = std::vector<PoseWaypoint>;

/// Poses along the path, and which working modes each piece between two is proved for.
class Stations {
 public:
  Stations(const SegmentCertifier& certifier, const std::vector<PoseWaypoint>& waypoints,
           const MapControl& control)
      : certifier_(certifier), control_(control), modes_(working_modes(*certifier.manipulator())) {
    const Path path = divided_path(certifier.manipulator()->motions(), waypoints, first_pieces);
    const std::size_t segments = path.size() - 1, stride = 1 + segments / (2 * first_pieces);
    add_station(path.front());
    for (std::size_t i = 0; i < segments && !nowhere_ && !is_cancelled(control_); i += stride) {
      const std::size_t end = std::min(i + stride, segments);
      add_piece({path.begin() + static_cast<std::ptrdiff_t>(i),
                 path.begin() + static_cast<std::ptrdiff_t>(end) + 1},
                0);
      if (control_.progress) control_.progress(static_cast<double>(end) / static_cast<double>(segments));
    }
  }

  std::size_t count() const { return stations_.size(); }
  const PoseWaypoint& at(std::size_t station) const { return stations_[station]; }

  /// The sign of det A, where proved.
  int sign(std::size_t station, std::size_t mode) const { return signs_[station][mode]; }

  /// Whether the piece after a station is proved free.
  bool is_free(std::size_t station, std::size_t mode) const { return free_[station][mode]; }

  /// The time of a pose that is proved to lie in no aspect, if one was found.
  const std::optional<double>& nowhere() const { return nowhere_; }

 private:
  void add_station(const PoseWaypoint& station) {
    std::vector<int> signs;
    bool violated = true;
    for (const WorkingMode& mode : modes_) {
      const ConfigurationProof proof = certifier_.prove(station.pose, mode);
      signs.push_back(proof.sign);
      violated = violated && proof.proved_violation != Violation::none;
    }
    stations_.push_back(station);
    signs_.push_back(std::move(signs));
    if (violated) nowhere_ = station.time;
  }

  bool is_proved(const Path& piece, const WorkingMode& mode) const {
    for (std::size_t i = 0; i + 1 < piece.size(); ++i)
      if (is_cancelled(control_) ||
          certifier_.prove(piece[i].pose, piece[i + 1].pose, mode, parts_of_piece).verdict !=
              SegmentVerdict::free)
        return false;
    return true;
  }

  /// The piece from the last station. It is halved at a waypoint, or within its only segment.
  void add_piece(const Path& piece, int halvings) {
    std::vector<bool> free;
    for (const WorkingMode& mode : modes_) free.push_back(is_proved(piece, mode));
    const bool any = std::find(free.begin(), free.end(), true) != free.end();
    if (any || halvings == max_halvings || is_cancelled(control_)) {
      free_.push_back(std::move(free));
      return add_station(piece.back());
    }
    const auto [first, second] = halves(piece);
    const int more = piece.size() == 2 ? 1 : 0;
    add_piece(first, halvings + more);
    if (!nowhere_) add_piece(second, halvings + more);
  }

  std::pair<Path, Path> halves(const Path& piece) const {
    if (piece.size() == 2) {
      const PoseWaypoint middle = waypoint_between(certifier_.manipulator()->motions(), piece, 0, 0.5);
      return {{piece.front(), middle}, {middle, piece.back()}};
    }
    const auto middle = piece.begin() + static_cast<std::ptrdiff_t>(piece.size() / 2);
    return {{piece.begin(), middle + 1}, {middle, piece.end()}};
  }

  const SegmentCertifier& certifier_;
  const MapControl& control_;
  std::vector<WorkingMode> modes_;
  std::vector<PoseWaypoint> stations_;
  std::vector<std::vector<int>> signs_;  // by station and mode
  std::vector<std::vector<bool>> free_;  // by piece and mode
  std::optional<double> nowhere_;
};

/// Shortest paths from the first station to the last.
class LiftGraph {
 public:
  LiftGraph(const Manipulator& manipulator, const Stations& stations, const MapControl& control)
      : stations_(stations),
        control_(control),
        modes_(working_modes(manipulator)),
        legs_(manipulator.leg_count()),
        search_(manipulator) {}

  /// Nodes from the start to the end; empty where none was found.
  std::vector<std::size_t> shortest() {
    for (std::size_t mode = 0; mode < modes_.size(); ++mode)
      if (stations_.sign(0, mode) != 0) paths_.enter(mode, no_graph_node, {0, 0.0});
    while (!is_cancelled(control_)) {
      const std::size_t node = paths_.take();
      if (node == no_graph_node || station(node) + 1 == stations_.count()) return paths_.path_to(node);
      expand(node, paths_.cost(node));
    }
    return {};
  }

  std::size_t station(std::size_t node) const { return node / modes_.size(); }
  const WorkingMode& mode(std::size_t node) const { return modes_[node % modes_.size()]; }
  const PostureChange& change_to(std::size_t node) const { return changes_.at(node); }

 private:
  void expand(std::size_t node, const Cost cost) {
    const std::size_t at = station(node), mode = node % modes_.size();
    if (stations_.is_free(at, mode)) paths_.enter(node + modes_.size(), node, cost);
    for (std::size_t leg = 0; leg < legs_; ++leg) expand_change(node, leg, cost);
  }

  void expand_change(std::size_t node, std::size_t leg, const Cost& cost) {
    const std::size_t at = station(node), mode = node % modes_.size();
    WorkingMode flipped = modes_[mode];
    flipped.set_sign(leg, -flipped.sign(leg));
    const auto other =
        static_cast<std::size_t>(std::find(modes_.begin(), modes_.end(), flipped) - modes_.begin());
    if (other == modes_.size() || stations_.sign(at, other) != stations_.sign(at, mode)) return;
    const std::size_t next = at * modes_.size() + other;
    if (!paths_.is_cheaper(next, {cost.first + 1, cost.second})) return;  // by the least that a change takes
    auto change = search_.find(stations_.at(at).pose, mode, leg, stations_.sign(at, mode));
    if (!change) return;
    change->time = stations_.at(at).time;
    if (paths_.enter(next, node, {cost.first + 1, cost.second + change->detour})) changes_[next] = *change;
  }

  const Stations& stations_;
  const MapControl& control_;
  std::vector<WorkingMode> modes_;
  std::size_t legs_;
  PostureChangeSearch search_;
  ShortestPaths<Cost> paths_;
  std::map<std::size_t, PostureChange> changes_;  // that lead to nodes
};

ChangingPath path_of(const LiftGraph& graph, const Stations& stations,
                     const std::vector<std::size_t>& nodes) {
  ChangingPath result;
  result.answer = TrajectoryAnswer::safe;
  const auto time = [&](std::size_t node) { return stations.at(graph.station(node)).time; };
  result.pieces.push_back({graph.mode(nodes.front()), time(nodes.front()), time(nodes.front())});
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    result.pieces.back().end = time(nodes[i]);
    if (graph.station(nodes[i]) != graph.station(nodes[i - 1])) continue;
    result.changes.push_back(graph.change_to(nodes[i]));
    result.pieces.push_back({graph.mode(nodes[i]), time(nodes[i]), time(nodes[i])});
  }
  result.reason = result.changes.empty()
                      ? "Proved: all of the path can be done in one working mode."
                      : "Proved: all of the path can be done with " + std::to_string(result.changes.size()) +
                            (result.changes.size() == 1 ? " change" : " changes") + " of posture.";
  return result;
}

}  // namespace

ChangingPath choose_posture_changes(const SegmentCertifier& certifier,
                                    const std::vector<PoseWaypoint>& waypoints, const MapControl& control) {
  const Stations stations(certifier, waypoints, control);
  if (stations.nowhere())
    return {TrajectoryAnswer::unsafe,
            "Proved: at " + number_text(*stations.nowhere(), 9) + " s the pose lies in no aspect.",
            {},
            {}};
  LiftGraph graph(*certifier.manipulator(), stations, control);
  const std::vector<std::size_t> nodes = graph.shortest();
  if (!nodes.empty()) return path_of(graph, stations, nodes);
  if (is_cancelled(control))
    return {TrajectoryAnswer::unknown, "The search for changes of posture was cancelled.", {}, {}};
  return {TrajectoryAnswer::unknown,
          "No changes of posture were found that let all of the path be done, which proves nothing.",
          {},
          {}};
}

}  // namespace parallel_aspects
