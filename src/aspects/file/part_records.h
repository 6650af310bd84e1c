// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_PART_RECORDS_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_PART_RECORDS_H

#include "aspects/file/bytes.h"
#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_tree.h"
#include "model/linear_algebra.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/model/pose.h"

#include <cmath>
#include <cstddef>
#include <memory>

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

inline void put_tree(const TreeRecord& record, ByteWriter& writer) {
  writer.put_u32(static_cast<std::uint32_t>(record.parents.size()));
  for (const NodeIndex parent : record.parents) writer.put_u32(parent);
  writer.put_u32(static_cast<std::uint32_t>(record.states.size()));
  writer.put_bytes(record.states);
}

/// The reader is not ok where no record follows.
inline TreeRecord take_tree(ByteReader& reader) {
  TreeRecord record;
  record.parents.resize(reader.take_count(index_size));
  for (NodeIndex& parent : record.parents) parent = reader.take_u32();
  record.states = reader.take_bytes(reader.take_count(1));
  return record;
}

void write_graph(const AspectGraph& graph, ByteWriter& writer);

/// The graph that was written, of these aspects; null where it is not one of theirs: every id, leg, pose and
/// index is checked.
std::shared_ptr<const AspectGraph> read_graph(const AspectMap::Contents& map, ByteReader& reader);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_PART_RECORDS_H
