// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/chain.h"
#include "urdf/description/messages.h"
#include "urdf/diagnosis/closure_gaps.h"
#include "urdf/mechanism_recognition.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <utility>

namespace parallel_aspects {
namespace {

using Contents = std::unique_ptr<Mechanism::Contents>;

// Of these all combinations of two types are tried, thirty at most, where so few joints move that an attempt
// takes some milliseconds.
constexpr std::size_t max_mixed_closures = 5;
constexpr std::ptrdiff_t max_joints_of_mixed = 24;

bool is_open(const Closure& closure) { return closure.type == ClosureType::automatic; }

bool any_open(const std::vector<Closure>& closures) {
  return std::any_of(closures.begin(), closures.end(), is_open);
}

bool all_welds(const std::vector<Closure>& closures) {
  return std::all_of(closures.begin(), closures.end(),
                     [](const Closure& closure) { return !is_open(closure) || closure.weld != Weld::none; });
}

// Some of the open closures points and some revolute joints, few revolute ones first; none where there are
// many.
std::vector<std::vector<Closure>> mixtures(const std::vector<Closure>& closures) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < closures.size(); ++k)
    if (is_open(closures[k])) open.push_back(k);
  if (open.size() > max_mixed_closures) return {};
  std::vector<std::bitset<max_mixed_closures>> choices;
  for (unsigned long choice = 1; choice + 1 < 1UL << open.size(); ++choice) choices.emplace_back(choice);
  std::stable_sort(choices.begin(), choices.end(),
                   [](const auto& one, const auto& other) { return one.count() < other.count(); });
  std::vector<std::vector<Closure>> result;
  for (const auto& choice : choices) {
    result.push_back(closures);
    for (std::size_t k = 0; k < open.size(); ++k)
      result.back()[open[k]].type = choice[k] ? ClosureType::revolute : ClosureType::point;
  }
  return result;
}

// "point ('a - b') and revolute ('c - d', 'e - f')", of the closures whose types were open.
Note listed_types(const std::vector<Closure>& open, const std::vector<Closure>& taken) {
  Note text;
  for (const ClosureType type : {ClosureType::point, ClosureType::revolute}) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < open.size(); ++k)
      if (is_open(open[k]) && taken[k].type == type) names.push_back(taken[k].name);
    if (names.empty()) continue;
    text +=
        (text.pieces().empty() ? "" : " and ") + std::string(name(type)) + " (" + listed_names(names) + ")";
  }
  return text;
}

constexpr std::size_t most_named = 6;  // joints of a refusal; of more it has the count

// Where a weld holds its second link in the first.
Eigen::Isometry3d offset(const Closure& weld) {
  return weld.frames[0].in_link * weld.frames[1].in_link.inverse();
}

bool has_offset(const Closure& closure, double size) {
  return closure.weld != Weld::none && offset(closure).translation().norm() > closing_tolerance * size;
}

// "'b' at xyz [1, 0, 0] m of 'a'", for each weld that does not hold two origins together.
std::string offsets(const std::vector<Closure>& closures, const Tree& tree, double size) {
  std::string text;
  for (const Closure& closure : closures) {
    if (!has_offset(closure, size)) continue;
    const Eigen::Vector3d at = offset(closure).translation();
    text += (text.empty() ? "'" : ", '") + tree.links[closure.frames[1].link] + "' at xyz [";
    for (const Eigen::Index k : {0, 1, 2})
      text += (k == 0 ? "" : ", ") + number_text(without_noise(at[k]), 4);
    text += "] m of '" + tree.links[closure.frames[0].link] + "'";
  }
  return text;
}

// What ends that are to meet may be apart, in sizes of the robot: more than rounding, less than a body is.
constexpr double least_gap_of_ends = 1e-4, most_gap_of_ends = 0.02;

// Whether a weld without a frame of its own holds a link that is there for it alone beside the origin that it
// may be drawn for.
bool holds_end_apart(const Closure& weld, const Tree& tree, double size) {
  const std::size_t end = weld.frames[1].link;
  const double gap = offset(weld).translation().norm() / size;
  const auto joint = tree.joint_above[end];
  return weld.weld == Weld::at_origins && gap > least_gap_of_ends && gap < most_gap_of_ends && joint &&
         tree.joints[*joint].motion == JointMotion::fixed && !has_child(tree, end);
}

