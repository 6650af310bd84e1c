// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/misfit_axes.h"

#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "urdf/closing/actuation_choices.h"
#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/listed_corrections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double near_angle = 0.15;        // of an axis that was meant to be parallel [rad]
constexpr double max_misfits = 1.0 / 3.0;  // of the axes, where these are all meant to share something

constexpr std::size_t max_alone = 4;  // that are put right without the others

// The axis of a joint, in the base frame.
struct Axis {
  std::size_t joint = 0;  // of the tree
  Vector3d point, direction;
};

// An axis and what its direction should be.
struct Misfit {
  const Axis* axis;
  Vector3d direction;
};

// An axis and how far the point that it should go through is beside it [m].
struct Miss {
  const Axis* axis;
  Vector3d shift;
};

double angle_between(const Vector3d& one, const Vector3d& other) {
  return std::atan2(one.cross(other).norm(), std::abs(one.dot(other)));
}

// To six decimals, which is far inside of what is accepted.
std::string triple(const Vector3d& vector) {
  std::string text;
  for (Eigen::Index k = 0; k < 3; ++k) {
    std::array<char, 32> digits{};
    const double rounded = std::round(vector[k] * 1e6) / 1e6;
    std::snprintf(digits.data(), digits.size(), "%.9g", rounded == 0.0 ? 0.0 : rounded);
    text += (text.empty() ? "" : " ") + std::string(digits.data());
  }
  return text;
}

class MisfitFinder {
 public:
  MisfitFinder(const ClosureSystem& system, const Eigen::VectorXd& values, const SourceNames& files)
      : system_(system), files_(files), poses_(link_poses(system.tree(), system.base(), values)) {
    const Tree& tree = system.tree();
    for (std::size_t k = 0; k < tree.joints.size(); ++k) {
      const TreeJoint& joint = tree.joints[k];
      if (joint.motion == JointMotion::revolute && system.in_loop()[*joint.variable])
        axes_.push_back({k, poses_[joint.child].translation(), poses_[joint.child].linear() * joint.axis});
    }
  }

  Corrections find() {
    if (const auto common = common_direction())
      add(beside(*common), "the direction that the axes of the other joints share");
    add(beside_neighbours(), "axes that are parallel to each other");
    if (const auto center = common_point()) {
      const std::vector<Miss> misses = missing(*center);
      if (!misses.empty()) add_shifted(misses.front());
    }
    return std::move(found_);
  }

 private:
  bool are_most(std::size_t others) const {
    return others > 0 && static_cast<double>(others) <= max_misfits * static_cast<double>(axes_.size());
  }

  std::size_t count_beside(const Vector3d& direction) const {
    return static_cast<std::size_t>(std::count_if(axes_.begin(), axes_.end(), [&](const Axis& axis) {
      return angle_between(axis.direction, direction) > rank_tolerance;
    }));
  }

  std::optional<Vector3d> common_direction() const {
    for (const Axis& axis : axes_)
      if (are_most(count_beside(axis.direction))) return axis.direction;
    return std::nullopt;
  }

  std::vector<Misfit> beside(const Vector3d& direction) const {
    std::vector<Misfit> misfits;
    for (const Axis& axis : axes_)
      if (angle_between(axis.direction, direction) > rank_tolerance) misfits.push_back({&axis, direction});
    return misfits;
  }

  std::size_t count_parallel(const Vector3d& direction) const {
    return axes_.size() - count_beside(direction);
  }

  // Those with few parallels near a direction with more of them.
  std::vector<Misfit> beside_neighbours() const {
    std::vector<Misfit> misfits;
    for (const Axis& axis : axes_) {
      const Axis* neighbour = nullptr;
      for (const Axis& other : axes_)
        if (angle_between(axis.direction, other.direction) < near_angle &&
            (neighbour == nullptr || count_parallel(other.direction) > count_parallel(neighbour->direction)))
          neighbour = &other;
      if (count_parallel(neighbour->direction) > count_parallel(axis.direction))
        misfits.push_back({&axis, neighbour->direction});
    }
    return misfits;
  }

