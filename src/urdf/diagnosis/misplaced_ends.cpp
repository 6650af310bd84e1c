// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/misplaced_ends.h"

#include "model/message_text.h"
#include "urdf/corrections/closure_end_corrections.h"
#include "urdf/corrections/gap_corrections.h"
#include "urdf/corrections/legs_of_tree.h"
#include "urdf/corrections/listed_corrections.h"
#include "urdf/corrections/unit_corrections.h"
#include "urdf/diagnosis/closure_gaps.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <utility>

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

// What the corrected description is recognised as, with its ends as they are then; nothing where they are
// apart.
std::optional<std::string> put_together(const Correction& correction, const std::shared_ptr<const Tree>& tree,
                                        const ResolvedConfig& resolved, const Attempt& attempt) {
  auto changed = std::make_shared<Tree>(*tree);
  ResolvedConfig config = resolved;
  correction.apply(*changed, config);
  place_at_zero(*changed, config.closures);
  return those_apart(*changed, config).empty() ? attempt(changed, config) : std::nullopt;
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

Notes notes_beside_ends(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                        const SourceNames& files, const Attempt& attempt) {
  Notes notes;
  for (const Correction& correction : end_place_corrections(*tree, resolved, files)) {
    auto changed = std::make_shared<Tree>(*tree);
    ResolvedConfig config = resolved;
    correction.apply(*changed, config);
    if (attempt(changed, config))
      notes.push_back(correction.fault + "; if it is to be there, " + correction.remedy + ".");
  }
  return notes;
}

struct Working {
  Correction correction;
  std::string space;
};

// Those that put all ends together, each of another element.
std::vector<Working> working_at_zero(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                     const SourceNames& files, const Attempt& attempt) {
  std::vector<Working> working;
  std::set<std::string> corrected;
  for (const Correction& correction : place_corrections(tree, resolved, files)) {
    if (working.size() == max_remedies || corrected.count(correction.element) > 0) continue;
    const auto space = put_together(correction, tree, resolved, attempt);
    if (!space) continue;
    corrected.insert(correction.element);
    working.push_back({correction, *space});
  }
  return working;
}

std::string joined(const std::vector<Working>& working, const std::string& between) {
  std::string all;
  for (const Working& each : working) all += (all.empty() ? "" : between) + each.correction.remedy;
  return all;
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
  return joined(working_at_zero(tree, resolved, files, attempt), ", or ");
}

std::optional<Diagnosis> origin_of_ends(const std::shared_ptr<const Tree>& tree,
                                        const ResolvedConfig& resolved, const SourceNames& files,
                                        const Attempt& attempt) {
  const ApartEnds ends = apart_ends(*tree, resolved);
  if (!ends.stand_out() && !ends.all_apart()) return std::nullopt;
  const std::vector<Working> working = working_at_zero(tree, resolved, files, attempt);
  if (working.empty()) return std::nullopt;
  if (working.size() > 1)
    return without_remedy(ends.fault(files) + "; " + joined(working, "; or ") +
                          "; each alone makes it a robot.");
  const auto& [correction, space] = working.front();
  return with_remedy(correction.fault + "; " + correction.remedy + ", which makes it a robot in " + space +
                     ".");
}

Notes misplaced_ends_notes(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                           const SourceNames& files, const Attempt& attempt) {
  const ApartEnds ends = apart_ends(*tree, resolved);
  const std::string remedies = ends.stand_out() || ends.all_apart()
                                   ? remedies_of_places(tree, resolved, files, attempt)
                                   : std::string();
  if (!ends.stand_out() && remedies.empty()) return notes_beside_ends(tree, resolved, files, attempt);
  return {ends.fault(files) + "; if these are to meet there" + (ends.all_apart() ? ", " : ", too, ") +
          (remedies.empty() ? "correct the origins of the joints in their loops" : remedies) + "."};
}

}  // namespace parallel_aspects
