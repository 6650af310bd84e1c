// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_QUATERNION_CUBE_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_QUATERNION_CUBE_H

#include "aspects/tree/pose_space.h"
#include "interval/rotation_rows.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// The rotation at the coordinates `a` of a cube of SO3 (see PoseSpace): of the quaternion with its largest
/// component 1.
template <class Scalar>
RotationRows<Scalar> rotation_of_cube(RootIndex root, const std::array<Scalar, 3>& a) {
  std::array<Scalar, 4> q;
  for (std::size_t component = 0, i = 0; component < 4; ++component)
    q[component] = component == root ? Scalar(1.0) : a[i++];
  const QuaternionRotation<Scalar> rotation(q);
  return rotation.rows(reciprocal(rotation.squared_norm(), 1.0));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_QUATERNION_CUBE_H
