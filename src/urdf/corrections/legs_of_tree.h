// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_LEGS_OF_TREE_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_LEGS_OF_TREE_H

#include "urdf/closing/resolved_config.h"
#include "urdf/description/closure.h"
#include "urdf/description/tree.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Whether two legs are on one point of the platform though others are elsewhere on it. `size`: what lengths
/// are small against [m].
bool legs_share_anchors(const Tree& tree, const ResolvedConfig& resolved, double size);

/// The joints of a tree that closures put into loops, fixed ones too, and how those compare that are as far
/// from the root: in legs that are drawn alike they correspond. Joints are indices of the tree's.
class LoopJoints {
 public:
  /// With `size` as the length that others are small against [m].
  LoopJoints(const Tree& tree, const std::vector<Closure>& closures, double size);

  const std::vector<std::size_t>& all() const noexcept { return all_; }

  /// The others in loops that are as far from the root.
  std::vector<std::size_t> siblings(std::size_t joint) const;

  /// Whether two siblings have its type, axis and origin.
  bool is_like_others(std::size_t joint) const;

  /// The middle one of the lengths of all origins but that of `except`; zero where none has a length [m].
  double usual_length(std::optional<std::size_t> except = std::nullopt) const;

  bool same_motion(std::size_t one, std::size_t other) const;
  bool same_place(std::size_t one, std::size_t other) const;      ///< origins, without their rotations
  bool same_direction(std::size_t one, std::size_t other) const;  ///< rotations of the origins

 private:
  const Tree& tree_;
  double size_;
  std::vector<std::size_t> all_;
  std::vector<std::size_t> depth_;  // of each joint of the tree
};

/// Siblings that a joint is unlike, while as many are like them, at least, as are like the joint.
struct UsualSibling {
  std::size_t joint = 0;
  bool is_most = false;  ///< whether more are, and two at least
};
std::vector<UsualSibling> usual_siblings(const LoopJoints& loops, std::size_t joint,
                                         const std::function<bool(std::size_t, std::size_t)>& are_alike);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_LEGS_OF_TREE_H
