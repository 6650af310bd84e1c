// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/part_records.h"

#include "aspects/tree/pose_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {

TreeRecord PoseTree::record() const {
  TreeRecord record;
  record.parents.resize((node_count() - root_count()) >> dimension());
  for (NodeIndex node = 0; node < node_count(); ++node)
    if (first_child(node) != no_node) record.parents[family(first_child(node))] = node;
  for (NodeIndex node = 0; node < node_count(); ++node)
    for (std::size_t mode = 0; mode < modes_; ++mode)
      if (!inherits(record.parents, node, mode)) record.states.push_back(state(node, mode).code());
  return record;
}

std::optional<PoseTree> PoseTree::from_record(std::shared_ptr<const PoseSpace> space, std::size_t modes,
                                              const TreeRecord& record) {
  PoseTree tree(std::move(space), modes);
  if (!tree.append_all_children(record.parents) || !tree.set_states(record)) return std::nullopt;
  return tree;
}

bool PoseTree::append_all_children(const std::vector<NodeIndex>& parents) {
  if (parents.size() > (no_node - root_count()) >> dimension()) return false;
  const std::size_t nodes = root_count() + (parents.size() << dimension());
  parents_.reserve(parents.size());
  first_child_.reserve(nodes);
  states_.reserve(nodes * modes_);
  for (const NodeIndex parent : parents) {
    if (parent >= node_count() || first_child(parent) != no_node) return false;
    if (place(parent).level >= deepest_level) return false;
    append_children(parent);
  }
  return true;
}

// Children come after their parents.
bool PoseTree::set_states(const TreeRecord& record) {
  auto next = record.states.begin();
  for (NodeIndex node = 0; node < node_count(); ++node)
    for (std::size_t mode = 0; mode < modes_; ++mode) {
      if (inherits(record.parents, node, mode)) continue;
      if (next == record.states.end()) return false;
      const std::optional<LeafState> known = LeafState::from_code(*next++);
      if (!known || (known->is_divided() && first_child(node) == no_node)) return false;
      state(node, mode) = *known;
    }
  return next == record.states.end();
}

namespace {

constexpr std::size_t least_segment = 2, most_segment = 3;

void write_crossing(const GateCrossing& crossing, ByteWriter& writer) {
  writer.put_u8(static_cast<std::uint8_t>(crossing.segment.size()));
  for (const Pose& pose : crossing.segment) write_pose(pose, writer);
  write_pose(crossing.pose, writer);
  writer.put_double(crossing.index);
}

void write_gate(const Neighbours& gate, ByteWriter& writer) {
  writer.put_u32(static_cast<std::uint32_t>(gate.first));
  writer.put_u32(static_cast<std::uint32_t>(gate.second));
  writer.put_u8(gate.crossing == Crossing::serial ? 1 : 0);
  writer.put_u8(static_cast<std::uint8_t>(gate.leg));
  write_pose(gate.pose, writer);
  writer.put_u32(static_cast<std::uint32_t>(gate.crossings.size()));
  for (const GateCrossing& crossing : gate.crossings) write_crossing(crossing, writer);
}

/// Reads in the order of `write_graph`. Each step is false where what it reads cannot be.
class GraphReader {
 public:
  GraphReader(const AspectMap::Contents& map, ByteReader& reader) : map_(map), reader_(reader) {}

  std::shared_ptr<const AspectGraph> read() {
    AspectGraph graph;
    graph.gates.resize(reader_.take_count(index_size));
    for (Neighbours& gate : graph.gates)
      if (!read_gate(gate)) return nullptr;
    graph.sets.resize(reader_.take_count(index_size));
    for (AspectSet& set : graph.sets)
      if (!read_set(set)) return nullptr;
    if (!reader_.ok() || !are_all_aspects(graph.sets) || !read_groups(graph)) return nullptr;
    return std::make_shared<const AspectGraph>(std::move(graph));
  }

 private:
  const Aspect& aspect(int id) const { return map_.aspects[static_cast<std::size_t>(id - 1)]; }

  bool read_id(int& id) {
    const std::uint32_t value = reader_.take_u32();
    id = static_cast<int>(value);
    return 1 <= value && value <= map_.aspects.size();
  }

