// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/box_classifier.h"

#include "parallel_aspects/aspects/t2_classifier.h"

namespace parallel_aspects {

std::unique_ptr<const BoxClassifier> make_box_classifier(const Manipulator& manipulator,
                                                         const std::vector<WorkingMode>& modes) {
  switch (manipulator.task_space()) {
    case TaskSpace::T2:
      return std::make_unique<const T2Classifier>(manipulator, modes);
    case TaskSpace::SE2:
    case TaskSpace::T3:
    case TaskSpace::SO3:
    case TaskSpace::SE3:
      break;
  }
  return nullptr;
}

}  // namespace parallel_aspects
