// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_HELD_JOINT_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_HELD_JOINT_CLASSIFIER_H

#include "aspects/boxes/box_classifier.h"

#include <memory>
#include <vector>

namespace parallel_aspects {

/// The classifier for a slice that holds a joint (see `find_slice_problem`), in the coordinates of
/// `make_held_joint_space`.
std::unique_ptr<const BoxClassifier> make_held_joint_classifier(const Manipulator& manipulator,
                                                                const std::vector<WorkingMode>& modes,
                                                                const MapSlice& slice,
                                                                const BoxPolicy& policy);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_HELD_JOINT_CLASSIFIER_H
