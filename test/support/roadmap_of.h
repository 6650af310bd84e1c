// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROADMAP_OF_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROADMAP_OF_H

#include "parallel_aspects/aspects/pose_roadmap.h"

#include "support/thoroughness.h"
#include <memory>
#include <vector>

namespace parallel_aspects::test {

/// A roadmap of the working modes that a few questions need is enough.
inline std::shared_ptr<const PoseRoadmap> roadmap_of(const std::shared_ptr<const Manipulator>& robot,
                                                     const std::vector<WorkingMode>& modes,
                                                     std::size_t samples) {
  RoadmapOptions options;
  options.samples = is_sanitized ? samples / 4 : samples;
  options.modes = modes;
  return compute_pose_roadmap(robot, options).roadmap;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROADMAP_OF_H
