// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/like_closures.h"

#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/listed_corrections.h"
#include "urdf/description/name_words.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double other_axis = 0.01;    // sine of the angle to the axis that is stated, at least
constexpr double axis_decimal = 1e-6;  // to which axes are printed

using Group = std::vector<std::size_t>;  // of closures

// All, and those of each kind.
std::vector<Group> groups_of(const std::vector<Closure>& closures) {
  Group all(closures.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::map<std::string, Group> kinds;
  for (const std::size_t k : all) kinds[role_of(closures[k].name)].push_back(k);
  std::vector<Group> groups{all};
  for (auto& [role, group] : kinds)
    if (kinds.size() > 1 && group.size() > 1) groups.push_back(std::move(group));
  return groups;
}

std::string names_of(const std::vector<Closure>& closures, const Group& group) {
  std::string names;
  for (const std::size_t k : group) names += (names.empty() ? "'" : ", '") + closures[k].name + "'";
  return names;
}

// Of the second frame of a closure in its link.
struct ClosureAxis {
  std::size_t closure = 0;
  Vector3d direction;
};

// Axes of the revolute closures of a group.
class AxesFinder {
 public:
  AxesFinder(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved)
      : tree_(tree), resolved_(resolved) {}

  // Those that are not as stated; none where the links of one turn about no single axis.
  std::vector<ClosureAxis> find(const Group& group) const {
    std::vector<Closure> closures = resolved_.closures;
    for (const std::size_t k : group)
      if (closures[k].type == ClosureType::revolute) closures[k].type = ClosureType::point;
    const ClosureSystem balls(tree_, resolved_.base, with_type(closures, ClosureType::point));
    const auto& joints = resolved_.actuated_joints;
    const auto assembly = assemble(balls, joints.variables, joints.platform_link).assembly;
    if (!assembly) return {};
    std::vector<ClosureAxis> others;
    for (const std::size_t k : group) {
      if (resolved_.closures[k].type != ClosureType::revolute) continue;
      const auto axis = axis_of(balls, *assembly, resolved_.closures[k].frames);
      if (!axis) return {};
      const Vector3d stated = resolved_.closures[k].frames[1].in_link.linear().col(2);
      if (axis->cross(stated).norm() > other_axis) others.push_back({k, *axis});
    }
    return others;
  }

 private:
  std::optional<Vector3d> axis_of(const ClosureSystem& system, const Assembly& assembly,
                                  const std::array<LinkFrame, 2>& frames) const {
    const Poses poses = link_poses(*tree_, resolved_.base, assembly.values);
    const auto turning = [&](std::size_t link) {
      return link_twists(system, poses, link, assembly.motions).topRows<3>().eval();
    };
    const auto svd = singular_value_decomposition(turning(frames[1].link) - turning(frames[0].link));
    if (svd.rank_above(velocity_tolerance) != 1) return std::nullopt;
    return rounded(poses[frames[1].link].linear().transpose() * svd.u.col(0));
  }

  // Its largest coordinate is positive.
  static Vector3d rounded(Vector3d axis) {
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    if (axis[largest] < 0.0) axis = -axis;
    return (axis / axis_decimal).array().round().matrix() * axis_decimal;
  }

  const std::shared_ptr<const Tree>& tree_;
  const ResolvedConfig& resolved_;
};

// At zero, where SDF has the axis of a joint.
void turn(const Tree& tree, const ClosureAxis& axis, Closure& closure) {
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  auto& [first, second] = closure.frames;
  second.in_link.linear() = shortest_rotation(Vector3d::UnitZ(), axis.direction).toRotationMatrix();
  first.in_link.linear() =
      poses[first.link].linear().transpose() * poses[second.link].linear() * second.in_link.linear();
}

std::string remedy_of(const Tree& tree, const std::vector<Closure>& closures,
                      const std::vector<ClosureAxis>& axes) {
  std::string text;
  for (const ClosureAxis& axis : axes)
    text += (text.empty() ? "write <axis><xyz expressed_in=\"" : ", <axis><xyz expressed_in=\"") +
            tree.links[closures[axis.closure].frames[1].link] + "\">" + as_attribute(axis.direction) +
            "</xyz></axis> for '" + closures[axis.closure].name + "'";
  return text;
}

}  // namespace

Corrections axes_of_like_closures(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                  const SourceNames& files) {
  if (resolved.closure_dialect != "<gazebo><joint>") return {};
  Corrections found;
  for (const Group& group : groups_of(resolved.closures)) {
    const std::vector<ClosureAxis> axes = AxesFinder(tree, resolved).find(group);
    if (axes.empty()) continue;
    Group turned;
    for (const ClosureAxis& axis : axes) turned.push_back(axis.closure);
    const std::string names = names_of(resolved.closures, turned);
    found.push_back(
        {"closures", files.urdf + " states axes for " + names + " about which their links do not turn",
         remedy_of(*tree, resolved.closures, axes), true, [axes](Tree& changed, ResolvedConfig& config) {
           for (const ClosureAxis& axis : axes) turn(changed, axis, config.closures[axis.closure]);
         }});
  }
  return found;
}

Corrections types_of_like_closures(const ResolvedConfig& resolved, ClosureType type,
                                   const SourceNames& files) {
  const std::vector<Closure>& closures = resolved.closures;
  Corrections found;
  for (Group group : groups_of(closures)) {
    const auto is_as_it_is = [&](std::size_t k) {
      return closures[k].type == ClosureType::automatic || closures[k].type == type;
    };
    group.erase(std::remove_if(group.begin(), group.end(), is_as_it_is), group.end());
    if (group.empty()) continue;
    found.push_back(
        {"closures",
         file_of_closures(resolved, files) + " closes loops of " + files.urdf +
             " by types that do not fit its joints",
         "write " + type_text(resolved, type) + " for " + names_of(closures, group) + " in " +
             (resolved.closure_dialect.empty() ? files.full_key("closures") : resolved.closure_dialect),
         false, [group, type](Tree&, ResolvedConfig& config) {
           for (const std::size_t k : group) config.closures[k].type = type;
         }});
  }
  return found;
}

}  // namespace parallel_aspects