  static Vector3d to_point(const Axis& axis, const Vector3d& point) {
    const Vector3d between = point - axis.point;
    return between - axis.direction * axis.direction.dot(between);
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
        if (are_most(missing(point).size())) return point;
      }
    return std::nullopt;
  }

  std::vector<Miss> missing(const Vector3d& point) const {
    std::vector<Miss> misses;
    for (const Axis& axis : axes_)
      if (to_point(axis, point).norm() > rank_tolerance * system_.size())
        misses.push_back({&axis, to_point(axis, point)});
    return misses;
  }

  void add(const std::vector<Misfit>& misfits, const std::string& from) {
    if (misfits.empty()) return;
    for (std::size_t k = 0; k < misfits.size() && k < max_alone; ++k) add_turned_axes({misfits[k]}, from);
    if (misfits.size() > 1) add_turned_axes(misfits, from);
    add_turned_frame(misfits.front(), from);
  }

  // With all that hangs on it.
  void add_shifted(const Miss& miss) {
    const TreeJoint& joint = joint_of(*miss.axis);
    Eigen::Isometry3d origin = joint.origin;
    origin.translation() += poses_[joint.parent].linear().transpose() * miss.shift;
    found_.push_back(
        {quoted(*miss.axis),
         files_.urdf + " puts the axis of " + quoted(*miss.axis) + " " + number_text(miss.shift.norm(), 3) +
             " m beside the point that the axes of the other joints meet in" + consequence,
         "write xyz=\"" + triple(origin.translation()) + "\" in the origin of " + quoted(*miss.axis), true,
         with_origin(miss.axis->joint, origin)});
  }

  const TreeJoint& joint_of(const Axis& axis) const { return system_.tree().joints[axis.joint]; }

  std::string quoted(const Axis& axis) const { return "joint '" + joint_of(axis).name + "'"; }

  static std::function<void(Tree&, ResolvedConfig&)> with_origin(std::size_t joint,
                                                                 const Eigen::Isometry3d& origin) {
    return [joint, origin](Tree& tree, ResolvedConfig&) { tree.joints[joint].origin = origin; };
  }

  std::string fault(const Misfit& misfit, const std::string& from) const {
    return "turns the axis of " + quoted(*misfit.axis) + " " +
           number_text(angle_between(misfit.axis->direction, misfit.direction), 3) + " rad away from " + from;
  }

  void add_turned_axes(const std::vector<Misfit>& misfits, const std::string& from) {
    Correction correction;
    std::vector<std::pair<std::size_t, Vector3d>> turned;
    for (const Misfit& misfit : misfits) {
      const TreeJoint& joint = joint_of(*misfit.axis);
      const Eigen::Matrix3d frame = poses_[joint.parent].linear() * joint.origin.linear();
      turned.emplace_back(misfit.axis->joint, (frame.transpose() * same_way(misfit)).normalized());
      const bool first = correction.element.empty();
      correction.element += (first ? "" : " and ") + quoted(*misfit.axis);
      correction.fault += (first ? files_.urdf + " " : ", and ") + fault(misfit, from);
      correction.remedy += (first ? "" : ", and ") + std::string("write <axis xyz=\"") +
                           triple(turned.back().second) + "\"/> for " + quoted(*misfit.axis);
    }
    correction.fault += consequence;
    correction.like_others = true;
    correction.apply = [turned](Tree& tree, ResolvedConfig&) {
      for (const auto& [joint, axis] : turned) tree.joints[joint].axis = axis;
    };
    found_.push_back(std::move(correction));
  }

  // With all that hangs on it, as where the rpy of its origin is wrong.
  void add_turned_frame(const Misfit& misfit, const std::string& from) {
    const TreeJoint& joint = joint_of(*misfit.axis);
    const auto turn = shortest_rotation(misfit.axis->direction, same_way(misfit));
    const Eigen::Matrix3d parent = poses_[joint.parent].linear();
    Eigen::Isometry3d origin = joint.origin;
    origin.linear() = (parent.transpose() * turn.toRotationMatrix() * parent * joint.origin.linear()).eval();
    found_.push_back({quoted(*misfit.axis), files_.urdf + " " + fault(misfit, from) + consequence,
                      "write rpy=\"" + triple(roll_pitch_yaw(origin.linear())) + "\" in the origin of " +
                          quoted(*misfit.axis),
                      true, with_origin(misfit.axis->joint, origin)});
  }

  static Vector3d same_way(const Misfit& misfit) {
    return std::copysign(1.0, misfit.axis->direction.dot(misfit.direction)) * misfit.direction;
  }

  static constexpr const char* consequence = ", so that the loops hold too much";

  const ClosureSystem& system_;
  const SourceNames& files_;
  Poses poses_;
  std::vector<Axis> axes_;
  Corrections found_;
};

}  // namespace

Corrections find_axis_corrections(const ClosureSystem& system, const Eigen::VectorXd& values,
                                  const SourceNames& files) {
  return MisfitFinder(system, values, files).find();
}

std::optional<std::string> misfit_types(const std::shared_ptr<const Tree>& tree,
                                        const ResolvedConfig& resolved, const Eigen::VectorXd& values,
                                        const SourceNames& files) {
  if (resolved.actuation_origin.empty()) return std::nullopt;
  std::string names;
  std::vector<Closure> closures = resolved.closures;
  for (Closure& closure : closures) {
    if (closure.type != ClosureType::point) names += (names.empty() ? "'" : ", '") + closure.name + "'";
    closure.type = ClosureType::point;
  }
  const ClosureSystem balls(tree, resolved.base, closures);
  const auto freedom = static_cast<std::size_t>(loop_motions(balls, values).motions.cols());
  if (names.empty() || freedom < 2 || !is_actuation_count(freedom)) return std::nullopt;
  return file_of_closures(resolved, files) + " closes loops of " + files.urdf +
         " by types that leave it one degree of freedom, as their axes are not along those of its joints; "
         "write " +
         type_text(resolved, ClosureType::point) + " for " + names + ", which leaves it " +
         std::to_string(freedom) + ".";
}

}  // namespace parallel_aspects
