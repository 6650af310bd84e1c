// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/misplaced_ends.h"

#include "model/number_text.h"
#include "urdf/corrections/gap_corrections.h"
#include "urdf/corrections/loop_joints.h"
#include "urdf/culprits/closure_gaps.h"

#include <algorithm>
#include <cstddef>
#include <optional>

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

bool all_meet(const Tree& tree, const ResolvedConfig& resolved) {
  return those_apart(tree, resolved).empty();
}

// The corrected description is recognised with its ends as they are then.
std::optional<std::string> remedy_at(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                     const Corrections& corrections, const Attempt& attempt) {
  for (const Correction& correction : corrections) {
    auto changed = std::make_shared<Tree>(*tree);
    ResolvedConfig config = resolved;
    correction.apply(*changed, config);
    place_at_zero(*changed, config.closures);
    if (all_meet(*changed, config) && attempt(changed, config)) return correction.remedy;
  }
  return std::nullopt;
}

std::string gap_text(const Tree& tree, const Closure& closure, double gap) {
  return "'" + tree.links[closure.frames[0].link] + "' and '" + tree.links[closure.frames[1].link] + "' by " +
         number_text(gap, 4) + " m (closure '" + closure.name + "')";
}

}  // namespace

std::vector<std::string> remedies_of_places(const std::shared_ptr<const Tree>& tree,
                                            const ResolvedConfig& resolved, const SourceNames& files,
                                            const Attempt& attempt) {
  const double size =
      ClosureSystem(tree, resolved.base, with_type(resolved.closures, ClosureType::point)).size();
  const LoopJoints loops(*tree, resolved.closures, size);
  const LoopJoints suspects(*tree, those_apart(*tree, resolved), size);
  std::vector<std::string> remedies;
  for (const std::size_t joint : suspects.all()) {
    if (remedies.size() == max_remedies) break;
    if (auto remedy = remedy_at(tree, resolved, gap_corrections(*tree, loops, joint, files), attempt))
      remedies.push_back(*remedy);
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
    if (resolved.closures[k].at_zero || !gaps[k]) continue;
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
