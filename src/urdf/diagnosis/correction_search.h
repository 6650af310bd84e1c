// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_CORRECTION_SEARCH_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_CORRECTION_SEARCH_H

#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"
#include "urdf/diagnosis/attempt.h"
#include "urdf/diagnosis/closure_gaps.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whether the mobility fits and the platform moves in a task space, not as a mere point of space: that is
/// seldom meant where three joints are actuated.
bool moves_a_body(const ClosureSystem& system, const Assembly& assembly,
                  const ActuatedJoints& actuated_joints, const SourceNames& files);

/// Tries corrections of one element at a time. Most are sorted out by whether the loops close from some
/// starts and the mobility fits; those that are left are recognised like any description.
class CorrectionSearch {
 public:
  /// `closes`: whether the description can be assembled as it is.
  CorrectionSearch(std::shared_ptr<const Tree> tree, const ResolvedConfig& resolved, bool closes,
                   const SourceNames& files, const Attempt& attempt);

  /// Those of what closures hold: why, if any works. It lists those of joints that work as well, first.
  std::optional<Diagnosis> of_frames();

  /// Those of a closure that holds another place of the platform than its operational point.
  std::optional<Diagnosis> of_point();

  /// Those of legs that lack a joint.
  std::optional<Diagnosis> of_missing_joints();

  /// Those of chains between base and platform that no actuated joint is in.
  std::optional<Diagnosis> of_chains();

  /// Those of frames, each together with one of the actuated joints.
  std::optional<Diagnosis> of_frames_and_actuation();

  /// Those that make an element like others of its kind: why, if any works.
  std::optional<Diagnosis> like_others();

  /// All others.
  std::optional<Diagnosis> others();

  /// Those of these that work.
  std::optional<Diagnosis> working_of(const Corrections& corrections);

 private:
  struct Working {
    Correction correction;
    std::string space;
  };

  void collect();
  bool takes_in_joints(const Correction& correction) const;
  Diagnosis with_rivals();
  Corrections with_actuation(const Corrections& kind) const;
  std::vector<std::size_t> open_loops() const;
  std::vector<std::size_t> suspected_closures() const;
  std::vector<std::size_t> suspects() const;
  void try_one(const Correction& correction);
  bool closes_and_moves(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& config);
  bool closes_and_moves(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& config,
                        ClosureType type_of_open_ones);
  Diagnosis diagnosis() const;

  std::shared_ptr<const Tree> tree_;
  const ResolvedConfig& resolved_;
  const SourceNames& files_;
  const Attempt& attempt_;
  ClosureSystem system_;
  LoopJoints loops_;
  EndGaps gaps_;
  std::vector<std::size_t> open_loops_;  // closures that cannot be closed even without the others
  Corrections corrections_;
  std::vector<Working> working_;
  std::size_t tried_ = 0, attempts_ = 0;
  bool is_complete_ = true;  // whether all were tried that were to be
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_CORRECTION_SEARCH_H
