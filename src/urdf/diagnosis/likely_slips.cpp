// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "urdf/corrections/edit.h"
#include "urdf/description/name_words.h"
#include "urdf/diagnosis/closure_gaps.h"
#include "urdf/diagnosis/diagnosis.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// By wide margins: directions of legs are alike to the rounding of angles, or differ by ten degrees and more.
constexpr double alike = 1e-3;        // of directions
constexpr double not_in_line = 0.1;   // sine of the angle at the middle, at least, for a plane of the joints
constexpr double one_sided = 0.01;    // of a range of values
constexpr double same_length = 1e-6;  // to which a place is typed [m]
constexpr double turned = 0.1;        // sine of the angle between axes that differ, at least

// An actuated joint on the base.
struct Drive {
  std::size_t joint = 0;  // of the tree
  Vector3d place, axis;   // in the frame of the base at zero
  Matrix3d turn;          // of the frame of the joint in that of the base
};

// Nothing where one is carried by another joint.
std::vector<Drive> drives_on_base(const Tree& tree, const ResolvedConfig& resolved) {
  const Poses poses = link_poses(tree, resolved.base, Eigen::VectorXd::Zero(tree.variables()));
  const std::size_t base = body_of(tree, resolved.base);
  std::vector<Drive> drives;
  for (const std::size_t variable : resolved.actuated_joints.variables) {
    const TreeJoint& joint = tree.joint_of(variable);
    if (body_of(tree, joint.parent) != base) return {};
    const Eigen::Isometry3d& pose = poses[joint.child];
    drives.push_back({tree.movable[variable], pose.translation(), pose.linear() * joint.axis, pose.linear()});
  }
  return drives;
}

// What is outward from the middle, around it, and across the plane of the joints, for each of them.
std::vector<Matrix3d> frames_seen_from_middle(const std::vector<Drive>& drives) {
  Vector3d middle = Vector3d::Zero(), normal = Vector3d::Zero();
  for (const Drive& drive : drives) middle += drive.place / static_cast<double>(drives.size());
  for (const Drive& one : drives)
    for (const Drive& other : drives) {
      const Vector3d across = (one.place - middle).normalized().cross((other.place - middle).normalized());
      if (across.norm() > normal.norm()) normal = across;
    }
  if (!(normal.norm() > not_in_line)) return {};
  normal.normalize();
  std::vector<Matrix3d> frames;
  for (const Drive& drive : drives) {
    const Vector3d from_middle = drive.place - middle;
    const Vector3d outward = (from_middle - normal * normal.dot(from_middle)).normalized();
    frames.emplace_back();
    frames.back() << outward, normal.cross(outward), normal;
  }
  return frames;
}

std::vector<Vector3d> axes_seen_from_middle(const std::vector<Drive>& drives) {
  const std::vector<Matrix3d> frames = frames_seen_from_middle(drives);
  std::vector<Vector3d> seen;
  for (std::size_t k = 0; k < frames.size(); ++k) seen.emplace_back(frames[k].transpose() * drives[k].axis);
  return seen;
}

bool have_one_range(const TreeJoint& one, const TreeJoint& other) {
  return one.motion == other.motion && one.limits.lower == other.limits.lower &&
         one.limits.upper == other.limits.upper;
}

bool is_one_sided(const JointLimits& limits) {
  const double range = limits.upper - limits.lower;
  return std::isfinite(range) && std::abs(limits.upper + limits.lower) > one_sided * range;
}

// The one whose axis is opposite to those of all others, which are alike.
std::optional<std::size_t> reversed(const std::vector<Vector3d>& axes) {
  for (std::size_t k = 0; k < axes.size(); ++k) {
    std::size_t opposite = 0;
    for (std::size_t other = 0; other < axes.size(); ++other)
      if (other != k && (axes[other] + axes[k]).norm() < alike) ++opposite;
    if (opposite + 1 == axes.size()) return k;
  }
  return std::nullopt;
}

// The one that is neither along nor against those of all others, which are alike.
std::optional<std::size_t> turned_away(const std::vector<Vector3d>& axes) {
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Vector3d& usual = axes[k == 0 ? 1 : 0];
    bool others_alike = axes[k].cross(usual).norm() > turned;
    for (std::size_t other = 0; other < axes.size(); ++other)
      others_alike = others_alike && (other == k || (axes[other] - usual).norm() < alike);
    if (others_alike) return k;
  }
  return std::nullopt;
}

