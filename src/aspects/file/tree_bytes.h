// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_TREE_BYTES_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_TREE_BYTES_H

#include "aspects/file/byte_stream.h"
#include "aspects/tree/pose_tree.h"

namespace parallel_aspects {

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_TREE_BYTES_H
