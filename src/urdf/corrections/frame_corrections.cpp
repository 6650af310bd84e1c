// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/frame_corrections.h"

#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"
#include "urdf/description/messages.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Links = std::vector<std::size_t>;

constexpr std::size_t max_open = 12;  // links that a closure may lack

bool contains(const Links& links, std::size_t link) {
  return std::find(links.begin(), links.end(), link) != links.end();
}

class FrameCorrections {
 public:
  FrameCorrections(const Tree& tree, const ResolvedConfig& resolved, const ClosureSystem& system,
                   const SourceNames& files)
      : tree_(tree),
        resolved_(resolved),
        system_(system),
        files_(files),
        platform_(body_of(tree, resolved.actuated_joints.platform_link)),
        may_share_(legs_share_anchors(tree, resolved, system.size())),
        is_parent_(tree.links.size(), false) {
    for (const TreeJoint& joint : tree.joints) is_parent_[joint.parent] = true;
    find_loose_bodies();
    find_open_frames();
  }

  // The operational point in the place of the start of its body.
  Corrections find_at_point() {
    for_point_ = true;
    exchange_links(true, false);
    return std::move(found_.back());
  }

  // A link that a movable joint carries is seldom a frame of its own.
  std::vector<Corrections> find() {
    exchange_links(true, true);
    exchange_parents(true);
    add_missing_closures();
    exchange_links(true, false);
    add_closures(true);
    exchange_parents(false);
    exchange_links(false, true);
    exchange_links(false, false);
    add_closures(false);
    add_far_ends();
    return std::move(found_);
  }

 private:
  void start_kind() { found_.emplace_back(); }

  bool is_frame(std::size_t link) const {
    return tree_.joint_above[link] && !tree_.joints[*tree_.joint_above[link]].variable;
  }

  // The ends of chains that no loop holds.
  void find_loose_bodies() {
    std::vector<bool> carries(tree_.links.size(), false);
    for (const TreeJoint& joint : tree_.joints)
      if (joint.variable) carries[body_of(tree_, joint.parent)] = true;
    for (const TreeJoint& joint : tree_.joints)
      if (joint.variable && !system_.in_loop()[*joint.variable] && !carries[joint.child] &&
          joint.child != platform_)
        loose_.push_back(joint.child);
  }

  // Which end chains and bodies and which no closure has, loose ones first.
  void find_open_frames() {
    for (const bool loose : {true, false})
      for (std::size_t link = 0; link < tree_.links.size(); ++link) {
        const std::size_t body = body_of(tree_, link);
        const bool is_end = !is_parent_[link] && body != body_of(tree_, resolved_.base);
        if (is_end && !is_closed(link) && contains(loose_, body) == loose && open_.size() < max_open &&
            link != resolved_.actuated_joints.platform_link)
          open_.push_back(link);
      }
  }

  bool is_closed(std::size_t link) const {
    return std::any_of(resolved_.closures.begin(), resolved_.closures.end(), [&](const Closure& closure) {
      return closure.frames[0].link == link || closure.frames[1].link == link;
    });
  }

  // The other closure that has it.
  const Closure* other_with(const LinkFrame& frame) const {
    for (const Closure& closure : resolved_.closures)
      for (const LinkFrame& other : closure.frames)
        if (&other != &frame && other.link == frame.link &&
            other.in_link.isApprox(frame.in_link, rank_tolerance))
          return &closure;
    return nullptr;
  }

  bool is_repeated(const LinkFrame& frame) const { return other_with(frame) != nullptr; }

  std::string quoted(std::size_t link) const { return "'" + tree_.links[link] + "'"; }

  void exchange_links(bool for_frames, bool repeated) {
    start_kind();
    for (std::size_t k = 0; k < resolved_.closures.size(); ++k)
      for (const std::size_t end : {0, 1})
        if (is_repeated(resolved_.closures[k].frames[end]) == repeated) exchange_link(k, end, for_frames);
  }

  void add_closures(bool of_frames) {
    start_kind();
    for (const std::size_t loose : open_)
      if (contains(loose_, body_of(tree_, loose)) && is_frame(loose) == of_frames) add_closures_of(loose);
  }

  // Where a chain ends in a frame and the platform has one that no closure has either, one closure is
  // missing: nothing that is written must be changed.
  void add_missing_closures() {
    start_kind();
    for (const std::size_t loose : open_)
      if (contains(loose_, body_of(tree_, loose)) && is_frame(loose) && has_open_frame_of_platform())
        add_closures_of(loose);
  }

  bool has_open_frame_of_platform() const {
    return std::any_of(open_.begin(), open_.end(), [this](std::size_t link) {
      return is_frame(link) && body_of(tree_, link) == platform_;
    });
  }

