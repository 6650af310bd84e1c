// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/diagnosis.h"

#include "urdf/closing/assembly.h"
#include "urdf/corrections/edits.h"
#include "urdf/diagnosis/edit_search.h"
#include "urdf/diagnosis/facts.h"
#include "urdf/diagnosis/misplaced_ends.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr int starts_without_limits = 12;

// Edits that cost the same; those that doubt least of the description come first.
enum class Cost {
  names,              // ends of closures, which their names or links that are there for them tell
  ends_apart,         // an origin that puts all ends together
  base,               // where the actuated joints are, or the tree starts
  missing_joint,      // that the other legs have
  frames,             // what closures hold, one kind after the other
  passive_slides,     // axes of those between base and platform
  like_axes,          // of all like closures
  one_type,           // of all closures, which have one
  like_others,        // an element, as others of its kind are
  fitting_axes,       // of joints
  platform_frame,     // of the one closure that is elsewhere
  operational_point,  // where the legs meet
  point_frame,        // of a closure that holds another place of the platform than that
  frames_and_drives,  // a frame with one of the actuated joints
  others,             // an element otherwise
  like_legs,          // the same of a joint in all legs
  types,              // of like closures
};
constexpr auto costliest = Cost::types;

void append(Edits& all, Edits more) { std::move(more.begin(), more.end(), std::back_inserter(all)); }

Edits those_of(const Edits& edits, bool like_others) {
  Edits found;
  std::copy_if(edits.begin(), edits.end(), std::back_inserter(found),
               [&](const Edit& edit) { return edit.like_others == like_others; });
  return found;
}

// Of one element each, first of those that are unlike others and in all loops that cannot be closed.
Edits element_edits(const Subject& s, const std::vector<std::size_t>& open_loops) {
  std::vector<std::size_t> joints = s.loops.all(), closures = open_loops;
  for (const std::size_t loop : open_loops) {
    const LoopJoints of_loop(s.tree, {s.system.closures()[loop]}, s.size());
    const auto is_elsewhere = [&](std::size_t joint) {
      return std::count(of_loop.all().begin(), of_loop.all().end(), joint) == 0;
    };
    joints.erase(std::remove_if(joints.begin(), joints.end(), is_elsewhere), joints.end());
  }
  std::stable_partition(joints.begin(), joints.end(),
                        [&](std::size_t joint) { return !s.loops.is_like_others(joint); });
  for (std::size_t k = 0; open_loops.empty() && k < s.resolved.closures.size(); ++k) closures.push_back(k);
  Edits all;
  if (s.resolved.actuation_origin.empty()) append(all, actuation_edits(s));
  append(all, unit_edits(s, s.loops));
  append(all, series_edits(s));
  append(all, closure_edits(s));
  append(all, exchanged_ends(s));
  append(all, closure_place_edits(s, closures));
  for (const std::size_t joint : joints) {
    const bool is_fixed = s.tree.joints[joint].motion == JointMotion::fixed;
    append(all, is_fixed ? origin_edits(s, joint) : motion_edits(s, joint));
    append(all, is_fixed ? motion_edits(s, joint) : origin_edits(s, joint));
  }
  return all;
}

// Each with those of the actuated joints that are like others once it is made.
Edits with_actuation(const Subject& s, const Edits& edits) {
  Edits both;
  for (const Edit& first : edits) {
    const Edited after = edited(s, first);
    for (const Edit& second : those_of(actuation_edits({after.tree, after.resolved, s.files}), true))
      both.push_back(together(first, second));
  }
  return both;
}

bool fixes_joint(const Edit& edit) {
  const auto* change = std::get_if<MotionChange>(&edit.changes.front());
  return change != nullptr && change->motion == JointMotion::fixed;
}

class Search {
 public:
  Search(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved, const SourceNames& files,
         const Attempt& attempt)
      : s_(tree, resolved, files), gaps_(*tree, resolved), search_(s_, attempt) {}

  // What is true of the robot rules out what is only possible.
  std::optional<Diagnosis> run() {
    const auto singular = singular_everywhere(s_.shared_tree, s_.resolved, s_.files);
    for (int cost = 0; cost <= static_cast<int>(costliest); ++cost) {
      const auto at = static_cast<Cost>(cost);
      if (singular && at != Cost::like_others && at != Cost::fitting_axes) continue;
      for (const Edits& kind : edits_at(at))
        if (search_.try_all(kind)) return diagnosis(at);
    }
    if (singular) return Diagnosis{{*singular}, Diagnosis::Kind::fact};
    if (const auto held =
            chain_that_holds_too_much(s_.system, values(), s_.resolved.actuated_joints, s_.files))
      return Diagnosis{{*held}};
    if (const auto linkage =
            linkage_of_one_degree_of_freedom(s_.shared_tree, s_.resolved, assembled(), s_.files))
      return Diagnosis{{*linkage}};
    return std::nullopt;
  }

