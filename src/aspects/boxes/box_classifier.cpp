// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_classifier.h"

#include "aspects/boxes/chart_classifier.h"
#include "aspects/boxes/charts.h"

#include <array>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_modes = 64;  // the bits of a ModeSet

}  // namespace

LeafState BoxClassifier::state(RootIndex root, const Box& box, std::size_t mode) const noexcept {
  std::array<LeafState, max_modes> states;
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
    case TaskSpace::SE3:
      break;
  }
  return nullptr;
}

}  // namespace parallel_aspects
