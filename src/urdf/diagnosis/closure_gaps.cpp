// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/closure_gaps.h"

#include "model/message_text.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/corrections/edit.h"
#include "urdf/description/xml_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace parallel_aspects {

bool passes_base(const Tree& tree, std::size_t base, const Closure& closure) {
  const std::size_t body = body_of(tree, base);
  std::array<std::optional<std::size_t>, 2> starts;
  for (const std::size_t end : {0, 1})
    for (std::size_t at = body_of(tree, closure.frames[end].link); at != body;) {
      const auto joint = tree.joint_above[at];
      if (!joint) return false;
      starts.at(end) = joint;
      at = body_of(tree, tree.joints[*joint].parent);
    }
  return starts[0] != starts[1];
}

namespace {

constexpr double small_gap = 1e-4;  // of the size of the robot: what CAD rounds to four digits

// The last of several joints in one place makes a ball joint.
bool is_last_of_ball(const Tree& tree, const TreeJoint& joint) {
  const auto before = tree.joint_above[joint.parent];
  return joint.origin.translation().isZero() && before &&
         tree.joints[*before].motion == JointMotion::revolute;
}

// Without children, and fixed to what carries it, or to the last ring of a ball joint.
bool is_end(const Tree& tree, std::size_t link) {
  const auto joint = tree.joint_above[link];
  return joint && !has_child(tree, link) &&
         (tree.joints[*joint].motion == JointMotion::fixed || is_last_of_ball(tree, tree.joints[*joint]));
}

// Else it is a body.
bool is_held_once(const std::vector<Closure>& closures, std::size_t link) {
  return std::count_if(closures.begin(), closures.end(), [link](const Closure& other) {
           return other.frames[0].link == link || other.frames[1].link == link;
         }) == 1;
}

// Whether its first link is there for it alone, so that it is to be held at its origin.
bool holds_end(const Tree& tree, const std::vector<Closure>& closures, const Closure& closure) {
  return closure.at_zero && is_end(tree, closure.frames[0].link) &&
         is_held_once(closures, closure.frames[0].link);
}

// A place beside its links is meant as it is written.
bool joins_ends(const Tree& tree, const std::vector<Closure>& closures, const Closure& closure) {
  return holds_end(tree, closures, closure) && !has_child(tree, closure.frames[1].link) &&
         closure.frames[1].in_link.translation().isZero();
}

// Of its ends, and zero where it has none [m].
std::vector<double> end_gaps(const Tree& tree, const std::vector<Closure>& closures) {
  std::vector<double> gaps;
  for (const Closure& closure : closures)
    gaps.push_back(joins_ends(tree, closures, closure) ? closure.frames[0].in_link.translation().norm()
                                                       : 0.0);
  return gaps;
}

double widest(const std::vector<double>& gaps) {
  return gaps.empty() ? 0.0 : *std::max_element(gaps.begin(), gaps.end());
}

}  // namespace

std::optional<ResolvedConfig> with_ends_together(const Tree& tree, const ResolvedConfig& resolved) {
  if (widest(end_gaps(tree, resolved.closures)) <= meeting_tolerance(tree, resolved)) return std::nullopt;
  ResolvedConfig together = resolved;
  for (Closure& closure : together.closures)
    if (joins_ends(tree, resolved.closures, closure)) closure.frames[0].in_link.translation().setZero();
  return together;
}

std::optional<ResolvedConfig> drawn_open(const Tree& tree, const ResolvedConfig& resolved,
                                         const SourceNames& files) {
  const std::vector<double> gaps = end_gaps(tree, resolved.closures);
  const double meet = meeting_tolerance(tree, resolved);
  bool any_apart = false;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const Closure& closure = resolved.closures[k];
    if (!passes_base(tree, resolved.base, closure)) continue;
    const std::size_t second = closure.frames[1].link;
    if (gaps[k] <= meet || !is_end(tree, second) || !is_held_once(resolved.closures, second))
      return std::nullopt;
    any_apart = true;
  }
  if (!any_apart) return std::nullopt;
  ResolvedConfig meant = as_listed(tree, resolved);
  join_layers(tree, meant.actuated_joints.platform_link, files, meant.closures);
  return meant;
}

ResolvedConfig as_listed(const Tree& tree, ResolvedConfig resolved) {
  place_at_zero(tree, resolved.closures);
  ResolvedConfig listed = resolved;
  for (Closure& closure : listed.closures) {
    if (joins_ends(tree, resolved.closures, closure)) closure.frames[0].in_link.translation().setZero();
    closure.at_zero.reset();
  }
  return listed;
}

std::vector<Closure> with_known_types(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                      const Attempt& attempt) {
  const auto is_open = [](const Closure& closure) { return closure.type == ClosureType::automatic; };
  if (std::none_of(resolved.closures.begin(), resolved.closures.end(), is_open)) return resolved.closures;
  for (const ClosureType type : {ClosureType::point, ClosureType::revolute}) {
    ResolvedConfig typed = resolved;
    typed.closures = with_type(resolved.closures, type);
    if (attempt(tree, typed)) return typed.closures;
  }
  return resolved.closures;
}