  bool read_gate(Neighbours& gate) {
    if (!read_id(gate.first) || !read_id(gate.second) || gate.first >= gate.second) return false;
    const std::uint8_t is_serial = reader_.take_u8();
    gate.crossing = is_serial != 0 ? Crossing::serial : Crossing::parallel;
    gate.leg = reader_.take_u8();
    if (is_serial > 1 || !joins(gate) || !read_pose(reader_, gate.pose)) return false;
    gate.crossings.resize(reader_.take_count(pose_size));
    gate.proved = !gate.crossings.empty();
    return std::all_of(gate.crossings.begin(), gate.crossings.end(),
                       [this](GateCrossing& crossing) { return read_crossing(crossing); });
  }

  /// Whether the working modes and signs of det A are those of such a gate.
  bool joins(const Neighbours& gate) const {
    const Aspect &one = aspect(gate.first), &other = aspect(gate.second);
    const bool same_sign = one.determinant_sign == other.determinant_sign;
    if (gate.crossing == Crossing::parallel) return gate.leg == 0 && one.mode == other.mode && !same_sign;
    if (gate.leg >= one.mode.leg_count()) return false;
    WorkingMode flipped = one.mode;
    flipped.set_sign(gate.leg, -flipped.sign(gate.leg));
    return same_sign && flipped == other.mode;
  }

  bool read_crossing(GateCrossing& crossing) {
    crossing.segment.resize(reader_.take_u8());
    if (crossing.segment.size() < least_segment || crossing.segment.size() > most_segment) return false;
    for (Pose& pose : crossing.segment)
      if (!read_pose(reader_, pose)) return false;
    if (!read_pose(reader_, crossing.pose)) return false;
    crossing.index = reader_.take_double();
    return reader_.ok() && std::isfinite(crossing.index);
  }

  bool read_set(AspectSet& set) {
    set.workspace_lower = reader_.take_double();
    set.aspects.resize(reader_.take_count(index_size));
    for (int& id : set.aspects)
      if (!read_id(id)) return false;
    if (set.aspects.empty() || !std::isfinite(set.workspace_lower)) return false;
    set.determinant_sign = aspect(set.aspects.front()).determinant_sign;
    return std::all_of(set.aspects.begin(), set.aspects.end(),
                       [&](int id) { return aspect(id).determinant_sign == set.determinant_sign; });
  }

  /// Each in one set, the sets by their lowest ids.
  bool are_all_aspects(const std::vector<AspectSet>& sets) const {
    std::vector<int> ids;
    int lowest = 0;
    for (const AspectSet& set : sets) {
      if (!std::is_sorted(set.aspects.begin(), set.aspects.end()) || set.aspects.front() <= lowest)
        return false;
      lowest = set.aspects.front();
      ids.insert(ids.end(), set.aspects.begin(), set.aspects.end());
    }
    std::sort(ids.begin(), ids.end());
    return ids.size() == map_.aspects.size() && std::adjacent_find(ids.begin(), ids.end()) == ids.end();
  }

  bool read_groups(AspectGraph& graph) {
    for (std::size_t i = 0; i < graph.sets.size(); ++i) {
      const std::size_t group = reader_.take_u32();
      if (group > i || (group < i && graph.set_group[group] != group) ||
          graph.sets[group].determinant_sign != graph.sets[i].determinant_sign)
        return false;
      graph.set_group.push_back(group);
      graph.proved_set_count += group == i;
    }
    return reader_.ok();
  }

  const AspectMap::Contents& map_;
  ByteReader& reader_;
};

}  // namespace

void write_graph(const AspectGraph& graph, ByteWriter& writer) {
  writer.put_u32(static_cast<std::uint32_t>(graph.gates.size()));
  for (const Neighbours& gate : graph.gates) write_gate(gate, writer);
  writer.put_u32(static_cast<std::uint32_t>(graph.sets.size()));
  for (const AspectSet& set : graph.sets) {
    writer.put_double(set.workspace_lower);
    writer.put_u32(static_cast<std::uint32_t>(set.aspects.size()));
    for (const int id : set.aspects) writer.put_u32(static_cast<std::uint32_t>(id));
  }
  for (const std::size_t group : graph.set_group) writer.put_u32(static_cast<std::uint32_t>(group));
}

std::shared_ptr<const AspectGraph> read_graph(const AspectMap::Contents& map, ByteReader& reader) {
  return GraphReader(map, reader).read();
}

}  // namespace parallel_aspects
