// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_EDIT_SEARCH_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_EDIT_SEARCH_H

#include "parallel_aspects/model/problems.h"
#include "urdf/corrections/edit.h"
#include "urdf/diagnosis/closure_gaps.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Why a description makes no robot.
struct Diagnosis {
  enum class Kind {
    guess,   ///< what is not as it should be
    remedy,  ///< edits of it that were tried and make a robot
    fact,    ///< that the description may be right, and no way to read it gives a robot that can be used
  };
  Problems problems;
  Kind kind = Kind::guess;
};

/// Whether the mobility fits and the platform moves in a task space, not as a mere point of space: that is
/// seldom meant where three joints are actuated.
bool moves_a_body(const ClosureSystem& system, const Assembly& assembly,
                  const ActuatedJoints& actuated_joints, const SourceNames& files);

/// Tries edits of a description in the order of their cost, and offers the first ones of one cost that work.
/// Cheap checks reject most of them: where the ends of closures are, whether the loops close from some
/// starts, and the mobility. The others are recognised like any description. Its budget counts work, not
/// time.
class EditSearch {
 public:
  EditSearch(const Subject& subject, const Attempt& attempt);

  /// From now on only edits work that close these closures, each without the others.
  void require_closed(std::vector<std::size_t> open_loops) { open_loops_ = std::move(open_loops); }

  /// Whether any works of these, which cost the same, or of those that were tried before.
  bool try_all(const Edits& edits);

  /// The same of edits that cost no more than those which work: they come first in the list.
  void try_before(const Edits& edits);

  /// Of those that work: the one with its fault, or the list.
  Diagnosis diagnosis() const;

  struct Working {
    Edit edit;
    std::string space;
  };
  const std::vector<Working>& working() const noexcept { return working_; }

 private:
  void try_one(const Edit& edit);
  bool closes_and_moves(const Edited& after) const;
  bool closes_and_moves(const Edited& after, ClosureType type_of_open_ones) const;

  const Subject& s_;
  const Attempt& attempt_;
  EndGaps gaps_;
  std::vector<std::size_t> open_loops_;
  std::vector<Working> working_;
  std::set<std::string> known_;  // by their remedies: those that were tried
  std::size_t tried_ = 0, attempts_ = 0;
  bool is_complete_ = true;  // whether all were tried that were to be
};

/// Closures that cannot be closed even without the others.
std::vector<std::size_t> loops_that_stay_open(const Subject& subject);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_EDIT_SEARCH_H
