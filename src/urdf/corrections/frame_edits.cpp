// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/edits.h"

#include <algorithm>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

using Links = std::vector<std::size_t>;

constexpr std::size_t max_open = 12;           // links that a closure may lack: both ends of six legs
constexpr std::size_t max_platform_links = 4;  // that are tried as the end of one closure, frames without use

bool contains(const Links& links, std::size_t link) {
  return std::find(links.begin(), links.end(), link) != links.end();
}

bool is_at_origin(const LinkFrame& frame) { return frame.in_link.isApprox(Eigen::Isometry3d::Identity()); }

class FrameEdits {
 public:
  explicit FrameEdits(const Subject& subject)
      : s_(subject),
        tree_(subject.tree),
        closures_(subject.resolved.closures),
        point_(subject.resolved.actuated_joints.platform_link),
        platform_(subject.platform()),
        may_share_(legs_share_anchors(tree_, subject.resolved, subject.size())) {
    find_loose_bodies();
    find_open_frames();
  }

  // The operational point in the place of the start of its body.
  Edits find_at_point() {
    for_point_ = true;
    exchange_links(false);
    return std::move(found_.back());
  }

  std::vector<Edits> find() {
    exchange_links(true);
    exchange_parents(true);
    add_closures();
    exchange_links(false);
    exchange_parents(false);
    return std::move(found_);
  }

 private:
  bool is_frame(std::size_t link) const {
    return tree_.joint_above[link] && !tree_.joints[*tree_.joint_above[link]].variable;
  }

  bool is_loose(std::size_t link) const { return contains(loose_, body_of(tree_, link)); }

  // The ends of chains that no loop holds.
  void find_loose_bodies() {
    std::vector<bool> carries(tree_.links.size(), false);
    for (const TreeJoint& joint : tree_.joints)
      if (joint.variable) carries[body_of(tree_, joint.parent)] = true;
    for (const TreeJoint& joint : tree_.joints)
      if (joint.variable && !s_.system.in_loop()[*joint.variable] && !carries[joint.child] &&
          joint.child != platform_)
        loose_.push_back(joint.child);
  }

  // Which end chains and bodies and which no closure has, loose ones first.
  void find_open_frames() {
    for (const bool loose : {true, false})
      for (std::size_t link = 0; link < tree_.links.size(); ++link) {
        const bool is_end =
            !has_child(tree_, link) && body_of(tree_, link) != body_of(tree_, s_.resolved.base);
        if (is_end && !s_.is_closed(link) && is_loose(link) == loose && open_.size() < max_open &&
            link != point_)
          open_.push_back(link);
      }
  }

  // Another closure that has it.
  const Closure* other_with(const LinkFrame& frame) const {
    for (const Closure& closure : closures_)
      for (const LinkFrame& other : closure.frames)
        if (&other != &frame && other.link == frame.link &&
            other.in_link.isApprox(frame.in_link, rank_tolerance))
          return &closure;
    return nullptr;
  }

  // For a frame: a link that a movable joint carries is seldom one.
  void exchange_links(bool repeated) {
    found_.emplace_back();
    for (std::size_t k = 0; k < closures_.size(); ++k)
      for (const std::size_t end : {0, 1})
        if ((other_with(closures_[k].frames[end]) != nullptr) == repeated) exchange_link(k, end);
  }

  // In the place of a frame: the operational point too, where its body is in no loop.
  Links open_at(const LinkFrame& frame) const {
    Links links = open_;
    if (for_point_) return s_.is_closed(point_) || frame.link != platform_ ? Links{} : Links{point_};
    if (!s_.is_closed(point_) && !is_platform_in_loop()) links.push_back(point_);
    return links;
  }

  bool is_platform_in_loop() const {
    return std::any_of(tree_.joints.begin(), tree_.joints.end(), [this](const TreeJoint& joint) {
      return joint.variable && s_.system.in_loop()[*joint.variable] &&
             (joint.child == platform_ || body_of(tree_, joint.parent) == platform_);
    });
  }

  // What stays loose is no leg.
  void exchange_link(std::size_t index, std::size_t end) {
    const auto& frames = closures_[index].frames;
    const LinkFrame& frame = frames[end];
    const Closure* other = other_with(frame);
    if (!is_at_origin(frame)) return;
    for (const std::size_t link : open_at(frame)) {
      const std::size_t body = body_of(tree_, link);
      const bool is_meant = is_loose(link) || body == body_of(tree_, frame.link) || body == platform_;
      if (!is_meant || !is_frame(link) || body == body_of(tree_, frames[1 - end].link)) continue;
      add(s_.file() + " names link " + s_.link(frame.link) + " in " + s_.closure(index) +
              (other != nullptr ? ", which closure '" + other->name + "' has, too"
                                : ", while no closure has link " + s_.link(link)),
          FrameChange{index, end, {link, Eigen::Isometry3d::Identity()}});
    }
  }

  // Where a chain ends in a frame and the platform has one that no closure has either: nothing that is
  // written must be changed.
  void add_closures() {
    found_.emplace_back();
    Links others;
    for (const std::size_t link : open_)
      if (body_of(tree_, link) == platform_) others.push_back(link);
    if (std::none_of(others.begin(), others.end(), [this](std::size_t link) { return is_frame(link); }))
      return;
    for (const std::size_t loose : open_)
      if (is_loose(loose) && is_frame(loose))
        for (const std::size_t other : others) add_closure(loose, other);
  }

