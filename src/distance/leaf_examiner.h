// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_LEAF_EXAMINER_H
#define PARALLEL_ASPECTS_DISTANCE_LEAF_EXAMINER_H

#include "aspects/tree/pose_space.h"
#include "distance/leaf_view.h"
#include "distance/mode_determinant.h"
#include "distance/singular_leaves.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Proves of boxes of a map that they hold no parallel singularity, or near which plane these lie. The box is
/// enclosed by a parallelepiped y = L e, |e_i| <= 1, of the coordinates about its center, over which legs are
/// evaluated once for all working modes. Owns the memory it works in; needs a live `RoundingUpward`.
template <TaskSpace space>
class LeafExaminer {
 public:
  using Chart = LocalChart<space>;
  static constexpr std::size_t size = Chart::size, moves = Chart::moves, turns = Chart::turns;

  explicit LeafExaminer(const Manipulator& manipulator)
      : chart_(manipulator), determinant_(chart_, manipulator) {
    unit_cell_.half_width.fill(1.0);
  }

  LeafExaminer(const LeafExaminer&) = delete;
  LeafExaminer& operator=(const LeafExaminer&) = delete;

  void look_at(RootIndex root, const Box& box) noexcept;

  /// Whether every pose of the box is proved to be out of reach of some leg.
  bool holds_no_pose() const noexcept { return !reached_; }

  /// What may be singular in this mode; nothing where that is proved to be nothing.
  std::optional<SingularLeaf> leaf(const WorkingMode& mode) noexcept;

 private:
  using Edges = std::array<Coordinates<size>, size>;  // L by rows

  void enclose_positions(const Box& box) noexcept;
  void enclose_motions(const Box& box) noexcept;
  void enclose_rotations(RootIndex root, const Box& box) noexcept;
  Eigen::Vector3d lengthening(const Eigen::Matrix3d& edges, const Eigen::Matrix3d& slopes,
                              const Eigen::Vector3d& rest) const noexcept;
  void set_plane(const Affine<size>& value, SingularLeaf& leaf) const noexcept;
  double half_width_about(const Box& box, std::size_t i) const noexcept;

  static constexpr double everywhere = 2.0;  // a radius that holds the unit cell

  Chart chart_;
  ModeDeterminant<space> determinant_;
  Cell<size> unit_cell_;
  LeafCenter center_{};
  Edges edges_{};
  float radius_ = 0.0F;
  bool reached_ = false;
  typename ModeDeterminant<space>::LegsOverCell legs_;
  typename ModeDeterminant<space>::OverCell over_;
};

extern template class LeafExaminer<TaskSpace::T1>;
extern template class LeafExaminer<TaskSpace::T2>;
extern template class LeafExaminer<TaskSpace::SE2>;
extern template class LeafExaminer<TaskSpace::T3>;
extern template class LeafExaminer<TaskSpace::SO3>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_LEAF_EXAMINER_H
