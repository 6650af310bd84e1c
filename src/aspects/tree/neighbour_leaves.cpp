// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/neighbour_leaves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace parallel_aspects {
namespace {

NodeIndex bit(std::size_t axis) { return NodeIndex{1} << axis; }

}  // namespace

FacingRanks facing_ranks(std::size_t dimension, std::size_t axis) {
  FacingRanks facing;
  for (NodeIndex rank = 0; rank < bit(dimension); ++rank)
    if ((rank & bit(axis)) == 0) facing.emplace_back(rank + bit(axis), rank);
  return facing;
}

FacingRanks facing_ranks(std::size_t dimension, const Gluing& gluing) {
  FacingRanks facing;
  for (NodeIndex rank = 0; rank < bit(dimension); ++rank) {
    if (((rank & bit(gluing.first.axis)) != 0) != gluing.first.upper) continue;
    NodeIndex other = gluing.second.upper ? bit(gluing.second.axis) : 0;
    for (std::size_t i = 0; i < dimension; ++i)
      if (i != gluing.first.axis && ((rank & bit(i)) != 0) != gluing.flipped[i])
        other |= bit(gluing.axis_of[i]);
    facing.emplace_back(rank, other);
  }
  return facing;
}

namespace {

NodePlace image(const PoseSpace& space, const Gluing& gluing, const NodePlace& place,
                bool from_first) noexcept {
  const RootFace& to = from_first ? gluing.second : gluing.first;
  const std::uint32_t last = (std::uint32_t{1} << place.level) - 1;
  NodePlace there{{}, place.level, to.root};
  for (std::size_t i = 0; i < space.dimension(); ++i) {
    const std::uint32_t cell = place.cell[from_first ? i : gluing.axis_of[i]];
    there.cell[from_first ? gluing.axis_of[i] : i] = gluing.flipped[i] ? last - cell : cell;
  }
  there.cell[to.axis] = to.upper ? last : 0;
  return there;
}

}  // namespace

std::optional<NodePlace> place_across(const PoseSpace& space, const NodePlace& place,
                                      const NodeFace& face) noexcept {
  const std::uint32_t last = (std::uint32_t{1} << place.level) - 1;
  if (place.cell[face.axis] != (face.upper ? last : 0)) {
    NodePlace there = place;
    there.cell[face.axis] += face.upper ? 1U : ~0U;
    return there;
  }
  const RootFace end{place.root, static_cast<std::uint8_t>(face.axis), face.upper};
  for (const Gluing& gluing : space.gluings())
    if (gluing.first == end || gluing.second == end) return image(space, gluing, place, gluing.first == end);
  return std::nullopt;
}

namespace {

constexpr std::uint32_t units = std::uint32_t{1} << PoseTree::deepest_level;  // across a root box

/// A closed range along one coordinate, in units of the deepest level.
struct Span {
  std::uint32_t begin, end;

  Span flipped() const noexcept { return {units - end, units - begin}; }
};

/// A closed box of a root, flat where it is a face.
struct Patch {
  RootIndex root;
  std::array<Span, max_map_dimension> spans{};
};

Patch patch(const NodePlace& place) noexcept {
  const std::uint32_t shift = PoseTree::deepest_level - place.level;
  Patch result{place.root, {}};
  for (std::size_t i = 0; i < max_map_dimension; ++i)
    result.spans[i] = {place.cell[i] << shift, (place.cell[i] + 1) << shift};
  return result;
}

bool lies_on(const Patch& patch, const RootFace& face) noexcept {
  const Span& along = patch.spans[face.axis];
  return patch.root == face.root && (face.upper ? along.end == units : along.begin == 0);
}

Span end_of(bool upper) noexcept { return upper ? Span{units, units} : Span{0, 0}; }

/// A face that lies on one side of a gluing, seen from the other.
Patch image(const Gluing& gluing, const Patch& here, bool from_first, std::size_t dimension) noexcept {
  const RootFace& to = from_first ? gluing.second : gluing.first;
  Patch there{to.root, {}};
  for (std::size_t i = 0; i < dimension; ++i) {
    const std::size_t from = from_first ? i : gluing.axis_of[i];
    const Span& span = here.spans[from];
    there.spans[from_first ? gluing.axis_of[i] : i] = gluing.flipped[i] ? span.flipped() : span;
  }
  there.spans[to.axis] = end_of(to.upper);
  return there;
}

/// The node itself, and its faces as seen from across glued faces.
template <class Visitor>
void for_each_image(const PoseTree& tree, NodeIndex node, const Visitor& visit) {
  const Patch own = patch(tree.place(node));
  visit(own);
  for (const Gluing& gluing : tree.space().gluings()) {
    if (lies_on(own, gluing.first)) visit(image(gluing, own, true, tree.dimension()));
    if (lies_on(own, gluing.second)) visit(image(gluing, own, false, tree.dimension()));
  }
}

/// What two patches have in common; nothing where that is less than part of a face.
std::optional<Patch> common(const Patch& a, const Patch& b, std::size_t dimension) noexcept {
  if (a.root != b.root) return std::nullopt;
  Patch result{a.root, {}};
  std::size_t flat = 0;
  for (std::size_t i = 0; i < dimension; ++i) {
    result.spans[i] = {std::max(a.spans[i].begin, b.spans[i].begin),
                       std::min(a.spans[i].end, b.spans[i].end)};
    if (result.spans[i].begin > result.spans[i].end) return std::nullopt;
    flat += result.spans[i].begin == result.spans[i].end;
  }
  return flat <= 1 ? std::optional<Patch>(result) : std::nullopt;
}

/// Whether they have a part of a face in common.
bool touch(const Patch& a, const Patch& b, std::size_t dimension) noexcept {
  bool meet = a.root == b.root;
  int flat = 0;
  for (std::size_t i = 0; i < dimension; ++i) {
    const std::uint32_t begin = std::max(a.spans[i].begin, b.spans[i].begin),
                        end = std::min(a.spans[i].end, b.spans[i].end);
    meet = meet && begin <= end;
    flat += begin == end ? 1 : 0;
  }
  return meet && flat <= 1;
}

/// Bit i for the child of rank i.
using RankSet = std::uint32_t;

// By coordinate, the children at its lower end; by dimension, all children.
constexpr std::array<RankSet, max_map_dimension> lower_ranks{0x55, 0x33, 0x0f};
constexpr std::array<RankSet, max_map_dimension + 1> all_ranks{0x01, 0x03, 0x0f, 0xff};

class NeighbourSearch {
 public:
  NeighbourSearch(const PoseTree& tree, std::size_t mode, NodeIndex node)
      : tree_(tree), mode_(mode), node_(node) {}