  // Of the type that most closures have.
  void add_closure(std::size_t loose, std::size_t other) {
    std::map<ClosureType, int> counts;
    ClosureType usual = ClosureType::automatic;
    for (const Closure& closure : closures_) ++counts[closure.type];
    for (const auto& [type, count] : counts)
      if (count > counts[usual]) usual = type;
    add("no closure of " + s_.file() + " joins link " + s_.link(loose) + ", which ends a chain of " +
            s_.files.urdf + ", to link " + s_.link(other),
        ClosureAddition{
            {tree_.links[other] + " - " + tree_.links[loose], {LinkFrame{other}, LinkFrame{loose}}, usual}});
  }

  // Of frames that are not on the platform though they should, or on one point of it; else where chains are
  // loose.
  void exchange_parents(bool misplaced) {
    found_.emplace_back();
    for (const Closure& closure : closures_) {
      const bool is_elsewhere =
          !is_at_platform(closure.frames[0].link) && !is_at_platform(closure.frames[1].link);
      for (const LinkFrame& frame : closure.frames)
        if (misplaced == (is_elsewhere || may_share_) && (misplaced || !loose_.empty()))
          exchange_parent(closure, frame.link);
    }
  }

  // Or on a body that a joint moves against it.
  bool is_at_platform(std::size_t link) const {
    const std::size_t body = body_of(tree_, link);
    const auto joint = tree_.joint_above[body];
    return body == platform_ || (joint && body_of(tree_, tree_.joints[*joint].parent) == platform_);
  }

  // For links of loose bodies and of the platform.
  void exchange_parent(const Closure& closure, std::size_t link) {
    const auto joint = tree_.joint_above[link];
    if (!is_frame(link) || has_child(tree_, link)) return;
    const std::size_t present = tree_.joints[*joint].parent;
    for (std::size_t parent = 0; parent < tree_.links.size(); ++parent) {
      const std::size_t body = body_of(tree_, parent);
      const bool is_meant = body == platform_ || contains(loose_, body);
      if (!is_meant || parent == present || parent == link || s_.is_closed(parent)) continue;
      add(s_.files.urdf + " fixes link " + s_.link(link) + ", which closure '" + closure.name +
              "' holds, to link " + s_.link(present) +
              (contains(loose_, body) ? ", and link " + s_.link(body) + " is in no loop" : ""),
          ParentChange{*joint, parent});
    }
  }

  void add(const std::string& fault, const Change& change) {
    Edit edit = edit_of(s_, fault, {change});
    const Edited after = edited(s_, edit);
    if (may_share_ || !legs_share_anchors(*after.tree, after.resolved, s_.size()))
      found_.back().push_back(std::move(edit));
  }

  const Subject& s_;
  const Tree& tree_;
  const std::vector<Closure>& closures_;
  std::size_t point_;     // link
  std::size_t platform_;  // body
  bool may_share_;
  bool for_point_ = false;  // whether the operational point alone is to be a frame
  Links loose_;             // bodies
  Links open_;              // links
  std::vector<Edits> found_;
};

bool is_on_platform(const Subject& s, std::size_t link) { return body_of(s.tree, link) == s.platform(); }

// What may be meant: a place beside a link stays there, and else links that no closure has.
Links platform_links(const Subject& s, const LinkFrame& frame) {
  const std::size_t point = s.resolved.actuated_joints.platform_link;
  if (!is_at_origin(frame)) return {point};
  Links links;
  for (std::size_t link = 0; link < s.tree.links.size(); ++link)
    if (is_on_platform(s, link) && link != point && !s.is_closed(link) && links.size() < max_platform_links)
      links.push_back(link);
  return links;
}

}  // namespace

std::vector<Edits> frame_edits(const Subject& subject) { return FrameEdits(subject).find(); }

Edits point_frame_edits(const Subject& subject) { return FrameEdits(subject).find_at_point(); }

Edits platform_frame_edits(const Subject& subject) {
  const std::vector<Closure>& closures = subject.resolved.closures;
  const auto is_elsewhere = [&](const Closure& closure) {
    return !is_on_platform(subject, closure.frames[0].link) &&
           !is_on_platform(subject, closure.frames[1].link);
  };
  const auto found = std::find_if(closures.begin(), closures.end(), is_elsewhere);
  if (closures.size() < 2 || std::count_if(closures.begin(), closures.end(), is_elsewhere) != 1) return {};
  const auto index = static_cast<std::size_t>(found - closures.begin());
  Edits edits;
  for (const std::size_t end : {0, 1})
    for (const std::size_t link : platform_links(subject, found->frames[end])) {
      Edit edit =
          edit_of(subject,
                  subject.file() + " closes '" + found->name + "' at link " +
                      subject.link(found->frames[end].link) + ", which is not on the body of " +
                      operational_point_text(subject.tree, subject.resolved.actuated_joints.platform_link,
                                             subject.files),
                  {FrameChange{index, end, {link, found->frames[end].in_link}}});
      const Edited after = edited(subject, edit);
      if (!legs_share_anchors(*after.tree, after.resolved, subject.size())) edits.push_back(std::move(edit));
    }
  return edits;
}

}  // namespace parallel_aspects
