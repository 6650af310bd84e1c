// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_RANDOM_PATH_END_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_RANDOM_PATH_END_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/motion/plan_path.h"

#include <cstddef>
#include <random>

namespace parallel_aspects::test {

inline const Aspect& random_aspect(const AspectMap& map, std::mt19937_64& random) {
  return map.aspects()[random() % map.aspects().size()];
}

/// The middle of a random inside leaf.
inline PathEnd random_path_end(const AspectMap& map, const Aspect& aspect, std::mt19937_64& random) {
  PathEnd end;
  end.mode = aspect.mode;
  std::size_t wanted = random() % aspect.inside_leaves;
  map.visit_inside_poses(aspect.id, [&](const Pose& pose, double) {
    if (wanted-- == 0) end.pose = pose;
  });
  return end;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_RANDOM_PATH_END_H
