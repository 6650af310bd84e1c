// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_JOINT_MAP_H
#define PARALLEL_ASPECTS_ARMS_JOINT_MAP_H

#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/arms/serial_arm.h"
#include "parallel_aspects/aspects/map_slice.h"

#include "arms/arm_determinant.h"
#include "arms/factor_enclosure.h"
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A connected set of joint values where each factor of a group has one sign, as far as it is proved.
struct JointComponent {
  std::size_t signs = 0;    ///< bit i: whether factor i is positive
  double measure = 0.0;     ///< of what is proved to belong to it [product of rad and m]
  Eigen::VectorXd witness;  ///< values of the joints of the group in it
};

/// The certified map of one group of factors: a 2^d-tree of boxes of the values of its joints, of which at
/// most three count, with one mode for each combination of signs.
///
/// Counts are exact where `count_at_most` is the number of components and `proved_count` is so too. Upper
/// bound: over the closure of a connected set the product of the factors has a maximum within it; where each
/// undecided box has a direction along which the product grows wherever it is positive (and which leads out
/// of no limit), that maximum lies in a box that is proved inside, so that each set has one. Lower bound:
/// components that no chain of undecided boxes joins are apart.
class JointMap {
 public:
  /// `resolution`: longest edge of an undecided box [share of a coordinate's range], of the base map.
  /// Throws `InvalidDescription` where a joint that slides and counts has no limits.
  JointMap(const SerialArm& arm, const FactorGroup& group, double resolution, const MapControl& control);

  const FactorGroup& group() const noexcept { return group_; }
  const std::vector<JointComponent>& components() const noexcept { return components_; }
  std::size_t proved_count() const noexcept { return proved_count_; }
  std::optional<std::size_t> count_at_most() const noexcept { return count_at_most_; }
  double measure() const noexcept { return measure_; }      ///< of all values within limits
  double undecided() const noexcept { return undecided_; }  ///< of boxes that are open for some signs
  std::size_t box_count() const noexcept { return tree_->node_count(); }

  /// The component that holds values of all joints; nothing where no box is proved to.
  std::optional<std::size_t> component_at(const Eigen::VectorXd& q) const noexcept;

  /// The signs of the factors there, as in `JointComponent`; nothing where one is not proved.
  std::optional<std::size_t> signs_at(const Eigen::VectorXd& q) const;

  /// The only component with these signs, where it is proved that there is one only.
  std::optional<std::size_t> only_component(std::size_t signs) const noexcept;

 private:
  struct Coordinate {
    std::size_t joint = 0;
    bool turns = true, wraps = false;
    double middle = 0.0, half = 0.0;  // value = middle + half t, t from -1 to 1; of what wraps, pi t
  };
  struct BoxForms;

  std::size_t mode_count() const noexcept { return std::size_t{1} << group_.factors.size(); }
  void add_coordinates(const SerialArm& arm);
  JointNumbers<Affine<3>> numbers(const Box& box) const;
  void classify(NodeIndex node);
  bool has_rising_direction(NodeIndex node, std::size_t signs) const;
  bool grows(const BoxForms& forms, const std::array<double, 3>& direction) const;
  std::vector<NodeIndex> leaves(std::size_t signs) const;
  void divide(NodeIndex node, std::size_t signs);
  void refine_to(double resolution, const MapControl& control);
  bool refine_once(const MapControl& control);
  std::vector<NodeIndex> contacts(std::size_t signs) const;
  void count(const MapControl& control);
  std::optional<MapPosition> position(const Eigen::VectorXd& q) const noexcept;
  double measure_of(const Box& box) const noexcept;

  FactorGroup group_;
  std::vector<Coordinate> coordinates_;
  std::vector<EnclosedPolynomial> factors_;
  std::vector<std::array<EnclosedPolynomial, 3>> gradients_;
  std::shared_ptr<PoseTree> tree_;
  std::uint32_t base_level_ = 0;
  std::vector<std::uint8_t> rising_;  // by node and mode: 0 not looked at, 1 no, 2 yes
  std::vector<JointComponent> components_;
  std::vector<std::vector<std::uint32_t>> component_of_;  // by mode and node
  std::size_t proved_count_ = 0;
  std::optional<std::size_t> count_at_most_;
  double measure_ = 0.0, undecided_ = 0.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_JOINT_MAP_H
