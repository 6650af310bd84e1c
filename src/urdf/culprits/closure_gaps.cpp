// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/culprits/closure_gaps.h"

#include "model/number_text.h"
#include "urdf/corrections/correction_text.h"
#include "urdf/corrections/listed_corrections.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

constexpr double small_gap = 1e-4;     // of the size of the robot
constexpr double clearly_wider = 1.5;  // than the gaps of other closures

std::string number(double value) { return number_text(value, 4); }

bool is_fixed_frame(const Tree& tree, std::size_t link) {
  const auto joint = tree.joint_above[link];
  return joint && tree.joints[*joint].motion == JointMotion::fixed && !has_child(tree, link);
}

// A place beside its links is meant as it is written, and a link that several closures hold is a body.
bool joins_ends(const Tree& tree, const std::vector<Closure>& closures, const Closure& closure) {
  const std::size_t first = closure.frames[0].link;
  const auto is_held = [first](const Closure& other) {
    return other.frames[0].link == first || other.frames[1].link == first;
  };
  return closure.at_zero && is_fixed_frame(tree, first) && !has_child(tree, closure.frames[1].link) &&
         closure.frames[1].in_link.translation().isZero() &&
         std::count_if(closures.begin(), closures.end(), is_held) == 1;
}

double tolerance(const Tree& tree, const ResolvedConfig& resolved) {
  const auto shared = std::make_shared<const Tree>(tree);
  return small_gap *
         ClosureSystem(shared, resolved.base, with_type(resolved.closures, ClosureType::point)).size();
}

// Of its ends, and zero where it has none [m].
std::vector<double> end_gaps(const Tree& tree, const std::vector<Closure>& closures) {
  std::vector<double> gaps;
  for (const Closure& closure : closures)
    gaps.push_back(joins_ends(tree, closures, closure) ? closure.frames[0].in_link.translation().norm()
                                                       : 0.0);
  return gaps;
}

double widest(const std::vector<double>& gaps) {
  return gaps.empty() ? 0.0 : *std::max_element(gaps.begin(), gaps.end());
}

// What of a frame its closure sees.
LinkFrame as_seen(LinkFrame frame, ClosureType type) {
  const bool any_axis = type == ClosureType::universal || type == ClosureType::fixed;
  const bool is_upright = (frame.in_link.linear().col(2) - Eigen::Vector3d::UnitZ()).norm() < 1e-9;
  if (type == ClosureType::point || (!any_axis && is_upright)) frame.in_link.linear().setIdentity();
  return frame;
}

std::string as_yaml(const Tree& tree, const LinkFrame& frame) {
  const std::string& link = tree.links[frame.link];
  if (frame.in_link.isApprox(Eigen::Isometry3d::Identity())) return link;
  return "{link: " + link + ", xyz: " + as_list(frame.in_link.translation()) +
         ", rpy: " + as_list(roll_pitch_yaw(frame.in_link.linear())) + "}";
}

// The numbers in a name.
std::vector<std::string> numbers_in(const std::string& name) {
  std::vector<std::string> found;
  bool inside = false;
  for (const char letter : name) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(letter)) != 0;
    if (is_digit && !inside) found.emplace_back();
    if (is_digit) found.back() += letter;
    inside = is_digit;
  }
  return found;
}

// Closures whose ends may be exchanged.
class CrossedEnds {
 public:
  CrossedEnds(const Tree& tree, const ResolvedConfig& resolved)
      : tree_(tree),
        resolved_(resolved),
        tolerance_(tolerance(tree, resolved)),
        poses_(link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()))),
        gaps_(gaps_at_zero(resolved.closures)) {}

  // What tells so, or nothing. `exchanged`: those with two ends exchanged.
  std::optional<std::string> reason(const std::vector<Closure>& exchanged) const {
    std::vector<std::size_t> both;
    for (std::size_t k = 0; k < exchanged.size(); ++k)
      if (exchanged[k].frames[1].link != resolved_.closures[k].frames[1].link) both.push_back(k);
    if (both.size() != 2) return std::nullopt;
    if (names_cross(both[0], both[1])) return "as the numbers in their names say";
    const std::vector<std::optional<double>> after = gaps_at_zero(exchanged);
    if (!are_nearer(both, after)) return std::nullopt;
    return "since these are " + number(*gaps_[both[0]]) + " m and " + number(*gaps_[both[1]]) +
           " m apart while all joints are zero, and the others of them " + number(*after[both[0]]) +
           " m and " + number(*after[both[1]]) + " m";
  }

 private:
  // Of the origins that are to meet; nothing where a frame follows from the other.
  std::vector<std::optional<double>> gaps_at_zero(const std::vector<Closure>& closures) const {
    std::vector<std::optional<double>> gaps;
    for (const Closure& closure : closures) {
      const auto& [one, other] = closure.frames;
      const bool is_given = !closure.at_zero || joins_ends(tree_, closures, closure);
      const Eigen::Vector3d in_one =
          closure.at_zero ? Eigen::Vector3d::Zero() : Eigen::Vector3d(one.in_link.translation());
      gaps.push_back(
          is_given
              ? std::optional<double>(
                    (poses_[one.link] * in_one - poses_[other.link] * other.in_link.translation()).norm())
              : std::nullopt);
    }
    return gaps;
  }

  // As near as those of all other closures that are given at zero, or together.
  bool are_nearer(const std::vector<std::size_t>& both,
                  const std::vector<std::optional<double>>& after) const {
    double usual = 0.0;
    for (std::size_t k = 0; k < gaps_.size(); ++k)
      if (k != both[0] && k != both[1] && resolved_.closures[k].at_zero && gaps_[k])
        usual = std::max(usual, *gaps_[k]);
    return std::all_of(both.begin(), both.end(), [&](std::size_t k) {
      return gaps_[k] && after[k] && *gaps_[k] > clearly_wider * usual + tolerance_ &&
             *after[k] <= usual + tolerance_;
    });
  }

  // Where those of all others agree.
  bool names_cross(std::size_t one, std::size_t other) const {
    std::size_t agreeing = 0;
    for (std::size_t k = 0; k < resolved_.closures.size(); ++k)
      if (!numbers_of(k, 0).empty() && numbers_of(k, 0) == numbers_of(k, 1)) ++agreeing;
    return agreeing > 0 && agreeing + 2 == resolved_.closures.size() &&
           numbers_of(one, 0) != numbers_of(one, 1) && numbers_of(one, 0) == numbers_of(other, 1) &&
           numbers_of(one, 1) == numbers_of(other, 0);
  }

  std::vector<std::string> numbers_of(std::size_t closure, std::size_t end) const {
    return numbers_in(tree_.links[resolved_.closures[closure].frames[end].link]);
  }

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  double tolerance_;
  Poses poses_;
  std::vector<std::optional<double>> gaps_;
};

}  // namespace

