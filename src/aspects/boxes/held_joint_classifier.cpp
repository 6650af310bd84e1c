// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/held_joint_classifier.h"

#include "aspects/boxes/chart_classifier.h"
#include "aspects/boxes/held_joint_chart.h"

namespace parallel_aspects {

std::unique_ptr<const BoxClassifier> make_held_joint_classifier(const Manipulator& manipulator,
                                                                const std::vector<WorkingMode>& modes,
                                                                const MapSlice& slice,
                                                                const BoxPolicy& policy) {
  return std::make_unique<const ChartClassifier<HeldJointChart>>(manipulator, modes, policy, slice);
}

}  // namespace parallel_aspects
