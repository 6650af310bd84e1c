// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/singular_everywhere.h"

#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/closing/platform_freedom.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr int starts_of_poses = 24;
constexpr std::size_t most_poses = 12, least_poses = 6;

// Elsewhere mobility beyond that of the platform is a fault of its own.
constexpr std::size_t drives_of_spinning_rods = 6;

// Of an assembled robot in one pose.
class DriveOfPlatform {
 public:
  DriveOfPlatform(const ClosureSystem& system, const ActuatedJoints& joints, const SourceNames& files)
      : system_(system), joints_(joints), files_(files) {}

  // Whether each leg has its actuated joint, all of these move, and the platform in as many ways; but some of
  // them with all actuated joints locked.
  bool is_lost(const Eigen::VectorXd& values) const {
    const LoopMotions loops = loop_motions(system_, values);
    const std::size_t count = joints_.variables.size();
    const bool has_idle = loops.motions.cols() > static_cast<Eigen::Index>(count);
    if (has_idle && count != drives_of_spinning_rods) return false;
    if (!platform_freedom(system_, {values, loops.motions, 0.0}, joints_.platform_link, count).is_full(count))
      return false;
    const Eigen::MatrixXd rates = actuated_rates(system_, loops.motions, joints_.variables);
    const bool all_move = rates.rowwise().norm().minCoeff() > velocity_tolerance;
    return all_move && singular_values(rates).minCoeff() < rank_tolerance && has_legs(values);
  }

 private:
  bool has_legs(const Eigen::VectorXd& values) const {
    const std::vector<bool> none(system_.in_loop().size(), false);
    Problems problems;
    return find_legs({system_, values, none}, joints_, files_, problems).legs.size() ==
               joints_.variables.size() &&
           problems.empty();
  }

  const ClosureSystem& system_;
  const ActuatedJoints& joints_;
  const SourceNames& files_;
};

}  // namespace

std::optional<std::string> singular_everywhere(const std::shared_ptr<const Tree>& tree,
                                               const ResolvedConfig& resolved, const SourceNames& files) {
  const ActuatedJoints& joints = resolved.actuated_joints;
  if (joints.variables.size() < 2) return std::nullopt;
  const ClosureSystem system(tree, resolved.base, with_type(resolved.closures, ClosureType::point));
  const DriveOfPlatform drive(system, joints, files);
  const auto poses = closed_configurations(system, starts_of_poses, most_poses);
  if (poses.size() < least_poses ||
      !std::all_of(poses.begin(), poses.end(), [&](const auto& values) { return drive.is_lost(values); }))
    return std::nullopt;
  return files.urdf + " is assembled, but singular in every pose: det A is zero to rounding in all " +
         std::to_string(poses.size()) +
         " random poses that were tried, so that its actuated joints never hold " +
         operational_point_text(*tree, joints.platform_link, files) +
         "; change the places of the joints on base or platform, which are, for instance, two similar "
         "hexagons joined corner to corner, or struts that stay parallel.";
}

}  // namespace parallel_aspects
