// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "urdf/closing/freedom.h"
#include "urdf/corrections/edit.h"
#include "urdf/corrections/edits.h"
#include "urdf/description/name_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

bool is_sdf(const ResolvedConfig& resolved) { return resolved.closure_dialect == "<gazebo><joint>"; }

constexpr double other_axis = 0.01;        // sine of the angle to the axis that is stated, at least
constexpr double axis_decimal = 1e-6;      // to which axes are printed
constexpr double along_coordinate = 1e-4;  // what rounding of a file leaves of coordinates that are zero

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

// That the links of a closure turn about, in the frame of each.
struct ClosureAxis {
  std::size_t closure = 0;
  std::array<Vector3d, 2> directions;
};

// Its largest coordinate is positive.
Vector3d upright(Vector3d axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] < 0.0) axis = -axis;
  if (axis.cross(Vector3d::Unit(largest)).norm() < along_coordinate) return Vector3d::Unit(largest);
  return (axis / axis_decimal).array().round().matrix() * axis_decimal;
}

// Along one line, either way; nothing where they turn about none, or several.
std::optional<std::array<Vector3d, 2>> axis_of(const ClosureSystem& system, const Assembly& assembly,
                                               const std::array<LinkFrame, 2>& frames) {
  const Poses poses = link_poses(system.tree(), system.base(), assembly.values);
  const Eigen::MatrixXd axes = axes_between(system, poses, assembly.motions, frames);
  if (axes.cols() != 1) return std::nullopt;
  const auto seen_from = [&](std::size_t link) -> Vector3d {
    return poses[link].linear().transpose() * axes.col(0);
  };
  return std::array<Vector3d, 2>{upright(seen_from(frames[0].link)), upright(seen_from(frames[1].link))};
}

// Of the revolute closures of a group: those that are not as stated; none where the links of one turn about
// no single axis.
std::vector<ClosureAxis> other_axes(const Subject& s, const Group& group) {
  std::vector<Closure> closures = s.resolved.closures;
  for (const std::size_t k : group)
    if (closures[k].type == ClosureType::revolute) closures[k].type = ClosureType::point;
  const ClosureSystem balls(s.shared_tree, s.resolved.base, with_type(closures, ClosureType::point));
  const auto& joints = s.resolved.actuated_joints;
  const auto assembly = assemble(balls, joints.variables, joints.platform_link).assembly;
  if (!assembly) return {};
  std::vector<ClosureAxis> others;
  for (const std::size_t k : group) {
    const Closure& closure = s.resolved.closures[k];
    if (closure.type != ClosureType::revolute) continue;
    const auto axis = axis_of(balls, *assembly, closure.frames);
    if (!axis) return {};
    const auto is_other = [&](std::size_t end) {
      return (*axis)[end].cross(closure.frames[end].in_link.linear().col(2)).norm() > other_axis;
    };
    if (is_other(0) || is_other(1)) others.push_back({k, *axis});
  }
  return others;
}

// With their z along it. SDF has the axis in the second link, and at zero in the first.
std::array<LinkFrame, 2> turned(const Subject& s, const ClosureAxis& axis, std::array<LinkFrame, 2> frames) {
  for (const std::size_t end : {0, 1})
    frames[end].in_link.linear() =
        shortest_rotation(Vector3d::UnitZ(), axis.directions[end]).toRotationMatrix();
  if (!is_sdf(s.resolved)) return frames;
  const Poses poses = link_poses(s.tree, 0, Eigen::VectorXd::Zero(s.tree.variables()));
  frames[0].in_link.linear() = poses[frames[0].link].linear().transpose() * poses[frames[1].link].linear() *
                               frames[1].in_link.linear();
  return frames;
}

}  // namespace

Edits axes_of_like_closures(const Subject& subject) {
  const std::vector<Closure>& closures = subject.resolved.closures;
  Edits found;
  for (const Group& group : groups_of(closures)) {
    Edit edit{"closures", "", "", {}, true};
    std::vector<Closure> changed = closures;
    Group others;
    std::string axes;
    for (const ClosureAxis& axis : other_axes(subject, group)) {
      const auto frames = turned(subject, axis, closures[axis.closure].frames);
      changed[axis.closure].frames = frames;
      for (const std::size_t end : {0, 1})
        edit.changes.emplace_back(FrameChange{axis.closure, end, frames[end]});
      axes += (others.empty() ? "<axis><xyz expressed_in=\"" : ", <axis><xyz expressed_in=\"") +
              subject.tree.links[frames[1].link] + "\">" + as_attribute(axis.directions[1]) +
              "</xyz></axis> for '" + closures[axis.closure].name + "'";
      others.push_back(axis.closure);
    }
    // One alone may be the fault of a joint beside it.
    const bool are_all = others.size() > 1 && others.size() == group.size();
    if (others.empty() || !(is_sdf(subject.resolved) || are_all)) continue;
    edit.remedy =
        "write " +
        (is_sdf(subject.resolved) ? axes : closures_entry(subject.tree, changed, subject.files).text());
    edit.fault = (is_sdf(subject.resolved) ? subject.files.urdf : subject.file()) + " states axes for " +
                 names_of(closures, others) + " about which their links do not turn";
    found.push_back(std::move(edit));
  }
  return found;
}

Edits points_for_all_closures(const Subject& subject) {
  const std::vector<Closure>& closures = subject.resolved.closures;
  const std::string& dialect = subject.resolved.closure_dialect;
  const ClosureType type = closures.front().type;
  const bool have_one_type = std::all_of(closures.begin(), closures.end(),
                                         [&](const Closure& closure) { return closure.type == type; });
  if (closures.size() < 3 || !have_one_type || type == ClosureType::automatic || type == ClosureType::point)
    return {};
  Edits found;
  for (const Group& group : groups_of(closures)) {
    Edit edit{
        "closures",
        subject.file() + " closes loops of " + subject.files.urdf + " by types that do not fit its joints",
        "write " + type_text(subject.resolved, ClosureType::point) + " for " + names_of(closures, group) +
            " in " + (dialect.empty() ? subject.files.full_key("closures") : dialect),
        {},
        false};
    for (const std::size_t k : group) edit.changes.emplace_back(TypeChange{k, ClosureType::point});
    found.push_back(std::move(edit));
  }
  return found;
}

}  // namespace parallel_aspects
