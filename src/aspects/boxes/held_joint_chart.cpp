// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/held_joint_chart.h"

#include "aspects/boxes/chart_classifier.h"

namespace parallel_aspects {
namespace {

Planar<Interval> difference(const Planar<Interval>& a, const Planar<Interval>& b) {
  return {a.x - b.x, a.y - b.y};
}

}  // namespace

HeldJointChart::HeldJointChart(const Manipulator& manipulator, const MapSlice& slice)
    : PlanarLegs(manipulator),
      held_(slice.joint->leg),
      held_leg_(manipulator.leg(held_), slice.joint->value, manipulator.constraints().margins.serial) {
  for (std::size_t j = 0; j < leg_count; ++j) {
    const Eigen::Vector3d& anchor = manipulator.leg(j).anchor;
    anchors_[j] = {anchor.x(), anchor.y()};
  }
  for (std::size_t j = 0; j < leg_count; ++j) {
    from_held_anchor_[j] = difference(anchors_[j], anchors_[held_]);
    from_base_[j] = difference(held_leg_.center(), leg(j).base());
  }
}

std::unique_ptr<const BoxClassifier> make_held_joint_classifier(const Manipulator& manipulator,
                                                                const std::vector<WorkingMode>& modes,
                                                                const MapSlice& slice,
                                                                const BoxPolicy& policy) {
  return std::make_unique<const ChartClassifier<HeldJointChart>>(manipulator, modes, policy, slice);
}

}  // namespace parallel_aspects