bool are_one_kind(const Tree& tree, const std::vector<Drive>& drives) {
  return std::all_of(drives.begin(), drives.end(), [&](const Drive& drive) {
    return tree.joints[drive.joint].motion == tree.joints[drives.front().joint].motion;
  });
}

}  // namespace

std::vector<std::string> reversed_axes_notes(const Tree& tree, const ResolvedConfig& resolved,
                                             const SourceNames& files) {
  const std::vector<Drive> drives = drives_on_base(tree, resolved);
  if (drives.size() < 3) return {};
  const auto found = reversed(axes_seen_from_middle(drives));
  if (!found) return {};
  const TreeJoint& joint = tree.joints[drives[*found].joint];
  const bool same_limits = std::all_of(drives.begin(), drives.end(), [&](const Drive& drive) {
    return have_one_range(joint, tree.joints[drive.joint]);
  });
  if (!same_limits || !is_one_sided(joint.limits)) return {};
  return {files.urdf + " lets actuated joint '" + joint.name +
          "' move the other way round than those of the other legs, with the same limits, from " +
          number_text(joint.limits.lower) + " to " + number_text(joint.limits.upper) +
          "; if that is not meant, write <axis xyz=\"" + as_attribute(-joint.axis) + "\"/> for joint '" +
          joint.name + "'."};
}

Notes other_axes_notes(const Subject& subject, const Attempt& attempt) {
  const std::vector<Drive> drives = drives_on_base(subject.tree, subject.resolved);
  if (drives.size() < 3 || !are_one_kind(subject.tree, drives)) return {};
  const std::vector<Vector3d> seen = axes_seen_from_middle(drives);
  const auto found = turned_away(seen);
  if (!found) return {};
  const std::size_t joint = drives[*found].joint;
  const Vector3d usual = frames_seen_from_middle(drives)[*found] * seen[*found == 0 ? 1 : 0];
  const Vector3d axis = (drives[*found].turn.transpose() * usual).normalized();
  const Edit edit = edit_of(subject,
                            subject.files.urdf + " lets actuated " + subject.joint(joint) +
                                " move along another axis, " + in_brackets(subject.tree.joints[joint].axis) +
                                ", than those of the other legs, seen from the middle of these",
                            {MotionChange{joint, subject.tree.joints[joint].motion, axis}});
  return notes_of_working(subject, {edit}, "if that is not meant", attempt);
}

namespace {

// The joint that has the other end in that place on a link of the same name but for its number.
const TreeJoint* lender_of(const Tree& tree, const LinkFrame& end, const LinkFrame& other) {
  const Vector3d place = end.in_link.translation();
  if (place.norm() <= same_length) return nullptr;
  for (const TreeJoint& joint : tree.joints)
    if (!joint.variable && joint.child == other.link && joint.parent != end.link &&
        role_of(tree.links[joint.parent]) == role_of(tree.links[end.link]) &&
        (joint.origin.translation() - place).norm() <= same_length)
      return &joint;
  return nullptr;
}

}  // namespace

std::optional<Note> length_of_another_link(const Subject& subject, const Attempt& attempt) {
  const Tree& tree = subject.tree;
  const TreeJoint* lender = nullptr;
  ResolvedConfig changed = subject.resolved;
  for (Closure& closure : changed.closures)
    for (const std::size_t end : {0, 1})
      if (const TreeJoint* joint = lender_of(tree, closure.frames[end], closure.frames[1 - end])) {
        lender = joint;
        closure.frames[end].in_link.translation().setZero();
      }
  if (lender == nullptr || !attempt(subject.shared_tree, changed)) return std::nullopt;
  const std::string carrier = "'" + tree.links[lender->parent] + "'";
  return subject.file() + " ends legs by the length of another link: closures hold rods where joint '" +
         lender->name + "' has link '" + tree.links[lender->child] + "' on " + carrier +
         ", while the leg of " + carrier + " ends at its origin; end all legs so and write " +
         closures_entry(tree, with_known_types(subject.shared_tree, changed, attempt), subject.files) +
         ", or, if the legs differ, add a link at the end of each rod to " + subject.files.urdf + ".";
}

