// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CLIMB_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CLIMB_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/components/component_policy.h"
#include "aspects/tree/pose_space.h"

#include <cstddef>

namespace parallel_aspects {

/// A path from a pose of S(mode, sign) to poses farther from its boundary: out of thin wedges into the open.
/// Every step is a straight path that is proved to stay in S(mode, sign). Steps are those of an
/// interior-point method that maximises the product of all `Conditions`, see Boyd and Vandenberghe, Convex
/// Optimization, 2004, section 9.5. Needs a live `RoundingUpward`.
class Climb {
 public:
  /// `start` must be proved to be in S(mode, sign); `policy` must outlive this.
  Climb(const BoxClassifier& classifier, const PoseSpace& space, std::size_t mode, int sign,
        const MapPosition& start, const ClimbPolicy& policy) noexcept
      : classifier_(classifier), space_(space), mode_(mode), sign_(sign), position_(start), policy_(policy) {}

  /// Takes one step; false where none can be proved, or none leads on.
  bool step() noexcept;

  const MapPosition& position() const noexcept { return position_; }

 private:
  bool cross_glued_face() noexcept;

  const BoxClassifier& classifier_;
  const PoseSpace& space_;
  std::size_t mode_;
  int sign_;
  MapPosition position_;
  const ClimbPolicy& policy_;
  double damping_ = 1.0;
  bool has_crossed_ = false;  // with the last step
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CLIMB_H
