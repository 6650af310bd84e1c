// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/shard_record.h"

#include "aspects/components/component_policy.h"
#include "aspects/components/components.h"
#include "aspects/file/bytes.h"
#include "parallel_aspects/model/problems.h"

#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

/// Gives labels to the leaves of one mode and sign.
class Labels {
 public:
  Labels(const PoseTree& tree, std::size_t mode, int sign, SignGraph& graph)
      : tree_(tree), mode_(mode), sign_(sign), graph_(graph), label_(tree.node_count(), none) {}

  SignRecord record(const NodePlace& shard) {
    label_components();
    const SignGraph::Meeting meeting = graph_.meeting();
    label_undecided(meeting);
    label_loose();
    for (const SignGraph::Contact& contact : meeting.contacts) add(contact);
    add_border(shard);
    return std::move(record_);
  }

 private:
  static constexpr std::uint32_t none = SignGraph::none;

  void label_components() {
    std::vector<std::uint32_t> label_of(graph_.component_bound(), none);
    for (NodeIndex node = 0; node < tree_.node_count(); ++node) {
      if (!tree_.state(node, mode_).is_inside(sign_)) continue;
      std::uint32_t& label = label_of[graph_.component(node)];
      if (label == none) {
        label = static_cast<std::uint32_t>(record_.components.size());
        record_.components.emplace_back();
      }
      label_[node] = label;
      record_.components[label].add(tree_.place(node).level, tree_.space().measure(tree_.box(node)));
    }
  }

  void label_undecided(const SignGraph::Meeting& meeting) {
    for (std::size_t v = 0; v < meeting.nearest.size(); ++v)
      if (meeting.nearest[v] != no_node)
        label_[graph_.indeterminate_leaves().node(v)] = label_[meeting.nearest[v]];
  }

  // What spreads from a component spreads to all neighbours, so that a loose group has no labelled ones.
  void label_loose() {
    const IndeterminateLeaves& undecided = graph_.indeterminate_leaves();
    for (std::size_t v = 0; v < undecided.size(); ++v) {
      const NodeIndex start = undecided.node(v);
      if (label_[start] != none) continue;
      const std::uint32_t label = record_.label_count();
      ++record_.loose_count;
      std::vector<NodeIndex> open{start};
      label_[start] = label;
      while (!open.empty()) {
        const NodeIndex node = open.back();
        open.pop_back();
        graph_.visit_paths_on(tree_, graph_.slot(node), [&](LeafSlot slot) {
          const NodeIndex neighbour = graph_.node(slot);
          if (label_[neighbour] != none) return;
          label_[neighbour] = label;
          open.push_back(neighbour);
        });
      }
    }
  }

  void add(const SignGraph::Contact& contact) {
    record_.contacts.push_back(
        {contact.node, contact.other_node, label_[contact.leaf], label_[contact.other_leaf]});
  }

  void add_border(const NodePlace& shard) {
    for (NodeIndex node = 0; node < tree_.node_count(); ++node)
      if (label_[node] != none && is_on_border(shard, tree_.place(node)))
        record_.border.push_back(
            {tree_.place(node), node, label_[node], tree_.state(node, mode_).is_inside(sign_)});
  }

  bool is_on_border(const NodePlace& shard, const NodePlace& place) const noexcept {
    const std::uint32_t shift = place.level - shard.level, last = (std::uint32_t{1} << shift) - 1;
    for (std::size_t i = 0; i < tree_.dimension(); ++i) {
      const std::uint32_t within = place.cell[i] & last;
      if (within == 0 || within == last) return true;
    }
    return false;
  }

  const PoseTree& tree_;
  std::size_t mode_;
  int sign_;
  SignGraph& graph_;
  std::vector<std::uint32_t> label_;  // of a node
  SignRecord record_;
};

void write(const SignRecord& record, ByteWriter& writer) {
  write(record.undecided, writer);
  writer.put_u32(static_cast<std::uint32_t>(record.components.size()));
  for (const LeafTotal& component : record.components) write(component, writer);
  writer.put_u32(record.loose_count);
  writer.put_u32(static_cast<std::uint32_t>(record.contacts.size()));
  for (const SignRecord::Contact& contact : record.contacts)
    for (const std::uint32_t value : {contact.leaf, contact.other_leaf, contact.label, contact.other_label})
      writer.put_u32(value);
  writer.put_u32(static_cast<std::uint32_t>(record.border.size()));
  for (const SignRecord::BorderLeaf& leaf : record.border) {
    for (const std::uint32_t cell : leaf.place.cell) writer.put_u32(cell);
    writer.put_u8(static_cast<std::uint8_t>(leaf.place.level));
    writer.put_u8(static_cast<std::uint8_t>(leaf.place.root));
    writer.put_u32(leaf.leaf);
    writer.put_u32(leaf.label);
    writer.put_u8(leaf.is_inside ? 1 : 0);
  }
}