// "'b' and 'a' by 1.5 mm", for each of these.
std::string gaps_of_ends(const std::vector<Closure>& welds, const Tree& tree, double size) {
  std::string text;
  for (const Closure& weld : welds)
    if (holds_end_apart(weld, tree, size))
      text += (text.empty() ? "'" : ", '") + tree.links[weld.frames[1].link] + "' and '" +
              tree.links[weld.frames[0].link] + "' by " +
              number_text(1e3 * offset(weld).translation().norm(), 3) + " mm";
  return text;
}

// With the origins of these together, turned as they are.
std::vector<Closure> with_ends_at_origins(std::vector<Closure> welds, const Tree& tree, double size) {
  for (Closure& weld : welds) {
    if (!holds_end_apart(weld, tree, size)) continue;
    Eigen::Isometry3d first = offset(weld);
    first.translation().setZero();
    weld.frames[0].in_link = first;
    weld.frames[1].in_link.setIdentity();
    weld.at_zero.reset();
    weld.weld = Weld::none;
  }
  return welds;
}

// Welds without a frame of their own, turned about the origin of that link which the tree has first, or last.
// So it does not matter which of the two is called the parent.
std::vector<Closure> turned_at(std::vector<Closure> closures, bool first) {
  for (Closure& closure : closures) {
    if (closure.weld != Weld::at_origins) continue;
    const Eigen::Isometry3d second_in_first = offset(closure);
    const bool at_second = (closure.frames[0].link < closure.frames[1].link) != first;
    closure.frames[0].in_link = at_second ? second_in_first : Eigen::Isometry3d::Identity();
    closure.frames[1].in_link = at_second ? Eigen::Isometry3d::Identity() : second_in_first.inverse();
  }
  return closures;
}

// The first of the choices that makes a manipulator; the problems are those of the first that does not.
class OpenChoices {
 public:
  OpenChoices(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
              const Recognise& recognise, const SourceNames& files)
      : tree_(tree), resolved_(resolved), recognise_(recognise), files_(files) {}

  Contents find(Problems& problems) const {
    const std::vector<Closure>& closures = resolved_.closures;
    if (!any_open(closures)) return recognise_(resolved_, problems);
    return all_welds(closures) ? find_welds(problems) : find_types(closures, problems);
  }

 private:
  Contents recognise(const std::vector<Closure>& closures, Problems& problems) const {
    ResolvedConfig chosen = resolved_;
    chosen.closures = closures;
    Problems found;
    Contents contents = recognise_(chosen, found);
    if (problems.empty()) problems = found;
    return contents;
  }

  Contents find_type(const std::vector<Closure>& closures, const std::vector<ClosureType>& types, Note& taken,
                     Problems& problems) const {
    for (const ClosureType type : types) {
      taken = std::string(name(type));
      if (Contents contents = recognise(with_type(closures, type), problems)) return contents;
    }
    if (joints_in_loops(closures) > max_joints_of_mixed) return nullptr;
    for (const std::vector<Closure>& mixed : mixtures(closures)) {
      taken = listed_types(closures, mixed);
      if (Contents contents = recognise(mixed, problems)) return contents;
    }
    return nullptr;
  }

  std::ptrdiff_t joints_in_loops(const std::vector<Closure>& closures) const {
    const ClosureSystem system(tree_, resolved_.base, with_type(closures, ClosureType::point));
    return std::count(system.in_loop().begin(), system.in_loop().end(), true);
  }

  Contents find_types(const std::vector<Closure>& closures, Problems& problems) const {
    Note taken;
    Contents contents = find_type(
        closures, {ClosureType::point, ClosureType::revolute, ClosureType::universal, ClosureType::fixed},
        taken, problems);
    if (contents)
      contents->notes.push_back(files_.config + " leaves the type of closures open; they are taken as " +
                                taken + ", under which the mobility is the number of actuated joints.");
    return contents;
  }

