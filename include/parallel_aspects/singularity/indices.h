// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_SINGULARITY_INDICES_H
#define PARALLEL_ASPECTS_SINGULARITY_INDICES_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <string>

namespace parallel_aspects {

/// Numbers that vanish at singularities. None of them is a distance in the workspace.
struct SingularityIndices {
  /// det A; unit as in `direct_determinant`. Zero at a parallel singularity.
  double determinant = 0.0;

  /// B_jj of every leg; unit as in `inverse_diagonal`. Zero at a serial singularity of that leg.
  TaskVector inverse_diagonal;

  /// Smallest singular value (spectral norm) of the homogenised A: rotational columns divided by the
  /// manipulator's characteristic length, then each row by its rod length |u|. Dimensionless; 0 at a parallel
  /// singularity, at most 1 in T2 and T3.
  double smallest_singular_value = 0.0;

  /// Smallest over largest singular value of the same matrix. Dimensionless, 0 to 1 (isotropic).
  double inverse_condition_number = 0.0;
};

/// The indices at a configuration. `q` must assemble with `pose`; both must be finite.
SingularityIndices singularity_indices(const Manipulator& manipulator, const Pose& pose,
                                       const JointVector& q);

/// Which number measures how near a configuration is to a parallel singularity.
enum class ParallelIndex {
  normalised,   ///< `parallel_index`
  determinant,  ///< |det A|, in the unit of `direct_determinant`
};

/// |det A| over the product of the norms of its rows, with moments about the middle of the anchors and over
/// their root mean square distance from it, so that moving the operational point in the platform changes
/// nothing. In T1 |A| over |u|, in T2 the sine of the angle between the rods, in R1 |A| over |u| and the
/// distance of the anchor from the hinge. Dimensionless; 0 at a parallel singularity, 1 at most.
double parallel_index(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// |B_jj| of each leg over its `largest_entry`: the sine of the angle between rod and crank, or rod and the
/// normal of its rail. 1 for a strut. Dimensionless; 0 at a serial singularity.
TaskVector serial_indices(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// Those that ask something, as "parallel 0.05, serial 0.1"; empty where none does.
std::string to_string(const Margins& margins);

/// Which margins of the manipulator a configuration does not keep, as "the parallel index is 0.71, below the
/// margin 0.9"; empty where it keeps all. In double precision, so it proves nothing. `q` must assemble with
/// `pose`; both must be finite.
std::string missed_margins(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_SINGULARITY_INDICES_H
