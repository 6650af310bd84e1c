// SPDX-License-Identifier: BSD-3-Clause
// Lists the aspects of a robot, and says in which of them it is at a pose: list_aspects URDF YAML X Y
#include <parallel_aspects/aspects/aspect_map.h>
#include <parallel_aspects/kinematics/kinematics.h>
#include <parallel_aspects/model/problems.h>
#include <parallel_aspects/urdf/mechanism.h>

#include <cstdlib>
#include <iostream>

namespace {

void list_aspects(const parallel_aspects::AspectMap& map) {
  for (const parallel_aspects::Aspect& aspect : map.aspects())
    std::cout << "aspect " << aspect.id << ": working mode " << to_string(aspect.mode) << ", det A "
              << (aspect.determinant_sign > 0 ? "+" : "-") << ", measure " << aspect.measure << '\n';
  std::cout << map.proved_count() << " proved distinct\n";
}

void locate_in_every_mode(const parallel_aspects::AspectMap& map, const parallel_aspects::Pose& pose) {
  for (const auto& solution : inverse_in_all_modes(*map.manipulator(), pose)) {
    const parallel_aspects::Location location = map.locate(pose, solution.mode);
    std::cout << to_string(solution.mode) << ": " << name(solution.status);
    if (location) std::cout << ", aspect " << location.aspect;
    std::cout << '\n';
  }
}

int run(char** argv) {
  const auto mechanism = parallel_aspects::load_mechanism_files(argv[1], argv[2]);
  const parallel_aspects::MapResult result = compute_aspect_map(mechanism->manipulator());
  if (!result) {
    std::cerr << result.message << '\n';
    return EXIT_FAILURE;
  }
  list_aspects(*result.map);
  locate_in_every_mode(*result.map, parallel_aspects::Pose::planar(std::atof(argv[3]), std::atof(argv[4])));
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: list_aspects URDF YAML X Y\n";
    return EXIT_FAILURE;
  }
  try {
    return run(argv);
  } catch (const parallel_aspects::InvalidDescription& invalid) {
    std::cerr << invalid.what() << '\n';  // every problem, a line each
    return EXIT_FAILURE;
  }
}