namespace {

// Those that hold its origin.
std::size_t closures_at(std::size_t link, const std::vector<Closure>& closures) {
  const auto is_origin = [link](const LinkFrame& frame) {
    return frame.link == link && frame.in_link.translation().isZero();
  };
  return static_cast<std::size_t>(std::count_if(
      closures.begin(), closures.end(),
      [&](const Closure& closure) { return is_origin(closure.frames[0]) || is_origin(closure.frames[1]); }));
}

std::string without_digits(std::string name) {
  const auto is_digit = [](unsigned char letter) { return std::isdigit(letter) != 0; };
  name.erase(std::remove_if(name.begin(), name.end(), is_digit), name.end());
  return name;
}

// Links of one body, the other of which carries nothing, whose names differ in digits alone.
bool are_numbered_alike(const Tree& tree, std::size_t one, std::size_t other) {
  return one != other && body_of(tree, one) == body_of(tree, other) && !has_child(tree, other) &&
         without_digits(tree.links[one]) == without_digits(tree.links[other]);
}

std::string digits_of(const std::string& name) {
  std::string digits;
  for (const char letter : name)
    if (std::isdigit(static_cast<unsigned char>(letter)) != 0) digits += letter;
  return digits;
}

// A closure that holds a link which another one holds, too, and a link of that number in none.
struct WrongNumber {
  const Closure* closure = nullptr;
  std::size_t meant = 0;
};

// By the number of the other end; nothing where it tells none.
std::optional<WrongNumber> wrong_number(const Tree& tree, const std::vector<Closure>& closures,
                                        std::size_t link, const std::vector<std::size_t>& free) {
  for (const Closure& closure : closures)
    for (const std::size_t end : {0, 1})
      for (const std::size_t other : free)
        if (closure.frames[end].link == link &&
            digits_of(tree.links[closure.frames[1 - end].link]) == digits_of(tree.links[other]))
          return WrongNumber{&closure, other};
  return std::nullopt;
}

std::vector<std::string> notes_of_numbers(const Tree& tree, const std::vector<Closure>& closures) {
  std::vector<std::string> notes;
  for (std::size_t link = 0; link < tree.links.size(); ++link) {
    const auto own_frames = closures_at(link, closures);
    if (own_frames < 2) continue;
    std::vector<std::size_t> free;
    for (std::size_t other = 0; other < tree.links.size(); ++other)
      if (are_numbered_alike(tree, link, other) && closures_at(other, closures) == 0) free.push_back(other);
    if (free.empty()) continue;
    const auto wrong = wrong_number(tree, closures, link, free);
    const std::string quoted = "'" + tree.links[wrong ? wrong->meant : free.front()] + "'";
    notes.push_back("Link '" + tree.links[link] + "' is in " +
                    (own_frames == 2 ? "two" : std::to_string(own_frames)) + " closures, and " + quoted +
                    " of the same body in none; where each joint has its own link, " +
                    (wrong ? "write link " + quoted + " in the place of '" + tree.links[link] +
                                 "' in closure '" + wrong->closure->name + "'."
                           : "correct the closures."));
  }
  return notes;
}

bool is_free_frame(const Tree& tree, const ResolvedConfig& resolved, std::size_t link, std::size_t body) {
  const auto joint = tree.joint_above[link];
  return joint && !tree.joints[*joint].variable && body_of(tree, link) == body && !has_child(tree, link) &&
         link != resolved.actuated_joints.platform_link && closures_at(link, resolved.closures) == 0 &&
         !tree.joints[*joint].origin.translation().isZero();
}

// Of the body of the platform.
std::vector<std::string> notes_of_shared_joints(const Tree& tree, const ResolvedConfig& resolved) {
  std::vector<std::string> notes;
  const std::size_t body = body_of(tree, resolved.actuated_joints.platform_link);
  const auto joint = tree.joint_above[body];
  for (const Closure& closure : resolved.closures)
    for (const LinkFrame& frame : closure.frames)
      for (std::size_t other = 0; joint && other < tree.links.size(); ++other)
        if (frame.link == body && frame.in_link.translation().isZero() &&
            is_free_frame(tree, resolved, other, body)) {
          const std::string link = "'" + tree.links[body] + "'", free = "'" + tree.links[other] + "'";
          notes.push_back("Closure '" + closure.name + "' holds link " + link + " where its joint '" +
                          tree.joints[*joint].name + "' is, so that two legs share a place, and " + free +
                          " of the same body is in no closure; if that is meant, write link " + free +
                          " in the place of " + link + " in closure '" + closure.name + "'.");
          break;
        }
  return notes;
}

}  // namespace

std::vector<std::string> shared_frame_notes(const Tree& tree, const ResolvedConfig& resolved, double size) {
  std::vector<std::string> notes = notes_of_numbers(tree, resolved.closures);
  if (!legs_share_anchors(tree, resolved, size)) return notes;
  for (const std::string& note : notes_of_shared_joints(tree, resolved)) notes.push_back(note);
  return notes;
}

}  // namespace parallel_aspects
