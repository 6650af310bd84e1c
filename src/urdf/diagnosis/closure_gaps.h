// SPDX-License-Identifier: BSD-3-Clause
//
// Simulators hold together what coincides while all joints are zero. If the two links of a closure were meant
// to meet elsewhere, a robot loads that is not the intended one.
#ifndef PARALLEL_ASPECTS_URDF_DIAGNOSIS_CLOSURE_GAPS_H
#define PARALLEL_ASPECTS_URDF_DIAGNOSIS_CLOSURE_GAPS_H

#include "urdf/closing/resolved_config.h"
#include "urdf/corrections/edit.h"
#include "urdf/description/closure.h"
#include "urdf/description/messages.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whether the loop of a closure goes through the base, as those of parallelograms in a leg do not.
bool passes_base(const Tree& tree, std::size_t base, const Closure& closure);

/// The same closures with the origins of their ends together, and given by these; nothing where none are
/// apart while all joints are zero. An end is a link that exists for a closure alone: it has no children, and
/// the first of the two is fixed to what carries it.
std::optional<ResolvedConfig> with_ends_together(const Tree& tree, const ResolvedConfig& resolved);

/// The closures as a YAML can list them: given in their frames, with ends together.
ResolvedConfig as_listed(const Tree& tree, ResolvedConfig resolved);

/// The same where the ends of all loops through the base are apart while all joints are zero: then the robot
/// is drawn open, and ends that exist for a closure alone are to meet. Nothing where any meet.
std::optional<ResolvedConfig> drawn_open(const Tree& tree, const ResolvedConfig& resolved,
                                         const SourceNames& files);

/// Closures of open type with the first one under which the robot is recognised; as they are where none is.
std::vector<Closure> with_known_types(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                      const Attempt& attempt);

/// How far apart the origins are that each closure holds together, while all joints are zero [m]; nothing
/// where one follows from the other.
std::vector<std::optional<double>> gaps_at_zero(const Tree& tree, const std::vector<Closure>& closures);

/// Closures that are given by a place in their second link, and hold by it a link beside its origin, though
/// that link exists for them alone.
std::vector<std::size_t> held_beside_ends(const Tree& tree, const ResolvedConfig& resolved);

/// The largest gap that counts as rounding [m].
double meeting_tolerance(const Tree& tree, const ResolvedConfig& resolved);

/// Whether all closures are welds, which turn at one end or the other; the question about these is asked
/// elsewhere.
bool are_all_welds(const std::vector<Closure>& closures);

/// Judges by the ends of closures which changes of a description may be what it needs.
class EndGaps {
 public:
  EndGaps(const Tree& tree, const ResolvedConfig& resolved);

  /// Whether all ends meet, or all are as far apart as all were before, as where a platform is drawn too low;
  /// where those of `resolved` were put together, whether all meet. `changed`: placed at zero.
  bool allow(const Tree& tree, const ResolvedConfig& changed) const;

  /// Whether ends that are apart at zero were put together.
  bool are_to_meet() const noexcept { return are_to_meet_; }

 private:
  std::vector<bool> joins_ends_;  // of each closure, as described; an end that is changed still is one
  std::vector<double> before_;
  bool are_to_meet_ = false;
};

/// The list that holds ends together, and where to write it; nothing where that makes no robot.
std::optional<Note> list_of_ends(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                 const SourceNames& files, const Attempt& attempt);

/// "'a' and 'b' by 0.05 m (closure 'c')", and that of all ends that are apart.
std::string gap_text(const Tree& tree, const Closure& closure, double gap);
std::string end_gaps_text(const Tree& tree, const ResolvedConfig& resolved);

/// "; give ..." for ends that are apart at the start of a link, where its joint is, and may be meant at its
/// far end, for which the description has no frame.
std::string starts_of_links_text(const Tree& tree, const ResolvedConfig& resolved);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DIAGNOSIS_CLOSURE_GAPS_H