  // As they are written; where that holds too much, as joints that turn (for a universal one a weld has no
  // axes), at the stated place or at the one of two that makes a manipulator.
  Contents find_welds(Problems& problems) const {
    const std::vector<Closure>& welds = resolved_.closures;
    const double size = ClosureSystem(tree_, resolved_.base, with_type(welds, ClosureType::fixed)).size();
    const std::string apart = gaps_of_ends(welds, *tree_, size);
    const std::string held = offsets(welds, *tree_, size);
    const std::string where = held.empty() ? "" : ", with " + held;
    if (Contents contents = recognise(with_type(welds, ClosureType::fixed), problems)) {
      contents->notes.push_back("The rigid closures of " + files_.urdf +
                                " are taken as fixed, as they are written" +
                                (apart.empty() ? Note(where + ".") : note_of_gaps(welds, apart, size)));
      return contents;
    }
    return find_turning(size, where, problems);
  }

  // Where the robot is one with these ends together, too, that may be meant.
  Note note_of_gaps(const std::vector<Closure>& welds, const std::string& apart, double size) const {
    const std::vector<Closure> meeting =
        with_type(with_ends_at_origins(welds, *tree_, size), ClosureType::fixed);
    Problems ignored;
    const bool may_meet = recognise(meeting, ignored) != nullptr;
    return ", which holds ends apart as they are drawn while all joints are zero: " + apart +
           "; if they are to meet, " +
           (may_meet ? "write " + closures_entry(*tree_, meeting, files_)
                     : Note("correct the origins of their joints")) +
           ".";
  }

  Contents find_turning(double size, const std::string& where, Problems& problems) const {
    std::array<Contents, 2> found;
    std::array<Note, 2> taken;
    std::array<std::vector<Closure>, 2> closures;
    for (const std::size_t end : {0, 1}) {
      closures[end] = turned_at(resolved_.closures, end == 0);
      found[end] =
          find_type(closures[end], {ClosureType::point, ClosureType::revolute}, taken[end], problems);
      if (!any_end_open(size)) break;
    }
    if (found[0] && found[1]) return refuse_both(size, problems);
    const std::size_t end = found[0] ? 0 : 1;
    if (found[end])
      found[end]->notes.push_back("The rigid closures of " + files_.urdf + " would hold the robot still" +
                                  where + "; they are taken as " + taken[end] + places(closures[end], size) +
                                  ", under which the mobility is the number of actuated joints.");
    return std::move(found[end]);
  }

  bool is_end_open(const Closure& closure, double size) const {
    return closure.weld == Weld::at_origins && has_offset(closure, size);
  }

  bool any_end_open(double size) const {
    return std::any_of(resolved_.closures.begin(), resolved_.closures.end(),
                       [&](const Closure& closure) { return is_end_open(closure, size); });
  }

  // " at the origin of 'a', 'b'" of welds that hold two origins apart.
  Note places(const std::vector<Closure>& closures, double size) const {
    std::vector<std::string> links;
    for (const Closure& closure : closures) {
      if (!is_end_open(closure, size)) continue;
      const bool at_first = closure.frames[0].in_link.translation().isZero(0.0);
      links.push_back(tree_->links[closure.frames[at_first ? 0 : 1].link]);
    }
    return links.empty() ? Note() : " at the origin of " + listed_names(links);
  }

  // With the first of the two origins, as the YAML has it.
  std::nullptr_t refuse_both(double size, Problems& problems) const {
    problems = {files_.urdf + " holds " + offsets(resolved_.closures, *tree_, size) +
                ", and is a manipulator with a joint at either origin; say which is meant, as by " +
                closures_entry(*tree_, turned_at(resolved_.closures, true), files_).text() + "."};
    return nullptr;
  }

  const std::shared_ptr<const Tree>& tree_;
  const ResolvedConfig& resolved_;
  const Recognise& recognise_;
  const SourceNames& files_;
};

std::string joint_list(const Tree& tree, const std::vector<std::size_t>& variables) {
  std::string text;
  for (const std::size_t variable : variables)
    text += (text.empty() ? "[" : ", ") + tree.joint_of(variable).name;
  return text + "]";
}

