// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_GRAPH_RECORD_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_GRAPH_RECORD_H

#include "aspects/file/byte_stream.h"
#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/aspect_graph.h"

#include <memory>

namespace parallel_aspects {

void write_graph(const AspectGraph& graph, ByteWriter& writer);

/// The graph that was written, of these aspects; null where it is not one of theirs: every id, leg, pose and
/// index is checked.
std::shared_ptr<const AspectGraph> read_graph(const AspectMap::Contents& map, ByteReader& reader);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_GRAPH_RECORD_H
