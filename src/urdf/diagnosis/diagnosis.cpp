// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/diagnosis.h"

#include "urdf/closing/assembly.h"
#include "urdf/corrections/closure_end_corrections.h"
#include "urdf/corrections/legs_of_tree.h"
#include "urdf/diagnosis/correction_search.h"
#include "urdf/diagnosis/degenerate_mechanisms.h"
#include "urdf/diagnosis/like_closures.h"
#include "urdf/diagnosis/misfit_axes.h"
#include "urdf/diagnosis/misplaced_ends.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_points = 16;  // links that are tried as operational point
constexpr std::size_t max_links = 4;    // and as the end of one closure

// Of attempts, times the square of the number of joints in the loops, and more where an attempt has choices
// of its own: a refusal is not to take long.
constexpr std::size_t max_work = 2200;
constexpr std::size_t choices_of_types = 8;

constexpr int starts_without_limits = 12;

class Search {
 public:
  Search(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved, const SourceNames& files,
         const Attempt& attempt)
      : tree_(tree),
        resolved_(resolved),
        files_(files),
        attempt_(attempt),
        gaps_(*tree, resolved),
        system_(tree, resolved.base, typed(resolved.closures)),
        assembled_(
            assemble(system_, resolved.actuated_joints.variables, resolved.actuated_joints.platform_link)) {}

  std::optional<Diagnosis> run() {
    if (auto culprit = wrong_ends()) return culprit;
    if (auto culprit = origin_of_ends(tree_, resolved_, files_, attempt_)) return culprit;
    if (auto culprit = other_base()) return culprit;
    if (auto culprit = CorrectionSearch(tree_, resolved_, true, files_, attempt_).of_missing_joints())
      return culprit;
    if (auto culprit = CorrectionSearch(tree_, resolved_, true, files_, attempt_).of_frames()) return culprit;
    if (auto culprit = CorrectionSearch(tree_, resolved_, true, files_, attempt_).of_chains()) return culprit;
    if (auto culprit = CorrectionSearch(tree_, resolved_, true, files_, attempt_)
                           .working_of(axes_of_like_closures(tree_, resolved_, files_)))
      return culprit;
    if (is_one_type())
      if (auto culprit = other_type(ClosureType::point)) return culprit;
    const Eigen::VectorXd& values = assembled_.assembly ? assembled_.assembly->values : assembled_.closest;
    const bool is_known = (has_zero_length() && has_mobility()) || closes_without_limits();
    CorrectionSearch corrections(tree_, resolved_, assembled_.assembly.has_value(), files_, attempt_);
    if (!is_known) {
      if (auto culprit = corrections.like_others()) return culprit;
      if (auto culprit = corrections.working_of(find_axis_corrections(system_, values, files_)))
        return culprit;
    }
    if (const auto singular = singular_everywhere(tree_, resolved_, files_)) return without_remedy(*singular);
    if (auto culprit = other_closing_link()) return culprit;
    if (assembled_.assembly)
      if (auto culprit = other_operational_point()) return culprit;
    if (auto culprit = CorrectionSearch(tree_, resolved_, true, files_, attempt_).of_point()) return culprit;
    CorrectionSearch both(tree_, resolved_, true, files_, attempt_);
    if (auto culprit = both.of_frames_and_actuation()) return culprit;
    if (!is_known && (gaps_.are_to_meet() || !mobility_fits()))
      if (auto culprit = corrections.others()) return culprit;
    if (auto culprit = other_types()) return culprit;
    if (const auto linkage = linkage_of_one_degree_of_freedom(tree_, resolved_, assembled_, files_))
      return without_remedy(*linkage);
    return std::nullopt;
  }

 private:
  // Names that say so speak for it alone, and links that are there for a closure.
  std::optional<Diagnosis> wrong_ends() const {
    Corrections ends = end_place_corrections(*tree_, resolved_, files_);
    if (const auto by_names = ends_paired_by_names(*tree_, resolved_, files_)) ends.push_back(*by_names);
    return CorrectionSearch(tree_, resolved_, true, files_, attempt_).working_of(ends);
  }

