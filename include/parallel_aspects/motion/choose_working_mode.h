// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_WORKING_MODE_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_WORKING_MODE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/basins.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// What the best working mode of a path is best by.
enum class Preference {
  clear,   ///< the largest `PathClearance::lower`
  travel,  ///< the least travel of the actuated joints, in sum [rad, m]
  fast,    ///< the least time at the velocity limits
};

/// How far a path stays from singularities, in the metric of `BoundaryDistance`.
struct PathClearance {
  double lower = 0.0;  ///< proved: at no pose of the path is a singularity nearer than this [m]

  /// The least proved distance at the poses that were measured [m]; infinite where none was.
  double measured = std::numeric_limits<double>::infinity();

  double time = 0.0;         ///< of that pose [s]
  bool serial = false;       ///< whether the singularity near it is a serial one
  std::size_t leg = 0;       ///< whose, where serial
  std::size_t measures = 0;  ///< poses that were measured
};

/// What a path asks of one working mode.
struct ModeOnPath {
  WorkingMode mode;          ///< one sign a leg
  int determinant_sign = 0;  ///< of det A at the start, proved; 0 where it is not
  int aspect = 0;            ///< that holds the start; 0 where it is not known

  /// Whether all of the path can be done in it; where it cannot, why, and where it first fails.
  TrajectoryCheck check;

  // What follows is of all of the path, where it is proved to be safe.
  std::optional<PathClearance> clearance;  ///< to singularities
  std::vector<double> travel;              ///< of each actuated joint, from samples [rad or m]

  /// At the velocity limits of the actuated joints, from samples, however fast they start and stop [s];
  /// joints without a limit cost none.
  double least_time = 0.0;

  double total_travel() const noexcept;  ///< the sum of `travel`
};

/// In which working modes a path can be done.
struct PathChoice {
  /// Safe: in one of them or more. Unsafe: proved to fail in each.
  TrajectoryAnswer answer = TrajectoryAnswer::unknown;

  std::string reason;  ///< a sentence

  /// Every working mode: safe ones first, the best of them before all; then unknown ones; those that come
  /// farthest first.
  std::vector<ModeOnPath> modes;
};

/// How a path is looked at.
struct PathChoiceOptions {
  Preference preference = Preference::clear;  ///< what is best
  TrajectoryCheckOptions check{};             ///< how each working mode is checked
  int measures = 60;                          ///< poses at which distances are measured, at most
  const AspectMap* map = nullptr;             ///< that tells aspects, of the same manipulator; null for none
};

/// Every reason why no working mode can be chosen: those of a trajectory besides its working mode, and a
/// preference for `fast` where no actuated joint has a velocity limit.
Problems problems_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     Preference preference);

/// Checks a path as `check_trajectory` in every working mode, and puts the best first. There must be no
/// problems.
PathChoice choose_working_mode(const SegmentCertifier& certifier, const std::vector<PoseWaypoint>& waypoints,
                               const PathChoiceOptions& options = {});

/// "clear", "travel" or "fast".
const char* name(Preference preference) noexcept;

/// The preference with this name; nothing where there is none.
std::optional<Preference> preference_named(const std::string& name);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_WORKING_MODE_H
