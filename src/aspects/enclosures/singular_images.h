// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_SINGULAR_IMAGES_H
#define PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_SINGULAR_IMAGES_H

#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Enclosed actuated values, or half the squares of lengths. In one slice the third counts as 0.
using ValueBox = std::array<Interval, 3>;

/// Stands for all values that there are, and can be multiplied by zero.
inline const Interval all_values(-1e100, 1e100);

/// Encloses the image of a box of poses in the space of such values: by its extents along the axes and along
/// the directions of a frame. About a singular box the first of these is across the image of the singular
/// curve or surface, so that this extent is of second order in the size of the box. A frame of zeros stands
/// for none.
struct ImageStrip {
  std::array<std::array<double, 3>, 3> frame{};
  ValueBox range;
  std::array<Interval, 3> extents;  ///< of frame[k] . values

  /// Across the image.
  const std::array<double, 3>& normal() const noexcept { return frame[0]; }

  /// Of direction . values.
  Interval along(const std::array<double, 3>& direction) const noexcept;

  /// Whether it may have a point in common with a box of values.
  bool may_meet(const ValueBox& values) const noexcept;

  /// Without any bounds of this value.
  void take_all(std::size_t axis) noexcept;

  /// Moved by that much.
  ImageStrip moved(const ValueBox& by) const noexcept;
};

/// The normalized vector; zero where there is none.
std::array<double, 3> normalized(const std::array<double, 3>& v) noexcept;

std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) noexcept;

/// What actuated values are divided into.
struct ValueSpace {
  Box values;                        ///< all of them, within limits [m or rad]
  std::array<bool, 3> are_angles{};  ///< to whole turns, where images are concerned
  /// Angles that take all values, so that the last are the first; of these `values` has a little more than a
  /// turn.
  std::array<bool, 3> are_periodic{};
  bool of_half_squares = false;  ///< whether strips are of half the squares of these, which are lengths
};

/// Boxes of a slice, or of a family of slices, that cover its singular poses, each divided where that is
/// asked for. Needs a live `RoundingUpward`.
class SingularImages {
 public:
  using Node = std::uint32_t;
  static constexpr Node root = 0;

  virtual ~SingularImages() = default;

  const ValueSpace& space() const noexcept { return space_; }
  const ImageStrip& strip(Node node) const noexcept { return nodes_[node].strip; }
  const Box& box(Node node) const noexcept { return nodes_[node].box; }

  /// Whether it is as small as boxes get.
  bool is_smallest(Node node) const noexcept;

  /// Forgets all boxes, which take much memory; after that there is nothing to ask.
  void clear() noexcept { std::vector<Entry>().swap(nodes_); }

  /// Nodes that follow each other.
  struct Parts {
    Node first = 0, count = 0;

    Node operator[](Node k) const noexcept { return first + k; }
  };

  /// Its parts that may hold singular poses.
  Parts parts(Node node);

 protected:
  /// A kind of singularity, in the order of who distinguishes them.
  using Surface = std::uint32_t;

  /// `smallest` boxes are not divided [half turns].
  SingularImages(ValueSpace space, double smallest);

  /// Covers this singularity; to be called before anything is asked.
  void add_surface(const Box& whole, Surface surface);

  /// Of the poses of such a singularity in the box; nothing where there are none.
  virtual std::optional<ImageStrip> strip_of(const Box& box, Surface surface) const = 0;

  /// How much of the third coordinate counts as half a turn, where boxes are halved: of an angle half a turn,
  /// of a length as far as the end of a rod moves in one [rad or m].
  virtual double half_turn(Surface surface) const = 0;

 private:
  struct Entry {
    Box box;
    ImageStrip strip;
    Surface surface = 0;
    bool divided = false;
    Parts parts;
  };

  std::array<Box, 2> halves_of(const Box& box, Surface surface) const;
  void add(const Box& box, Surface surface);
  void add_halves(const Box& box, Surface surface, std::size_t times);

  ValueSpace space_;
  double smallest_;  // [half turns]
  std::vector<Entry> nodes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_SINGULAR_IMAGES_H
