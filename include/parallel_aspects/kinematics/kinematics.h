// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_KINEMATICS_H
#define PARALLEL_ASPECTS_KINEMATICS_KINEMATICS_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Mf_i of the paper: the vector of signs of B_jj, one a leg, none zero.
class WorkingMode {
 public:
  WorkingMode() = default;  ///< of no leg

  /// All signs positive. `leg_count` at most `max_legs`.
  explicit WorkingMode(std::size_t leg_count) noexcept : legs_(static_cast<std::uint8_t>(leg_count)) {}

  /// The mode whose `index()` this is; `index` below 2^leg_count.
  static WorkingMode from_index(std::size_t leg_count, std::size_t index) noexcept;

  /// From signs as people write them, each 1 or -1; nothing when one is neither or there are none or too
  /// many.
  static std::optional<WorkingMode> from_signs(const std::vector<int>& signs);

  /// How many signs there are, 0 to `max_legs`.
  std::size_t leg_count() const noexcept { return legs_; }

  /// Bit j is set where the sign of leg j is negative; so 0 is (+, ..., +).
  std::size_t index() const noexcept { return negative_; }

  /// +1 or -1.
  int sign(std::size_t leg) const noexcept { return (negative_ >> leg & 1U) != 0 ? -1 : 1; }

  /// `leg` below `leg_count()`, `sign` 1 or -1.
  void set_sign(std::size_t leg, int sign) noexcept;

  /// The signs, each 1 or -1, in the order of the legs.
  std::vector<int> signs() const;

  /// Whether both have the same signs of the same number of legs.
  friend bool operator==(const WorkingMode& a, const WorkingMode& b) noexcept {
    return a.legs_ == b.legs_ && a.negative_ == b.negative_;
  }

  /// Whether they differ.
  friend bool operator!=(const WorkingMode& a, const WorkingMode& b) noexcept { return !(a == b); }

 private:
  std::uint8_t legs_ = 0;
  std::uint8_t negative_ = 0;
};

/// "(+,-)".
std::string to_string(const WorkingMode& mode);

/// Every working mode that the kinds of the legs allow, by rising index. Joint limits are not considered.
std::vector<WorkingMode> working_modes(const Manipulator& manipulator);

/// B_jj^2 of a leg whose anchor is at `point` (task frame) [m^4, or m^2 for a joint value in m]. Negative
/// where the leg cannot reach: B_jj^2 = 0 is the serial singularity, stretched or folded, and the same for
/// all working modes.
double squared_inverse_entry(const Leg& leg, const Eigen::Vector3d& point) noexcept;

/// The joint value that puts the leg's anchor at `point` with the given sign of B_jj [rad or m]; an angle
/// comes in
/// (-pi, pi], or a whole number of turns away where that is what the joint limits ask for.
/// Where the leg cannot reach, the value of the closest configuration (B_jj = 0). With the sign 0 it is the
/// value that both branches have where B_jj = 0.
double joint_value(const Leg& leg, const Eigen::Vector3d& point, int sign) noexcept;

/// What became of an inverse problem.
enum class InverseStatus {
  solved,          ///< every leg reaches, within its limits
  out_of_reach,    ///< a leg cannot reach; `leg` says which
  outside_limits,  ///< a joint value is outside its joint limits; `leg` says which
};

/// The joint values of a pose in one working mode.
struct InverseSolution {
  InverseStatus status = InverseStatus::out_of_reach;  ///< whether `q` can be used
  WorkingMode mode;                                    ///< that was asked for
  JointVector q;        ///< one entry a leg [rad or m]; filled unless out of reach
  std::size_t leg = 0;  ///< first leg at fault, unless solved

  /// Whether every leg reaches, within its limits.
  explicit operator bool() const noexcept { return status == InverseStatus::solved; }
};

/// The one inverse solution in this working mode, in closed form.
InverseSolution inverse(const Manipulator& manipulator, const Pose& pose, const WorkingMode& mode) noexcept;

/// One entry for every working mode of `working_modes(manipulator)`, whatever its status.
std::vector<InverseSolution> inverse_in_all_modes(const Manipulator& manipulator, const Pose& pose);

/// "solved", "out of reach" or "outside joint limits".
const char* name(InverseStatus status) noexcept;

/// One direct solution: a pose that the given joint values can hold.
struct AssemblyMode {
  Pose pose;                 ///< in the task frame
  double determinant = 0.0;  ///< det A there; unit as in `direct_determinant`
  double residual = 0.0;     ///< largest |f_j| over the squared `assembly_scale`, dimensionless
  bool near_singular =
      false;  ///< so close to det A = 0 that its count or pose may depend on rounding (see `direct`)
  /// Some B_jj is zero to rounding, below 1e-6 of |u_j| |c_j'|: a leg is stretched or folded, and the
  /// solution belongs to no working mode. The trivial solutions of the Agile Eye are such, whatever the
  /// actuated joints.
  bool serially_singular = false;
};

/// What became of a direct problem.
enum class DirectStatus {
  solved,     ///< every real solution is in the list, which may be empty
  continuum,  ///< the platform can move with the actuated joints locked; no finite list exists
  unsolved,   ///< the input is not finite, or the list may be incomplete
};

/// The direct solutions for given joint values.
struct DirectResult {
  DirectStatus status = DirectStatus::unsolved;  ///< whether the list is complete
  std::vector<AssemblyMode> solutions;           ///< by falling det A

  /// Whether the list, which may be empty, is complete.
  explicit operator bool() const noexcept { return status == DirectStatus::solved; }
};

/// Every real assembly mode for these actuated joint values (one entry a leg), whatever the joint limits.
/// There are at most 2 (T1, T2, T3), 6 (SE2), 8 (SO3) or 40 (SE3). A strut of negative length assembles
/// nowhere.
///
/// Each is refined until rounding stops it; its residual is below 1e-12. Solutions that have met at a
/// parallel singularity to half the digits come as one, flagged `near_singular`: the smallest singular value
/// of the homogenised A is below 1e-6 there.
DirectResult direct(const Manipulator& manipulator, const JointVector& q);

/// "solved", "continuum" or "unsolved".
const char* name(DirectStatus status) noexcept;

/// A of the velocity model A t = B q̇ (the sign convention of the paper's five-bar): one row a leg, one column
/// a degree of freedom. With u = p - c and b = p - operational point, row j is u (T1, T2, T3; of it what the
/// space moves), (b x u, u) (SE2, SE3) or p x u (SO3); columns follow the twist t = (w, v). Translational
/// columns in m, rotational ones in m^2.
TaskMatrix direct_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// A with its rows over their rod length and its rotational columns over the characteristic length.
/// Dimensionless.
TaskMatrix homogenised_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// The diagonal of B: B_jj = u_j . c_j'(q_j) + rho_j rho_j' [m^2/rad for an angle, m for a length].
TaskVector inverse_diagonal(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// f_j(X, q_j) of every leg [m^2].
TaskVector residuals(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// det A [m for T1, m^2 for T2, m^4 for SE2, m^3 for T3, m^6 for SO3, m^9 for SE3].
double direct_determinant(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// The signs of B; nothing where an entry is exactly zero or not a number.
std::optional<WorkingMode> working_mode(const Manipulator& manipulator, const Pose& pose,
                                        const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_KINEMATICS_H
