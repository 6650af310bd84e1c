// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_MAP_RECORD_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_MAP_RECORD_H

#include "aspects/file/bytes.h"
#include "aspects/map/map_contents.h"
#include "aspects/map/map_plan.h"

#include <memory>

namespace parallel_aspects {

/// Appends what the computation of a map found: all of the contents that does not follow from its plan.
void write_record(const AspectMap::Contents& map, ByteWriter& writer);

/// The contents that were written, of the same manipulator and plan; null where the record is not that of a
/// map: every count, index and state is checked.
std::unique_ptr<const AspectMap::Contents> read_record(std::shared_ptr<const Manipulator> manipulator,
                                                       MapPlan plan, ByteReader& reader);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_MAP_RECORD_H
