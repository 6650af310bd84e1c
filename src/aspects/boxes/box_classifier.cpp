// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"

#include "aspects/boxes/chart_classifier.h"
#include "aspects/boxes/charts.h"
#include "aspects/boxes/hinge_chart.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>

namespace parallel_aspects {

LeafState BoxClassifier::state(RootIndex root, const Box& box, std::size_t mode) const noexcept {
  std::array<LeafState, most_modes> states;
  classify(root, box, ModeSet{1} << mode, Detail::states, states.data());
  return states[mode];
}

std::unique_ptr<const BoxClassifier> make_box_classifier(const Manipulator& manipulator,
                                                         const std::vector<WorkingMode>& modes,
                                                         const BoxPolicy& policy) {
  switch (manipulator.task_space()) {
    case TaskSpace::T1:
      return std::make_unique<const ChartClassifier<T1Chart>>(manipulator, modes, policy);
    case TaskSpace::T2:
      return std::make_unique<const ChartClassifier<T2Chart>>(manipulator, modes, policy);
    case TaskSpace::SE2:
      return std::make_unique<const ChartClassifier<SE2Chart>>(manipulator, modes, policy);
    case TaskSpace::T3:
      return std::make_unique<const ChartClassifier<T3Chart>>(manipulator, modes, policy);
    case TaskSpace::SO3:
      return std::make_unique<const ChartClassifier<SO3Chart>>(manipulator, modes, policy);
    case TaskSpace::R1:
      return std::make_unique<const ChartClassifier<R1Chart>>(manipulator, modes, policy);
    case TaskSpace::R2:
      return std::make_unique<const ChartClassifier<R2Chart>>(manipulator, modes, policy);
    case TaskSpace::SE3:
      break;
  }
  return nullptr;
}

}  // namespace parallel_aspects