  // With what holds least, so that it is assembled wherever it can be.
  static std::vector<Closure> typed(std::vector<Closure> closures) {
    for (Closure& closure : closures)
      if (closure.type == ClosureType::automatic) closure.type = ClosureType::point;
    return closures;
  }

  // Which is said where the legs are looked for.
  bool has_zero_length() const {
    if (!assembled_.assembly) return false;
    const std::vector<bool> none(system_.in_loop().size(), false);
    Problems unused;
    return find_legs({system_, assembled_.assembly->values, none}, resolved_.actuated_joints, files_, unused)
        .has_zero_length;
  }

  bool has_mobility() const {
    return assembled_.assembly && assembled_.assembly->motions.cols() ==
                                      static_cast<Eigen::Index>(resolved_.actuated_joints.variables.size());
  }

  // As where somebody takes revolute joints for ball joints throughout. Fewer are of planar robots.
  bool is_one_type() const {
    const std::vector<Closure>& closures = resolved_.closures;
    return closures.size() > 2 && closures.front().type != ClosureType::automatic &&
           std::all_of(closures.begin(), closures.end(),
                       [&](const Closure& closure) { return closure.type == closures.front().type; });
  }

  // Then lengths and axes are not at fault. Slides without limits would reach any length.
  bool closes_without_limits() const {
    if (assembled_.assembly) return false;
    auto tree = std::make_shared<Tree>(*tree_);
    for (TreeJoint& joint : tree->joints)
      if (joint.motion == JointMotion::revolute) joint.limits = {};
    return !closed_configurations({tree, resolved_.base, system_.closures()}, starts_without_limits, 1)
                .empty();
  }

  bool mobility_fits() const {
    return assembled_.assembly &&
           (!resolved_.actuation_origin.empty() ||
            moves_a_body(system_, *assembled_.assembly, resolved_.actuated_joints, files_));
  }

  std::size_t platform() const { return resolved_.actuated_joints.platform_link; }

  std::string operational_point() const { return operational_point_text(*tree_, platform(), files_); }

  // Where most of the actuated joints are fixed to, and else the root.
  std::optional<Diagnosis> other_base() {
    const std::size_t usual = usual_link_of_actuation();
    if (body_of(*tree_, usual) != body_of(*tree_, resolved_.base))
      return based_on(usual, "which is not where the actuated joints are fixed");
    return based_on(0, "while the tree of " + files_.urdf + " starts at link '" + tree_->links.front() + "'");
  }

  // The base as it is where they have none together.
  std::size_t usual_link_of_actuation() const {
    std::size_t most = 1, base = resolved_.base;
    for (const std::size_t variable : resolved_.actuated_joints.variables) {
      const std::size_t link = tree_->joint_of(variable).parent;
      const auto count = static_cast<std::size_t>(
          std::count_if(resolved_.actuated_joints.variables.begin(),
                        resolved_.actuated_joints.variables.end(), [&](std::size_t other) {
                          return body_of(*tree_, tree_->joint_of(other).parent) == body_of(*tree_, link);
                        }));
      if (count > most) base = link;
      most = std::max(most, count);
    }
    return base;
  }

  std::optional<Diagnosis> based_on(std::size_t base, const std::string& reason) {
    if (body_of(*tree_, base) == body_of(*tree_, resolved_.base) || is_on_platform(base)) return std::nullopt;
    ResolvedConfig changed = resolved_;
    changed.base = base;
    const auto space = tried(tree_, changed);
    if (!space) return std::nullopt;
    return with_remedy(files_.config + " has " + files_.key("base_link") + " '" +
                       tree_->links[resolved_.base] + "', " + reason + "; write " +
                       files_.entry("base_link", tree_->links[base]) + ", which makes it a robot in " +
                       *space + ".");
  }