  // Of frames alone, with the actuated joints where nothing else is known.
  std::optional<Diagnosis> of_frames(bool with_drives) {
    for (const Cost cost : {Cost::frames, Cost::frames_and_drives})
      for (const Edits& kind : cost == Cost::frames || with_drives ? edits_at(cost) : std::vector<Edits>{})
        if (search_.try_all(kind)) return diagnosis(cost);
    return std::nullopt;
  }

 private:
  std::vector<Edits> edits_at(Cost cost) {
    switch (cost) {
      case Cost::names: {
        Edits ends = end_place_edits(s_);
        append(ends, ends_paired_by_names(s_));
        return {ends};
      }
      case Cost::ends_apart:
        return {edits_of_apart_ends(s_)};
      case Cost::base:
        return {base_edits(s_)};
      case Cost::missing_joint:
        return {missing_joint_edits(s_)};
      case Cost::frames:
        return frame_edits(s_);
      case Cost::passive_slides:
        return {passive_slide_edits(s_)};
      case Cost::like_axes:
        return {axes_of_like_closures(s_)};
      case Cost::one_type:
        return {is_one_type() ? types_of_like_closures(s_, ClosureType::point) : Edits{}};
      case Cost::like_others:
        return {is_known() ? Edits{} : those_of(elements(), true)};
      case Cost::fitting_axes:
        return {is_known() ? Edits{} : axis_edits(s_, values())};
      case Cost::platform_frame:
        return {platform_frame_edits(s_)};
      case Cost::operational_point:
        return {is_assembled() ? operational_point_edits(s_) : Edits{}};
      case Cost::point_frame:
        return {point_frame_edits(s_)};
      case Cost::frames_and_drives:
        return frames_and_drives();
      case Cost::others:
        return {may_be_elsewhere() ? those_of(elements(), false) : Edits{}};
      case Cost::like_legs:
        return {may_be_elsewhere() ? motions_of_like_legs(s_) : Edits{}};
      case Cost::types:
        return types();
    }
    return {};
  }

  const AssemblyResult& assembled() {
    const ActuatedJoints& joints = s_.resolved.actuated_joints;
    if (!assembled_) assembled_ = assemble(s_.system, joints.variables, joints.platform_link);
    return *assembled_;
  }
  bool is_assembled() { return assembled().assembly.has_value(); }

  const Eigen::VectorXd& values() {
    return is_assembled() ? assembled().assembly->values : assembled().closest;
  }

  const Edits& elements() {
    if (elements_) return *elements_;
    const auto open = is_assembled() ? std::vector<std::size_t>{} : loops_that_stay_open(s_);
    search_.require_closed(open);
    elements_ = element_edits(s_, open);
    return *elements_;
  }

  std::vector<Edits> frames_and_drives() const {
    std::vector<Edits> both;
    if (s_.resolved.actuation_origin.empty())
      for (const Edits& kind : frame_edits(s_)) both.push_back(with_actuation(s_, kind));
    return both;
  }

  // One for like closures, or none. Where all are revolute, as in the plane, that is right.
  std::vector<Edits> types() const {
    const std::vector<Closure>& closures = s_.resolved.closures;
    const bool all_revolute = std::all_of(closures.begin(), closures.end(), [](const Closure& closure) {
      return closure.type == ClosureType::revolute;
    });
    std::vector<Edits> all;
    for (const ClosureType type : {ClosureType::point, ClosureType::revolute, ClosureType::universal})
      if (!all_revolute) all.push_back(types_of_like_closures(s_, type));
    if (s_.resolved.closure_dialect.empty())
      all.push_back(types_of_like_closures(s_, ClosureType::automatic));
    return all;
  }

  // A chain that was loose speaks for what puts it into a loop. Else a frame that a joint lets loose may be
  // put onto another link, or the joint be fixed: edits of joints change less than what is joined to what.
  Diagnosis diagnosis(Cost cost) {
    if (cost == Cost::frames && std::none_of(search_.working().begin(), search_.working().end(),
                                             [this](const auto& each) { return closes_more(each.edit); })) {
      Edits rivals;
      for (const Edit& edit : elements())
        if (edit.like_others || fixes_joint(edit)) rivals.push_back(edit);
      search_.try_before(rivals);
    }
    return search_.diagnosis();
  }

