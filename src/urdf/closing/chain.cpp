// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/chain.h"

#include "model/message_text.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_chains = 16;    // of one leg; a Delta leg has two
constexpr std::size_t max_steps = 20000;  // on the path along them

// Sets of numbers that are joined pair by pair.
class Partition {
 public:
  explicit Partition(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t item) const {
    while (parent_[item] != item) item = parent_[item];
    return item;
  }
  void join(std::size_t one, std::size_t other) { parent_[find(one)] = find(other); }

 private:
  std::vector<std::size_t> parent_;
};

class LegFinder {
 public:
  LegFinder(const AssembledMechanism& mechanism, const ActuatedJoints& actuated_joints,
            const SourceNames& files, Problems& problems)
      : system_(mechanism.system),
        still_(mechanism.still),
        actuated_joints_(actuated_joints),
        files_(files),
        problems_(problems),
        bodies_(system_.tree().links.size()),
        parts_(system_.tree().links.size()) {
    const Poses poses = link_poses(system_.tree(), system_.base(), mechanism.values);
    join_rigid_links();
    base_ = bodies_.find(system_.base());
    platform_ = bodies_.find(actuated_joints.platform_link);
    operational_point_ = poses[actuated_joints.platform_link].translation();
    collect_joints(poses);
    collect_closures(poses);
    for (const Edge& edge : edges_)
      if (!ends_of_legs(edge.from) && !ends_of_legs(edge.to)) parts_.join(edge.from, edge.to);
  }

  FoundLegs find() {
    if (base_ == platform_) {
      problem("lets " + operational_point_text(system_.tree(), actuated_joints_.platform_link, files_) +
              " be fixed to the base link; name a link of the moving platform.");
      return {};
    }
    FoundLegs found;
    const auto joining = joining_parts();
    for (std::size_t k = 0; k < joining.size(); ++k) add_leg(joining, k, found);
    std::vector<LegChains>& legs = found.legs;
    check_actuated_joints_used(legs);
    const bool are_legs = problems_.empty();
    if (are_legs) check_lengths(legs);
    found.has_zero_length = are_legs && !problems_.empty();
    std::sort(legs.begin(), legs.end(),
              [](const auto& a, const auto& b) { return a.actuation < b.actuation; });
    return found;
  }

  std::vector<JoiningPart> parts() {
    std::vector<JoiningPart> result;
    if (base_ == platform_) return result;
    for (const std::vector<std::size_t>& part : joining_parts())
      result.push_back({chains_of(part), freedom_left({held_by(part)}), !actuated_joints_of(part).empty()});
    return result;
  }

  std::vector<std::vector<LegJoint>> joints() const {
    std::vector<std::vector<LegJoint>> result;
    for (const std::vector<std::size_t>& part : joining_parts()) result.push_back(joints_from_base(part));
    return result;
  }

 private:
  void problem(const std::string& text) { problems_.push_back(files_.config + " " + text); }
  bool ends_of_legs(std::size_t body) const { return body == base_ || body == platform_; }

  bool is_rigid(const TreeJoint& joint) const { return !joint.variable || still_[*joint.variable]; }

  void join_rigid_links() {
    for (const TreeJoint& joint : system_.tree().joints)
      if (is_rigid(joint)) bodies_.join(joint.parent, joint.child);
    for (const Closure& closure : system_.closures())
      if (closure.type == ClosureType::fixed) bodies_.join(closure.frames[0].link, closure.frames[1].link);
  }

  void collect_joints(const Poses& poses) {
    for (const TreeJoint& joint : system_.tree().joints) {
      if (is_rigid(joint)) continue;
      const Eigen::Isometry3d& pose = poses[joint.child];
      const PivotKind kind =
          joint.motion == JointMotion::prismatic ? PivotKind::prismatic : PivotKind::revolute;
      edges_.push_back(
          {bodies_.find(joint.parent),
           bodies_.find(joint.child),
           {{kind, joint.name, pose.translation(), pose.linear() * joint.axis, joint.variable, 1.0}}});
    }
  }

