// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <cstdint>
#include <cstdlib>
#include <string>

// A URDF and a YAML file in one input, with this line between them.
namespace {

constexpr const char* separator = "\n%%%%\n";

using parallel_aspects::InverseSolution;
using parallel_aspects::Mechanism;

// What is accepted can be used: every solution at the pose that the mechanism was recognised in is completed.
void use(const Mechanism& mechanism) {
  const auto assembled = mechanism.assembled();
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism.joint_names().size()));
  if (!mechanism.complete(assembled.pose, assembled.q, positions)) std::abort();
  for (const InverseSolution& solution : inverse_in_all_modes(*mechanism.manipulator(), assembled.pose))
    if (solution.q.size() > 0) mechanism.complete(assembled.pose, solution.q, positions);
}

}  // namespace

// A mechanism comes back, or messages do; anything else thrown ends the program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = text.find(separator);
  const std::string urdf = text.substr(0, cut);
  const std::string config = cut == std::string::npos ? "" : text.substr(cut + std::string(separator).size());
  try {
    use(*parallel_aspects::load_mechanism(urdf, "robot.urdf", config, "robot.yaml"));
  } catch (const parallel_aspects::InvalidDescription& invalid) {
    for (const std::string& problem : invalid.problems())
      if (problem.empty()) std::abort();
  }
  return 0;
}