  // In the place of a frame: the operational point too, where its body is in no loop.
  Links open_at(const LinkFrame& frame) const {
    Links links = open_;
    const std::size_t point = resolved_.actuated_joints.platform_link;
    if (for_point_) return is_closed(point) || frame.link != platform_ ? Links{} : Links{point};
    if (!is_closed(point) && !is_platform_in_loop()) links.push_back(point);
    return links;
  }

  bool is_platform_in_loop() const {
    return std::any_of(tree_.joints.begin(), tree_.joints.end(), [this](const TreeJoint& joint) {
      return joint.variable && system_.in_loop()[*joint.variable] &&
             (joint.child == platform_ || body_of(tree_, joint.parent) == platform_);
    });
  }

  // What stays loose is no leg.
  void exchange_link(std::size_t index, std::size_t end, bool for_frames) {
    const Closure& closure = resolved_.closures[index];
    const LinkFrame& frame = closure.frames[end];
    const Closure* other = other_with(frame);
    const std::size_t body = body_of(tree_, frame.link);
    if (!frame.in_link.isApprox(Eigen::Isometry3d::Identity())) return;
    for (const std::size_t link : open_at(frame)) {
      const std::size_t new_body = body_of(tree_, link);
      const bool is_meant = contains(loose_, new_body) || new_body == body || new_body == platform_;
      if (!is_meant || is_frame(link) != for_frames ||
          new_body == body_of(tree_, closure.frames[1 - end].link))
        continue;
      const std::string element = "closure '" + closure.name + "'";
      const std::string why = other != nullptr ? ", which closure '" + other->name + "' has, too"
                                               : ", while no closure has link " + quoted(link);
      add({element,
           file_of_closures(resolved_, files_) + " names link " + quoted(frame.link) + " in " + element + why,
           "write link " + quoted(link) + " in the place of " + quoted(frame.link) + " in " + element, false,
           [index, end, link](Tree&, ResolvedConfig& resolved) {
             resolved.closures[index].frames[end] = {link, Eigen::Isometry3d::Identity()};
           }});
    }
  }

  // Of links that a closure holds where they begin, at their joint: as far as those of other closures are
  // held, or as other links reach.
  void add_far_ends() {
    start_kind();
    for (std::size_t k = 0; k < resolved_.closures.size(); ++k)
      for (const std::size_t end : {0, 1}) {
        const LinkFrame& frame = resolved_.closures[k].frames[end];
        const bool is_start = frame.in_link.isApprox(Eigen::Isometry3d::Identity()) &&
                              !is_frame(frame.link) && !is_parent_[frame.link];
        if (!is_start || frame.link == platform_) continue;
        for (const Closure& closure : resolved_.closures) add_far_end(k, end, closure.frames[end].in_link);
        for (const bool of_platform : {false, true})
          for (const TreeJoint& joint : tree_.joints)
            if (!joint.variable && !is_parent_[joint.child] &&
                (body_of(tree_, joint.child) == platform_) == of_platform)
              add_far_end(k, end, joint.origin);
      }
  }

  void add_far_end(std::size_t index, std::size_t end, const Eigen::Isometry3d& place) {
    if (place.translation().isZero(0.0)) return;
    const Closure& closure = resolved_.closures[index];
    const std::size_t link = closure.frames[end].link;
    const std::string element = "closure '" + closure.name + "'";
    add({element,
         file_of_closures(resolved_, files_) + " has " + element + " at the start of link " + quoted(link) +
             ", where joint '" + tree_.joints[*tree_.joint_above[link]].name +
             "' is, and not at its far end, which has no link",
         far_end_text(closure, end, place.translation()), false,
         [index, end, translation = Eigen::Vector3d(place.translation())](Tree&, ResolvedConfig& resolved) {
           resolved.closures[index].frames[end].in_link.translation() = translation;
         }});
  }

  // A joint of SDF is placed in its child.
  std::string far_end_text(const Closure& closure, std::size_t end, const Eigen::Vector3d& place) const {
    const std::string& link = tree_.links[closure.frames[end].link];
    if (resolved_.closure_dialect == "<gazebo><joint>" && end == 1)
      return "write <pose>" + as_attribute(place) +
             " 0 0 0</pose>, or where else that is, in <gazebo><joint> '" + closure.name + "'";
    return "write {link: " + link + ", xyz: " + as_list(place) + "} or where else that is in the place of '" +
           link + "' in closure '" + closure.name + "'";
  }

  // The type that most closures have.
  ClosureType usual_type() const {
    std::map<ClosureType, int> counts;
    for (const Closure& closure : resolved_.closures) ++counts[closure.type];
    ClosureType usual = ClosureType::automatic;
    for (const auto& [type, count] : counts)
      if (count > counts[usual]) usual = type;
    return usual;
  }