  std::vector<NodeIndex> run() {
    found_.reserve(16);
    for_each_image(tree_, node_, [this](const Patch& image) {
      if (common(image, patch(tree_.place(image.root)), tree_.dimension()))
        descend(image, image.root, units, {});
    });
    return std::move(found_);
  }

 private:
  /// What a half of a node along one coordinate has in common with the image.
  struct Half {
    bool meets, is_flat;
  };

  static Half half(const Span& image, std::uint32_t begin, std::uint32_t end) noexcept {
    const std::uint32_t from = std::max(image.begin, begin), to = std::min(image.end, end);
    return {from <= to, from == to};
  }

  using Corner = std::array<std::uint32_t, max_map_dimension>;

  /// `other` shares part of a face with the image; its edges are so long, and its lower corner is there.
  void descend(const Patch& image, NodeIndex other, std::uint32_t edge, const Corner& corner) {
    const LeafState state = tree_.state(other, mode_);
    if (other == node_ || state.is_outside()) return;
    if (!state.is_divided()) return found_.push_back(other);
    const NodeIndex first = tree_.first_child(other);
    for (RankSet ranks = touching(image, edge / 2, corner); ranks != 0; ranks &= ranks - 1) {
      const auto rank = static_cast<NodeIndex>(__builtin_ctz(ranks));
      Corner at = corner;
      for (std::size_t i = 0; i < tree_.dimension(); ++i) at[i] += (rank >> i & 1U) * (edge / 2);
      descend(image, first + rank, edge / 2, at);
    }
  }

  /// Which children share part of a face with the image; their edges are so long.
  RankSet touching(const Patch& image, std::uint32_t edge, const Corner& corner) const {
    RankSet meet = all_ranks[tree_.dimension()], flat = 0, flat_twice = 0;
    for (std::size_t i = 0; i < tree_.dimension(); ++i) {
      const Half lower = half(image.spans[i], corner[i], corner[i] + edge),
                 upper = half(image.spans[i], corner[i] + edge, corner[i] + 2 * edge);
      const RankSet of_lower = lower_ranks[i], of_upper = ~of_lower;
      meet &= (lower.meets ? of_lower : 0) | (upper.meets ? of_upper : 0);
      const RankSet flat_here = (lower.is_flat ? of_lower : 0) | (upper.is_flat ? of_upper : 0);
      flat_twice |= flat & flat_here;
      flat |= flat_here;
    }
    return meet & ~flat_twice;
  }

  const PoseTree& tree_;
  std::size_t mode_;
  NodeIndex node_;
  std::vector<NodeIndex> found_;
};

Box box_of(const PoseTree& tree, const Patch& patch) {
  const Box& region = tree.region();
  Box box{region.dimension, {}, {}};
  for (std::size_t i = 0; i < region.dimension; ++i) {
    const double unit = std::ldexp(region.width(i), -static_cast<int>(PoseTree::deepest_level));
    box.lower[i] = region.lower[i] + unit * patch.spans[i].begin;
    box.upper[i] = region.lower[i] + unit * patch.spans[i].end;
  }
  return box;
}

}  // namespace

std::vector<NodeIndex> neighbour_leaves(const PoseTree& tree, std::size_t mode, NodeIndex node) {
  return NeighbourSearch(tree, mode, node).run();
}

std::vector<SharedFace> shared_faces(const PoseTree& tree, NodeIndex a, NodeIndex b) {
  std::vector<SharedFace> result;
  const Patch other = patch(tree.place(b));
  for_each_image(tree, a, [&](const Patch& image) {
    if (const auto face = common(image, other, tree.dimension()))
      result.push_back({face->root, box_of(tree, *face)});
  });
  return result;
}

NodePairs faces_between(const PoseTree& tree, const std::vector<NodeIndex>& ones,
                        const std::vector<NodeIndex>& others) {
  NodePairs pairs;
  std::vector<Patch> images, patches;
  for (const NodeIndex other : others) patches.push_back(patch(tree.place(other)));
  for (const NodeIndex one : ones) {
    images.clear();
    for_each_image(tree, one, [&images](const Patch& image) { images.push_back(image); });
    for (std::size_t i = 0; i < others.size(); ++i)
      if (std::any_of(images.begin(), images.end(),
                      [&](const Patch& image) { return touch(image, patches[i], tree.dimension()); }))
        pairs.emplace_back(one, others[i]);
  }
  return pairs;
}

}  // namespace parallel_aspects
