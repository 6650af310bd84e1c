// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/map_record.h"

#include "aspects/file/part_records.h"
#include "aspects/map/map_contents.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

void write_bounds(const Box& box, ByteWriter& writer) {
  writer.put_u8(static_cast<std::uint8_t>(box.dimension));
  for (std::size_t i = 0; i < box.dimension; ++i) {
    writer.put_double(box.lower[i]);
    writer.put_double(box.upper[i]);
  }
}

void write_aspect(const AspectMap::Contents& map, const Aspect& aspect, ByteWriter& writer) {
  writer.put_u8(static_cast<std::uint8_t>(*mode_index(map, aspect.mode)));
  writer.put_u8(aspect.determinant_sign > 0 ? 1 : 0);
  writer.put_double(aspect.measure);
  writer.put_double(aspect.measure_lower);
  writer.put_double(aspect.measure_upper);
  writer.put_u64(aspect.inside_leaves);
  write_pose(aspect.deepest, writer);
  writer.put_double(aspect.deepest_clearance);
  for (const Box& bounds : map.aspect_bounds[static_cast<std::size_t>(aspect.id - 1)])
    write_bounds(bounds, writer);
  writer.put_u32(static_cast<std::uint32_t>(aspect.unresolved_with.size()));
  for (const int id : aspect.unresolved_with) writer.put_u32(static_cast<std::uint32_t>(id));
}

void write_leaf_aspects(const AspectMap::Contents& map, ByteWriter& writer) {
  for (NodeIndex node = 0; node < map.tree.node_count(); ++node)
    for (std::size_t mode = 0; mode < map.modes.size(); ++mode)
      if (map.tree.state(node, mode).is_inside())
        writer.put_u32(static_cast<std::uint32_t>(map.leaf_aspect(node, mode)));
}

/// Reads in the order of `write_record`. Each step is false where what it reads cannot be.
class RecordReader {
 public:
  explicit RecordReader(ByteReader& reader) : reader_(reader) {}

  std::unique_ptr<const AspectMap::Contents> read(std::shared_ptr<const Manipulator> manipulator,
                                                  MapPlan plan) {
    std::optional<PoseTree> tree = read_tree(plan);
    if (!tree) return nullptr;
    AspectMap::Contents map(std::move(manipulator), std::move(plan.classifier), std::move(*tree), plan.modes);
    map.slice = plan.slice;
    map.resolution = plan.resolution;
    map.depth = plan.depth;
    map.deepest_level = plan.deepest_level;
    if (!read_totals(map) || !read_aspects(map) || !read_unresolved(map) || !read_leaf_aspects(map) ||
        !read_known_graph(map))
      return nullptr;
    add_existing_modes(map);
    return std::make_unique<const AspectMap::Contents>(std::move(map));
  }

 private:
  std::optional<PoseTree> read_tree(const MapPlan& plan) {
    const TreeRecord record = take_tree(reader_);
    if (!reader_.ok()) return std::nullopt;
    return PoseTree::from_record(plan.space, plan.modes.size(), record);
  }

  bool read_totals(AspectMap::Contents& map) {
    map.seconds = reader_.take_double();
    map.measure_undecided = reader_.take_double();
    map.proved_count = reader_.take_u32();
    map.indeterminate_leaves = reader_.take_u32();
    map.bound = reader_.take_u32();
    const std::uint8_t is_complete = reader_.take_u8();
    map.complete = is_complete == 1;
    aspect_count_ = reader_.take_count(1);
    return reader_.ok() && map.proved_count <= aspect_count_ && aspect_count_ <= map.bound &&
           std::isfinite(map.measure_undecided) && is_complete <= 1;
  }

  bool read_aspects(AspectMap::Contents& map) {
    for (std::size_t i = 0; i < aspect_count_; ++i) {
      Aspect aspect;
      aspect.id = static_cast<int>(i) + 1;
      if (!read_aspect(map, aspect)) return false;
      map.aspects.push_back(std::move(aspect));
    }
    return true;
  }

  bool read_aspect(AspectMap::Contents& map, Aspect& aspect) {
    const std::size_t mode = reader_.take_u8();
    const std::uint8_t is_positive = reader_.take_u8();
    if (mode >= map.modes.size() || is_positive > 1) return false;
    aspect.mode = map.modes[mode];
    aspect.determinant_sign = is_positive != 0 ? 1 : -1;
    aspect.measure = reader_.take_double();
    aspect.measure_lower = reader_.take_double();
    aspect.measure_upper = reader_.take_double();
    aspect.inside_leaves = reader_.take_u64();
    if (!read_pose(reader_, aspect.deepest)) return false;
    aspect.deepest_clearance = reader_.take_double();
    if (!read_bounds(map)) return false;
    aspect.bounds = map.tree.space().shown(map.aspect_bounds.back().front());
    aspect.unresolved_with.resize(reader_.take_count(index_size));
    for (int& id : aspect.unresolved_with)
      if (!read_id(id)) return false;
    return reader_.ok() && std::isfinite(aspect.measure + aspect.measure_lower + aspect.measure_upper);
  }

