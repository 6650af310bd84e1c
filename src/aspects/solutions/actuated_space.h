// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_ACTUATED_SPACE_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_ACTUATED_SPACE_H

#include "aspects/components/disjoint_sets.h"
#include "aspects/enclosures/singular_images.h"
#include "aspects/solutions/solution_equations.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace parallel_aspects {

using PieceIndex = std::uint32_t;

/// A part of a cell that no image of a singular pose touches: the whole, or what lies on one side of a slab.
/// It is convex.
struct Piece {
  std::uint32_t cell = 0;
  int side = 0;          ///< 0 the whole cell, -1 below the slab, 1 above it
  double measure = 0.0;  ///< a lower bound [m^2 or m^3]
};

/// A rectangle of two actuated values, or a box of three.
struct SpaceCell {
  Box box;                                     ///< [m or rad]
  std::uint32_t first_child = 0;               ///< 0 where it is not divided
  std::vector<SingularImages::Node> touching;  ///< whose images may touch it; empty once it is divided
  /// Their images are where slope . (values - middle) is in here; on both sides of it there are none.
  std::array<double, 3> slope{};
  Interval slab;
  std::array<std::optional<PieceIndex>, 3> pieces;  ///< by side, + 1
  double unknown = 0.0;                             ///< what is in no piece, an upper bound [m^2 or m^3]
};

/// Two pieces of one connected set, with values that both hold [m or rad]: as the first has them and, of an
/// angle whose last values are the first, as the second does, a turn apart.
struct PieceLink {
  std::array<PieceIndex, 2> pieces{};
  std::array<ActuatedValues, 2> common{};
};

/// Enclosures of all three lengths [m].
using LengthRanges = std::array<Interval, 3>;

/// Whether all these lengths lie in a box of all three.
bool holds_all(const Box& box, const LengthRanges& lengths) noexcept;

/// The pieces that hold ranges of lengths.
struct LengthCover {
  bool is_complete = false;           ///< whether these hold all of the ranges
  std::vector<PieceIndex> pieces;     ///< the search ends with the third, or after 64 cells
  std::optional<std::uint32_t> cell;  ///< the cell, if the ranges can be in one only
};

/// The plane of both actuated values of a slice, or the space of all three of a family of them, divided into
/// rectangles or boxes until all but little of it is in pieces that no image of a singular pose touches.
/// Within limits.
///
/// Over a connected set of values that g takes no singular pose to, the number of poses is constant: poses of
/// bounded values form a compact set, so that poses can neither come from nor go to anywhere else, and each
/// is regular. So is the number of poses in a working mode where the images are those of its singular poses.
class ActuatedSpace {
 public:
  /// Takes and clears the images. The division ends where no more than `unknown_share` of the whole is in no
  /// piece, or at so many cells. Needs a live `RoundingUpward`. Ends early when cancelled.
  ActuatedSpace(SingularImages& images, double unknown_share, const MapControl& control,
                std::size_t most_cells = 250000);

  std::size_t dimension() const noexcept { return space_.values.dimension; }

  const std::vector<SpaceCell>& cells() const noexcept { return cells_; }
  const std::vector<Piece>& pieces() const noexcept { return pieces_; }

  /// Every two pieces that share part of a face where that was seen; some come twice.
  const std::vector<PieceLink>& links() const noexcept { return links_; }

  /// The least index of a piece of the connected set that holds this one.
  PieceIndex set_of(PieceIndex piece) { return sets_.find(piece); }

  /// The piece that holds these values [m or rad]; nothing where they are in none.
  std::optional<PieceIndex> find(const ActuatedValues& values) const;

  /// Which pieces hold all lengths in these ranges, of a family. Needs a live `RoundingUpward`.
  LengthCover cover(const LengthRanges& lengths) const;

  /// A point of the piece, away from its ends [m or rad].
  ActuatedValues point_of(PieceIndex piece) const;

  /// Values that are in no piece, drawn evenly among these. Needs a live `RoundingUpward`.
  std::vector<ActuatedValues> draw_unknown(std::size_t count, std::uint64_t seed) const;

  /// What is in no piece, an upper bound [m^2 or m^3].
  double unknown() const noexcept { return unknown_; }

 private:
  using Node = SingularImages::Node;

  ValueBox values_over(const SpaceCell& cell) const noexcept;
  std::optional<ImageStrip> strip_beside(const ValueBox& cell, Node node) const;
  void divide(double unknown_share, std::size_t most_cells, const MapControl& control);
  void classify(std::uint32_t cell, const std::vector<Node>& candidates);
  void collect(const SpaceCell& cell, Node node, std::vector<Node>& touching);
  void find_slab(SpaceCell& cell) const;
  void make_pieces();
  void join_inside(std::uint32_t cell);
  void join_across(std::size_t axis, std::uint32_t a, std::uint32_t b);
  void join_leaves(std::size_t axis, std::uint32_t a, std::uint32_t b);
  void join_at(std::uint32_t a, std::uint32_t b, const std::array<ActuatedValues, 2>& at);
  static void add_to_cover(const SpaceCell& cell, const LengthRanges& lengths, LengthCover& cover);
  std::optional<PieceIndex> piece_at(const SpaceCell& cell, const ActuatedValues& at,
                                     double slack = 0.0) const;

  ValueSpace space_;
  SingularImages& images_;
  std::vector<SpaceCell> cells_;
  std::vector<Piece> pieces_;
  std::vector<PieceLink> links_;
  DisjointSets sets_;
  double unknown_ = 0.0;
};

/// Half the squares of lengths of a box; 0 where it has no third.
ValueBox half_squares(const Box& lengths) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_ACTUATED_SPACE_H