Note quoted_joints(const Tree& tree, const std::vector<std::size_t>& variables) {
  std::vector<std::string> names;
  for (const std::size_t variable : variables) names.push_back(tree.joint_of(variable).name);
  return listed_names(names);
}

using Choice = std::vector<std::size_t>;

bool is_part_of_any(const Choice& choice, const std::vector<Choice>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Choice& other) {
    return std::all_of(choice.begin(), choice.end(), [&](std::size_t joint) {
      return std::find(other.begin(), other.end(), joint) != other.end();
    });
  });
}

// Which of the joints that the description calls actuated are so.
class OpenActuation {
 public:
  OpenActuation(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                const Recognise& recognise, const SourceNames& files)
      : tree_(tree), resolved_(resolved), recognise_(recognise), files_(files) {}

  Contents find(Problems& problems) {
    const Choice& described = resolved_.actuated_joints.variables;
    const bool may_be_all = is_actuation_count(described.size());
    Contents all = may_be_all ? recognise(described, problems) : nullptr;
    if (resolved_.actuation_origin.empty()) {
      if (!may_be_all) problems = {wrong_number()};
      return all;
    }
    if (!all) return find_some(may_be_all, problems);
    all->notes.push_back("The actuated joints are those that " + resolved_.actuation_origin + ": " +
                         quoted_joints(*tree_, described) + ".");
    return all;
  }

 private:
  Contents find_some(bool may_be_all, Problems& problems) {
    const ClosureSystem system(tree_, resolved_.base, with_type(resolved_.closures, ClosureType::point));
    try_all(actuation_choices(system, resolved_.actuated_joints, files_));
    if (working_.size() != 1) {
      if (!may_be_all || !working_.empty()) problems = {refusal()};
      return nullptr;
    }
    found_->notes.push_back("Of the joints that " + resolved_.actuation_origin +
                            ", those are taken as actuated under which the mobility is their number: " +
                            quoted_joints(*tree_, working_.front()) + ".");
    return std::move(found_);
  }

  Contents recognise(const Choice& choice, Problems& problems) const {
    ResolvedConfig chosen = resolved_;
    chosen.actuated_joints.variables = choice;
    return OpenChoices(tree_, chosen, recognise_, files_).find(problems);
  }

  void try_all(const std::vector<Choice>& choices) {
    for (const Choice& choice : choices) {
      Problems unused;
      if (is_part_of_any(choice, working_)) continue;
      if (Contents contents = recognise(choice, unused)) {
        working_.push_back(choice);
        found_ = std::move(contents);
      }
    }
  }

  std::string wrong_number() const {
    return files_.config + " lists " + std::to_string(resolved_.actuated_joints.variables.size()) +
           " joints in " + files_.full_key("actuated_joints") +
           "; a fully parallel robot in T1 has one actuated joint, in T2 two, in SE2, T3 or SO3 three, in "
           "SE3 six.";
  }

  std::string refusal() const {
    const Choice& described = resolved_.actuated_joints.variables;
    std::string fitting;
    for (const Choice& choice : working_)
      fitting += (fitting.empty() ? "" : " and ") + joint_list(*tree_, choice);
    return files_.config + " does not say " + files_.full_key("actuated_joints") + ", and " +
           std::to_string(described.size()) + " joints " + resolved_.actuation_origin +
           (described.size() > most_named ? "" : ", " + quoted_joints(*tree_, described).text()) + "; " +
           (working_.empty() ? "no choice of one, two, three or six of them was found to make a manipulator"
                             : "the mobility fits " + fitting) +
           ", so list those that are actuated.";
  }

  const std::shared_ptr<const Tree>& tree_;
  const ResolvedConfig& resolved_;
  const Recognise& recognise_;
  const SourceNames& files_;
  std::vector<Choice> working_;
  Contents found_;
};

}  // namespace

Contents recognise_open(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                        const Recognise& recognise, const SourceNames& files, Problems& problems) {
  return OpenActuation(tree, resolved, recognise, files).find(problems);
}

}  // namespace parallel_aspects
