// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/listed_corrections.h"

#include "urdf/closing/actuation_choices.h"
#include "urdf/closing/assembly.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

using Choice = std::vector<std::size_t>;

bool has_variable(const Choice& choice, std::size_t variable) {
  return std::find(choice.begin(), choice.end(), variable) != choice.end();
}

bool are_same(const LinkFrame& one, const LinkFrame& other) {
  return one.link == other.link && one.in_link.isApprox(other.in_link, rank_tolerance);
}

bool are_same(const Closure& one, const Closure& other) {
  const auto &a = one.frames, &b = other.frames;
  return (are_same(a[0], b[0]) && are_same(a[1], b[1])) || (are_same(a[0], b[1]) && are_same(a[1], b[0]));
}

// As an attribute of the elements of a URDF, whose words differ.
bool has_attributes(const ResolvedConfig& resolved) {
  return resolved.closure_dialect == "<gazebo><joint>" || resolved.closure_dialect == "<loop_joint>" ||
         resolved.closure_dialect == "<constraint>";
}

std::string type_word(const ResolvedConfig& resolved, ClosureType type) {
  const bool is_constraint = resolved.closure_dialect == "<constraint>";
  std::string word(name(type));
  if (has_attributes(resolved) && type == ClosureType::point)
    word = resolved.closure_dialect == "<gazebo><joint>" ? "ball" : "spherical";
  return is_constraint ? word + "_joint" : word;
}

class ClosureCorrections {
 public:
  ClosureCorrections(const ResolvedConfig& resolved, const SourceNames& files)
      : resolved_(resolved), closures_(resolved.closures), file_(file_of_closures(resolved, files)) {}

  Corrections find() {
    for (std::size_t k = 0; k < closures_.size(); ++k)
      for (std::size_t other = 0; other < k; ++other)
        if (are_same(closures_[k], closures_[other])) add_without(k);
    for (std::size_t k = 0; k < closures_.size(); ++k)
      if (closures_[k].type != ClosureType::automatic)
        for (const ClosureType type : {ClosureType::point, ClosureType::revolute, ClosureType::universal})
          if (type != closures_[k].type) add_type(k, type);
    std::stable_partition(found_.begin(), found_.end(),
                          [](const Correction& correction) { return correction.like_others; });
    return std::move(found_);
  }

 private:
  void add_without(std::size_t index) {
    const std::string element = "closure '" + closures_[index].name + "'";
    found_.push_back({element, file_ + " has " + element + " twice", "leave out one entry of " + element,
                      true, [index](Tree&, ResolvedConfig& resolved) {
                        resolved.closures.erase(resolved.closures.begin() +
                                                static_cast<std::ptrdiff_t>(index));
                      }});
  }

  void add_type(std::size_t index, ClosureType type) {
    const Closure& closure = closures_[index];
    const auto count = [this](ClosureType wanted) {
      return std::count_if(closures_.begin(), closures_.end(),
                           [&](const Closure& other) { return other.type == wanted; });
    };
    const std::string element = "closure '" + closure.name + "'";
    const bool have_others = count(closure.type) == 1 && count(type) > 1;
    const bool like_others =
        have_others || closure.type == ClosureType::fixed;  // which makes one link of two
    found_.push_back(
        {element,
         file_ + " has type " + written(closure.type) + " for " + element +
             (have_others ? ", where others have type " + written(type) : ""),
         "write " + type_text(resolved_, type) + " for " + element, like_others,
         [index, type](Tree&, ResolvedConfig& resolved) { resolved.closures[index].type = type; }});
  }

  std::string written(ClosureType type) const { return type_word(resolved_, type); }

  const ResolvedConfig& resolved_;
  const std::vector<Closure>& closures_;
  const std::string& file_;
  Corrections found_;
};

// Ends of closures that are exchanged: those of two, and those of two legs with two closures each.
class ExchangedEnds {
 public:
  ExchangedEnds(const Tree& tree, const ResolvedConfig& resolved, const SourceNames& files,
                bool with_places_at_zero)
      : tree_(tree),
        resolved_(resolved),
        closures_(resolved.closures),
        files_(files),
        with_places_at_zero_(with_places_at_zero) {}

