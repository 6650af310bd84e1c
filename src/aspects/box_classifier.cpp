// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/box_classifier.h"

#include "parallel_aspects/aspects/chart_classifier.h"
#include "parallel_aspects/aspects/charts.h"

namespace parallel_aspects {

std::unique_ptr<const BoxClassifier> make_box_classifier(const Manipulator& manipulator,
                                                         const std::vector<WorkingMode>& modes) {
  switch (manipulator.task_space()) {
    case TaskSpace::T1:
      return std::make_unique<const ChartClassifier<T1Chart>>(manipulator, modes);
    case TaskSpace::T2:
      return std::make_unique<const ChartClassifier<T2Chart>>(manipulator, modes);
    case TaskSpace::SE2:
      return std::make_unique<const ChartClassifier<SE2Chart>>(manipulator, modes);
    case TaskSpace::T3:
      return std::make_unique<const ChartClassifier<T3Chart>>(manipulator, modes);
    case TaskSpace::SO3:
      return std::make_unique<const ChartClassifier<SO3Chart>>(manipulator, modes);
    case TaskSpace::SE3:
      break;
  }
  return nullptr;
}

}  // namespace parallel_aspects
