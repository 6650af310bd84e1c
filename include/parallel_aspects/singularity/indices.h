// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_SINGULARITY_INDICES_H
#define PARALLEL_ASPECTS_SINGULARITY_INDICES_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_SINGULARITY_INDICES_H