std::optional<ResolvedConfig> with_ends_together(const Tree& tree, const ResolvedConfig& resolved) {
  if (widest(end_gaps(tree, resolved.closures)) <= tolerance(tree, resolved)) return std::nullopt;
  ResolvedConfig together = resolved;
  for (Closure& closure : together.closures)
    if (joins_ends(tree, resolved.closures, closure)) closure.frames[0].in_link.translation().setZero();
  return together;
}

bool are_all_welds(const std::vector<Closure>& closures) {
  return std::all_of(closures.begin(), closures.end(),
                     [](const Closure& closure) { return closure.weld != Weld::none; });
}

EndGaps::EndGaps(const Tree& tree, const ResolvedConfig& resolved) {
  ResolvedConfig placed = resolved;
  place_at_zero(tree, placed.closures);
  for (const Closure& closure : resolved.closures)
    joins_ends_.push_back(joins_ends(tree, resolved.closures, closure));
  before_ = end_gaps(tree, placed.closures);
  const double meet = tolerance(tree, placed);
  are_to_meet_ = widest(before_) > meet && widest(end_gaps(tree, resolved.closures)) <= meet;
}

bool EndGaps::allow(const Tree& tree, const ResolvedConfig& changed) const {
  std::vector<double> after = end_gaps(tree, changed.closures);
  for (std::size_t k = 0; after.size() == joins_ends_.size() && k < after.size(); ++k)
    if (joins_ends_[k] && changed.closures[k].frames[1].in_link.translation().isZero())
      after[k] = changed.closures[k].frames[0].in_link.translation().norm();
  if (widest(after) == 0.0) return true;
  const double meet = tolerance(tree, changed);
  if (widest(after) <= meet) return true;
  if (are_to_meet_ || after.size() != before_.size() || after.size() < 2) return false;
  const auto is_usual = [&](double gap) { return std::abs(gap - before_.front()) <= meet; };
  return std::all_of(before_.begin(), before_.end(), is_usual) &&
         std::all_of(after.begin(), after.end(), is_usual);
}

std::string closures_entry(const Tree& tree, const std::vector<Closure>& closures) {
  std::string list;
  for (const Closure& closure : closures)
    list += (list.empty() ? "{frames: [" : ", {frames: [") +
            as_yaml(tree, as_seen(closure.frames[0], closure.type)) + ", " +
            as_yaml(tree, as_seen(closure.frames[1], closure.type)) +
            "], type: " + std::string(name(closure.type)) + "}";
  return "closures: [" + list + "]";
}

std::string end_gaps_text(const Tree& tree, const ResolvedConfig& resolved) {
  const std::vector<double> gaps = end_gaps(tree, resolved.closures);
  const double meet = tolerance(tree, resolved);
  std::string text;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (gaps[k] <= meet) continue;
    const Closure& closure = resolved.closures[k];
    text += (text.empty() ? "'" : ", '") + tree.links[closure.frames[0].link] + "' and '" +
            tree.links[closure.frames[1].link] + "' by " + number(gaps[k]) + " m (closure '" + closure.name +
            "')";
  }
  return text;
}

std::vector<std::string> crossed_ends_notes(const std::shared_ptr<const Tree>& tree,
                                            const ResolvedConfig& resolved, const SourceNames& files,
                                            const Attempt& attempt) {
  const CrossedEnds crossed(*tree, resolved);
  std::vector<std::string> notes;
  for (const Correction& exchange : exchanged_ends(*tree, resolved, files)) {
    Tree same = *tree;
    ResolvedConfig exchanged = resolved;
    exchange.apply(same, exchanged);
    const auto reason = crossed.reason(exchanged.closures);
    if (reason && attempt(tree, exchanged))
      notes.push_back("It seems that " + exchange.fault + ", " + *reason + "; if so, " + exchange.remedy +
                      ".");
  }
  return notes;
}

}  // namespace parallel_aspects
