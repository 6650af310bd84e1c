// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "urdf/corrections/edits.h"
#include "urdf/description/xml_values.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double near_angle = 0.15;  // of an axis that was meant to be parallel, below a meant slant [rad]
constexpr double max_misfits = 1.0 / 3.0;  // of the axes, where these are all meant to share something
constexpr std::size_t max_alone = 4;       // that are put right without the others: more are meant so
constexpr double decimal = 1e-6;           // to which values are printed, much finer than what is accepted

constexpr const char* consequence = ", so that the loops hold too much";

// The axis of a joint, in the base frame.
struct Axis {
  std::size_t joint = 0;  // of the tree
  Vector3d point, direction;
};

// An axis and what its direction should be.
struct Misfit {
  const Axis* axis;
  Vector3d direction;

  Vector3d same_way() const { return std::copysign(1.0, axis->direction.dot(direction)) * direction; }
};

double angle_between(const Vector3d& one, const Vector3d& other) {
  return std::atan2(one.cross(other).norm(), std::abs(one.dot(other)));
}

Vector3d rounded(const Vector3d& vector) { return (vector / decimal).array().round().matrix() * decimal; }

// How far the axis is beside the point [m].
Vector3d to_point(const Axis& axis, const Vector3d& point) {
  const Vector3d between = point - axis.point;
  return between - axis.direction * axis.direction.dot(between);
}

class MisfitFinder {
 public:
  MisfitFinder(const Subject& subject, const Eigen::VectorXd& values)
      : s_(subject), poses_(link_poses(subject.tree, subject.resolved.base, values)) {
    for (std::size_t k = 0; k < s_.tree.joints.size(); ++k) {
      const TreeJoint& joint = s_.tree.joints[k];
      if (joint.motion == JointMotion::revolute && s_.system.in_loop()[*joint.variable])
        axes_.push_back({k, poses_[joint.child].translation(), poses_[joint.child].linear() * joint.axis});
    }
  }

  Edits find() {
    if (const auto common = common_direction())
      add(beside(*common), "the direction that the axes of the other joints share");
    add(beside_neighbours(), "axes that are parallel to each other");
    if (const auto center = common_point())
      if (const auto missing = those_missing(*center); !missing.empty())
        add_shifted(*missing.front(), to_point(*missing.front(), *center));
    return std::move(found_);
  }

 private:
  bool are_few(std::size_t others) const {
    return others > 0 && static_cast<double>(others) <= max_misfits * static_cast<double>(axes_.size());
  }

  std::vector<Misfit> beside(const Vector3d& direction) const {
    std::vector<Misfit> misfits;
    for (const Axis& axis : axes_)
      if (angle_between(axis.direction, direction) > rank_tolerance) misfits.push_back({&axis, direction});
    return misfits;
  }

  std::optional<Vector3d> common_direction() const {
    for (const Axis& axis : axes_)
      if (are_few(beside(axis.direction).size())) return axis.direction;
    return std::nullopt;
  }

  // Those with few parallels near a direction with more of them.
  std::vector<Misfit> beside_neighbours() const {
    std::vector<Misfit> misfits;
    for (const Axis& axis : axes_) {
      const Axis* neighbour = &axis;
      for (const Axis& other : axes_)
        if (angle_between(axis.direction, other.direction) < near_angle &&
            beside(other.direction).size() < beside(neighbour->direction).size())
          neighbour = &other;
      if (neighbour != &axis) misfits.push_back({&axis, neighbour->direction});
    }
    return misfits;
  }

  // Where two axes come nearest to each other, if most of the others pass there.
  std::optional<Vector3d> common_point() const {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Vector3d normal = axes_[i].direction.cross(axes_[k].direction);
        if (normal.norm() < near_angle) continue;
        const Vector3d between = axes_[k].point - axes_[i].point;
        const double along = between.cross(axes_[k].direction).dot(normal) / normal.squaredNorm();
        const Vector3d point = axes_[i].point + along * axes_[i].direction;
        if (are_few(those_missing(point).size())) return point;
      }
    return std::nullopt;
  }

  std::vector<const Axis*> those_missing(const Vector3d& point) const {
    std::vector<const Axis*> missing;
    for (const Axis& axis : axes_)
      if (to_point(axis, point).norm() > rank_tolerance * s_.size()) missing.push_back(&axis);
    return missing;
  }

  void add(const std::vector<Misfit>& misfits, const std::string& from) {
    if (misfits.empty()) return;
    for (std::size_t k = 0; k < misfits.size() && k < max_alone; ++k) add_turned_axes({misfits[k]}, from);
    if (misfits.size() > 1) add_turned_axes(misfits, from);
    add_turned_frame(misfits.front(), from);
  }

  // With all that hangs on it.
  void add_shifted(const Axis& axis, const Vector3d& shift) {
    const TreeJoint& joint = s_.tree.joints[axis.joint];
    const Vector3d place =
        rounded(joint.origin.translation() + poses_[joint.parent].linear().transpose() * shift);
    found_.push_back(edit_of(
        s_,
        s_.files.urdf + " puts the axis of " + s_.joint(axis.joint) + " " + number_text(shift.norm(), 3) +
            " m beside the point that the axes of the other joints meet in" + consequence,
        {OriginChange{axis.joint, place, std::nullopt}}, true));
  }

  std::string fault(const Misfit& misfit, const std::string& from) const {
    return "turns the axis of " + s_.joint(misfit.axis->joint) + " " +
           number_text(angle_between(misfit.axis->direction, misfit.direction), 3) + " rad away from " + from;
  }

  void add_turned_axes(const std::vector<Misfit>& misfits, const std::string& from) {
    std::vector<Change> turned;
    std::string faults;
    for (const Misfit& misfit : misfits) {
      const TreeJoint& joint = s_.tree.joints[misfit.axis->joint];
      const Eigen::Matrix3d frame = poses_[joint.parent].linear() * joint.origin.linear();
      const Vector3d axis = (frame.transpose() * misfit.same_way()).normalized();
      turned.emplace_back(MotionChange{misfit.axis->joint, JointMotion::revolute, rounded(axis)});
      faults += (faults.empty() ? s_.files.urdf + " " : ", and ") + fault(misfit, from);
    }
    found_.push_back(edit_of(s_, faults + consequence, std::move(turned), true));
  }

  // With all that hangs on it, as where the rpy of its origin is wrong.
  void add_turned_frame(const Misfit& misfit, const std::string& from) {
    const TreeJoint& joint = s_.tree.joints[misfit.axis->joint];
    const auto turn = shortest_rotation(misfit.axis->direction, misfit.same_way());
    const Eigen::Matrix3d parent = poses_[joint.parent].linear();
    const Eigen::Matrix3d origin =
        parent.transpose() * turn.toRotationMatrix() * parent * joint.origin.linear();
    found_.push_back(
        edit_of(s_, s_.files.urdf + " " + fault(misfit, from) + consequence,
                {OriginChange{misfit.axis->joint, std::nullopt, rounded(roll_pitch_yaw(origin))}}, true));
  }

  const Subject& s_;
  Poses poses_;
  std::vector<Axis> axes_;
  Edits found_;
};

}  // namespace

Edits axis_edits(const Subject& subject, const Eigen::VectorXd& values) {
  return MisfitFinder(subject, values).find();
}

}  // namespace parallel_aspects
