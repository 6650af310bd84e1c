// SPDX-License-Identifier: BSD-3-Clause
#include "model/angles.h"
#include "motion/choose/path_measures.h"
#include "motion/choose/region_survey.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double longest_length = 1e9;  // [m]; intervals have room beyond it

/// From which of the coordinates on they are angles, if any is.
std::optional<std::size_t> angle_of(const Manipulator& manipulator, const RegionQuestion& question) {
  if (question.slice) {
    if (question.slice->rotation != MapSlice::Rotation::about_axis) return std::nullopt;
    return question.slice->free_positions();
  }
  if (has_hinges(manipulator.task_space())) return 0;
  return manipulator.task_space() == TaskSpace::SE2 ? std::optional<std::size_t>(2) : std::nullopt;
}

/// Why there are no boxes of poses; empty where there are.
std::string space_problem(const Manipulator& manipulator, const RegionQuestion& question) {
  if (question.slice) {
    if (question.slice->joint || question.slice->rotation == MapSlice::Rotation::freely)
      return "A region needs pose coordinates with ranges; hold all but one of roll, pitch and yaw, and no "
             "joint.";
    return find_slice_problem(manipulator, *question.slice);
  }
  switch (manipulator.task_space()) {
    case TaskSpace::SO3:
      return "Orientations have no coordinates to give ranges of; hold two of roll, pitch and yaw by a "
             "slice, such as \"roll=0 pitch=0\", and give a range of the third.";
    case TaskSpace::SE3:
      return "A region has three coordinates at most; hold the others by a slice, such as \"roll=0 pitch=0 "
             "yaw=0\".";
    case TaskSpace::T1:
    case TaskSpace::T2:
    case TaskSpace::SE2:
    case TaskSpace::T3:
    case TaskSpace::R1:
    case TaskSpace::R2:
      break;
  }
  return "";
}

std::string range_problem(const std::string& name, double lower, double upper, bool is_angle) {
  if (!std::isfinite(lower) || !std::isfinite(upper))
    return "The range of " + name + " is not finite; give two numbers.";
  if (!(lower < upper))
    return "The range of " + name + " is empty; give a lower end that is below the upper one.";
  const double largest = is_angle ? full_turn : longest_length;
  if (std::max(std::abs(lower), std::abs(upper)) > largest)
    return "The range of " + name +
           (is_angle ? " goes beyond a turn; give one within -6.28318 and 6.28318 rad."
                     : " goes beyond 1e9 m; give lengths in metres.");
  if (is_angle && upper - lower > full_turn)
    return "The range of " + name + " is longer than a turn; give one of at most 6.28318 rad.";
  return "";
}

bool is_better_region(const ModeInRegion& a, const ModeInRegion& b) {
  if (a.answer != b.answer) return rank(a.answer) < rank(b.answer);
  return a.answer == TrajectoryAnswer::safe ? a.least_index.lower > b.least_index.lower
                                            : a.undecided < b.undecided;
}

/// What is proved of single poses in every working mode.
class PoseTable {
 public:
  PoseTable(const std::shared_ptr<const Manipulator>& manipulator, std::vector<Pose> poses)
      : poses_(std::move(poses)), modes_(working_modes(*manipulator)) {
    const SegmentCertifier certifier(manipulator);
    for (const Pose& pose : poses_) {
      proofs_.emplace_back();
      for (const WorkingMode& mode : modes_) proofs_.back().push_back(certifier.prove(pose, mode));
    }
  }

  /// Two poses that no path joins, preferably such that each lies in an aspect.
  std::optional<std::pair<Pose, Pose>> find_apart() const {
    std::optional<std::pair<Pose, Pose>> found;
    for (std::size_t a = 0; a < poses_.size(); ++a)
      for (std::size_t b = a + 1; b < poses_.size(); ++b) {
        const bool better = is_somewhere(a) && is_somewhere(b);
        if ((found && !better) || !are_apart(a, b)) continue;
        found = {poses_[a], poses_[b]};
        if (better) return found;
      }
    return found;
  }

