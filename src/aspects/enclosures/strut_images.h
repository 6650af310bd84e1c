// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_STRUT_IMAGES_H
#define PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_STRUT_IMAGES_H

#include "aspects/cusps/strut_slice.h"
#include "aspects/enclosures/singular_images.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <optional>

namespace parallel_aspects {

/// The parallel singularities D = 0 of three struts, in one slice or in a family of slices; strips are of
/// (g_0, g_1, g_2), half the squares of the lengths.
class StrutImages : public SingularImages {
 public:
  /// The slice must outlive it.
  explicit StrutImages(const StrutSlice& slice);

 private:
  std::optional<ImageStrip> strip_of(const Box& box, Surface surface) const override;
  double half_turn(Surface /*parallel*/) const override { return pi * slice_.rod().upper(); }

  const StrutSlice& slice_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ENCLOSURES_STRUT_IMAGES_H
