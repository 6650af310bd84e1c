// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/chain.h"
#include "urdf/description/name_words.h"
#include "urdf/setup/actuation_candidates.h"
#include "urdf/setup/setup_config.h"

#include <algorithm>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

namespace parallel_aspects {
namespace {

std::vector<JointMotion> motions_of(const Tree& tree, const GraphPart& part) {
  std::vector<JointMotion> motions;
  for (const std::size_t joint : part.variables) motions.push_back(tree.joint_of(joint).motion);
  return motions;
}

bool stands_out(const Tree& tree, const GraphPart& part, const std::vector<GraphPart>& others) {
  const auto motions = motions_of(tree, others.front());
  return others.size() > 1 && motions_of(tree, part) != motions &&
         std::all_of(others.begin(), others.end(),
                     [&](const GraphPart& other) { return motions_of(tree, other) == motions; });
}

// Of the parts between base and platform, those that may be the legs: all; and all but one chain, which is
// passive where the others move the platform: that which it hangs on in the tree, or one that is unlike the
// others, which are alike; or both.
std::vector<std::vector<GraphPart>> leg_choices(const Tree& tree, const std::vector<GraphPart>& parts) {
  std::vector<std::vector<GraphPart>> choices;
  if (is_actuation_count(parts.size())) choices.push_back(parts);
  for (const bool closed : {false, true})
    for (std::size_t k = 0; k < parts.size(); ++k) {
      std::vector<GraphPart> others = parts;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      if (parts[k].closed != closed || (closed && !stands_out(tree, parts[k], others))) continue;
      if (is_actuation_count(others.size()))
        choices.push_back(std::move(others));
      else if (!closed)
        for (auto& fewer : leg_choices(tree, others)) choices.push_back(std::move(fewer));
    }
  return choices;
}

// What is between these bodies apart from everything else and touches both: the legs, where they are base and
// platform, in the order of the URDF.
std::vector<GraphPart> parts_between(const ClosureSystem& loops, const Bodies& bodies, std::size_t base,
                                     std::size_t platform) {
  std::vector<GraphPart> parts;
  for (const auto& joints : joints_by_leg(loops, {bodies.links(platform).front(), {}}, {})) {
    GraphPart part;
    std::set<std::size_t> inner;
    for (const LegJoint& joint : joints) {
      if (!loops.in_loop()[joint.variable]) continue;
      part.variables.push_back(joint.variable);
      part.depths.push_back(joint.depth);
      const TreeJoint& of_tree = loops.tree().joint_of(joint.variable);
      inner.insert({bodies.of(of_tree.parent), bodies.of(of_tree.child)});
    }
    inner.erase(base);
    inner.erase(platform);
    for (const Closure& closure : loops.closures())
      for (const LinkFrame& frame : closure.frames)
        part.closed = part.closed || inner.count(bodies.of(frame.link)) > 0;
    parts.push_back(std::move(part));
  }
  std::sort(parts.begin(), parts.end(),
            [](const GraphPart& one, const GraphPart& other) { return one.variables < other.variables; });
  return parts;
}

// Legs of a fully parallel robot, and two passive chains besides.
constexpr std::size_t min_parts = 2, max_parts = 8;

// As those that a reader puts between the axes of a joint.
bool is_named_frame(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return std::find(words.begin(), words.end(), "frame") != words.end();
}

// Two legs meet where a closure is, as a rule; a place without a link is of use there alone.
std::vector<std::size_t> links_of(const Tree& tree, std::vector<std::size_t> links,
                                  const std::vector<Closure>& closures, std::size_t legs) {
  const auto key = [&](std::size_t link) {
    const std::string& name = tree.links[link];
    return std::tuple{operational_point_likeness(name), legs == 2 && is_closed(closures, link),
                      !is_named_frame(name)};
  };
  links.erase(std::remove_if(links.begin(), links.end(),
                             [&](std::size_t link) { return legs != 2 && placed_frame(tree.links[link]); }),
              links.end());
  std::stable_sort(links.begin(), links.end(),
                   [&](std::size_t one, std::size_t other) { return key(one) > key(other); });
  return links;
}

}  // namespace

std::vector<Platform> platform_candidates(const Tree& tree, const Bodies& bodies, const BodyGraph& graph,
                                          std::size_t base, const std::vector<Closure>& closures,
                                          const SetupAnswers& answers) {
  const std::string& answer = answers.operational_point;
  const ClosureSystem loops({std::shared_ptr<const Tree>(), &tree}, bodies.links(base).front(),
                            with_type(closures, ClosureType::point));
  std::vector<Platform> result;
  for (const std::size_t body : graph.moving_bodies(base)) {
    if (!answer.empty() && bodies.of(*tree.link_named(answer)) != body) continue;
    const std::vector<GraphPart> parts = parts_between(loops, bodies, base, body);
    if (parts.size() < min_parts || parts.size() > max_parts) continue;
    Platform platform{body, {}, leg_choices(tree, parts)};
    platform.links = answer.empty() ? links_of(tree, bodies.links(body), closures, parts.size())
                                    : std::vector<std::size_t>{*tree.link_named(answer)};
    if (!platform.legs.empty()) result.push_back(platform);
  }
  const auto key = [&](const Platform& platform) {
    const std::vector<std::size_t>& links = bodies.links(platform.body);
    const bool is_held =
        std::any_of(links.begin(), links.end(), [&](std::size_t link) { return is_closed(closures, link); });
    return std::tuple{platform.legs.front().size(),
                      operational_point_likeness(tree.links[platform.links.front()]), is_held};
  };
  std::stable_sort(result.begin(), result.end(),
                   [&](const Platform& one, const Platform& other) { return key(one) > key(other); });
  return result;
}

std::optional<std::size_t> base_by_name(const Tree& tree, const Bodies& bodies, const BodyGraph& graph,
                                        std::size_t base) {
  const auto any_is = [&](std::size_t body, const auto& says) {
    const std::vector<std::size_t>& links = bodies.links(body);
    return std::any_of(links.begin(), links.end(), [&](std::size_t link) { return says(tree.links[link]); });
  };
  const auto says_platform = [](const std::string& name) { return operational_point_likeness(name) > 0; };
  if (any_is(base, says_base) || !any_is(base, says_platform)) return std::nullopt;
  std::optional<std::size_t> found;
  for (const std::size_t body : graph.moving_bodies(base)) {
    if (!any_is(body, says_base)) continue;
    if (found) return std::nullopt;
    found = body;
  }
  return found;
}

bool is_closed(const std::vector<Closure>& closures, std::size_t link) {
  return std::any_of(closures.begin(), closures.end(), [link](const Closure& closure) {
    return closure.frames[0].link == link || closure.frames[1].link == link;
  });
}

}  // namespace parallel_aspects
