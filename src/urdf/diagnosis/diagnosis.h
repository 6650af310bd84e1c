// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_DIAGNOSIS_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_DIAGNOSIS_H

#include "parallel_aspects/model/problems.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/ends_of_loops.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/corrections/edit.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"
#include "urdf/diagnosis/closure_gaps.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
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

/// Why a description is refused, in one message with a remedy that was tried and works; nothing where no
/// known remedy works. A mechanism of one degree of freedom is reported as none of the robots that are
/// treated.
std::optional<Diagnosis> diagnosis_of(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                      const SourceNames& files, const Attempt& attempt);

/// The same where the ends are not those of the loops, or where no joint is in a loop; nothing there alone.
/// Names remedies only where all together work.
std::optional<Diagnosis> diagnosis_of_ends(const std::shared_ptr<const Tree>& tree,
                                           const ResolvedConfig& resolved, const WrongEnds& ends,
                                           const SourceNames& files, const Attempt& attempt);

/// What is true of a mechanism that is not recognised, by the ranks of its loops and legs in configurations
/// that close them.
///
/// That it is a linkage of one degree of freedom, as a four-bar, and
/// not one in T1. `assembled`: with its closures as stated. One actuated joint that closures hold still by
/// their axes counts as free.
std::optional<std::string> linkage_of_one_degree_of_freedom(const std::shared_ptr<const Tree>& tree,
                                                            const ResolvedConfig& resolved,
                                                            const AssemblyResult& assembled,
                                                            const SourceNames& files);

/// That a chain between base and platform without an actuated joint lets the platform move, by its rank, in
/// fewer ways than joints are actuated.
std::optional<std::string> chain_that_holds_too_much(const ClosureSystem& system,
                                                     const Eigen::VectorXd& values,
                                                     const ActuatedJoints& actuated_joints,
                                                     const SourceNames& files);

/// That actuated joints can move while the others are locked, and leave the platform where it is.
std::optional<std::string> actuated_joints_that_move_nothing(const ClosureSystem& system,
                                                             const AssemblyResult& assembled,
                                                             const ActuatedJoints& actuated_joints,
                                                             const SourceNames& files);

/// That closures leave fewer degrees of freedom than there are actuated joints, by the axes about which their
/// links turn with balls in their place. `assembled`: with its closures as stated.
std::optional<std::string> closures_that_hold_too_much(const std::shared_ptr<const Tree>& tree,
                                                       const ResolvedConfig& resolved,
                                                       const AssemblyResult& assembled,
                                                       const SourceNames& files);

/// That a robot has legs and a platform that moves, but that its actuated joints do not hold this in any of
/// the random poses in which it was assembled.
std::optional<std::string> singular_everywhere(const std::shared_ptr<const Tree>& tree,
                                               const ResolvedConfig& resolved, const SourceNames& files);

/// Of a robot that loads: the actuated joint on the base that alone moves the other way round than those of
/// the other legs, seen from the middle of all, though it has the same limits and these are not the same to
/// both sides.
std::vector<std::string> reversed_axes_notes(const Tree& tree, const ResolvedConfig& resolved,
                                             const SourceNames& files);

/// Of a robot that loads: the actuated joint on the base that alone moves along or about another direction
/// than those of the other legs, which are alike, seen from the middle of all; where its robot with theirs
/// loads, too.
Notes other_axes_notes(const Subject& subject, const Attempt& attempt);

/// Of a robot that would load: that ends of closures are at a place which a like link has the other end at, a
/// length of that one, as where the plate is fixed to the first of six pins. A robot that nobody means, so
/// that it is refused, with the closures at the origins of their links; nothing where these make no robot.
std::optional<Note> length_of_another_link(const Subject& subject, const Attempt& attempt);

/// What looks like a slip, though it may be meant: a link that several closures hold, while one of its body
/// with such a name is in none; or one that a closure holds at its own joint, where another leg is, while a
/// frame of its body is in none. `size`: of the robot [m].
std::vector<std::string> shared_frame_notes(const Tree& tree, const ResolvedConfig& resolved, double size);

/// Of a robot that loads: closures whose ends are exchanged, judging by their names or by the places of the
/// ends while all joints are zero; with the list for the YAML that has them in order.
Notes crossed_ends_notes(const Subject& subject, const Attempt& attempt);

/// For closures that hold a link beside its origin, by a place in the other link, though that link exists for
/// the closure alone: the place where its origin is while all joints are zero.
Edits end_place_edits(const Subject& subject);

/// Changes of origins of joints in loops whose ends are apart while all joints are zero.
Edits place_edits(const Subject& subject);

/// Those of them that put all ends together, where several ends of closures in a list are apart while all
/// joints are zero, or where those of others meet.
Edits edits_of_apart_ends(const Subject& subject);

/// Changes of the origin of one joint that join all ends of closures while all joints are zero: a few of
/// those that make a robot, as "write xyz=\"1 0 0\" in the origin of joint 'a', or write ..."; empty where
/// none does.
std::string remedies_of_places(const Subject& subject, const Attempt& attempt);

/// Of a robot that loads: edits of it that load, too, one for each element; "FAULT; CONDITION, REMEDY.".
Notes notes_of_working(const Subject& subject, const Edits& edits, const std::string& condition,
                       const Attempt& attempt);

/// Of a robot that loads: ends of closures in a list that are apart while all joints are zero, though those
/// of most others are together; or the ends of several closures, all apart, which the origin of one joint
/// joins.
Notes misplaced_ends_notes(const Subject& subject, const Attempt& attempt);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_DIAGNOSIS_H
