// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_HINGES_H
#define PARALLEL_ASPECTS_LEGS_HINGES_H

#include "interval/half_turns.h"
#include "interval/interval.h"
#include "interval/rotation_rows.h"
#include "legs/spatial_leg.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/model/pose.h"

namespace parallel_aspects {

/// Where hinges put the platform.
template <class Scalar>
struct HingePlacement {
  Spatial<Scalar> position;       ///< of the operational point [m]
  RotationRows<Scalar> rotation;  ///< rows of the rotation matrix

  /// Of the second hinge.
  Spatial<Scalar> axis() const { return {rotation[0][2], rotation[1][2], rotation[2][2]}; }
};

/// Of the one hinge of R1.
template <class Scalar>
HingePlacement<Scalar> placed_by_hinge(const Turn<Scalar>& turn) {
  const Scalar zero(0.0), one(1.0);
  return {{zero, zero, zero},
          {{{turn.cosine, -turn.sine, zero}, {turn.sine, turn.cosine, zero}, {zero, zero, one}}}};
}

/// The constants of a pair of hinges, enclosed. All of it needs a live `RoundingUpward`.
class EnclosedHinges {
 public:
  explicit EnclosedHinges(const HingePair& hinges) noexcept
      : offset_(hinges.offset), twist_(enclosed_turn(hinges.twist)) {}

  /// The product of motions of `HingePair`.
  template <class Scalar>
  HingePlacement<Scalar> placed(const Turn<Scalar>& first, const Turn<Scalar>& second) const {
    const Interval &c = twist_.cosine, &s = twist_.sine;
    HingePlacement<Scalar> result;
    result.position = {offset_ * first.cosine, offset_ * first.sine, Scalar(0.0)};
    result.rotation[0] = {first.cosine * second.cosine - c * (first.sine * second.sine),
                          -(first.cosine * second.sine) - c * (first.sine * second.cosine), s * first.sine};
    result.rotation[1] = {first.sine * second.cosine + c * (first.cosine * second.sine),
                          c * (first.cosine * second.cosine) - first.sine * second.sine, -(s * first.cosine)};
    result.rotation[2] = {s * second.sine, s * second.cosine, Scalar(c)};
    return result;
  }

 private:
  Interval offset_;
  Turn<Interval> twist_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_HINGES_H