SignRecord::BorderLeaf read_border_leaf(ByteReader& reader) {
  SignRecord::BorderLeaf leaf;
  for (std::uint32_t& cell : leaf.place.cell) cell = reader.take_u32();
  leaf.place.level = reader.take_u8();
  leaf.place.root = reader.take_u8();
  leaf.leaf = reader.take_u32();
  leaf.label = reader.take_u32();
  leaf.is_inside = reader.take_u8() != 0;
  return leaf;
}

SignRecord read_sign(ByteReader& reader) {
  constexpr std::size_t least_total = 9, contact_size = 16, border_size = 23;
  SignRecord record;
  record.undecided = read_total(reader);
  record.components.resize(reader.take_count(least_total));
  for (LeafTotal& component : record.components) component = read_total(reader);
  record.loose_count = reader.take_u32();
  record.contacts.resize(reader.take_count(contact_size));
  for (SignRecord::Contact& contact : record.contacts)
    for (std::uint32_t* value : {&contact.leaf, &contact.other_leaf, &contact.label, &contact.other_label})
      *value = reader.take_u32();
  record.border.resize(reader.take_count(border_size));
  for (SignRecord::BorderLeaf& leaf : record.border) leaf = read_border_leaf(reader);
  return record;
}

LeafTotal undecided_of(const PoseTree& tree, std::size_t mode) {
  LeafTotal total;
  for (NodeIndex node = 0; node < tree.node_count(); ++node)
    if (tree.state(node, mode).is_undecided())
      total.add(tree.place(node).level, tree.space().measure(tree.box(node)));
  return total;
}

// Most of a record are places of neighbours, so that it is packed well.
Bytes bytes_of(const SignRecord& record) {
  ByteWriter writer;
  write(record, writer);
  return packed(writer.bytes());
}

}  // namespace

void write(const LeafTotal& total, ByteWriter& writer) {
  std::uint8_t last = 0;
  for (std::size_t level = 0; level < total.of_level.size(); ++level)
    if (total.of_level[level] > 0) last = static_cast<std::uint8_t>(level + 1);
  writer.put_u8(last);
  for (std::size_t level = 0; level < last; ++level) writer.put_u64(total.of_level[level]);
  writer.put_double(total.measure);
}

LeafTotal read_total(ByteReader& reader) {
  LeafTotal total;
  const std::size_t count = reader.take_u8();
  for (std::size_t level = 0; level < count && level < total.of_level.size(); ++level)
    total.of_level[level] = reader.take_u64();
  total.measure = reader.take_double();
  return total;
}

std::optional<std::vector<Bytes>> records_of(const PoseTree& tree, const NodePlace& shard,
                                             const std::vector<bool>& modes, const MapControl& control) {
  std::vector<Bytes> records(2 * tree.mode_count());
  for (std::size_t mode = 0; mode < tree.mode_count(); ++mode) {
    if (!modes[mode]) continue;
    LeafGraph graph(tree, mode, false, control, ComponentPolicy());
    for (const int sign : {1, -1}) {
      SignRecord record = Labels(tree, mode, sign, graph.of(sign)).record(shard);
      record.undecided = undecided_of(tree, mode);
      records[part_of(mode, sign)] = bytes_of(record);
    }
    if (is_cancelled(control)) return std::nullopt;
  }
  return records;
}

SignRecord sign_record(const Bytes& bytes) {
  Bytes unpacked;
  std::string problem = unpack(bytes, unpacked);
  ByteReader reader(unpacked.data(), unpacked.size());
  SignRecord record = read_sign(reader);
  if (problem.empty() && (!reader.ok() || reader.left() != 0)) problem = "it contradicts itself";
  if (!problem.empty())
    throw InvalidDescription({"The record of a shard is of no use, since " + problem + "."});
  return record;
}

}  // namespace parallel_aspects