std::vector<std::optional<double>> gaps_at_zero(const Tree& tree, const std::vector<Closure>& closures) {
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  std::vector<std::optional<double>> gaps;
  for (const Closure& closure : closures) {
    const auto& [one, other] = closure.frames;
    if (closure.at_zero && !holds_end(tree, closures, closure)) {
      gaps.emplace_back();
      continue;
    }
    const Eigen::Vector3d in_one =
        closure.at_zero ? Eigen::Vector3d::Zero() : Eigen::Vector3d(one.in_link.translation());
    gaps.emplace_back((poses[one.link] * in_one - poses[other.link] * other.in_link.translation()).norm());
  }
  return gaps;
}

double meeting_tolerance(const Tree& tree, const ResolvedConfig& resolved) {
  const auto shared = std::make_shared<const Tree>(tree);
  return small_gap *
         ClosureSystem(shared, resolved.base, with_type(resolved.closures, ClosureType::point)).size();
}

bool are_all_welds(const std::vector<Closure>& closures) {
  return std::all_of(closures.begin(), closures.end(),
                     [](const Closure& closure) { return closure.weld != Weld::none; });
}

EndGaps::EndGaps(const Tree& tree, const ResolvedConfig& resolved) {
  ResolvedConfig placed = resolved;
  place_at_zero(tree, placed.closures);
  for (const Closure& closure : resolved.closures)
    joins_ends_.push_back(joins_ends(tree, resolved.closures, closure));
  before_ = end_gaps(tree, placed.closures);
  const double meet = meeting_tolerance(tree, placed);
  are_to_meet_ = widest(before_) > meet && widest(end_gaps(tree, resolved.closures)) <= meet;
}

bool EndGaps::allow(const Tree& tree, const ResolvedConfig& changed) const {
  std::vector<double> after = end_gaps(tree, changed.closures);
  for (std::size_t k = 0; after.size() == joins_ends_.size() && k < after.size(); ++k)
    if (joins_ends_[k] && changed.closures[k].frames[1].in_link.translation().isZero())
      after[k] = changed.closures[k].frames[0].in_link.translation().norm();
  if (widest(after) == 0.0) return true;
  const double meet = meeting_tolerance(tree, changed);
  if (widest(after) <= meet) return true;
  if (are_to_meet_ || after.size() != before_.size() || after.size() < 2) return false;
  const auto is_usual = [&](double gap) { return std::abs(gap - before_.front()) <= meet; };
  return std::all_of(before_.begin(), before_.end(), is_usual) &&
         std::all_of(after.begin(), after.end(), is_usual);
}

std::vector<std::size_t> held_beside_ends(const Tree& tree, const ResolvedConfig& resolved) {
  const double meet = meeting_tolerance(tree, resolved);
  std::vector<Closure> placed = resolved.closures;
  place_at_zero(tree, placed);
  std::vector<std::size_t> beside;
  for (std::size_t k = 0; k < placed.size(); ++k)
    if (holds_end(tree, placed, placed[k]) && !placed[k].frames[1].in_link.translation().isZero() &&
        placed[k].frames[0].in_link.translation().norm() > meet)
      beside.push_back(k);
  return beside;
}

std::optional<Note> list_of_ends(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                 const SourceNames& files, const Attempt& attempt) {
  ResolvedConfig listed = as_listed(*tree, resolved);
  for (Closure& closure : listed.closures)
    if (files.as_options) closure.type = ClosureType::automatic;
  return attempt(tree, listed) ? std::optional(closures_entry(*tree, listed.closures, files)) : std::nullopt;
}

std::string gap_text(const Tree& tree, const Closure& closure, double gap) {
  return "'" + tree.links[closure.frames[0].link] + "' and '" + tree.links[closure.frames[1].link] + "' by " +
         number_text(gap, 4) + " m (closure '" + closure.name + "')";
}

std::string end_gaps_text(const Tree& tree, const ResolvedConfig& resolved) {
  const std::vector<double> gaps = end_gaps(tree, resolved.closures);
  const double meet = meeting_tolerance(tree, resolved);
  std::string text;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (gaps[k] > meet) text += (text.empty() ? "" : ", ") + gap_text(tree, resolved.closures[k], gaps[k]);
  return text;
}

std::string starts_of_links_text(const Tree& tree, const ResolvedConfig& resolved) {
  const std::vector<double> gaps = end_gaps(tree, resolved.closures);
  std::string text;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const Closure& closure = resolved.closures[k];
    const std::size_t link = closure.frames[1].link;
    const auto joint = tree.joint_above[link];
    if (gaps[k] <= meeting_tolerance(tree, resolved) || !joint || !tree.joints[*joint].variable) continue;
    text += "; closure '" + closure.name + "' holds link '" + tree.links[link] + "' where joint '" +
            tree.joints[*joint].name +
            "' is: give its far end, if that is meant, by {link: " + tree.links[link] +
            ", xyz: [X, Y, Z]} or the <pose> of a <gazebo><joint>";
  }
  return text;
}

}  // namespace parallel_aspects
