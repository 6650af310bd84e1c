// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SINGULAR_IMAGES_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SINGULAR_IMAGES_H

#include "aspects/cusps/strut_slice.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// Enclosed numbers, as (g_0, g_1, g_2): half the squares of the lengths. In one slice g_2 counts as 0.
using ValueBox = std::array<Interval, 3>;

/// Encloses the image of a box of poses in the space of (g_0, g_1, g_2): by its extents along the axes and
/// along the directions of a frame. About a singular box the first of these is across the image of the
/// singular curve or surface, so that this extent is of second order in the size of the box.
struct ImageStrip {
  std::array<std::array<double, 3>, 3> frame{};
  ValueBox range;
  std::array<Interval, 3> extents;  ///< of frame[k] . (g_0, g_1, g_2)

  /// Across the image.
  const std::array<double, 3>& normal() const noexcept { return frame[0]; }

  /// Of direction . (g_0, g_1, g_2).
  Interval along(const std::array<double, 3>& direction) const noexcept;

  /// Whether it may have a point in common with a box of values.
  bool may_meet(const ValueBox& values) const noexcept;
};

/// Boxes of a slice or of a family that cover its singular poses, D = 0, each divided where that is asked
/// for. Needs a live `RoundingUpward`.
class SingularImages {
 public:
  using Node = std::uint32_t;
  static constexpr Node root = 0;

  explicit SingularImages(const StrutSlice& slice);

  const ImageStrip& strip(Node node) const noexcept { return nodes_[node].strip; }
  const Box& box(Node node) const noexcept { return nodes_[node].box; }

  /// Whether it is as small as boxes get.
  bool is_smallest(Node node) const noexcept;

  /// Forgets all boxes, which take much memory; after that there is nothing to ask.
  void clear() noexcept { std::vector<Entry>().swap(nodes_); }

  /// Its parts that may hold singular poses.
  const std::vector<Node>& parts(Node node);

 private:
  struct Entry {
    Box box;
    ImageStrip strip;
    bool divided = false;
    std::vector<Node> parts;
  };

  void add(const Box& box, std::vector<Node>& parts);
  void add_halves(const Box& box, std::size_t times, std::vector<Node>& parts);
  std::array<Box, 2> halves_of(const Box& box) const;

  const StrutSlice& slice_;
  std::vector<Entry> nodes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SINGULAR_IMAGES_H