  // One closure elsewhere, where all others hold a leg to the platform.
  std::optional<Diagnosis> other_closing_link() {
    const std::vector<Closure>& closures = resolved_.closures;
    const auto is_elsewhere = [this](const Closure& closure) {
      return !is_on_platform(closure.frames[0].link) && !is_on_platform(closure.frames[1].link);
    };
    if (closures.size() < 2 || std::count_if(closures.begin(), closures.end(), is_elsewhere) != 1)
      return std::nullopt;
    for (std::size_t k = 0; k < closures.size(); ++k) {
      const auto& frames = closures[k].frames;
      if (!is_elsewhere(closures[k])) continue;
      for (const std::size_t end : {0, 1})
        for (const std::size_t link : platform_links(frames[end]))
          if (auto culprit = closed_at(k, end, link)) return culprit;
    }
    return std::nullopt;
  }

  bool is_on_platform(std::size_t link) const { return body_of(*tree_, link) == body_of(*tree_, platform()); }

  bool is_closed(std::size_t link) const {
    return std::any_of(resolved_.closures.begin(), resolved_.closures.end(), [&](const Closure& closure) {
      return closure.frames[0].link == link || closure.frames[1].link == link;
    });
  }

  // What may be meant: a place beside a link stays there, and else links that no closure has.
  std::vector<std::size_t> platform_links(const LinkFrame& frame) const {
    if (!frame.in_link.isApprox(Eigen::Isometry3d::Identity())) return {platform()};
    std::vector<std::size_t> links;
    for (std::size_t link = 0; link < tree_->links.size(); ++link)
      if (is_on_platform(link) && link != platform() && !is_closed(link) && links.size() < max_links)
        links.push_back(link);
    return links;
  }

  std::optional<Diagnosis> closed_at(std::size_t closure, std::size_t end, std::size_t link) {
    ResolvedConfig changed = resolved_;
    changed.closures[closure].frames[end].link = link;
    if (legs_share_anchors(*tree_, changed, system_.size())) return std::nullopt;
    const auto space = tried(tree_, changed);
    if (!space) return std::nullopt;
    const Closure& written = resolved_.closures[closure];
    return with_remedy(files_.config + " closes '" + written.name + "' at link '" +
                       tree_->links[written.frames[end].link] + "', which is not on the body of " +
                       operational_point() + "; write link '" + tree_->links[link] +
                       "' there, which makes it a robot in " + *space + ".");
  }

  // Origins of links where loops are closed, or that several joints move, each place on a body once.
  std::vector<std::size_t> candidates() const {
    std::vector<std::size_t> links;
    for (const Closure& closure : resolved_.closures)
      for (const LinkFrame& frame : closure.frames) links.push_back(frame.link);
    std::vector<std::size_t> joints_at(tree_->links.size(), 0);
    for (const TreeJoint& joint : tree_->joints)
      if (joint.variable && system_.in_loop()[*joint.variable]) ++joints_at[joint.parent];
    for (std::size_t link = 0; link < joints_at.size(); ++link)
      if (joints_at[link] > 1) links.push_back(link);
    std::vector<std::size_t> once;
    for (const std::size_t link : links)
      if (link != resolved_.base && link != resolved_.actuated_joints.platform_link &&
          std::find(once.begin(), once.end(), link) == once.end() && once.size() < max_points)
        once.push_back(link);
    return once;
  }

  std::optional<Diagnosis> other_operational_point() {
    for (const std::size_t link : candidates()) {
      ResolvedConfig changed = resolved_;
      changed.actuated_joints.platform_link = link;
      const auto space = tried(tree_, changed);
      if (!space) continue;
      const std::string& name = tree_->links[link];
      return without_remedy(files_.config + " has " + operational_point() + ", but the legs of " +
                            files_.urdf + " meet in link '" + name + "', as those of a robot in " + *space +
                            "; write " + files_.entry("operational_point", name) + ".");
    }
    return std::nullopt;
  }

  // One for like closures, or none. Where all are revolute, as in the plane, that is right.
  std::optional<Diagnosis> other_types() const {
    const bool all_revolute =
        std::all_of(resolved_.closures.begin(), resolved_.closures.end(),
                    [](const Closure& closure) { return closure.type == ClosureType::revolute; });
    if (!all_revolute)
      for (const ClosureType type : {ClosureType::point, ClosureType::revolute, ClosureType::universal})
        if (auto culprit = other_type(type)) return culprit;
    return resolved_.closure_dialect.empty() ? other_type(ClosureType::automatic) : std::nullopt;
  }

