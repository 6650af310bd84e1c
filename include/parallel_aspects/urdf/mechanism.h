// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_MECHANISM_H
#define PARALLEL_ASPECTS_URDF_MECHANISM_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

class Note;  // in the sources, as it is for what shows notes here
class Tracker;

/// A pose of the platform and the joint values that go with it.
struct AssembledConfiguration {
  Pose pose;      ///< in the task frame
  JointVector q;  ///< of the actuated joints, one a leg [rad or m]
};

/// A passive joint whose value the pose and the actuated joints determine.
struct PassiveJoint {
  std::size_t index = 0;  ///< into `Mechanism::joint_names()`
  bool turns = true;      ///< an angle [rad]; else a length [m]
};

/// A manipulator together with the joints of the URDF that it came from. Immutable.
class Mechanism {
 public:
  struct Contents;                                               ///< what the loader hands over
  explicit Mechanism(std::unique_ptr<const Contents> contents);  ///< `load_mechanism` makes one
  ~Mechanism();
  Mechanism(const Mechanism&) = delete;
  Mechanism& operator=(const Mechanism&) = delete;

  const std::shared_ptr<const Manipulator>& manipulator() const noexcept;  ///< never null

  /// Whose aspects are mapped, never null: `manipulator()`, but that limits of revolute joints which leave
  /// less than 0.01 rad of a full turn are none, unless limits are strict. Those are written for none; where
  /// a stop or a cable is there, it is in time that it counts.
  const std::shared_ptr<const Manipulator>& mapped_manipulator() const noexcept;

  /// Link whose origin is the operational point, or the name of that frame in the YAML.
  const std::string& platform_link() const noexcept;

  /// What the platform is called in tf: the name that the YAML gives the operational point, or else
  /// "platform".
  const std::string& platform_frame() const noexcept;

  /// Every link of the tree, the root first, and the operational point where it is a frame of its own.
  const std::vector<std::string>& link_names() const noexcept;

  /// Every movable joint of the tree, actuated and passive, in the order of the URDF.
  const std::vector<std::string>& joint_names() const noexcept;

  /// Limits of all `joint_names()` [rad or m].
  const std::vector<JointLimits>& joint_limits() const noexcept;

  /// The fastest change of velocity of each actuated joint, as `motion.acceleration` of the YAML states it
  /// [rad/s^2 or m/s^2]; positive, or empty where it is not stated.
  const JointVector& acceleration() const noexcept;

  /// Degrees of freedom of the closed mechanism, from the rank of its closures at `assembled()`.
  int mobility() const noexcept;

  /// Those of its degrees of freedom that move neither an actuated joint nor the platform, as a rod that
  /// spins.
  int idle_degrees_of_freedom() const noexcept;

  /// The passive joints that pose and actuated joints determine: those that move no loop or spin idly are
  /// left out. In the order of `joint_names()`.
  std::vector<PassiveJoint> determined_joints() const;

  /// The configuration, inside the joint limits, that the mechanism was recognised in.
  AssembledConfiguration assembled() const;

  /// Where the robot is shown, all of its joints inside their limits where that is possible: the pose that
  /// the YAML states as `start/pose`, or else that of `assembled()`; near it where it touches a limit.
  AssembledConfiguration home() const;

  /// Values of all `joint_names()` that close every loop at this configuration [rad or m]. False, with
  /// `positions` untouched, where the loops do not close. `positions` must have as many entries as there are
  /// names. Whether the values are within limits is another question: see `joint_outside_limits`.
  bool complete(const Pose& pose, const JointVector& q, Eigen::Ref<Eigen::VectorXd> positions) const noexcept;

  /// The first of `joint_names()`, actuated or passive, whose value in `positions` is outside its limits by
  /// more than 1e-9 rad or m; nothing when all are inside. Limits that lack less than 1e-5 rad of a full turn
  /// hold modulo a turn. A value that is not a number is outside.
  std::optional<std::size_t> joint_outside_limits(
      const Eigen::Ref<const Eigen::VectorXd>& positions) const noexcept;

  /// What the loader took where the description left a choice, and what it accepted with reservations;
  /// messages.
  const std::vector<std::string>& notes() const noexcept;

  /// The same with the lists of names in them apart.
  const std::vector<Note>& notes_in_pieces() const noexcept;

 private:
  std::unique_ptr<const Contents> contents_;
  std::vector<std::string> notes_;
};

/// Shares a mechanism that is there: never null, so that what loads a robot gives one or throws.
class SharedMechanism {
 public:
  /// Throws `InvalidDescription` where it is null.
  explicit SharedMechanism(std::shared_ptr<const Mechanism> mechanism);

  /// Copied only: what was moved from would be null.
  SharedMechanism(const SharedMechanism&) = default;
  SharedMechanism& operator=(const SharedMechanism&) = default;  ///< copied only

