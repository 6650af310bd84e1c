// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/dialects/closure_dialects.h"

#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <array>

namespace parallel_aspects {
namespace {

// The first link above, itself included, that a movable joint carries.
std::size_t carried_link(const Tree& tree, std::size_t link) {
  for (auto joint = tree.joint_above[link]; joint && tree.joints[*joint].motion == JointMotion::fixed;
       joint = tree.joint_above[link])
    link = tree.joints[*joint].parent;
  return link;
}

// Simulators are told in the same way to hold a base in the world.
bool closes_no_loop(const Tree& tree, const Closure& closure) {
  return carried_link(tree, closure.frames[0].link) == carried_link(tree, closure.frames[1].link);
}

// Robots are closed with fixed joints that could not move otherwise.
void take_as_weld(Closure& closure) {
  const bool rigid = closure.type == ClosureType::fixed;
  if (!rigid) closure.weld = Weld::none;
  if (rigid && closure.weld == Weld::none) closure.weld = Weld::at_frames;
  if (rigid) closure.type = ClosureType::automatic;
}

}  // namespace

const std::vector<ClosureDialect>& closure_dialects() {
  static const std::vector<ClosureDialect> dialects{
      {"<gazebo><joint>", dialects::gazebo_joint},
      {"closing frames", dialects::closing_frames},
      {"closed_loop", dialects::gepetto_file},
      {"<constraint>", dialects::constraint_element},
      {"DetachableJoint", dialects::detachable_joint},
      {"<loop_joint>", dialects::loop_joint},
      {"<drake:ball_constraint>", dialects::drake_ball_constraint},
  };
  return dialects;
}

FoundLoops find_described_loops(const LoopSource& source, Problems& problems) {
  for (const ClosureDialect& dialect : closure_dialects()) {
    const std::size_t before = problems.size();
    DescribedLoops loops = dialect.read(source, problems);
    loops.closures.erase(
        std::remove_if(loops.closures.begin(), loops.closures.end(),
                       [&](const Closure& closure) { return closes_no_loop(source.tree, closure); }),
        loops.closures.end());
    std::for_each(loops.closures.begin(), loops.closures.end(), take_as_weld);
    if (!loops.closures.empty() || problems.size() > before) return {dialect.name, loops};
  }
  return {};
}

std::optional<std::size_t> described_link(const LoopSource& source, const std::string& name,
                                          const std::string& where, Problems& problems) {
  // Simulators write MODEL::LINK.
  const auto scope = name.rfind("::");
  const std::string link = scope == std::string::npos ? name : name.substr(scope + 2);
  const auto found = source.tree.link_named(link);
  if (!found)
    problems.push_back(where + " names link '" + link + "', but " + source.files.urdf + " has no such link" +
                       suggestion(link, source.tree.links, problems));
  return found;
}

std::optional<ClosureType> described_type(std::string name) noexcept {
  const std::string suffix = "_joint";
  if (name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
    name.resize(name.size() - suffix.size());
  constexpr std::array<std::pair<std::string_view, ClosureType>, 9> known{
      {{"revolute", ClosureType::revolute},
       {"continuous", ClosureType::revolute},
       {"hinge", ClosureType::revolute},
       {"ball", ClosureType::point},
       {"spherical", ClosureType::point},
       {"point", ClosureType::point},
       {"universal", ClosureType::universal},
       {"fixed", ClosureType::fixed},
       {"weld", ClosureType::fixed}}};
  for (const auto& [word, type] : known)
    if (word == name) return type;
  return std::nullopt;
}

Poses poses_at_zero(const Tree& tree) { return link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables())); }

Closure closed_at_zero(const Poses& poses, const std::string& name, std::size_t parent,
                       const LinkFrame& child, ClosureType type) {
  const LinkFrame in_parent{parent, poses[parent].inverse() * poses[child.link] * child.in_link};
  return {name, {in_parent, child}, type, Weld::none, Eigen::Isometry3d::Identity()};
}

}  // namespace parallel_aspects
