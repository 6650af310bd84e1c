// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_QUATERNION_CUBE_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_QUATERNION_CUBE_H

#include "aspects/tree/pose_space.h"
#include "interval/interval.h"
#include "legs/spatial_leg.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Rows of a rotation matrix.
template <class Scalar>
using RotationRows = std::array<Spatial<Scalar>, 3>;

/// The rotation of a quaternion (x, y, z, w) that need not be of unit length; its squared norm must be at
/// least `least` > 0.
template <class Scalar>
RotationRows<Scalar> rotation_of(const std::array<Scalar, 4>& q, double least) {
  const Interval two(2.0);
  const Scalar xx = square(q[0]), yy = square(q[1]), zz = square(q[2]), ww = square(q[3]);
  const Scalar xy = two * (q[0] * q[1]), xz = two * (q[0] * q[2]), yz = two * (q[1] * q[2]);
  const Scalar wx = two * (q[3] * q[0]), wy = two * (q[3] * q[1]), wz = two * (q[3] * q[2]);
  const Scalar scale = reciprocal(xx + yy + zz + ww, least);
  return {{{scale * ((ww + xx) - (yy + zz)), scale * (xy - wz), scale * (xz + wy)},
           {scale * (xy + wz), scale * ((ww + yy) - (xx + zz)), scale * (yz - wx)},
           {scale * (xz - wy), scale * (yz + wx), scale * ((ww + zz) - (xx + yy))}}};
}

/// The rotation at the coordinates `a` of a cube of SO3 (see PoseSpace): of the quaternion with its largest
/// component 1.
template <class Scalar>
RotationRows<Scalar> rotation_of_cube(RootIndex root, const std::array<Scalar, 3>& a) {
  std::array<Scalar, 4> q;
  for (std::size_t component = 0, i = 0; component < 4; ++component)
    q[component] = component == root ? Scalar(1.0) : a[i++];
  return rotation_of(q, 1.0);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_QUATERNION_CUBE_H
