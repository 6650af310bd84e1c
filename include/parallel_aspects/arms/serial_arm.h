// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_SERIAL_ARM_H
#define PARALLEL_ASPECTS_ARMS_SERIAL_ARM_H

#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

inline constexpr double half_turn = 3.14159265358979323846;  ///< [rad]

/// The motion of the operational point that a serial arm is for. It has as many coordinates as the arm has
/// joints.
enum class ArmTask {
  plane_position,          ///< x, y in the plane of the arm
  plane_pose,              ///< x, y and the turn in that plane
  position,                ///< x, y, z
  direction,               ///< where the z axis of the operational point's frame points
  orientation,             ///< its orientation
  position_and_turn,       ///< x, y, z and the turn about the one direction of all axes, as of a SCARA
  position_and_direction,  ///< x, y, z, and where the z axis points
  pose,                    ///< position and orientation
};

/// All of them, for whoever reads one by its name.
inline constexpr std::array<ArmTask, 8> choices(ArmTask /*tag*/) {
  return {ArmTask::plane_position,
          ArmTask::plane_pose,
          ArmTask::position,
          ArmTask::direction,
          ArmTask::orientation,
          ArmTask::position_and_turn,
          ArmTask::position_and_direction,
          ArmTask::pose};
}
const char* name(ArmTask task);              ///< "plane_pose"
std::size_t coordinate_count(ArmTask task);  ///< 2 to 6
std::vector<std::string> coordinate_names(
    ArmTask task);  ///< of its coordinates, which `task_coordinates` has

/// An angle whose cosine and sine are rational numbers: a number of quarter turns and a rest, by the tangent
/// of half the rest in units of 1e-12.
struct RationalAngle {
  int quarters = 0;               ///< quarter turns, 0 to 3
  std::int64_t half_tangent = 0;  ///< of half the rest [1e-12]

  double value() const noexcept;  ///< [rad]
};

/// A joint and the link behind it, after Denavit and Hartenberg: turn about z and shift along z by `turn` and
/// `offset`, one of which the joint value is added to, then shift along x by `length` and turn about x by
/// `twist`. Lengths are whole nanometres.
struct ArmJoint {
  std::string name;         ///< in the URDF
  bool turns = true;        ///< about its axis; else it slides along it
  JointLimits limits;       ///< [rad or m]
  RationalAngle turn;       ///< about z
  RationalAngle twist;      ///< about x
  std::int64_t offset = 0;  ///< along z [nm]
  std::int64_t length = 0;  ///< along x [nm]
};

/// A joint of an arm as it is described, while all joints are zero, in the frame of the base link.
struct ArmAxis {
  std::string name;                                      ///< of the joint
  bool turns = true;                                     ///< about the axis; else it slides along it
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       ///< on the axis [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector
  JointLimits limits;                                    ///< [rad or m]
};

/// What an arm is made of.
struct ArmDescription {
  std::string name;                                       ///< in messages
  std::string base_link;                                  ///< in whose frame poses are
  std::string tip_link;                                   ///< whose origin the operational point is
  std::vector<ArmAxis> axes;                              ///< from the base on
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();  ///< frame of the operational point [m]
  std::optional<ArmTask> task;                            ///< nothing: by the number of joints
  double tolerance = 1e-4;  ///< axes that lack this share of the arm's size of meeting meet; likewise [rad]
  std::vector<std::string> notes;  ///< of the reader; messages
};

/// A serial arm: a chain of joints, each of which turns or slides, from a base link to an operational point.
/// Immutable.
///
/// It is the arm of an ideal geometry: axes that are parallel, perpendicular or meet but for what CAD rounds
/// are exactly so, lengths are whole nanometres, and cosines and sines of other angles are rational. Then det
/// J is a polynomial in cosines and sines with rational coefficients, of which exact facts can be proved.
class SerialArm {
 public:
  /// Throws `InvalidDescription` where it has more joints than its task has coordinates, or fewer, or where
  /// they cannot do the task.
  explicit SerialArm(const ArmDescription& description);

  const std::string& name() const noexcept { return name_; }            ///< in messages
  const std::string& base_link() const noexcept { return base_link_; }  ///< in whose frame poses are
  const std::string& tip_link() const noexcept {
    return tip_link_;
  }                                                ///< whose origin the operational point is
  ArmTask task() const noexcept { return task_; }  ///< what it is for
  const std::vector<ArmJoint>& joints() const noexcept { return joints_; }  ///< from the base on
  std::size_t size() const noexcept { return joints_.size(); }              ///< number of joints
  double reach() const noexcept { return reach_; }  ///< sum of its lengths and offsets [m]

  /// Height of the operational point above the last frame, along its z axis [nm].
  std::int64_t tip_height() const noexcept { return tip_height_; }

  /// What the ideal geometry changed, and other messages.
  const std::vector<std::string>& notes() const noexcept { return notes_; }

  /// Whether joint i turns all the way round: its limits leave a full turn, so that they bound no aspect.
  bool turns_freely(std::size_t i) const noexcept;

  /// Frames of the base and of each link, the last of them with its z axis through the operational point, or
  /// along the last axis where the task is a pose [m], in the frame of the base link.
  std::vector<Eigen::Isometry3d> frames(const Eigen::VectorXd& q) const;

  /// Frame of the operational point, in that of the base link [m].
  Eigen::Isometry3d tip(const Eigen::VectorXd& q) const;

  /// What is added to the last frame.
  const Eigen::Isometry3d& tool() const noexcept { return tool_; }
  const Eigen::Isometry3d& base() const noexcept { return base_; }  ///< the first frame

  /// Its columns are the velocities of `task_coordinates`, angular ones in the base frame, for unit joint
  /// velocities. Of directions: the angular velocity across it, in two coordinates.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& q) const;

  /// x, y in the plane, its normal last: the frame in which planar tasks have their coordinates.
  const Eigen::Matrix3d& plane() const noexcept { return plane_; }

  /// Coordinates of a frame of the operational point: positions [m], then a turn since all joints were zero
  /// [rad], a unit vector, or roll, pitch and yaw [rad].
  Eigen::VectorXd task_coordinates(const Eigen::Isometry3d& tip) const;

  /// Whether joint values are within limits, those of turning joints modulo turns where they turn freely.
  bool within_limits(const Eigen::VectorXd& q) const noexcept;

 private:
  void choose_task(const ArmDescription& description);
  void choose_plane(const ArmDescription& description);

  std::string name_, base_link_, tip_link_;
  ArmTask task_ = ArmTask::pose;
  std::vector<ArmJoint> joints_;
  Eigen::Isometry3d base_ = Eigen::Isometry3d::Identity(), tool_ = base_, tip_at_zero_ = base_;
  Eigen::Matrix3d plane_ = Eigen::Matrix3d::Identity();
  std::int64_t tip_height_ = 0;
  double reach_ = 0.0;
  std::vector<std::string> notes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_SERIAL_ARM_H