  // Whether more joints are in loops than before.
  bool closes_more(const Edit& edit) const {
    const Edited after = edited(s_, edit);
    const auto count = [](const std::vector<bool>& joints) {
      return std::count(joints.begin(), joints.end(), true);
    };
    return count(Subject(after.tree, after.resolved, s_.files).system.in_loop()) > count(s_.system.in_loop());
  }

  // Which is said where the legs are looked for.
  bool has_zero_length() {
    if (!is_assembled()) return false;
    const std::vector<bool> none(s_.system.in_loop().size(), false);
    Problems unused;
    return find_legs({s_.system, assembled().assembly->values, none}, s_.resolved.actuated_joints, s_.files,
                     unused)
        .has_zero_length;
  }

  bool has_mobility() {
    return is_assembled() && assembled().assembly->motions.cols() ==
                                 static_cast<Eigen::Index>(s_.resolved.actuated_joints.variables.size());
  }

  // As where somebody takes revolute joints for ball joints throughout. Fewer are of planar robots.
  bool is_one_type() const {
    const std::vector<Closure>& closures = s_.resolved.closures;
    return closures.size() > 2 && closures.front().type != ClosureType::automatic &&
           std::all_of(closures.begin(), closures.end(),
                       [&](const Closure& closure) { return closure.type == closures.front().type; });
  }

  // Then lengths and axes are not at fault.
  bool is_known() {
    if (!is_known_) is_known_ = (has_zero_length() && has_mobility()) || closes_without_limits();
    return *is_known_;
  }

  // Slides without limits would reach any length.
  bool closes_without_limits() {
    if (is_assembled()) return false;
    auto tree = std::make_shared<Tree>(s_.tree);
    for (TreeJoint& joint : tree->joints)
      if (joint.motion == JointMotion::revolute) joint.limits = {};
    return !closed_configurations({tree, s_.resolved.base, s_.system.closures()}, starts_without_limits, 1)
                .empty();
  }

  bool may_be_elsewhere() { return !is_known() && (gaps_.are_to_meet() || !mobility_fits()); }

  bool mobility_fits() {
    return is_assembled() &&
           (!s_.resolved.actuation_origin.empty() ||
            moves_a_body(s_.system, *assembled().assembly, s_.resolved.actuated_joints, s_.files));
  }

  Subject s_;
  EndGaps gaps_;
  EditSearch search_;
  std::optional<AssemblyResult> assembled_;
  std::optional<Edits> elements_;
  std::optional<bool> is_known_;
};

// Of closures whose ends are apart at zero: first what puts them together, then that they are together.
std::optional<Diagnosis> diagnosis_of_gaps(const std::shared_ptr<const Tree>& tree,
                                           const ResolvedConfig& resolved, const SourceNames& files,
                                           const Attempt& attempt) {
  auto together = with_ends_together(*tree, resolved);
  if (!together) return std::nullopt;
  if (drawn_open(*tree, resolved, files)) {
    const Subject meeting(tree, *together, files);
    EditSearch search(meeting, attempt);
    return search.try_all(place_edits({tree, resolved, files})) ? std::optional(search.diagnosis())
                                                                : std::nullopt;
  }
  if (auto found = Search(tree, *together, files, attempt).run()) return found;
  const auto remedy =
      are_all_welds(resolved.closures) ? std::nullopt : list_of_ends(tree, resolved, files, attempt);
  if (!remedy) return std::nullopt;
  return Diagnosis{{file_of_closures(resolved, files) +
                    " has ends of closures apart while all joints are zero, " +
                    end_gaps_text(*tree, resolved) +
                    ", and holds them so; correct the origins of the joints in their loops, or, if these are "
                    "right and the "
                    "ends are to meet elsewhere, write " +
                    *remedy + "."}};
}

}  // namespace

std::optional<Diagnosis> diagnosis_of(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                                      const SourceNames& files, const Attempt& attempt) {
  if (auto found = diagnosis_of_gaps(tree, resolved, files, attempt)) return found;
  const auto meant = drawn_open(*tree, resolved, files);
  return Search(tree, meant ? *meant : resolved, files, attempt).run();
}

std::optional<Diagnosis> diagnosis_of_ends(const std::shared_ptr<const Tree>& tree,
                                           const ResolvedConfig& resolved, const WrongEnds& ends,
                                           const SourceNames& files, const Attempt& attempt) {
  if (auto found = Search(tree, resolved, files, attempt).of_frames(ends.found.empty())) return found;
  if (ends.found.empty()) return std::nullopt;
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
  if (!next) return Diagnosis{{faults + "."}};
  return Diagnosis{{text + "then " + next->problems.front()}, next->kind};
}

}  // namespace parallel_aspects
