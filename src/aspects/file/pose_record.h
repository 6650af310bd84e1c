// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_POSE_RECORD_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_POSE_RECORD_H

#include "aspects/file/byte_stream.h"
#include "model/coefficients.h"
#include "parallel_aspects/model/pose.h"

#include <cmath>
#include <cstddef>

namespace parallel_aspects {

inline constexpr std::size_t pose_size = 7 * sizeof(double);

inline void write_pose(const Pose& pose, ByteWriter& writer) {
  for (const double each : coefficients_of(pose.position)) writer.put_double(each);
  for (const double each : coefficients_of(pose.orientation.coeffs())) writer.put_double(each);
}

/// False where what was read is no pose.
inline bool read_pose(ByteReader& reader, Pose& pose) {
  constexpr double unit_tolerance = 1e-6;
  for (double& each : coefficients_of(pose.position)) each = reader.take_double();
  for (double& each : coefficients_of(pose.orientation.coeffs())) each = reader.take_double();
  return pose.position.allFinite() && std::abs(pose.orientation.norm() - 1.0) < unit_tolerance;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_POSE_RECORD_H
