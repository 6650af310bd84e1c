// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_CLOSURE_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_CLOSURE_H

#include "urdf/description/tree.h"

#include <Eigen/Geometry>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// What two frames must share.
enum class ClosureType {
  point,      ///< the origins: a ball joint, or any joint of a planar mechanism
  revolute,   ///< the origins and the direction of the z axes, either way round
  universal,  ///< the origins; z of the first frame stays orthogonal to x of the second
  fixed,      ///< everything
  automatic,  ///< the first of the above under which the mobility is the number of actuated joints
};

/// "point", "revolute", "universal", "fixed" or "auto".
std::string_view name(ClosureType type) noexcept;

/// The type of that name, "spherical" being another word for "point"; nothing for any other text.
std::optional<ClosureType> closure_type_named(std::string_view text) noexcept;

/// A frame fixed in a link.
struct LinkFrame {
  std::size_t link = 0;
  Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();  ///< [m]
};

/// Whether a closure of automatic type is written as rigid: then `fixed` is the first type to be tried, and
/// another one says where the two links turn against each other.
enum class Weld {
  none,
  at_frames,   ///< in its frames
  at_origins,  ///< at the origin of the one link or of the other
};

/// Two frames that the mechanism holds together, though the tree does not.
struct Closure {
  std::string name;
  std::array<LinkFrame, 2> frames;
  ClosureType type = ClosureType::automatic;
  Weld weld = Weld::none;
  /// The first frame in the second while all joints are zero, where the description gives the second alone,
  /// as simulators take a joint: then the first follows from the tree.
  std::optional<Eigen::Isometry3d> at_zero = std::nullopt;
};

/// Where the tree has the first frames of closures that are given at zero.
void place_at_zero(const Tree& tree, std::vector<Closure>& closures);

/// What two frames lack of being held together.
struct LoopGap {
  double distance = 0.0;  ///< of their origins [m]
  double angle = 0.0;     ///< of what the closure holds of their directions [rad]

  /// The larger of each.
  LoopGap with(const LoopGap& other) const noexcept;
};

/// The equations of all closures, in the frame of the base.
class ClosureSystem {
 public:
  /// No closure may be automatic.
  ClosureSystem(std::shared_ptr<const Tree> tree, std::size_t base, std::vector<Closure> closures);

  const Tree& tree() const noexcept { return *tree_; }
  std::size_t base() const noexcept { return base_; }
  const std::vector<Closure>& closures() const noexcept { return closures_; }

  /// Length that makes angles and lengths comparable: the `mechanism_size` at zero [m].
  double size() const noexcept { return size_; }

  /// What each closure lacks [m]; angles are multiplied by `size()`.
  Eigen::VectorXd residual(const Eigen::VectorXd& values) const;

  /// Derivative of the residual by the joint values [m/rad or 1].
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& values) const;

  /// How far the closures are from closing: the most of all of them.
  LoopGap widest_gaps(const Eigen::VectorXd& values) const;

  /// Largest distance between the two origins of a closure, and which closure that is.
  std::pair<double, std::size_t> widest_gap(const Eigen::VectorXd& values) const;

  /// Whether the joint can move a closure, for each joint value; the others are outside the loops.
  const std::vector<bool>& in_loop() const noexcept { return in_loop_; }

 private:
  std::shared_ptr<const Tree> tree_;
  std::size_t base_;
  std::vector<Closure> closures_;
  std::vector<std::size_t> joints_;  // above the base and the frames of the closures
  double size_ = 1.0;
  std::vector<bool> in_loop_;
};

/// Those of no stated type are of this one.
std::vector<Closure> with_type(std::vector<Closure> closures, ClosureType type);

/// Velocity (w, v) of a point fixed in a link, by the joint values: 6 rows; the base rests.
Eigen::Matrix<double, 6, Eigen::Dynamic> velocity_matrix(const Tree& tree, std::size_t base,
                                                         const Poses& poses, std::size_t link,
                                                         const Eigen::Vector3d& point);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_CLOSURE_H
