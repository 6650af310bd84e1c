// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/connectivity.h"

#include "aspects/map/gate_crossings.h"
#include "aspects/map/gate_leaves.h"
#include "aspects/map/map_contents.h"
#include "interval/interval.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

// Of one gate: leaves whose facts are examined, those in which a crossing is tried while none is proved, and
// crossings that are wanted.
constexpr std::size_t max_looks = 600, max_attempts = 100, wanted = 6;

// Leaves whose index is compared, and how many of the best are tried.
constexpr std::size_t max_compared = 300, max_better = 4;

using Key = std::tuple<int, int, Crossing, std::size_t>;

struct Finding {
  Pose first_seen;
  std::vector<GateCrossing> crossings;
};

/// Indices below n, each once: any few in a row are spread over all of them.
std::vector<std::size_t> spread(std::size_t n, std::size_t most) {
  auto step = static_cast<std::size_t>(0.618 * static_cast<double>(n)) + 1;
  while (std::gcd(step, n) != 1) ++step;
  std::vector<std::size_t> order(std::min(n, most));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i * step % n;
  return order;
}

double index_of(const AspectMap::Contents& map, const GateClass& gates, const Pose& pose) {
  return crossing_index(*map.manipulator, pose, map.modes[gates.mode], gates.crossing, gates.leg);
}

using Findings = std::map<Key, Finding>;

void add(const AspectMap::Contents& map, const GateClass& gates, const LeafCrossing& crossing,
         Findings& found) {
  const auto [first, second] = std::minmax(crossing.from, crossing.to);
  const auto [item, is_new] = found.try_emplace({first, second, gates.crossing, gates.leg});
  const Pose middle = middle_of(map.tree.space(), crossing.path);
  if (is_new) item->second.first_seen = middle;
  if (!crossing.proved) return;
  std::vector<Pose> segment = poses_of(map.tree.space(), crossing.path);
  const double index = index_of(map, gates, segment.front());
  item->second.crossings.push_back({std::move(segment), middle, index});
}

/// Crossings in the leaves of one gate.
class GateSearch {
 public:
  GateSearch(const MarkedMap& marked, const GateLeaves& gate, const MapControl& control)
      : marked_(marked), map_(marked.map), gate_(gate), control_(control) {
    if (gate.crossing == Crossing::serial) other_mode_ = *other_mode(map_, gate.gate_class());
  }

  std::vector<LeafCrossing> run() {
    const RoundingUpward rounding;
    std::size_t attempts = 0;
    for (const std::size_t i : spread(gate_.leaves.size(), max_looks)) {
      if (is_cancelled(control_) || proved_ == wanted || (proved_ == 0 && attempts == max_attempts)) break;
      attempts += look_at(gate_.leaves[i]);
    }
    if (proved_ > 0)
      for (const NodeIndex leaf : better_leaves()) look_at(leaf);
    return std::move(found_);
  }

 private:
  /// Whether a crossing was tried there.
  bool look_at(NodeIndex leaf) {
    const BoxFacts facts =
        map_.classifier->facts(map_.tree.place(leaf).root, map_.tree.box(leaf), gate_.mode);
    const bool serial = gate_.crossing == Crossing::serial;
    if (serial ? facts.all_clear_but(0) || !facts.all_clear_but(BoxFacts::bit(gate_.leg))
               : !facts.all_clear_but(0))
      return false;
    const auto crossing =
        serial ? find_serial_crossing(marked_, leaf, gate_.mode, other_mode_, gate_.leg, gate_.sign)
               : find_parallel_crossing(marked_, leaf, gate_.mode);
    if (crossing) found_.push_back(*crossing);
    proved_ += crossing && crossing->proved;
    return true;
  }

  double index_at(const Pose& pose) const { return index_of(map_, gate_.gate_class(), pose); }

  double best_index() const {
    double best = 0.0;
    for (const LeafCrossing& crossing : found_) {
      const CrossingSegment& start = crossing.path.segments.front();
      if (crossing.proved) best = std::max(best, index_at(map_.tree.space().pose({start.root, start.from})));
    }
    return best;
  }

