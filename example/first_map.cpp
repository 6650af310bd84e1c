// SPDX-License-Identifier: BSD-3-Clause
#include <parallel_aspects/parallel_aspects.h>

#include <iostream>

int main() {
  const auto robot = parallel_aspects::models::five_bar();  // or load_mechanism_files("my.urdf", "my.yaml")
  const auto result = compute_aspect_map(robot->manipulator());
  if (!result) return 1;  // result.message says why
  for (const parallel_aspects::Aspect& aspect : result.map->aspects())
    std::cout << aspect.id << ' ' << to_string(aspect.mode) << ' ' << aspect.measure << '\n';
  const auto pose = parallel_aspects::Pose::planar(4.5, 8.0);
  const auto mode = parallel_aspects::WorkingMode::from_signs({1, -1});
  if (const auto found = result.map->locate(pose, *mode))
    std::cout << "(4.5, 8) is in aspect " << found.aspect << '\n';
}