  void collect_closures(const Poses& poses) {
    for (const Closure& closure : system_.closures()) {
      if (closure.type == ClosureType::fixed) continue;
      const auto placed = [&](const LinkFrame& frame) { return poses[frame.link] * frame.in_link; };
      const Eigen::Isometry3d one = placed(closure.frames[0]), other = placed(closure.frames[1]);
      const PivotKind kind = closure.type == ClosureType::point ? PivotKind::ball : PivotKind::revolute;
      Chain pivots{{kind, closure.name, one.translation(), one.linear().col(2), std::nullopt, 1.0}};
      if (closure.type == ClosureType::universal)
        pivots.push_back({kind, closure.name, one.translation(), other.linear().col(0), std::nullopt, 1.0});
      edges_.push_back(
          {bodies_.find(closure.frames[0].link), bodies_.find(closure.frames[1].link), std::move(pivots)});
    }
  }

  // Edges by connected part of the mechanism without base and platform; an edge from base to platform is a
  // part itself.
  std::vector<std::vector<std::size_t>> parts() const {
    std::vector<std::vector<std::size_t>> result;
    std::vector<std::size_t> keys;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const std::size_t inner = ends_of_legs(edges_[k].from) ? edges_[k].to : edges_[k].from;
      const std::size_t key = ends_of_legs(inner) ? bodies_count() + k : parts_.find(inner);
      const auto known = std::find(keys.begin(), keys.end(), key);
      if (known == keys.end()) {
        keys.push_back(key);
        result.push_back({k});
      } else {
        result[static_cast<std::size_t>(known - keys.begin())].push_back(k);
      }
    }
    return result;
  }

  // Those that are in the loops.
  std::vector<std::vector<std::size_t>> joining_parts() const {
    std::vector<std::vector<std::size_t>> joining = parts();
    joining.erase(std::remove_if(joining.begin(), joining.end(),
                                 [this](const std::vector<std::size_t>& part) {
                                   return !touches(part, base_) || !touches(part, platform_);
                                 }),
                  joining.end());
    return joining;
  }

  std::size_t bodies_count() const { return system_.tree().links.size(); }

  bool touches(const std::vector<std::size_t>& part, std::size_t body) const {
    return std::any_of(part.begin(), part.end(),
                       [&](std::size_t k) { return edges_[k].from == body || edges_[k].to == body; });
  }

  std::string joints_of(const std::vector<std::size_t>& part) const {
    std::string text;
    for (const std::size_t k : part)
      if (edges_[k].pivots.front().variable)
        text += (text.empty() ? "'" : ", '") + edges_[k].pivots.front().name + "'";
    return text;
  }

  std::vector<std::size_t> actuated_joints_of(const std::vector<std::size_t>& part) const {
    std::vector<std::size_t> found;
    for (std::size_t j = 0; j < actuated_joints_.variables.size(); ++j)
      for (const std::size_t k : part)
        if (edges_[k].pivots.front().variable == actuated_joints_.variables[j]) found.push_back(j);
    return found;
  }

  // Bodies are passed in rounds, each one joint farther from the base.
  std::vector<LegJoint> joints_from_base(const std::vector<std::size_t>& part) const {
    std::map<std::size_t, std::size_t> depths{{base_, 0}};
    std::vector<LegJoint> joints;
    std::set<std::size_t> open(part.begin(), part.end());
    for (std::size_t depth = 0; !open.empty() && depth <= part.size(); ++depth)
      for (auto k = open.begin(); k != open.end();) {
        const Edge& edge = edges_[*k];
        const auto reached = [&](std::size_t body) {
          return depths.count(body) > 0 && depths[body] == depth;
        };
        const bool from = reached(edge.from), to = reached(edge.to);
        if (!from && !to) {
          ++k;
          continue;
        }
        depths.emplace(from ? edge.to : edge.from, depth + 1);
        if (edge.pivots.front().variable) joints.push_back({*edge.pivots.front().variable, depth});
        k = open.erase(k);
      }
    return joints;
  }

  void add_leg(const std::vector<std::vector<std::size_t>>& joining, std::size_t index, FoundLegs& legs) {
    const std::vector<std::size_t>& part = joining[index];
    const std::vector<std::size_t> found = actuated_joints_of(part);
    if (found.size() > 1) {
      problem("actuates " + std::to_string(found.size()) + " of the joints " + joints_of(part) +
              ", which share links between the base and the link of " +
              operational_point_text(system_.tree(), actuated_joints_.platform_link, files_) +
              "; a fully parallel robot has one actuated joint a leg, and its operational point on the body "
              "that all legs share.");
      return;
    }
    const std::vector<Chain> chains = chains_of(part);
    if (chains.size() < max_chains && steps_ < max_steps) {
      if (found.empty())
        legs.passive.push_back({chains, restricts(joining, index), freedom_left({held_by(part)}) == 6});
      else
        legs.legs.push_back({found.front(), chains});
      return;
    }
    problem("makes one leg of the joints " + joints_of(part) +
            ", which form too many loops to be followed; simplify the leg in " + files_.urdf + ".");
  }

  std::vector<Chain> chains_of(const std::vector<std::size_t>& part) {
    std::vector<Chain> chains;
    Chain chain;
    std::set<std::size_t> visited{base_};
    steps_ = 0;
    walk(part, base_, visited, chain, chains);
    return chains;
  }

  static void append(const Edge& edge, bool forward, Chain& chain) {
    const auto start = chain.insert(chain.end(), edge.pivots.begin(), edge.pivots.end());
    if (!forward) std::reverse(start, chain.end());
    for (auto pivot = start; pivot != chain.end(); ++pivot) pivot->sense = forward ? 1.0 : -1.0;
  }

  void walk(const std::vector<std::size_t>& part, std::size_t body, std::set<std::size_t>& visited,
            Chain& chain, std::vector<Chain>& chains) {
    if (body == platform_) chains.push_back(chain);
    if (body == platform_ || chains.size() >= max_chains || ++steps_ >= max_steps) return;
    for (const std::size_t k : part) {
      const Edge& edge = edges_[k];
      if (edge.from != body && edge.to != body) continue;
      const bool forward = edge.from == body;
      const std::size_t next = forward ? edge.to : edge.from;
      if (!visited.insert(next).second) continue;
      append(edge, forward, chain);
      walk(part, next, visited, chain, chains);
      chain.resize(chain.size() - edge.pivots.size());
      visited.erase(next);
    }
  }

  TwistMatrix held_by(const std::vector<std::size_t>& part) const {
    std::vector<Edge> edges;
    for (const std::size_t k : part) edges.push_back(edges_[k]);
    return held_twists(edges, base_, platform_, system_.size());
  }

  // Whether the platform could move in more ways without one of the parts that join it to the base.
  bool restricts(const std::vector<std::vector<std::size_t>>& joining, std::size_t part) const {
    std::vector<TwistMatrix> all, others;
    for (std::size_t k = 0; k < joining.size(); ++k) {
      all.push_back(held_by(joining[k]));
      if (k != part) others.push_back(all.back());
    }
    return freedom_left(all) < freedom_left(others);
  }

  void check_actuated_joints_used(const std::vector<LegChains>& legs) {
    if (!problems_.empty()) return;
    for (std::size_t j = 0; j < actuated_joints_.variables.size(); ++j)
      if (std::none_of(legs.begin(), legs.end(), [j](const LegChains& leg) { return leg.actuation == j; }))
        problem("actuates joint '" + system_.tree().joint_of(actuated_joints_.variables[j]).name +
                "', which is in no chain between the base and the platform; take it out of " +
                files_.key("actuated_joints") + ", or add the closure of its leg.");
  }

  // In a planar mechanism neighbouring pivots of a leg must not share an axis. (In space they may meet in a
  // point.)
  void check_lengths(const std::vector<LegChains>& legs) {
    if (!planar()) return;
    for (const LegChains& leg : legs) {
      const Chain& chain = leg.chains.front();
      for (std::size_t k = 1; k < chain.size(); ++k) check_length(chain[k - 1], chain[k]);
      // Two actuated joints move a point, and the last link of a leg ends there.
      if (legs.size() == 2 && chain.size() <= 2) check_last_length(chain.back());
    }
  }

  bool planar() const {
    std::optional<Eigen::Vector3d> normal;
    for (const Edge& edge : edges_)
      for (const Pivot& pivot : edge.pivots) {
        if (pivot.kind != PivotKind::revolute) continue;
        if (!normal) normal = pivot.axis;
        if (pivot.axis.cross(*normal).norm() > rank_tolerance) return false;
      }
    return true;
  }

  bool on_axis(const Pivot& pivot, const Eigen::Vector3d& point) const {
    return (point - pivot.point).cross(pivot.axis).norm() < rank_tolerance * system_.size();
  }

  void check_last_length(const Pivot& pivot) {
    if (pivot.kind != PivotKind::revolute || !on_axis(pivot, operational_point_)) return;
    problem("has " + operational_point_text(system_.tree(), actuated_joints_.platform_link, files_) +
            " on the axis of joint '" + pivot.name +
            "', so that the last link of the leg has length zero; move it, or lengthen the link in " +
            files_.urdf + ".");
  }

  // The link of a closure that is held where the joint is that carries it.
  std::optional<std::string> closed_at_its_joint(const Pivot& one, const Pivot& other) const {
    if (one.variable.has_value() == other.variable.has_value()) return std::nullopt;
    const Pivot &joint = one.variable ? one : other, &closed = one.variable ? other : one;
    const std::size_t carried = system_.tree().joint_of(*joint.variable).child;
    for (const Closure& closure : system_.closures())
      for (const LinkFrame& frame : closure.frames)
        if (closure.name == closed.name && frame.link == carried && frame.in_link.translation().isZero())
          return system_.tree().links[carried];
    return std::nullopt;
  }

  void check_length(const Pivot& one, const Pivot& other) {
    if (one.kind != PivotKind::revolute || other.kind == PivotKind::prismatic || !on_axis(one, other.point))
      return;
    if (const auto link = closed_at_its_joint(one, other)) {
      const std::string place =
          files_.as_options ? *link + "@X:Y:Z in the place of " + *link + " with --closures"
                            : "{link: " + *link + ", xyz: [X, Y, Z]} in the place of " + *link + " in it";
      problems_.push_back(files_.urdf + " has joint '" + (one.variable ? one : other).name +
                          "' where closure '" + (one.variable ? other : one).name + "' holds link '" + *link +
                          "', at its origin, so that the rod between them has length zero; give the far end "
                          "of the rod: write " +
                          place + ", or the <pose> of a <gazebo><joint>.");
      return;
    }
    problems_.push_back(
        files_.urdf + " puts '" + one.name + "' and '" + other.name +
        "' on one axis, so that the link between them has length zero; give it a positive length.");
  }

  const ClosureSystem& system_;
  const std::vector<bool>& still_;
  const ActuatedJoints& actuated_joints_;
  const SourceNames& files_;
  Problems& problems_;
  Partition bodies_;  // links that are fixed to one another
  Partition parts_;   // bodies that are connected without base and platform
  std::vector<Edge> edges_;
  std::size_t base_ = 0, platform_ = 0;
  std::size_t steps_ = 0;              // of the walk through the present leg
  Eigen::Vector3d operational_point_;  // assembled, in the base frame [m]
};

}  // namespace