  Corrections find() {
    for (std::size_t k = 0; k < closures_.size(); ++k)
      for (std::size_t other = 0; other < k; ++other)
        if (may_exchange(k, other)) add({{other, k}});
    if (closures_.size() > max_in_two_legs) return std::move(found_);
    const std::size_t single = found_.size();
    for (std::size_t k = 0; k < single; ++k)
      for (std::size_t other = 0; other < k; ++other)
        if (are_apart(pairs_[k], pairs_[other])) add({pairs_[other], pairs_[k]});
    return std::move(found_);
  }

 private:
  using Pair = std::array<std::size_t, 2>;

  static bool are_apart(const Pair& one, const Pair& other) {
    return one[0] != other[0] && one[0] != other[1] && one[1] != other[0] && one[1] != other[1];
  }

  bool is_link(std::size_t closure) const {
    return closures_[closure].frames[1].in_link.isApprox(Eigen::Isometry3d::Identity());
  }

  bool may_exchange(std::size_t one, std::size_t other) const {
    if (is_link(one) && is_link(other)) return end_of(one) != end_of(other);
    const bool any_at_zero = closures_[one].at_zero || closures_[other].at_zero;
    return !are_same(closures_[one].frames[1], closures_[other].frames[1]) &&
           (with_places_at_zero_ || !any_at_zero);
  }

  void add(const std::vector<Pair>& pairs) {
    std::string names, remedy;
    for (const Pair& pair : pairs)
      for (const std::size_t k : pair) {
        const std::size_t other = k == pair[0] ? pair[1] : pair[0];
        const std::string name = "closure '" + closures_[k].name + "'";
        names += (names.empty() ? "" : ", ") + name;
        remedy += (remedy.empty() ? "write link '" : " and write link '") + end_of(other) +
                  "' in the place of '" + end_of(k) + "' in " + name;
      }
    if (resolved_.closure_dialect == "closing frames") {  // which are their names
      remedy.clear();
      for (const Pair& pair : pairs)
        remedy += (remedy.empty() ? "exchange the names of links '" : " and of '") + end_of(pair[0]) +
                  "' and '" + end_of(pair[1]) + "'";
    }
    if (std::any_of(pairs.begin(), pairs.end(),
                    [this](const Pair& pair) { return !is_link(pair[0]) || !is_link(pair[1]); }))
      remedy = exchange_of_places(pairs);
    if (pairs.size() == 1) pairs_.push_back(pairs.front());
    found_.push_back({names, file_of_closures(resolved_, files_) + " has the ends of " + names + " crossed",
                      remedy, false, [pairs](Tree&, ResolvedConfig& resolved) {
                        for (const Pair& pair : pairs)
                          std::swap(resolved.closures[pair[0]].frames[1],
                                    resolved.closures[pair[1]].frames[1]);
                      }});
  }

  // What is written of them differs from one dialect to the other.
  std::string exchange_of_places(const std::vector<Pair>& pairs) const {
    std::string remedy;
    for (const Pair& pair : pairs)
      remedy += (remedy.empty() ? "exchange the second ends of closure '" : " and of closure '") +
                closures_[pair[0]].name + "' and closure '" + closures_[pair[1]].name + "'";
    return remedy;
  }

  const std::string& end_of(std::size_t closure) const {
    return tree_.links[closures_[closure].frames[1].link];
  }

  static constexpr std::size_t max_in_two_legs = 6;

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  const std::vector<Closure>& closures_;
  const SourceNames& files_;
  bool with_places_at_zero_;
  std::vector<Pair> pairs_;
  Corrections found_;
};

class ActuationCorrections {
 public:
  ActuationCorrections(const Tree& tree, const ResolvedConfig& resolved, const ClosureSystem& system,
                       const SourceNames& files)
      : tree_(tree),
        listed_(resolved.actuated_joints.variables),
        legs_(joints_by_leg(system, resolved.actuated_joints, files)),
        files_(files) {
    std::map<std::size_t, std::size_t> counts;
    for (const auto& leg : legs_)
      for (const LegJoint& joint : leg)
        if (has_variable(listed_, joint.variable)) ++counts[joint.depth];
    for (const auto& [depth, count] : counts)
      if (count > counts[usual_depth_]) usual_depth_ = depth;
  }

  Corrections find() {
    if (!is_actuation_count(listed_.size())) add_one_of_each_leg();
    for (const auto& leg : legs_) {
      const std::vector<LegJoint> listed = listed_of(leg);
      if (listed.empty()) add_one_of(leg);
      if (listed.size() == 1) exchange(listed.front(), leg);
      if (listed.size() > 1) remove_one_of(listed);
    }
    std::stable_partition(found_.begin(), found_.end(),
                          [](const Correction& correction) { return correction.like_others; });
    return std::move(found_);
  }