  const Mechanism& operator*() const noexcept { return *mechanism_; }        ///< the mechanism
  const Mechanism* operator->() const noexcept { return mechanism_.get(); }  ///< never null

  /// For what takes a pointer; it is never null.
  operator const std::shared_ptr<const Mechanism>&() const noexcept { return mechanism_; }

 private:
  std::shared_ptr<const Mechanism> mechanism_;
};

/// Reads a tree URDF and the YAML that closes it. `urdf_name` and `config_name` are file or parameter names,
/// for messages. The base frame is the base link, in tf below `frame_prefix` where that is not empty. Throws
/// `InvalidDescription` with every problem found.
SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix = "");

/// The same from two files, whose names are in the messages.
SharedMechanism load_mechanism_files(const std::string& urdf_file, const std::string& config_file,
                                     const std::string& frame_prefix = "");

/// How far measured passive joints may be from those of a pose.
struct PassiveOptions {
  double angle_tolerance = 0.05;   ///< [rad], positive
  double length_tolerance = 0.01;  ///< as a share of the robot's size, positive
  double hysteresis = 0.2;         ///< a contradiction ends this share below the tolerance [0 to 1]
};

/// Every problem, a message each; empty when the options can be used.
std::vector<std::string> problems_of(const PassiveOptions& options);

/// What measured passive joints say of a pose.
struct PassiveResidual {
  std::size_t compared = 0;  ///< joints that were measured and can be compared; 0: nothing is known
  double excess = 0.0;       ///< largest difference over its tolerance; above 1 contradicts the pose
  std::size_t joint = 0;     ///< where: index into `Mechanism::joint_names()`
  double difference = 0.0;   ///< there, measured less computed [rad or m]

  /// Whether a joint is farther away than its tolerance.
  bool contradicts() const noexcept { return excess > 1.0; }
};

/// Compares measured passive joints with those that belong to a pose and joint values, in the branch that the
/// mechanism was assembled in. Its functions allocate; they are not for the hot path. Safe to share between
/// threads.
class PassiveJoints {
 public:
  /// The options have no `problems_of`.
  explicit PassiveJoints(std::shared_ptr<const Mechanism> mechanism, const PassiveOptions& options = {});

  /// How many passive joints can be compared where all are measured.
  std::size_t comparable() const noexcept { return joints_.size(); }

  /// `readings` has an entry for each of `Mechanism::joint_names()`, not a number where nothing was measured
  /// [rad or m]. Where the loops do not close, every difference is infinite.
  PassiveResidual residual(const Pose& pose, const JointVector& q, const Eigen::VectorXd& readings) const;

  /// Whether the loops close with every passive joint inside its limits.
  bool within_limits(const Pose& pose, const JointVector& q) const;

  /// Lets the tracker know: while it follows a pose, whether the readings contradict that, with hysteresis;
  /// while it has candidates, which of them fit the readings and the limits of passive joints. The residual
  /// of the pose that is followed in the end; nothing compared where there is none.
  PassiveResidual apply(const Eigen::VectorXd& readings, Tracker& tracker) const;

  /// What it was made with.
  const PassiveOptions& options() const noexcept { return options_; }

 private:
  std::shared_ptr<const Mechanism> mechanism_;
  PassiveOptions options_;
  std::vector<PassiveJoint> joints_;
};

}  // namespace parallel_aspects

/// The shipped robots, without a file: urdf/NAME.urdf and config/robots/NAME.yaml as they were when the
/// library was built. docs/reference/robots.md says where their dimensions come from.
namespace parallel_aspects::models {

SharedMechanism bipod();           ///< T2, two struts
SharedMechanism five_bar();        ///< T2, the five-bar of Chablat and Wenger
SharedMechanism three_prr();       ///< SE2, three sliders
SharedMechanism three_rpr();       ///< SE2, three struts
SharedMechanism three_rrr();       ///< SE2, three cranks
SharedMechanism delta();           ///< T3, the Delta
SharedMechanism linear_delta();    ///< T3, three sliders
SharedMechanism agile_eye();       ///< SO3, the Agile Eye
SharedMechanism spherical_3rrr();  ///< SO3, three spherical cranks
SharedMechanism hexa();            ///< SE3, six cranks
SharedMechanism six_pus();         ///< SE3, six sliders
SharedMechanism ankle();           ///< R2, two cranks, axes that lie apart
SharedMechanism skew_wrist();      ///< R2, two cranks, axes at 60 degrees
SharedMechanism tilt_table();      ///< R2, two struts and a universal joint
SharedMechanism four_bar();        ///< R1, a crank
SharedMechanism stewart();         ///< SE3, the Stewart platform, six struts

}  // namespace parallel_aspects::models

#endif  // PARALLEL_ASPECTS_URDF_MECHANISM_H
