// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/gap_corrections.h"

#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* pattern = ", beside the pattern of the others on its parent";

constexpr double out_of_scale = 30.0;  // of a length in mm against the others in m, at least

class GapCorrections {
 public:
  GapCorrections(const Tree& tree, const LoopJoints& loops, std::size_t joint, const SourceNames& files)
      : tree_(tree),
        loops_(loops),
        index_(joint),
        name_("joint '" + tree.joints[joint].name + "'"),
        files_(files),
        place_(tree.joints[joint].origin.translation()),
        angles_(roll_pitch_yaw(tree.joints[joint].origin.linear())) {}

  Corrections find() {
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
  static Vector3d with_sign(Vector3d vector, Eigen::Index changed) {
    vector[changed] = -vector[changed];
    return vector;
  }

  template <class Same, class Add>
  void add_common(Same same, Add add) {
    const std::vector<std::size_t> siblings = loops_.siblings(index_);
    const auto like = [&](std::size_t joint) {
      return std::count_if(siblings.begin(), siblings.end(),
                           [&](std::size_t other) { return same(joint, other); });
    };
    const auto own = like(index_) + 1;
    for (const std::size_t sibling : siblings) {
      const auto count = like(sibling);
      if (same(index_, sibling) || count < own) continue;
      const bool like_others = count > own && count > 1;
      add(sibling, like_others,
          ", where that of " + (like_others ? "other legs" : "joint '" + tree_.joints[sibling].name + "'") +
              " has ");
    }
  }

  void add_of_siblings() {
    add_common([this](std::size_t a, std::size_t b) { return loops_.same_place(a, b); },
               [this](std::size_t sibling, bool like_others, const std::string& reason) {
                 if (!like_others) return;  // legs of different lengths are no fault
                 const Vector3d place = tree_.joints[sibling].origin.translation();
                 add_place(place, reason + in_brackets(place) + " m", true);
               });
    add_common([this](std::size_t a, std::size_t b) { return loops_.same_direction(a, b); },
               [this](std::size_t sibling, bool like_others, const std::string& reason) {
                 const Vector3d angles = roll_pitch_yaw(tree_.joints[sibling].origin.linear());
                 add_angles(angles, reason + in_brackets(angles), like_others);
               });
  }

  // Those on its parent, where others of them are like each other but for a sign or a turn of the parent:
  // where one more of such a pattern is.
  void add_of_pattern() {
    const std::vector<Eigen::Isometry3d> others = beside();
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

  // The siblings on its parent.
  std::vector<Eigen::Isometry3d> beside() const {
    std::vector<Eigen::Isometry3d> others;
    for (const std::size_t sibling : loops_.siblings(index_))
      if (tree_.joints[sibling].parent == tree_.joints[index_].parent)
        others.push_back(tree_.joints[sibling].origin);
    return others;
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
    const bool is_turned_alike =
        (other.linear() - tree_.joints[index_].origin.linear()).norm() < rank_tolerance;
    other.translation() = place;
    if (is_turned_alike && (place - place_).norm() > rank_tolerance * place.norm() &&
        !any_is_like(other, others))
      add_place(place, pattern);
  }

  // Of frames, as those of a leg on the base and on the platform.
  void add_other_angles() {
    if (tree_.joints[index_].motion != JointMotion::fixed) return;
    for (const std::size_t joint : loops_.all())
      if (joint != index_ && tree_.joints[joint].motion == JointMotion::fixed &&
          !loops_.same_direction(index_, joint))
        add_angles(roll_pitch_yaw(tree_.joints[joint].origin.linear()),
                   ", where that of joint '" + tree_.joints[joint].name + "' has " +
                       in_brackets(roll_pitch_yaw(tree_.joints[joint].origin.linear())));
  }

  // Where it is the one that stands out.
  void add_units() {
    const double own = place_.norm();
    std::vector<double> lengths;
    for (const std::size_t joint : loops_.all()) {
      const double length = tree_.joints[joint].origin.translation().norm();
      if (joint != index_ && length > 0.0) lengths.push_back(length);
    }
    if (lengths.empty() || own == 0.0) return;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    if (own > out_of_scale * *middle) add_place(1e-3 * place_, ", as if in millimetres", true);
    if (own * out_of_scale < *middle) add_place(1e3 * place_, ", as if in kilometres", true);
  }

  void add_place(const Vector3d& place, const std::string& reason = "", bool like_others = false) {
    add("puts the origin of " + name_ + " at " + in_brackets(place_) + " m" + reason,
        "xyz=\"" + as_attribute(place) + "\"", like_others,
        [joint = index_, place](Tree& tree, ResolvedConfig&) {
          tree.joints[joint].origin.translation() = place;
        });
  }

  void add_angles(const Vector3d& angles, const std::string& reason = "", bool like_others = false) {
    add("turns the origin of " + name_ + " by rpy " + in_brackets(angles_) + reason,
        "rpy=\"" + as_attribute(angles) + "\"", like_others,
        [joint = index_, angles](Tree& tree, ResolvedConfig&) {
          tree.joints[joint].origin.linear() = rotation_of(angles);
        });
  }

  void add(const std::string& fault, const std::string& attribute, bool like_others,
           std::function<void(Tree&, ResolvedConfig&)> apply) {
    const std::string remedy = "write " + attribute + " in the origin of " + name_;
    const bool is_known = std::any_of(found_.begin(), found_.end(),
                                      [&](const Correction& other) { return other.remedy == remedy; });
    if (!is_known)
      found_.push_back({name_, files_.urdf + " " + fault, remedy, like_others, std::move(apply)});
  }

  const Tree& tree_;
  const LoopJoints& loops_;
  std::size_t index_;
  std::string name_;
  const SourceNames& files_;
  Vector3d place_, angles_;  // as the origin has them
  Corrections found_;
};

}  // namespace

Corrections gap_corrections(const Tree& tree, const LoopJoints& loops, std::size_t joint,
                            const SourceNames& files) {
  return GapCorrections(tree, loops, joint, files).find();
}

}  // namespace parallel_aspects