  std::optional<Diagnosis> other_type(ClosureType type) const {
    return CorrectionSearch(tree_, resolved_, true, files_, attempt_)
        .working_of(types_of_like_closures(resolved_, type, files_));
  }

  std::optional<std::string> tried(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& changed) {
    const auto joints =
        static_cast<std::size_t>(std::count(system_.in_loop().begin(), system_.in_loop().end(), true));
    const auto& closures = changed.closures;
    const bool is_open = !changed.actuation_origin.empty() ||
                         std::any_of(closures.begin(), closures.end(), [](const Closure& closure) {
                           return closure.type == ClosureType::automatic;
                         });
    work_ += joints * joints * (is_open ? choices_of_types : 1);
    if (work_ > max_work) return std::nullopt;
    ResolvedConfig placed = changed;
    place_at_zero(*tree, placed.closures);
    return gaps_.allow(*tree, placed) ? attempt_(tree, placed) : std::nullopt;
  }

  const std::shared_ptr<const Tree>& tree_;
  const ResolvedConfig& resolved_;
  const SourceNames& files_;
  const Attempt& attempt_;
  EndGaps gaps_;
  ClosureSystem system_;
  AssemblyResult assembled_;
  std::size_t work_ = 0;
};

// Of closures whose ends are apart at zero: first what puts them together, then that they are together.
std::optional<Diagnosis> diagnosis_of_gaps(const std::shared_ptr<const Tree>& tree,
                                           const ResolvedConfig& resolved, const SourceNames& files,
                                           const Attempt& attempt) {
  auto together = with_ends_together(*tree, resolved);
  if (!together) return std::nullopt;
  if (drawn_open(*tree, resolved, files))
    return CorrectionSearch(tree, *together, true, files, attempt)
        .working_of(place_corrections(tree, resolved, files));
  if (auto culprit = Search(tree, *together, files, attempt).run()) return culprit;
  const auto remedy =
      are_all_welds(resolved.closures) ? std::nullopt : list_of_ends(tree, resolved, files, attempt);
  if (!remedy) return std::nullopt;
  return without_remedy(
      file_of_closures(resolved, files) + " has ends of closures apart while all joints are zero, " +
      end_gaps_text(*tree, resolved) +
      ", and holds them so; correct the origins of the joints in their loops, or, if these are right and "
      "the "
      "ends are to meet elsewhere, write " +
      *remedy + ".");
}

}  // namespace

std::optional<Diagnosis> diagnosis_of(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                      const SourceNames& files, const Attempt& attempt) {
  if (auto culprit = diagnosis_of_gaps(tree, resolved, files, attempt)) return culprit;
  const auto meant = drawn_open(*tree, resolved, files);
  return Search(tree, meant ? *meant : resolved, files, attempt).run();
}

std::optional<Diagnosis> diagnosis_of_ends(const std::shared_ptr<const Tree>& tree,
                                           const ResolvedConfig& resolved, const WrongEnds& ends,
                                           const SourceNames& files, const Attempt& attempt) {
  CorrectionSearch frames(tree, resolved, true, files, attempt);
  if (auto culprit = frames.of_frames()) return culprit;
  if (ends.found.empty()) return frames.of_frames_and_actuation();
  ResolvedConfig changed = resolved;
  changed.base = ends.base;
  changed.actuated_joints.platform_link = ends.actuated_joints.platform_link;
  if (resolved.actuation_origin.empty()) changed.actuated_joints = ends.actuated_joints;
  if (attempt(tree, changed)) return Diagnosis{ends.problems()};
  std::string text, faults;
  for (const WrongEnds::Wrong& wrong : ends.found) {
    text += wrong.fault + "; " + wrong.remedy + "; ";
    faults += (faults.empty() ? "" : ", and ") + wrong.fault;
  }
  const auto next = diagnosis_of(tree, changed, files, attempt);
  if (!next) return without_remedy(faults + ".");
  return Diagnosis{{text + "then " + next->problems.front()}, next->has_remedy};
}

}  // namespace parallel_aspects