std::string operational_point_text(const Tree& tree, std::size_t platform_link, const SourceNames& files) {
  const std::string& name = tree.links[platform_link];
  const auto above = tree.joint_above[platform_link];
  const bool is_made = name == unnamed_operational_point && above && tree.joints[*above].name == name;
  if (!is_made) return files.key("operational_point") + " '" + name + "'";
  std::string xyz;
  for (Eigen::Index k = 0; k < 3; ++k)
    xyz += (k == 0 ? "" : ", ") + number_text(tree.joints[*above].origin.translation()[k]);
  return files.key("operational_point") + " {link: " + tree.links[tree.joints[*above].parent] + ", xyz: [" +
         xyz + "]}";
}

std::string names_of(const Chain& chain) {
  std::string text;
  for (const Pivot& pivot : chain) text += (text.empty() ? "'" : ", '") + pivot.name + "'";
  return text;
}

Note joint_names_of(const Chain& chain) {
  std::vector<std::string> names;
  for (const Pivot& pivot : chain)
    if (pivot.variable) names.push_back(pivot.name);
  return listed_names(std::move(names));
}

FoundLegs find_legs(const AssembledMechanism& mechanism, const ActuatedJoints& actuated_joints,
                    const SourceNames& files, Problems& problems) {
  return LegFinder(mechanism, actuated_joints, files, problems).find();
}

std::vector<std::vector<LegJoint>> joints_by_leg(const ClosureSystem& system,
                                                 const ActuatedJoints& actuated_joints,
                                                 const SourceNames& files) {
  Problems unused;
  const AssembledMechanism at_zero{system, Eigen::VectorXd::Zero(system.tree().variables()),
                                   std::vector<bool>(system.in_loop().size(), false)};
  return LegFinder(at_zero, actuated_joints, files, unused).joints();
}

std::vector<JoiningPart> joining_parts(const AssembledMechanism& mechanism,
                                       const ActuatedJoints& actuated_joints, const SourceNames& files) {
  Problems unused;
  return LegFinder(mechanism, actuated_joints, files, unused).parts();
}

}  // namespace parallel_aspects
