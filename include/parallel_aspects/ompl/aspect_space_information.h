// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_OMPL_ASPECT_SPACE_INFORMATION_H
#define PARALLEL_ASPECTS_OMPL_ASPECT_SPACE_INFORMATION_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <memory>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSpace.h>
#include <ompl/base/StateValidityChecker.h>
#include <optional>
#include <utility>

namespace parallel_aspects {

/// OMPL's state space for the poses of this manipulator: a RealVectorStateSpace in T1, T2 and T3, an
/// SE2StateSpace, an SO3StateSpace or an SE3StateSpace. Two things differ from OMPL's own:
///  - `interpolate` runs as `pose_between`, as certified segments do. In SE2 and SE3 the rotation is then not
///    uniform while the position is: a part of a motion is not quite the motion between its ends, and must be
///    checked anew, as OMPL's path simplifier does.
///  - distances are metres [m], with rotations times `Manipulator::characteristic_length`. In SO3 they are
///    OMPL's own, half the angle [rad].
///
/// Positions are bounded by the reach of the legs, the workspace of the constraints, and `region` where one
/// is given: as many of x, y, z as the task space moves [m]. Throws `InvalidDescription` where these leave
/// positions unbounded or leave none.
ompl::base::StateSpacePtr make_pose_state_space(const Manipulator& manipulator,
                                                const std::optional<Box>& region = {});

/// The pose that a state of `make_pose_state_space` says; never of another kind of state.
Pose pose_of(TaskSpace space, const ompl::base::State& state) noexcept;

/// Makes a state say this pose, which must lie in the task space.
void set_pose(TaskSpace space, const Pose& pose, ompl::base::State& state) noexcept;

/// Where OMPL plans: the poses that are reached in one working mode with one sign of det A.
struct ModeAndSign {
  WorkingMode mode;          ///< one sign a leg
  int determinant_sign = 1;  ///< +1 or -1
};

/// Valid are the states for which it is proved that every leg reaches in this working mode, all constraints
/// hold, and det A has this sign. For states of `make_pose_state_space`; any number of threads may ask.
class AspectValidityChecker : public ompl::base::StateValidityChecker {
 public:
  /// The space information outlives it.
  AspectValidityChecker(const ompl::base::SpaceInformationPtr& space_information, SegmentCertifier certifier,
                        const ModeAndSign& side);

  /// Whether it is proved; takes some microseconds.
  bool isValid(const ompl::base::State* state) const override;

 private:
  SegmentCertifier certifier_;
  ModeAndSign side_;
};

/// Valid are the motions all of whose poses, at every t, are proved valid in the sense of
/// `AspectValidityChecker`; there is no resolution. So every path of valid motions stays in one aspect. For
/// states of `make_pose_state_space`; any number of threads may ask.
class CertifiedMotionValidator : public ompl::base::MotionValidator {
 public:
  /// The space information outlives it. At most `max_parts` parts of a motion are tried, each some
  /// microseconds; a motion that needs more is not valid.
  CertifiedMotionValidator(const ompl::base::SpaceInformationPtr& space_information,
                           SegmentCertifier certifier, const ModeAndSign& side, int max_parts = 400);

  /// Whether the motion is proved, its ends among it.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;

  /// The same. Where it is not, `last_valid` gets a state on the motion, and its t, to which the motion from
  /// `from` is proved; `from` itself and 0 where there is none.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  bool is_proved(const Pose& from, const Pose& to) const noexcept;
  bool counted(bool is_valid) const noexcept;
  double last_proved(const Pose& from, const Pose& to) const noexcept;
  Pose pose_of_state(const ompl::base::State* state) const noexcept;

  SegmentCertifier certifier_;
  ModeAndSign side_;
  int max_parts_;
};

/// A space information that is ready to plan with: the state space, the checker and the validator above. Its
/// ends must be valid; what OMPL plans then is proved. Throws `InvalidDescription` where `side` does not fit
/// the manipulator, and as `make_pose_state_space` does.
ompl::base::SpaceInformationPtr make_aspect_space_information(
    const std::shared_ptr<const Manipulator>& manipulator, const ModeAndSign& side,
    const std::optional<Box>& region = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_OMPL_ASPECT_SPACE_INFORMATION_H
