// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/ompl/aspect_space_information.h"

#include <algorithm>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

namespace ob = ompl::base;

// How often the end of a proved part is taken back until the motion to it is proved as well.
constexpr int steps_back = 20;
constexpr double step_back = 0.95;  // of the part
constexpr double width = 0.01;      // of a motion, between what is proved and what is in its way

void check_side(const Manipulator& manipulator, const ModeAndSign& side) {
  const std::vector<WorkingMode> modes = working_modes(manipulator);
  if (std::find(modes.begin(), modes.end(), side.mode) == modes.end())
    throw InvalidDescription({"'" + manipulator.name() + "' has no working mode " + to_string(side.mode) +
                              "; its first is " + to_string(modes.front()) + "."});
  if (side.determinant_sign != 1 && side.determinant_sign != -1)
    throw InvalidDescription(
        {"The sign of det A is " + std::to_string(side.determinant_sign) + "; give 1 or -1."});
}

}  // namespace

AspectValidityChecker::AspectValidityChecker(const ob::SpaceInformationPtr& space_information,
                                             SegmentCertifier certifier, const ModeAndSign& side)
    : StateValidityChecker(space_information), certifier_(std::move(certifier)), side_(side) {}

bool AspectValidityChecker::isValid(const ob::State* state) const {
  const Pose pose = pose_of(certifier_.manipulator()->task_space(), *state);
  return certifier_.prove(pose, side_.mode).sign == side_.determinant_sign;
}

CertifiedMotionValidator::CertifiedMotionValidator(const ob::SpaceInformationPtr& space_information,
                                                   SegmentCertifier certifier, const ModeAndSign& side,
                                                   int max_parts)
    : MotionValidator(space_information),
      certifier_(std::move(certifier)),
      side_(side),
      max_parts_(max_parts) {}

bool CertifiedMotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  return counted(is_proved(pose_of_state(from), pose_of_state(to)));
}

bool CertifiedMotionValidator::checkMotion(const ob::State* from, const ob::State* to,
                                           std::pair<ob::State*, double>& last_valid) const {
  const Pose start = pose_of_state(from), end = pose_of_state(to);
  if (is_proved(start, end)) return counted(true);
  last_valid.second = last_proved(start, end);
  if (last_valid.first != nullptr) {
    if (last_valid.second > 0.0)
      set_pose(certifier_.manipulator()->task_space(), pose_between(start, end, last_valid.second),
               *last_valid.first);
    else if (last_valid.first != from)
      si_->copyState(last_valid.first, from);
  }
  return counted(false);
}

bool CertifiedMotionValidator::is_proved(const Pose& from, const Pose& to) const noexcept {
  return certifier_.prove(to, side_.mode).sign == side_.determinant_sign &&
         certifier_.prove(from, to, side_.mode, max_parts_).verdict == SegmentVerdict::free;
}

// OMPL counts in plain integers, which its threads share.
bool CertifiedMotionValidator::counted(bool is_valid) const noexcept {
  __atomic_fetch_add(is_valid ? &valid_ : &invalid_, 1U, __ATOMIC_RELAXED);
  return is_valid;
}

// The motion to the end of the proved part is, in SE2 and SE3, not quite that part.
double CertifiedMotionValidator::last_proved(const Pose& from, const Pose& to) const noexcept {
  double t = certifier_.prove_to_violation(from, to, side_.mode, width, max_parts_).free_until;
  for (int i = 0; i < steps_back && t > 0.0; ++i, t *= step_back)
    if (is_proved(from, pose_between(from, to, t))) return t;
  return 0.0;
}

Pose CertifiedMotionValidator::pose_of_state(const ob::State* state) const noexcept {
  return pose_of(certifier_.manipulator()->task_space(), *state);
}

ob::SpaceInformationPtr make_aspect_space_information(const std::shared_ptr<const Manipulator>& manipulator,
                                                      const ModeAndSign& side,
                                                      const std::optional<Box>& region) {
  check_side(*manipulator, side);
  const SegmentCertifier certifier(manipulator);
  auto result = std::make_shared<ob::SpaceInformation>(make_pose_state_space(*manipulator, region));
  result->setStateValidityChecker(std::make_shared<AspectValidityChecker>(result, certifier, side));
  result->setMotionValidator(std::make_shared<CertifiedMotionValidator>(result, certifier, side));
  result->setup();
  return result;
}

}  // namespace parallel_aspects