 private:
  std::vector<LegJoint> listed_of(const std::vector<LegJoint>& leg) const {
    std::vector<LegJoint> listed;
    for (const LegJoint& joint : leg)
      if (has_variable(listed_, joint.variable)) listed.push_back(joint);
    return listed;
  }

  // Those of the listed ones that are where most are.
  void add_one_of_each_leg() {
    Choice choice;
    for (const std::size_t variable : listed_)
      for (const auto& leg : legs_)
        for (const LegJoint& joint : leg)
          if (joint.variable == variable && joint.depth == usual_depth_) choice.push_back(variable);
    if (choice.size() < listed_.size()) add(choice, "lists several joints of a leg", true);
  }

  void add_one_of(const std::vector<LegJoint>& leg) {
    for (const LegJoint& joint : leg)
      add(with(listed_, joint.variable), "does not list joint '" + name_of(joint) + "'",
          joint.depth == usual_depth_);
  }

  // For the joint where others have theirs.
  void exchange(const LegJoint& listed, const std::vector<LegJoint>& leg) {
    if (listed.depth == usual_depth_) return;
    for (const LegJoint& joint : leg) {
      if (joint.depth != usual_depth_) continue;
      Choice choice = listed_;
      *std::find(choice.begin(), choice.end(), listed.variable) = joint.variable;
      add(choice,
          "lists joint '" + name_of(listed) + "', where other legs have the one of '" + name_of(joint) + "'",
          true);
    }
  }

  // Another leg may have none.
  void remove_one_of(const std::vector<LegJoint>& leg) {
    for (const LegJoint& joint : leg) {
      Choice fewer = listed_;
      fewer.erase(std::find(fewer.begin(), fewer.end(), joint.variable));
      const std::string fault = "lists joint '" + name_of(joint) + "' besides another one of its leg";
      const bool stands_out = joint.depth != usual_depth_;
      add(fewer, fault, stands_out);
      for (const auto& other : legs_)
        if (listed_of(other).empty())
          for (const LegJoint& added : other)
            add(with(fewer, added.variable), fault + ", and none of the leg of '" + name_of(added) + "'",
                stands_out && added.depth == usual_depth_);
    }
  }

  // In the order of the file, where the others are.
  static Choice with(Choice choice, std::size_t variable) {
    const bool in_order = std::is_sorted(choice.begin(), choice.end());
    const auto place = std::upper_bound(choice.begin(), choice.end(), variable);
    choice.insert(in_order ? place : choice.end(), variable);
    return choice;
  }

  std::string name_of(const LegJoint& joint) const { return tree_.joint_of(joint.variable).name; }

  void add(const Choice& choice, const std::string& fault, bool like_others) {
    if (std::any_of(choice.begin(), choice.end(),
                    [this](std::size_t variable) { return tree_.joint_of(variable).mimics; }))
      return;
    std::vector<std::string> names;
    for (const std::size_t variable : choice) names.push_back(tree_.joint_of(variable).name);
    const std::string remedy = "write " + files_.entry("actuated_joints", names);
    found_.push_back(
        {like_others ? "actuated_joints" : remedy,
         files_.config + " " + fault + " in " + files_.key("actuated_joints"), remedy, like_others,
         [choice](Tree&, ResolvedConfig& resolved) { resolved.actuated_joints.variables = choice; }});
  }

  const Tree& tree_;
  const Choice& listed_;
  std::vector<std::vector<LegJoint>> legs_;
  const SourceNames& files_;
  std::size_t usual_depth_ = 0;  // of the actuated joints in their legs
  Corrections found_;
};

}  // namespace

Corrections closure_corrections(const ResolvedConfig& resolved, const SourceNames& files) {
  return ClosureCorrections(resolved, files).find();
}

std::string type_text(const ResolvedConfig& resolved, ClosureType type) {
  return has_attributes(resolved) ? "type=\"" + type_word(resolved, type) + "\""
                                  : "type: " + type_word(resolved, type);
}

Corrections exchanged_ends(const Tree& tree, const ResolvedConfig& resolved, const SourceNames& files,
                           bool with_places_at_zero) {
  return ExchangedEnds(tree, resolved, files, with_places_at_zero).find();
}

Corrections actuation_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                  const ClosureSystem& system, const SourceNames& files) {
  return ActuationCorrections(tree, resolved, system, files).find();
}

}  // namespace parallel_aspects
