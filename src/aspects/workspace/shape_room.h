// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_ROOM_H
#define PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_ROOM_H

#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/regular_workspace.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

namespace parallel_aspects {

/// A regular shape as the unit ball of a norm of displacements: the shape of size s about a center holds what
/// is at a distance of s or less from it. So distances bound sizes, and the largest shape about a center
/// changes by no more than the center moves.
///
/// Coordinates are multiplied by scales; those of one group count by their Euclidean norm, and the largest
/// group counts. Other coordinates of boxes than the first `dimension()` are not examined.
class ShapeGauge {
 public:
  /// `turns`: whether coordinates are angles in half turns, which begin anew after a whole one.
  ShapeGauge(const WorkspaceQuestion& question, std::size_t dimension, bool turns = false);

  std::size_t dimension() const noexcept { return dimension_; }

  /// An upper bound of the distance of the nearest point of the box, and little more than it. This and what
  /// follows needs a live `RoundingUpward`.
  double distance(const MapPoint& center, const Box& box) const noexcept;

  /// A lower bound of it.
  double distance_at_least(const MapPoint& center, const Box& box) const noexcept;

  /// A point of the box at that distance.
  MapPoint nearest(const MapPoint& center, const Box& box) const noexcept;

  /// The farthest that a point of the box is from its middle.
  double half_extent(const Box& box) const noexcept;

  /// How large a shape about `center` may be without leaving the box of all positions: upper and lower
  /// bounds. Of angles it may take a whole turn.
  double room(const MapPoint& center, const Box& box) const noexcept;
  double room_at_least(const MapPoint& center, const Box& box) const noexcept;

  /// Extent of the shape of size 1 along coordinate i, from its center.
  double reach(std::size_t i) const noexcept { return 1.0 / scale_[i]; }

 private:
  template <class Scalar>
  Scalar norm(const std::array<Scalar, max_map_dimension>& displacement) const noexcept;

  std::size_t dimension_;
  bool turns_;
  std::array<double, max_map_dimension> scale_{};
  std::array<std::size_t, max_map_dimension> group_{};
};

/// How large the shape about a center can be.
struct ShapeRoom {
  double lower = 0.0;                                      ///< all of the shape of this size is proved usable
  double upper = std::numeric_limits<double>::infinity();  ///< no larger one is
  /// A position that is not usable and limits `upper`: no shape holds it, wherever its center is. None where
  /// the wall of the region limits it, which only does so about this center.
  std::optional<MapPoint> obstacle{};
};

/// The part of the last coordinate that counts, where it is no position: boxes that hold it, and that it
/// holds. (Where it is one angle, the second one is turned around: what meets it from both sides holds the
/// angle.)
struct AngleBounds {
  Box outer, inner;
};

/// The leaves of a map in one working mode and sign of det A, S(s, sigma) of `LeafState`, divided further
/// where a question needs it. A leaf is usable where it is proved to lie in S(s, sigma), an obstacle where it
/// is proved not to meet it, and open otherwise.
///
/// A shape of usable positions is connected, and so are the poses over it. So they lie in one aspect, that of
/// any leaf of the map that they meet. Needs a live `RoundingUpward`.
class UsableLeaves {
 public:
  UsableLeaves(const AspectMap::Contents& map, std::size_t mode, int sign, const ShapeGauge& gauge,
               const AngleBounds& angles);

  /// The room about a center. Open leaves are divided down to this extent [in the gauge]. Where `upper` falls
  /// to `enough`, nothing more is asked, nor where many leaves are examined in vain.
  ShapeRoom room(const MapPoint& center, double extent, double enough);

  /// How many leaves were examined for that, so far.
  std::size_t looks() const noexcept { return looks_; }

  /// Whether all of the shape of this size is usable, with the leaves as they are.
  bool holds(const MapPoint& center, double size) const;

  /// The aspect of a leaf of the map that the usable shape of this size meets; 0 where there is none.
  int aspect_of(const MapPoint& center, double size) const;

  /// Whether poses over the box of positions may lie in one of these aspects.
  bool may_hold(const std::vector<int>& aspects, const Box& positions) const;

  /// The box of all positions.
  Box positions() const;

 private:
  enum class State : std::uint8_t { divided, usable, obstacle, open };

  struct Leaf {
    NodeIndex first_child = no_node;
    std::int32_t aspect = 0;  ///< in the map; 0 for leaves that it does not have
    State state = State::open;
  };

  /// A leaf, and a lower bound of how far it is.
  struct Near {
    double distance;
    NodeIndex leaf;
    Box box;
    bool operator<(const Near& other) const { return distance > other.distance; }
  };

  void copy(const AspectMap::Contents& map, NodeIndex node, NodeIndex leaf);
  void divide(NodeIndex leaf, const Box& box);
  State state_of(LeafState state) const;
  bool meets(const Box& box, const Box& angles) const;
  bool meets_angles(const Box& box) const { return meets(box, angles_.outer); }
  bool meets_over(const Box& positions, const Box& box) const;
  void push(const MapPoint& center, NodeIndex leaf, const Box& box, ShapeRoom& room);
  void look_at(const MapPoint& center, double extent, const Near& near, ShapeRoom& room);

  bool holds(const MapPoint& center, double size, NodeIndex leaf, const Box& box) const;
  int aspect_of(const MapPoint& center, double size, NodeIndex leaf, const Box& box) const;
  bool may_hold(const std::vector<int>& aspects, const Box& positions, NodeIndex leaf, const Box& box) const;

  const BoxClassifier& classifier_;
  Box region_;
  std::size_t mode_;
  int sign_;
  ShapeGauge gauge_;
  AngleBounds angles_;
  std::vector<Leaf> leaves_;
  std::size_t looks_ = 0;
  std::priority_queue<Near> queue_;  // of the question that is answered
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_ROOM_H