 private:
  bool is_somewhere(std::size_t pose) const {
    return std::any_of(proofs_[pose].begin(), proofs_[pose].end(),
                       [](const ConfigurationProof& proof) { return proof.sign != 0; });
  }

  bool are_apart(std::size_t a, std::size_t b) const {
    for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
      const ConfigurationProof &one = proofs_[a][mode], &other = proofs_[b][mode];
      const bool nowhere =
          one.proved_violation != Violation::none || other.proved_violation != Violation::none;
      if (!nowhere && one.sign * other.sign != -1) return false;
    }
    return true;
  }

  std::vector<Pose> poses_;
  std::vector<WorkingMode> modes_;
  std::vector<std::vector<ConfigurationProof>> proofs_;  // by pose and mode
};

std::optional<std::pair<Pose, Pose>> find_apart(const std::shared_ptr<const Manipulator>& manipulator,
                                                const RegionSurvey& survey,
                                                const std::vector<ModeInRegion>& modes) {
  std::vector<Pose> poses = survey.corners();
  for (const ModeInRegion& mode : modes)
    poses.insert(poses.end(), mode.witnesses.begin(), mode.witnesses.end());
  return PoseTable(manipulator, std::move(poses)).find_apart();
}

std::string reason_of(const RegionChoice& choice) {
  const auto count = [&](TrajectoryAnswer answer) {
    return std::to_string(std::count_if(choice.modes.begin(), choice.modes.end(),
                                        [&](const ModeInRegion& mode) { return mode.answer == answer; }));
  };
  const std::string all = " of " + std::to_string(choice.modes.size()) + " working modes";
  switch (choice.answer) {
    case TrajectoryAnswer::safe:
      return "Proved: the region is t-connected; in " + count(TrajectoryAnswer::safe) + all +
             " it lies in one aspect, and every path in it can be followed.";
    case TrajectoryAnswer::unsafe:
      return choice.apart
                 ? "Proved: the region is not t-connected; two of its poses are joined in no working "
                   "mode."
                 : "Proved: the region is not t-connected; in no working mode it lies in one aspect.";
    case TrajectoryAnswer::unknown:
      break;
  }
  return "In no working mode the region is proved to lie in one aspect, but in " +
         count(TrajectoryAnswer::unknown) + all + " it could.";
}

}  // namespace

Problems problems_of(const Manipulator& manipulator, const RegionQuestion& question) {
  const std::string problem = space_problem(manipulator, question);
  if (!problem.empty()) return {problem};
  const std::vector<std::string> names =
      question.slice ? coordinate_names(*question.slice) : coordinate_names(manipulator.task_space());
  if (question.region.dimension != names.size())
    return {"The region has " + std::to_string(question.region.dimension) + " ranges; give " +
            std::to_string(names.size()) + ", one for each coordinate."};
  Problems problems;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string fault = range_problem(names[i], question.region.lower[i], question.region.upper[i],
                                      i >= angle_of(manipulator, question).value_or(names.size()));
    if (!fault.empty()) problems.push_back(std::move(fault));
  }
  return problems;
}

RegionChoice choose_working_mode(const std::shared_ptr<const Manipulator>& manipulator,
                                 const RegionQuestion& question, const RegionChoiceOptions& options) {
  RegionSurvey survey(*manipulator, question, angle_of(*manipulator, question));
  RegionChoice choice;
  choice.modes = survey.run(options);
  std::stable_sort(choice.modes.begin(), choice.modes.end(), is_better_region);
  choice.answer = choice.modes.front().answer;
  if (choice.answer == TrajectoryAnswer::unsafe) choice.apart = find_apart(manipulator, survey, choice.modes);
  choice.reason = reason_of(choice);
  return choice;
}

}  // namespace parallel_aspects
