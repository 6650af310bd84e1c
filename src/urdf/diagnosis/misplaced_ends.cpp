// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "urdf/corrections/edits.h"
#include "urdf/diagnosis/closure_gaps.h"
#include "urdf/diagnosis/diagnosis.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double clearly_wider = 1.5;  // than the gaps of other closures, which legs of one drawing share

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
std::optional<Note> note(const Subject& s, const Edit& exchange, const std::string& reason,
                         const Attempt& attempt) {
  const ResolvedConfig listed = as_listed(s.tree, edited(s, exchange).resolved);
  if (!attempt(s.shared_tree, listed)) return std::nullopt;
  return "It seems that " + exchange.fault + ", " + reason + "; if so, " + exchange.remedy + ", or write " +
         closures_entry(s.tree, with_known_types(s.shared_tree, listed, attempt), s.files) + ".";
}

}  // namespace

Notes crossed_ends_notes(const Subject& subject, const Attempt& attempt) {
  for (const Edit& by_names : ends_paired_by_names(subject))
    if (auto text = note(subject, by_names, "as their names say", attempt)) return {*text};
  const CrossedPlaces crossed(subject.tree, subject.resolved);
  Notes notes;
  for (const Edit& exchange : exchanged_ends(subject, true))
    if (const auto reason = crossed.reason(edited(subject, exchange).resolved.closures))
      if (auto text = note(subject, exchange, *reason, attempt)) notes.push_back(*text);
  return notes;
}

namespace {

constexpr std::size_t max_remedies = 3;  // that one note names
constexpr double decimal = 1e-8;         // to which a place is printed [m]

// By their indices.
std::vector<std::size_t> those_apart(const Tree& tree, const ResolvedConfig& resolved) {
  const std::vector<std::optional<double>> gaps = gaps_at_zero(tree, resolved.closures);
  const double meet = meeting_tolerance(tree, resolved);
  std::vector<std::size_t> apart;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (gaps[k] && *gaps[k] > meet) apart.push_back(k);
  return apart;
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

// Of the closures through the base whose ends are given.
struct ApartEnds {
  std::string names;
  std::size_t apart = 0, together = 0;

  bool stand_out() const { return apart > 0 && (apart == 1 ? together > 0 : apart < together); }
  bool all_apart() const { return apart > 1 && together == 0; }

  std::string fault(const SourceNames& files) const {
    return files.urdf + " has ends of closures apart while all joints are zero, " + names +
           (all_apart() ? ", all of which one origin puts together" : ", where those of others meet");
  }
};

ApartEnds apart_ends(const Tree& tree, const ResolvedConfig& resolved) {
  const std::vector<std::optional<double>> gaps = gaps_at_zero(tree, resolved.closures);
  const double meet = meeting_tolerance(tree, resolved);
  ApartEnds ends;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const Closure& closure = resolved.closures[k];
    if (closure.at_zero || !gaps[k] || holds_body(tree, resolved.closures, closure) ||
        !passes_base(tree, resolved.base, closure))
      continue;
    ++(*gaps[k] > meet ? ends.apart : ends.together);
    if (*gaps[k] > meet) ends.names += (ends.names.empty() ? "" : ", ") + gap_text(tree, closure, *gaps[k]);
  }
  return ends;
}

// Of one origin in the loops whose ends are apart: those that put all ends together.
Edits edits_that_join(const Subject& s) {
  Edits joining;
  for (Edit& edit : place_edits(s)) {
    const Edited after = edited(s, edit);
    if (those_apart(*after.tree, after.resolved).empty()) joining.push_back(std::move(edit));
  }
  return joining;
}

}  // namespace

Edits end_place_edits(const Subject& subject) {
  const Tree& tree = subject.tree;
  Edits found;
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  const std::vector<std::optional<double>> gaps = gaps_at_zero(tree, subject.resolved.closures);
  for (const std::size_t k : held_beside_ends(tree, subject.resolved)) {
    const auto& [first, second] = subject.resolved.closures[k].frames;
    const Eigen::Vector3d place = rounded(poses[second.link].inverse() * poses[first.link].translation());
    found.push_back(edit_of(subject,
                            subject.file() + " has " + subject.closure(k) + " " +
                                number_text(gaps[k].value_or(0.0), 4) + " m beside the origin of link " +
                                subject.link(first.link) + " while all joints are zero",
                            {moved(subject, {k, 1, place}, place)}, true));
  }
  return found;
}

Edits place_edits(const Subject& subject) {
  const std::vector<std::size_t> indices = those_apart(subject.tree, subject.resolved);
  std::vector<Closure> apart;
  for (const std::size_t k : indices) apart.push_back(subject.resolved.closures[k]);
  const LoopJoints suspects(subject.tree, apart, subject.size());
  Edits found = unit_edits(subject, suspects);
  const auto append = [&](Edits more) { std::move(more.begin(), more.end(), std::back_inserter(found)); };
  append(closure_place_edits(subject, indices));
  for (const std::size_t joint : suspects.all()) append(origin_edits(subject, joint));
  return found;
}

Edits edits_of_apart_ends(const Subject& subject) {
  const ApartEnds ends = apart_ends(subject.tree, subject.resolved);
  return ends.stand_out() || ends.all_apart() ? edits_that_join(subject) : Edits{};
}

std::string remedies_of_places(const Subject& subject, const Attempt& attempt) {
  std::string remedies;
  std::set<std::string> corrected;
  for (const Edit& edit : edits_that_join(subject)) {
    if (corrected.size() == max_remedies || corrected.count(edit.element) > 0) continue;
    const Edited after = edited(subject, edit);
    if (!attempt(after.tree, after.resolved)) continue;
    corrected.insert(edit.element);
    remedies += (remedies.empty() ? "" : ", or ") + edit.remedy;
  }
  return remedies;
}

Notes notes_of_working(const Subject& subject, const Edits& edits, const std::string& condition,
                       const Attempt& attempt) {
  Notes notes;
  std::set<std::string> noted;
  for (const Edit& edit : edits) {
    const Edited after = edited(subject, edit);
    if (noted.count(edit.element) > 0 || !attempt(after.tree, after.resolved)) continue;
    noted.insert(edit.element);
    notes.push_back(edit.fault + "; " + condition + ", " + edit.remedy + ".");
  }
  return notes;
}

Notes misplaced_ends_notes(const Subject& subject, const Attempt& attempt) {
  const ApartEnds ends = apart_ends(subject.tree, subject.resolved);
  const std::string remedies =
      ends.stand_out() || ends.all_apart() ? remedies_of_places(subject, attempt) : std::string();
  if (!ends.stand_out() && remedies.empty())
    return notes_of_working(subject, end_place_edits(subject), "if it is to be there", attempt);
  return {ends.fault(subject.files) + "; if these are to meet there" + (ends.all_apart() ? ", " : ", too, ") +
          (remedies.empty() ? "correct the origins of the joints in their loops" : remedies) + "."};
}

}  // namespace parallel_aspects
