// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/crossed_ends.h"

#include "model/number_text.h"
#include "urdf/corrections/listed_corrections.h"
#include "urdf/corrections/named_ends.h"
#include "urdf/culprits/closure_gaps.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr double clearly_wider = 1.5;  // than the gaps of other closures

// Closures whose ends are where one another's should be, by their places at zero.
class CrossedPlaces {
 public:
  CrossedPlaces(const Tree& tree, const ResolvedConfig& resolved)
      : tree_(tree),
        resolved_(resolved),
        tolerance_(meeting_tolerance(tree, resolved)),
        gaps_(gaps_at_zero(tree, resolved.closures)) {}

  // What tells so, or nothing. `exchanged`: those with two ends exchanged.
  std::optional<std::string> reason(const std::vector<Closure>& exchanged) const {
    std::vector<std::size_t> both;
    for (std::size_t k = 0; k < exchanged.size(); ++k)
      if (!is_same(exchanged[k].frames[1], resolved_.closures[k].frames[1])) both.push_back(k);
    if (both.size() != 2) return std::nullopt;
    const std::vector<std::optional<double>> after = gaps_at_zero(tree_, exchanged);
    if (!are_nearer(both, after)) return std::nullopt;
    return "since these are " + number_text(*gaps_[both[0]], 4) + " m and " +
           number_text(*gaps_[both[1]], 4) + " m apart while all joints are zero, and the others of them " +
           number_text(*after[both[0]], 4) + " m and " + number_text(*after[both[1]], 4) + " m";
  }

 private:
  static bool is_same(const LinkFrame& one, const LinkFrame& other) {
    return one.link == other.link && one.in_link.isApprox(other.in_link);
  }

  // As near as those of all other closures, or together. Where ends are given, it is not to be by chance:
  // then all are to be as far apart.
  bool are_nearer(const std::vector<std::size_t>& both,
                  const std::vector<std::optional<double>>& after) const {
    double usual = 0.0, least = std::numeric_limits<double>::infinity();
    bool any_given = false;
    for (std::size_t k = 0; k < gaps_.size(); ++k) {
      if (k == both[0] || k == both[1] || !gaps_[k]) continue;
      usual = std::max(usual, *gaps_[k]);
      least = std::min(least, *gaps_[k]);
      any_given = any_given || !resolved_.closures[k].at_zero;
    }
    return std::all_of(both.begin(), both.end(), [&](std::size_t k) {
      if (!gaps_[k] || !after[k]) return false;
      const bool is_near = *gaps_[k] > clearly_wider * usual + tolerance_ && *after[k] <= usual + tolerance_;
      const bool are_alike = *after[k] >= least - tolerance_ && usual <= least + tolerance_;
      const bool meets = *after[k] <= tolerance_ && *gaps_[k] > tolerance_;
      return any_given ? meets || (is_near && are_alike) : is_near;
    });
  }

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  double tolerance_;
  std::vector<std::optional<double>> gaps_;
};

// Nothing where the ends make no robot in this order.
std::optional<Note> note(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                         const Correction& exchange, const std::string& reason, const SourceNames& files,
                         const Attempt& attempt) {
  Tree same = *tree;
  ResolvedConfig exchanged = resolved;
  exchange.apply(same, exchanged);
  ResolvedConfig listed = as_listed(*tree, exchanged);
  if (!attempt(tree, listed)) return std::nullopt;
  return "It seems that " + exchange.fault + ", " + reason + "; if so, " + exchange.remedy + ", or write " +
         closures_entry(*tree, with_known_types(tree, listed, attempt)) + " under mechanism in " +
         files.config + ".";
}

}  // namespace

Notes crossed_ends_notes(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                         const SourceNames& files, const Attempt& attempt) {
  if (const auto by_names = ends_paired_by_names(*tree, resolved, files))
    if (auto text = note(tree, resolved, *by_names, "as their names say", files, attempt)) return {*text};
  const CrossedPlaces crossed(*tree, resolved);
  Notes notes;
  for (const Correction& exchange : exchanged_ends(*tree, resolved, files, true)) {
    Tree same = *tree;
    ResolvedConfig exchanged = resolved;
    exchange.apply(same, exchanged);
    if (const auto reason = crossed.reason(exchanged.closures))
      if (auto text = note(tree, resolved, exchange, *reason, files, attempt)) notes.push_back(*text);
  }
  return notes;
}

}  // namespace parallel_aspects