  /// Of one aspect, in every root.
  bool read_bounds(AspectMap::Contents& map) {
    map.aspect_bounds.emplace_back(map.tree.root_count());
    for (Box& box : map.aspect_bounds.back()) {
      box.dimension = reader_.take_u8();
      if (box.dimension != 0 && box.dimension != map.tree.dimension()) return false;
      for (std::size_t i = 0; i < box.dimension; ++i) {
        box.lower[i] = reader_.take_double();
        box.upper[i] = reader_.take_double();
        if (!(box.lower[i] <= box.upper[i])) return false;
      }
      if (box.dimension != 0 &&
          !(map.tree.region().contains(box.lower) && map.tree.region().contains(box.upper)))
        return false;
    }
    return true;
  }

  bool read_id(int& id) {
    const std::uint32_t value = reader_.take_u32();
    id = static_cast<int>(value);
    return 1 <= value && value <= aspect_count_;
  }

  bool read_unresolved(AspectMap::Contents& map) {
    map.unresolved.resize(reader_.take_count(2 * index_size));
    return std::all_of(map.unresolved.begin(), map.unresolved.end(), [this](auto& pair) {
      return read_id(pair.first) && read_id(pair.second) && pair.first < pair.second;
    });
  }

  /// Every inside leaf has an aspect of its mode and sign, and every aspect as many as it says.
  bool read_leaf_aspects(AspectMap::Contents& map) {
    map.leaf_aspects.resize(map.modes.size());
    std::vector<std::size_t> leaves(aspect_count_, 0);
    for (NodeIndex node = 0; node < map.tree.node_count(); ++node)
      for (std::size_t mode = 0; mode < map.modes.size(); ++mode) {
        const LeafState state = map.tree.state(node, mode);
        if (!state.is_inside()) continue;
        int id = 0;
        if (!read_id(id)) return false;
        map.leaf_aspects[mode].set(node, static_cast<std::uint32_t>(id));
        const Aspect& aspect = map.aspects[static_cast<std::size_t>(id - 1)];
        if (!state.is_inside(aspect.determinant_sign) || aspect.mode != map.modes[mode]) return false;
        ++leaves[static_cast<std::size_t>(id - 1)];
      }
    return std::equal(leaves.begin(), leaves.end(), map.aspects.begin(),
                      [](std::size_t count, const Aspect& aspect) { return count == aspect.inside_leaves; });
  }

  bool read_known_graph(const AspectMap::Contents& map) {
    const std::uint8_t is_known = reader_.take_u8();
    if (is_known == 1) map.graph = read_graph(map, reader_);
    return reader_.ok() && (is_known == 0 || map.graph != nullptr);
  }

  static void add_existing_modes(AspectMap::Contents& map) {
    for (const WorkingMode& mode : map.modes)
      if (std::any_of(map.aspects.begin(), map.aspects.end(),
                      [&mode](const Aspect& aspect) { return aspect.mode == mode; }))
        map.existing_modes.push_back(mode);
  }

  ByteReader& reader_;
  std::size_t aspect_count_ = 0;
};

}  // namespace

void write_record(const AspectMap::Contents& map, ByteWriter& writer) {
  put_tree(map.tree.record(), writer);
  writer.put_double(map.seconds);
  writer.put_double(map.measure_undecided);
  writer.put_u32(static_cast<std::uint32_t>(map.proved_count));
  writer.put_u32(static_cast<std::uint32_t>(map.indeterminate_leaves));
  writer.put_u32(static_cast<std::uint32_t>(map.bound));
  writer.put_u8(map.complete ? 1 : 0);
  writer.put_u32(static_cast<std::uint32_t>(map.aspects.size()));
  for (const Aspect& aspect : map.aspects) write_aspect(map, aspect, writer);
  writer.put_u32(static_cast<std::uint32_t>(map.unresolved.size()));
  for (const auto& [a, b] : map.unresolved) {
    writer.put_u32(static_cast<std::uint32_t>(a));
    writer.put_u32(static_cast<std::uint32_t>(b));
  }
  write_leaf_aspects(map, writer);
  const auto graph = std::atomic_load(&map.graph);
  writer.put_u8(graph ? 1 : 0);
  if (graph) write_graph(*graph, writer);
}

std::unique_ptr<const AspectMap::Contents> read_record(std::shared_ptr<const Manipulator> manipulator,
                                                       MapPlan plan, ByteReader& reader) {
  return RecordReader(reader).read(std::move(manipulator), std::move(plan));
}

}  // namespace parallel_aspects
