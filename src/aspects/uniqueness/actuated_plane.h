// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_ACTUATED_PLANE_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_ACTUATED_PLANE_H

#include "aspects/components/disjoint_sets.h"
#include "aspects/uniqueness/singular_images.h"
#include "aspects/uniqueness/strut_slice.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_control.h"

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
  int side = 0;       ///< 0 the whole cell, -1 below the slab, 1 above it
  double area = 0.0;  ///< a lower bound [m^2]
};

/// A square of the plane of lengths.
struct PlaneCell {
  Box box;                                     ///< of both lengths [m]
  std::uint32_t first_child = 0;               ///< 0 where it is not divided
  std::vector<SingularImages::Node> touching;  ///< whose images may touch it
  /// Their images are where slope . (lengths - middle) is in here; on both sides of it there are none.
  std::array<double, 2> slope{};
  Interval slab;
  std::array<std::optional<PieceIndex>, 3> pieces;  ///< by side, + 1
  double unknown = 0.0;                             ///< area that is in no piece, an upper bound [m^2]
};

/// Two pieces of one connected set, with lengths that both hold [m].
struct PieceLink {
  PieceIndex first = 0, second = 0;
  std::array<double, 2> common{};
};

/// The plane of both lengths of a slice, divided into squares until all but little of it is in pieces that no
/// image of a singular pose touches. Within limits.
///
/// Over a connected set of values that g takes no singular pose to, the number of poses is constant: the
/// slice is compact, so that poses can neither come from nor go to anywhere else, and each is regular.
class ActuatedPlane {
 public:
  /// The division ends where no more than `unknown_share` of the plane is in no piece. Needs a live
  /// `RoundingUpward`. Ends early when cancelled.
  ActuatedPlane(const StrutSlice& slice, SingularImages& images, double unknown_share,
                const MapControl& control);

  const std::vector<PlaneCell>& cells() const noexcept { return cells_; }
  const std::vector<Piece>& pieces() const noexcept { return pieces_; }

  /// Every two pieces that share part of a face where that was seen; some come twice.
  const std::vector<PieceLink>& links() const noexcept { return links_; }

  /// The least index of a piece of the connected set that holds this one.
  PieceIndex set_of(PieceIndex piece) { return sets_.find(piece); }

  /// The piece that holds these lengths [m]; nothing where they are in none.
  std::optional<PieceIndex> find(const std::array<double, 2>& lengths) const;

  /// A point of the piece, away from its ends [m].
  std::array<double, 2> point_of(PieceIndex piece) const;

  /// Area that is in no piece, an upper bound [m^2].
  double unknown() const noexcept { return unknown_; }

 private:
  using Node = SingularImages::Node;
  using Point = std::array<double, 2>;

  void divide(double unknown_share, const MapControl& control);
  void classify(std::uint32_t cell, const std::vector<Node>& candidates);
  void collect(const PlaneCell& cell, Node node, std::vector<Node>& touching);
  void find_slab(PlaneCell& cell) const;
  void cut(PlaneCell& cell) const;
  void make_pieces();
  void join_inside(std::uint32_t cell);
  void join_across(std::size_t axis, std::uint32_t a, std::uint32_t b);
  void join_at(std::uint32_t a, std::uint32_t b, const Point& at);
  std::optional<PieceIndex> piece_at(const PlaneCell& cell, const Point& at) const;

  const StrutSlice& slice_;
  SingularImages& images_;
  std::vector<PlaneCell> cells_;
  std::vector<std::array<double, 2>> sides_;  // by cell: area below and above its slab
  std::vector<Piece> pieces_;
  std::vector<PieceLink> links_;
  DisjointSets sets_;
  double unknown_ = 0.0;
};

/// Half the squares of lengths of a box.
ValueBox half_squares(const Box& lengths) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_ACTUATED_PLANE_H