  // With an open frame of the platform, and where it has none with the operational point.
  void add_closures_of(std::size_t loose) {
    Links others;
    for (const std::size_t link : open_)
      if (body_of(tree_, link) == platform_) others.push_back(link);
    const std::size_t point = resolved_.actuated_joints.platform_link;
    if (others.empty() && body_of(tree_, loose) != platform_) others.push_back(point);
    for (const std::size_t other : others) {
      const std::string frames = "{frames: [" + tree_.links[other] + ", " + tree_.links[loose] +
                                 "], type: " + std::string(name(usual_type())) + "}";
      const Closure closure{
          tree_.links[other] + " - " + tree_.links[loose],
          {{{other, Eigen::Isometry3d::Identity()}, {loose, Eigen::Isometry3d::Identity()}}},
          usual_type(),
          Weld::none};
      add({"closure '" + closure.name + "'",
           "no closure of " + file_of_closures(resolved_, files_) + " joins link " + quoted(loose) +
               ", which ends a chain of " + files_.urdf + ", to link " + quoted(other),
           added_text(other, loose, frames), false,
           [closure](Tree&, ResolvedConfig& resolved) { resolved.closures.push_back(closure); }});
    }
  }

  // Those of the YAML take the place of those that the URDF describes, to which options add theirs.
  std::string added_text(std::size_t one, std::size_t other, const std::string& frames) const {
    const bool described = !resolved_.closure_dialect.empty();
    const std::string pair = shell_word(tree_.links[one] + "=" + tree_.links[other]);
    if (files_.as_options) return described ? "add --closures " + pair : "add " + pair + " to --closures";
    return "add " + frames + " to mechanism." + (described ? "added_closures" : "closures");
  }

  // Of frames that are not on the platform though they should, or on one point of it; else where chains are
  // loose.
  void exchange_parents(bool misplaced) {
    start_kind();
    for (const Closure& closure : resolved_.closures) {
      const bool is_elsewhere =
          !is_at_platform(closure.frames[0].link) && !is_at_platform(closure.frames[1].link);
      for (const std::size_t end : {0, 1})
        if (misplaced == (is_elsewhere || may_share_) && (misplaced || !loose_.empty()))
          exchange_parent(closure, end);
    }
  }

  // Or on a body that a joint moves against it.
  bool is_at_platform(std::size_t link) const {
    const std::size_t body = body_of(tree_, link);
    const auto joint = tree_.joint_above[body];
    return body == platform_ || (joint && body_of(tree_, tree_.joints[*joint].parent) == platform_);
  }

  // For links of loose bodies and of the platform.
  void exchange_parent(const Closure& closure, std::size_t end) {
    const std::size_t link = closure.frames[end].link;
    const auto joint = tree_.joint_above[link];
    if (!joint || tree_.joints[*joint].variable || is_parent_[link]) return;
    const std::size_t present = tree_.joints[*joint].parent;
    for (std::size_t parent = 0; parent < tree_.links.size(); ++parent) {
      const std::size_t body = body_of(tree_, parent);
      const bool is_meant = body == platform_ || contains(loose_, body);
      if (!is_meant || parent == present || parent == link || is_closed(parent)) continue;
      const std::string name = tree_.joints[*joint].name;
      add({"joint '" + name + "'",
           files_.urdf + " fixes link " + quoted(link) + ", which closure '" + closure.name +
               "' holds, to link " + quoted(present) +
               (contains(loose_, body) ? ", and link " + quoted(body) + " is in no loop" : ""),
           "write <parent link=\"" + tree_.links[parent] + "\"/> for joint '" + name + "'", false,
           [at = *joint, parent](Tree& tree, ResolvedConfig&) { hang(tree, at, parent); }});
    }
  }

  void add(Correction correction) {
    Tree tree = tree_;
    ResolvedConfig resolved = resolved_;
    correction.apply(tree, resolved);
    if (may_share_ || !legs_share_anchors(tree, resolved, system_.size()))
      found_.back().push_back(std::move(correction));
  }

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  const ClosureSystem& system_;
  const SourceNames& files_;
  std::size_t platform_;  // body
  bool may_share_;
  bool for_point_ = false;       // whether the operational point alone is to be a frame
  std::vector<bool> is_parent_;  // by link
  Links loose_;                  // bodies
  Links open_;                   // links
  std::vector<Corrections> found_;
};

}  // namespace

std::vector<Corrections> frame_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                           const ClosureSystem& system, const SourceNames& files) {
  return FrameCorrections(tree, resolved, system, files).find();
}

Corrections point_corrections(const Tree& tree, const ResolvedConfig& resolved, const ClosureSystem& system,
                              const SourceNames& files) {
  return FrameCorrections(tree, resolved, system, files).find_at_point();
}

}  // namespace parallel_aspects
