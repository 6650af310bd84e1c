// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_ROTATION_ROWS_H
#define PARALLEL_ASPECTS_INTERVAL_ROTATION_ROWS_H

#include "interval/interval.h"

#include <Eigen/Geometry>

#include <array>

namespace parallel_aspects {

/// Rows of a rotation matrix.
template <class Scalar>
using RotationRows = std::array<std::array<Scalar, 3>, 3>;

/// The rotation of a quaternion (x, y, z, w), which stands for its direction: it need not be of unit length.
/// Scalar encloses numbers; needs a live `RoundingUpward`.
template <class Scalar>
class QuaternionRotation {
 public:
  explicit QuaternionRotation(const std::array<Scalar, 4>& xyzw)
      : q_(xyzw), xx_(square(q_[0])), yy_(square(q_[1])), zz_(square(q_[2])), ww_(square(q_[3])) {}

  Scalar squared_norm() const { return xx_ + yy_ + zz_ + ww_; }

  /// `scale` must enclose 1 / squared_norm().
  RotationRows<Scalar> rows(const Scalar& scale) const {
    const Interval two(2.0);
    const Scalar xy = two * (q_[0] * q_[1]), xz = two * (q_[0] * q_[2]), yz = two * (q_[1] * q_[2]);
    const Scalar wx = two * (q_[3] * q_[0]), wy = two * (q_[3] * q_[1]), wz = two * (q_[3] * q_[2]);
    return {{{scale * ((ww_ + xx_) - (yy_ + zz_)), scale * (xy - wz), scale * (xz + wy)},
             {scale * (xy + wz), scale * ((ww_ + yy_) - (xx_ + zz_)), scale * (yz - wx)},
             {scale * (xz - wy), scale * (yz + wx), scale * ((ww_ + zz_) - (xx_ + yy_))}}};
  }

 private:
  std::array<Scalar, 4> q_;
  Scalar xx_, yy_, zz_, ww_;
};

/// The same of numbers, which must not be 0 altogether.
inline RotationRows<Interval> enclosed_rotation(const Eigen::Quaterniond& q) noexcept {
  assert_rounding_upward();
  const QuaternionRotation<Interval> rotation({q.x(), q.y(), q.z(), q.w()});
  return rotation.rows(reciprocal(rotation.squared_norm()));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_ROTATION_ROWS_H
