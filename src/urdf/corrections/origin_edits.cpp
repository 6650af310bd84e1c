// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "urdf/corrections/edits.h"
#include "urdf/description/xml_values.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* pattern = ", beside the pattern of the others on its parent";

Vector3d with_sign(Vector3d vector, Eigen::Index changed) {
  vector[changed] = -vector[changed];
  return vector;
}

class OriginEdits {
 public:
  OriginEdits(const Subject& subject, std::size_t joint)
      : s_(subject),
        index_(joint),
        origin_(subject.tree.joints[joint].origin),
        place_(origin_.translation()),
        angles_(roll_pitch_yaw(origin_.linear())) {}

  Edits find() {
    add_units();
    add_of_siblings();
    for (Eigen::Index k = 0; k < 3; ++k)
      if (std::abs(place_[k]) > rank_tolerance * place_.norm()) add_place(with_sign(place_, k));
    add_of_pattern();
    add_other_angles();
    if (angles_.norm() < rank_tolerance) return std::move(found_);
    add_angles(Vector3d::Zero());
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (std::abs(angles_[k]) < rank_tolerance) continue;
      add_angles(with_sign(angles_, k));
      Vector3d without = angles_;
      without[k] = 0.0;
      add_angles(without);
    }
    return std::move(found_);
  }

 private:
  Vector3d place_of(std::size_t joint) const { return s_.tree.joints[joint].origin.translation(); }
  Vector3d angles_of(std::size_t joint) const {
    return roll_pitch_yaw(s_.tree.joints[joint].origin.linear());
  }

  // Legs of different lengths are no fault.
  void add_of_siblings() {
    const LoopJoints& loops = s_.loops;
    for (const UsualSibling& usual :
         usual_siblings(loops, index_, [&](std::size_t a, std::size_t b) { return loops.same_place(a, b); }))
      if (usual.is_most)
        add_place(place_of(usual.joint),
                  ", where that of other legs has " + in_brackets(place_of(usual.joint)) + " m", true);
    for (const UsualSibling& usual : usual_siblings(
             loops, index_, [&](std::size_t a, std::size_t b) { return loops.same_direction(a, b); }))
      add_angles(angles_of(usual.joint),
                 ", where that of " + (usual.is_most ? "other legs" : s_.joint(usual.joint)) + " has " +
                     in_brackets(angles_of(usual.joint)),
                 usual.is_most);
  }

  // Those on its parent, where others of them are like each other but for a sign or a turn of the parent:
  // where one more of such a pattern is.
  void add_of_pattern() {
    std::vector<Eigen::Isometry3d> others;
    for (const std::size_t sibling : s_.loops.siblings(index_))
      if (s_.tree.joints[sibling].parent == s_.tree.joints[index_].parent)
        others.push_back(s_.tree.joints[sibling].origin);
    for (const Eigen::Isometry3d& one : others)
      for (Eigen::Index k = 0; k < 3; ++k) add_like(one, with_sign(one.translation(), k), others);
    for (std::size_t k = 0; k < others.size(); ++k)
      for (std::size_t other = 0; other < others.size(); ++other) {
        if (k == other) continue;
        add_turned(others[k].linear() * others[other].linear().transpose(), others[k], others);
        const Matrix3d turn =
            shortest_rotation(others[other].translation(), others[k].translation()).toRotationMatrix();
        for (const Eigen::Isometry3d& turned : others) add_like(turned, turn * turned.translation(), others);
      }
  }

  static bool any_is_like(const Eigen::Isometry3d& one, const std::vector<Eigen::Isometry3d>& others) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Eigen::Isometry3d& other) { return one.isApprox(other, rank_tolerance); });
  }

  // About the origin of the parent, by what turns one of the others into another.
  void add_turned(const Matrix3d& turn, const Eigen::Isometry3d& other,
                  const std::vector<Eigen::Isometry3d>& others) {
    const Eigen::Isometry3d turned = Eigen::Isometry3d(turn) * other;
    const bool is_at_place = (place_ - turned.translation()).norm() <= rank_tolerance * place_.norm();
    if (is_at_place && !any_is_like(turned, others)) add_angles(roll_pitch_yaw(turned.linear()), pattern);
  }

  // A place of a frame that is turned as this one.
  void add_like(Eigen::Isometry3d other, const Vector3d& place,
                const std::vector<Eigen::Isometry3d>& others) {
    const bool is_turned_alike = (other.linear() - origin_.linear()).norm() < rank_tolerance;
    other.translation() = place;
    if (is_turned_alike && (place - place_).norm() > rank_tolerance * place.norm() &&
        !any_is_like(other, others))
      add_place(place, pattern);
  }

  // Of frames, as those of a leg on the base and on the platform.
  void add_other_angles() {
    if (s_.tree.joints[index_].motion != JointMotion::fixed) return;
    for (const std::size_t joint : s_.loops.all())
      if (joint != index_ && s_.tree.joints[joint].motion == JointMotion::fixed &&
          !s_.loops.same_direction(index_, joint))
        add_angles(angles_of(joint),
                   ", where that of " + s_.joint(joint) + " has " + in_brackets(angles_of(joint)));
  }

  // Where it is the one that stands out.
  void add_units() {
    const double own = place_.norm(), usual = s_.loops.usual_length(index_);
    if (usual == 0.0 || own == 0.0) return;
    if (own > out_of_scale * usual) add_place(millimetre * place_, ", as if in millimetres", true);
    if (own * out_of_scale < usual) add_place(place_ / millimetre, ", as if in kilometres", true);
  }

  void add_place(const Vector3d& place, const std::string& reason = "", bool like_others = false) {
    add("puts the origin of " + s_.joint(index_) + " at " + in_brackets(place_) + " m" + reason,
        {index_, place, std::nullopt}, like_others);
  }

  void add_angles(const Vector3d& angles, const std::string& reason = "", bool like_others = false) {
    add("turns the origin of " + s_.joint(index_) + " by rpy " + in_brackets(angles_) + reason,
        {index_, std::nullopt, angles}, like_others);
  }

  void add(const std::string& fault, const OriginChange& change, bool like_others) {
    Edit edit = edit_of(s_, s_.files.urdf + " " + fault, {change}, like_others);
    if (std::none_of(found_.begin(), found_.end(),
                     [&](const Edit& other) { return other.remedy == edit.remedy; }))
      found_.push_back(std::move(edit));
  }

  const Subject& s_;
  std::size_t index_;
  const Eigen::Isometry3d& origin_;
  Vector3d place_, angles_;  // as the origin has them
  Edits found_;
};

}  // namespace

Edits origin_edits(const Subject& subject, std::size_t joint) { return OriginEdits(subject, joint).find(); }

}  // namespace parallel_aspects
