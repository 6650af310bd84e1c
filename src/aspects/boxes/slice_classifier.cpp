// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/chart_classifier.h"
#include "aspects/boxes/held_joint_chart.h"
#include "aspects/boxes/slice_chart.h"
#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects {
namespace {

using Modes = std::vector<WorkingMode>;
using Classifier = std::unique_ptr<const BoxClassifier>;

template <class Chart>
Classifier make(const Manipulator& manipulator, const Modes& modes, const MapSlice& slice,
                const BoxPolicy& policy) {
  return std::make_unique<const ChartClassifier<Chart>>(manipulator, modes, policy, slice);
}

Classifier make_for_three_legs(const Manipulator& manipulator, const Modes& modes, const MapSlice& slice,
                               const BoxPolicy& policy) {
  const bool is_line = slice.dimension() == 1;
  if (is_planar(manipulator.task_space()))
    return is_line ? make<SliceChart<3, 1, 2>>(manipulator, modes, slice, policy)
                   : make<SliceChart<3, 2, 2>>(manipulator, modes, slice, policy);
  return is_line ? make<SliceChart<3, 1>>(manipulator, modes, slice, policy)
                 : make<SliceChart<3, 2>>(manipulator, modes, slice, policy);
}

Classifier make_for_six_legs(const Manipulator& manipulator, const Modes& modes, const MapSlice& slice,
                             const BoxPolicy& policy) {
  if (slice.rotation == MapSlice::Rotation::freely)
    return make<OrientationChart>(manipulator, modes, slice, policy);
  switch (slice.dimension()) {
    case 1:
      return make<SliceChart<6, 1>>(manipulator, modes, slice, policy);
    case 2:
      return make<SliceChart<6, 2>>(manipulator, modes, slice, policy);
    default:
      return make<SliceChart<6, 3>>(manipulator, modes, slice, policy);
  }
}

}  // namespace

Classifier make_slice_classifier(const Manipulator& manipulator, const Modes& modes, const MapSlice& slice,
                                 const BoxPolicy& policy) {
  if (slice.joint) return make_held_joint_classifier(manipulator, modes, slice, policy);
  switch (manipulator.leg_count()) {
    case 2:
      return make<SliceChart<2, 1, 2>>(manipulator, modes, slice, policy);
    case 3:
      return make_for_three_legs(manipulator, modes, slice, policy);
    case 6:
      return make_for_six_legs(manipulator, modes, slice, policy);
    default:
      return nullptr;
  }
}

}  // namespace parallel_aspects
