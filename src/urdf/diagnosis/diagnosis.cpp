// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/diagnosis/diagnosis.h"

#include "urdf/closing/assembly.h"
#include "urdf/corrections/edits.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr int starts_without_limits = 12;  // as the space is wider then than that of other searches

// Edits that cost the same; those that change the description least come first.
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
};

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
    for (const Source& source : sources())
      if (!singular || source.cost == Cost::like_others || source.cost == Cost::fitting_axes)
        if (auto found = of(source)) return found;
    if (singular) return Diagnosis{{*singular}, Diagnosis::Kind::fact};
    if (const auto held =
            chain_that_holds_too_much(s_.system, values(), s_.resolved.actuated_joints, s_.files))
      return Diagnosis{{*held}};
    if (const auto linkage =
            linkage_of_one_degree_of_freedom(s_.shared_tree, s_.resolved, assembled(), s_.files))
      return Diagnosis{{*linkage}};
    return has_zero_length() ? std::nullopt : of_ranks();
  }

  // Of frames alone, and with the actuated joints where nothing else is known.
  std::optional<Diagnosis> of_frames(bool with_drives) {
    for (const Source& source : sources())
      if (source.cost == Cost::frames || (with_drives && source.cost == Cost::frames_and_drives))
        if (auto found = of(source)) return found;
    return std::nullopt;
  }

 private:
  using Kinds = std::vector<Edits>;  // one after the other
  struct Source {
    Cost cost;
    std::function<Kinds()> edits;
  };

  std::optional<Diagnosis> of_ranks() {
    if (const auto idle =
            actuated_joints_that_move_nothing(s_.system, assembled(), s_.resolved.actuated_joints, s_.files))
      return Diagnosis{{*idle}};
    if (const auto held = closures_that_hold_too_much(s_.shared_tree, s_.resolved, assembled(), s_.files))
      return Diagnosis{{*held}};
    return std::nullopt;
  }

  std::optional<Diagnosis> of(const Source& source) {
    for (const Edits& kind : source.edits())
      if (search_.try_all(kind)) return diagnosis(source.cost);
    return std::nullopt;
  }

  // Each is asked only where those before it had nothing that works.
  std::vector<Source> sources() {
    return {
        {Cost::names, [this] { return Kinds{ends()}; }},
        {Cost::ends_apart, [this] { return Kinds{edits_of_apart_ends(s_)}; }},
        {Cost::base, [this] { return Kinds{base_edits(s_)}; }},
        {Cost::missing_joint, [this] { return Kinds{missing_joint_edits(s_)}; }},
        {Cost::frames, [this] { return frame_edits(s_); }},
        {Cost::passive_slides, [this] { return Kinds{passive_slide_edits(s_)}; }},
        {Cost::like_axes, [this] { return Kinds{axes_of_like_closures(s_)}; }},
        {Cost::one_type, [this] { return Kinds{points_for_all_closures(s_)}; }},
        {Cost::like_others, [this] { return Kinds{is_known() ? Edits{} : those_of(elements(), true)}; }},
        {Cost::fitting_axes, [this] { return Kinds{is_known() ? Edits{} : axis_edits(s_, values())}; }},
        {Cost::platform_frame, [this] { return Kinds{platform_frame_edits(s_)}; }},
        {Cost::operational_point, [this] { return Kinds{points()}; }},
        {Cost::point_frame, [this] { return Kinds{point_frame_edits(s_)}; }},
        {Cost::frames_and_drives, [this] { return frames_and_drives(); }},
        {Cost::others, [this] { return may_be_elsewhere() ? Kinds{those_of(elements(), false)} : Kinds{}; }},
        {Cost::like_legs, [this] { return may_be_elsewhere() ? Kinds{motions_of_like_legs(s_)} : Kinds{}; }}};
  }

  Edits ends() const {
    Edits ends = end_place_edits(s_);
    append(ends, ends_paired_by_names(s_));
    return ends;
  }

  Edits points() { return is_assembled() ? operational_point_edits(s_) : Edits{}; }

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

  Kinds frames_and_drives() const {
    Kinds both;
    if (s_.resolved.actuation_origin.empty())
      for (const Edits& kind : frame_edits(s_)) both.push_back(with_actuation(s_, kind));
    return both;
  }

  // Where a chain was in no loop, an edit that puts it into one is preferred. Else the frame that a joint
  // leaves free may be put onto another link, or the joint be fixed: the latter changes less, since it leaves
  // the connections as they are.
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

  // The search for legs reports these.
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

  // Then lengths and axes are not at fault. Beside lengths in millimetres, those in metres count as zero.
  bool is_known() {
    if (!is_known_)
      is_known_ =
          (s_.size() <= widest_robot && has_zero_length() && has_mobility()) || closes_without_limits();
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
                    remedy->text() + "."}};
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
