// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/misplaced_ends.h"

#include "model/number_text.h"
#include "urdf/corrections/gap_corrections.h"
#include "urdf/corrections/loop_joints.h"
#include "urdf/corrections/unit_corrections.h"
#include "urdf/culprits/closure_gaps.h"
#include "urdf/culprits/loops_through_base.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_remedies = 3;

std::vector<Closure> those_apart(const Tree& tree, const ResolvedConfig& resolved) {
  const std::vector<std::optional<double>> gaps = gaps_at_zero(tree, resolved.closures);
  const double meet = meeting_tolerance(tree, resolved);
  std::vector<Closure> apart;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (gaps[k] && *gaps[k] > meet) apart.push_back(resolved.closures[k]);
  return apart;
}

// The corrected description is recognised with its ends as they are then.
bool puts_together(const Correction& correction, const std::shared_ptr<const Tree>& tree,
                   const ResolvedConfig& resolved, const Attempt& attempt) {
  auto changed = std::make_shared<Tree>(*tree);
  ResolvedConfig config = resolved;
  correction.apply(*changed, config);
  place_at_zero(*changed, config.closures);
  return those_apart(*changed, config).empty() && attempt(changed, config);
}

// A link that carries others, or that several closures hold, is a body.
bool holds_body(const Tree& tree, const std::vector<Closure>& closures, const Closure& closure) {
  return std::any_of(closure.frames.begin(), closure.frames.end(), [&](const LinkFrame& frame) {
    const auto count = std::count_if(closures.begin(), closures.end(), [&](const Closure& other) {
      return other.frames[0].link == frame.link || other.frames[1].link == frame.link;
    });
    return count > 1 || (has_child(tree, frame.link) && frame.in_link.translation().isZero());
  });
}

std::string gap_text(const Tree& tree, const Closure& closure, double gap) {
  return "'" + tree.links[closure.frames[0].link] + "' and '" + tree.links[closure.frames[1].link] + "' by " +
         number_text(gap, 4) + " m (closure '" + closure.name + "')";
}

}  // namespace

Corrections place_corrections(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                              const SourceNames& files) {
  const double size =
      ClosureSystem(tree, resolved.base, with_type(resolved.closures, ClosureType::point)).size();
  const LoopJoints loops(*tree, resolved.closures, size);
  const LoopJoints suspects(*tree, those_apart(*tree, resolved), size);
  Corrections found = unit_corrections(*tree, resolved, suspects, size, files);
  for (const std::size_t joint : suspects.all())
    for (Correction& correction : gap_corrections(*tree, loops, joint, files))
      found.push_back(std::move(correction));
  return found;
}

std::vector<std::string> remedies_of_places(const std::shared_ptr<const Tree>& tree,
                                            const ResolvedConfig& resolved, const SourceNames& files,
                                            const Attempt& attempt) {
  std::vector<std::string> remedies;
  std::set<std::string> corrected;
  for (const Correction& correction : place_corrections(tree, resolved, files))
    if (remedies.size() < max_remedies && corrected.count(correction.element) == 0 &&
        puts_together(correction, tree, resolved, attempt)) {
      corrected.insert(correction.element);
      remedies.push_back(correction.remedy);
    }
  return remedies;
}

std::vector<std::string> misplaced_ends_notes(const std::shared_ptr<const Tree>& tree,
                                              const ResolvedConfig& resolved, const SourceNames& files,
                                              const Attempt& attempt) {
  const std::vector<std::optional<double>> gaps = gaps_at_zero(*tree, resolved.closures);
  const double meet = meeting_tolerance(*tree, resolved);
  std::string apart;
  std::size_t count_apart = 0, count_together = 0;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (resolved.closures[k].at_zero || !gaps[k] ||
        holds_body(*tree, resolved.closures, resolved.closures[k]))
      continue;
    if (!passes_base(*tree, resolved.base, resolved.closures[k])) continue;
    ++(*gaps[k] > meet ? count_apart : count_together);
    if (*gaps[k] > meet)
      apart += (apart.empty() ? "" : ", ") + gap_text(*tree, resolved.closures[k], *gaps[k]);
  }
  const bool stands_out = count_apart == 1 ? count_together > 0 : count_apart < count_together;
  if (count_apart == 0 || !stands_out) return {};
  std::string text = files.urdf + " has ends of closures apart while all joints are zero, " + apart +
                     ", where those of others meet; if these are to meet there, too, ";
  const std::vector<std::string> remedies = remedies_of_places(tree, resolved, files, attempt);
  for (std::size_t k = 0; k < remedies.size(); ++k) text += (k == 0 ? "" : ", or ") + remedies[k];
  return {text + (remedies.empty() ? "correct the origins of the joints in their loops." : ".")};
}

}  // namespace parallel_aspects
