// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_POLICY_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_POLICY_H

namespace parallel_aspects {

/// Which proofs are tried on an undecided box, and how hard. None of this can make a proof wrong: what is not
/// tried is not known. `benchmark/component_ablation` switches each off; see docs/benchmarks.md.
struct BoxPolicy {
  // The proofs, each as docs/maps.md names it.
  bool wedges = true;
  bool shells = true;
  bool faces = true;  ///< a box is examined on the face that the set grows to

  /// Lengths of the wedge's box that are tried, each twice the one before. The first is a quarter longer than
  /// first-order approximation asks for.
  int wedge_attempts = 3;

  /// Halvings of the line that the height of a wedge is looked for on: about the digits of a double.
  int wedge_bisections = 50;

  /// Halvings of the diagonal on which a shell begins: to a billionth of it.
  int shell_bisections = 30;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_POLICY_H