  /// Leaves at whose middle the index is larger than that of every crossing, the largest first.
  std::vector<NodeIndex> better_leaves() const {
    std::vector<std::pair<double, NodeIndex>> order;
    const double best = best_index();
    for (const std::size_t i : spread(gate_.leaves.size(), max_compared)) {
      const NodeIndex leaf = gate_.leaves[i];
      const Pose middle = map_.tree.space().pose({map_.tree.place(leaf).root, map_.tree.box(leaf).middle()});
      if (const double index = index_at(middle); index > best) order.emplace_back(-index, leaf);
    }
    std::sort(order.begin(), order.end());
    std::vector<NodeIndex> result;
    for (std::size_t i = 0; i < std::min(order.size(), max_better); ++i) result.push_back(order[i].second);
    return result;
  }

  const MarkedMap& marked_;
  const AspectMap::Contents& map_;
  const GateLeaves& gate_;
  const MapControl& control_;
  std::size_t other_mode_ = 0;
  std::vector<LeafCrossing> found_;
  std::size_t proved_ = 0;
};

/// In the leaves of one gate, and in those of its images.
Findings find_crossings(const MarkedMap& map, const GateClasses& classes, const GateLeaves& gate,
                        const MapControl& control) {
  Findings found;
  const GateClass gates = gate.gate_class();
  const std::vector<LeafCrossing> crossings = GateSearch(map, gate, control).run();
  for (const LeafCrossing& crossing : crossings) add(map.map, gates, crossing, found);
  const RoundingUpward rounding;
  for (const GateClasses::Image& image : classes.images()) {
    if (!(image.of == gates)) continue;
    for (const LeafCrossing& crossing : crossings) {
      if (is_cancelled(control)) return found;
      if (const auto other = image_of(map, crossing, gate.sign, image)) add(map.map, image.to, *other, found);
    }
  }
  return found;
}

/// What is found for all gates, in their order: of two with one name the crossings of both.
Findings merged(std::vector<Findings> found) {
  Findings result;
  for (auto& of_gate : found)
    for (auto& [key, finding] : of_gate) {
      const auto [item, is_new] = result.try_emplace(key, finding);
      std::vector<GateCrossing>& all = item->second.crossings;
      if (!is_new) all.insert(all.end(), finding.crossings.begin(), finding.crossings.end());
    }
  return result;
}

Neighbours neighbours(const Key& key, Finding& finding) {
  const auto [first, second, crossing, leg] = key;
  std::vector<GateCrossing>& all = finding.crossings;
  std::stable_sort(all.begin(), all.end(),
                   [](const GateCrossing& a, const GateCrossing& b) { return a.index > b.index; });
  if (all.size() > wanted) all.resize(wanted);
  const Pose pose = all.empty() ? finding.first_seen : all.front().pose;
  return {first, second, crossing, leg, !all.empty(), pose, std::move(all)};
}

}  // namespace

std::vector<Neighbours> find_neighbours(const AspectMap& map, const MapControl& control) {
  const AspectMap::Contents& contents = map.contents();
  const GateClasses classes(contents);
  const std::vector<GateLeaves> gates =
      find_gate_leaves(contents, classes, NearestAspects(contents, classes, control), control);
  const MarkedMap marked(contents);
  std::vector<Findings> found(gates.size());
  tbb::parallel_for(std::size_t{0}, gates.size(),
                    [&](std::size_t i) { found[i] = find_crossings(marked, classes, gates[i], control); });
  std::vector<Neighbours> result;
  if (is_cancelled(control)) return result;
  for (auto& [key, finding] : merged(std::move(found))) result.push_back(neighbours(key, finding));
  std::sort(result.begin(), result.end(), [](const Neighbours& a, const Neighbours& b) {
    return std::tie(a.first, a.second, a.leg) < std::tie(b.first, b.second, b.leg);
  });
  return result;
}

const char* name(Crossing crossing) noexcept { return crossing == Crossing::serial ? "serial" : "parallel"; }

}  // namespace parallel_aspects
