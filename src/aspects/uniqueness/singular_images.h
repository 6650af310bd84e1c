// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SINGULAR_IMAGES_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SINGULAR_IMAGES_H

#include "aspects/uniqueness/strut_slice.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// Two enclosed numbers, as (g_0, g_1).
using ValueBox = std::array<Interval, 2>;

/// Encloses the image of a box of the slice in the plane of (g_0, g_1): by its extent along both axes, along
/// a normal, and across that. About a singular box the normal is across the image of the singular curve, so
/// that this extent is of second order in the size of the box.
struct ImageStrip {
  std::array<double, 2> normal{};
  ValueBox range;
  Interval along_normal;   ///< of normal . (g_0, g_1)
  Interval along_tangent;  ///< the same of the normal turned by a right angle

  /// Of direction . (g_0, g_1).
  Interval along(const std::array<double, 2>& direction) const noexcept;

  /// Whether it may have a point in common with a box of values.
  bool may_meet(const ValueBox& values) const noexcept;
};

/// Boxes of the slice that cover its singular curve D = 0, each divided where that is asked for. Needs a live
/// `RoundingUpward`.
class SingularImages {
 public:
  using Node = std::uint32_t;
  static constexpr Node root = 0;

  explicit SingularImages(const StrutSlice& slice);

  const ImageStrip& strip(Node node) const noexcept { return nodes_[node].strip; }
  const Box& box(Node node) const noexcept { return nodes_[node].box; }

  /// Whether it is as small as boxes get.
  bool is_smallest(Node node) const noexcept;

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

  const StrutSlice& slice_;
  std::vector<Entry> nodes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SINGULAR_IMAGES_H
