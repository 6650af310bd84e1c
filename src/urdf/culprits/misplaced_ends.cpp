// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/misplaced_ends.h"

#include "model/number_text.h"
#include "urdf/corrections/closure_places.h"
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
constexpr double decimal = 1e-8;  // to which a place is said [m]

// By their indices.
std::vector<std::size_t> those_apart(const Tree& tree, const ResolvedConfig& resolved) {
  const std::vector<std::optional<double>> gaps = gaps_at_zero(tree, resolved.closures);
  const double meet = meeting_tolerance(tree, resolved);
  std::vector<std::size_t> apart;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (gaps[k] && *gaps[k] > meet) apart.push_back(k);
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

// A link that carries others, or that several closures hold, is a body; a place in it is none.
bool holds_body(const Tree& tree, const std::vector<Closure>& closures, const Closure& closure) {
  return std::any_of(closure.frames.begin(), closure.frames.end(), [&](const LinkFrame& frame) {
    const auto count = std::count_if(closures.begin(), closures.end(), [&](const Closure& other) {
      return other.frames[0].link == frame.link || other.frames[1].link == frame.link;
    });
    return frame.in_link.translation().isZero() && (count > 1 || has_child(tree, frame.link));
  });
}

// Without what adding up frames leaves.
Eigen::Vector3d rounded(const Eigen::Vector3d& place) {
  return (place / decimal).array().round().matrix() * decimal;
}

std::string gap_text(const Tree& tree, const Closure& closure, double gap) {
  return "'" + tree.links[closure.frames[0].link] + "' and '" + tree.links[closure.frames[1].link] + "' by " +
         number_text(gap, 4) + " m (closure '" + closure.name + "')";
}

std::vector<std::string> notes_beside_ends(const std::shared_ptr<const Tree>& tree,
                                           const ResolvedConfig& resolved, const SourceNames& files,
                                           const Attempt& attempt) {
  std::vector<std::string> notes;
  for (const Correction& correction : end_place_corrections(*tree, resolved, files)) {
    auto changed = std::make_shared<Tree>(*tree);
    ResolvedConfig config = resolved;
    correction.apply(*changed, config);
    if (attempt(changed, config))
      notes.push_back(correction.fault + "; if it is to be there, " + correction.remedy + ".");
  }
  return notes;
}

}  // namespace

Corrections end_place_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                  const SourceNames& files) {
  Corrections found;
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  const std::vector<std::optional<double>> gaps = gaps_at_zero(tree, resolved.closures);
  for (const std::size_t k : held_beside_ends(tree, resolved)) {
    const auto& [first, second] = resolved.closures[k].frames;
    const Eigen::Vector3d place = rounded(poses[second.link].inverse() * poses[first.link].translation());
    const std::string element = "closure '" + resolved.closures[k].name + "'";
    found.push_back(
        {element,
         file_of_closures(resolved, files) + " has " + element + " " + number_text(gaps[k].value_or(0.0), 4) +
             " m beside the origin of link '" + tree.links[first.link] + "' while all joints are zero",
         place_remedy(tree, resolved, k, place), true, [k, place](Tree&, ResolvedConfig& changed) {
           changed.closures[k].frames[1].in_link.translation() = place;
         }});
  }
  return found;
}

Corrections place_corrections(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                              const SourceNames& files) {
  const double size =
      ClosureSystem(tree, resolved.base, with_type(resolved.closures, ClosureType::point)).size();
  const LoopJoints loops(*tree, resolved.closures, size);
  const std::vector<std::size_t> indices = those_apart(*tree, resolved);
  std::vector<Closure> apart;
  for (const std::size_t k : indices) apart.push_back(resolved.closures[k]);
  const LoopJoints suspects(*tree, apart, size);
  Corrections found = unit_corrections(*tree, resolved, suspects, size, files);
  for (Correction& correction : closure_place_corrections(*tree, resolved, indices, files))
    found.push_back(std::move(correction));
  for (const std::size_t joint : suspects.all())
    for (Correction& correction : gap_corrections(*tree, loops, joint, files))
      found.push_back(std::move(correction));
  return found;
}

std::string remedies_of_places(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                               const SourceNames& files, const Attempt& attempt) {
  std::string remedies;
  std::set<std::string> corrected;
  for (const Correction& correction : place_corrections(tree, resolved, files))
    if (corrected.size() < max_remedies && corrected.count(correction.element) == 0 &&
        puts_together(correction, tree, resolved, attempt)) {
      corrected.insert(correction.element);
      remedies += (remedies.empty() ? "" : ", or ") + correction.remedy;
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
  if (count_apart == 0 || !stands_out) return notes_beside_ends(tree, resolved, files, attempt);
  const std::string text = files.urdf + " has ends of closures apart while all joints are zero, " + apart +
                           ", where those of others meet; if these are to meet there, too, ";
  const std::string remedies = remedies_of_places(tree, resolved, files, attempt);
  return {text + (remedies.empty() ? "correct the origins of the joints in their loops" : remedies) + "."};
}

}  // namespace parallel_aspects
