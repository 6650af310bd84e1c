// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_SYMMETRIC_REGION_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_SYMMETRIC_REGION_H

#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects {

/// The `exact_region` of positions; where one about the middle of the legs is next to nothing larger, and
/// more symmetries of the manipulator take it onto itself, that one, whose corners are as exact. Else
/// symmetries about any other point than the origin would hang on how its coordinates are rounded. `exact`:
/// the `exact_region` of `positions`.
Box symmetric_region(const Manipulator& manipulator, const Box& positions, const Box& exact);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_SYMMETRIC_REGION_H
