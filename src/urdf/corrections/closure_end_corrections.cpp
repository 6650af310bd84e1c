// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/closure_end_corrections.h"

#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction.h"
#include "urdf/corrections/legs_of_tree.h"
#include "urdf/description/name_words.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double far_out_of_scale = 30.0;  // of a place in mm against the lengths in m, at least
constexpr double metres_of_millimetre = 1e-3;

// An end of a closure that its description gives by coordinates.
struct PlacedEnd {
  std::size_t closure = 0, end = 0;
  Vector3d place;  // in its link
};

// Where the first end follows from the second, that alone is written.
std::vector<PlacedEnd> placed_ends(const std::vector<Closure>& closures) {
  std::vector<PlacedEnd> ends;
  for (std::size_t k = 0; k < closures.size(); ++k)
    for (const std::size_t end : {0, 1}) {
      const Vector3d place = closures[k].frames[end].in_link.translation();
      if (!(closures[k].at_zero && end == 0) && !place.isZero(0.0)) ends.push_back({k, end, place});
    }
  return ends;
}

// How the description says it.
std::string written(const ResolvedConfig& resolved, const Vector3d& place) {
  if (resolved.closure_dialect.empty()) return "xyz: " + as_list(place);
  if (resolved.closure_dialect == "<gazebo><joint>") return "<pose> starting with " + as_attribute(place);
  return (resolved.closure_dialect == "<drake:ball_constraint>" ? "value=\"" : "xyz=\"") +
         as_attribute(place) + "\"";
}

std::string element_of(const ResolvedConfig& resolved, const PlacedEnd& end) {
  return "closure '" + resolved.closures[end.closure].name + "'";
}

std::string remedy_of(const Tree& tree, const ResolvedConfig& resolved, const PlacedEnd& end,
                      const Vector3d& place) {
  return "write " + written(resolved, place) + " in link '" +
         tree.links[resolved.closures[end.closure].frames[end.end].link] + "' of " +
         element_of(resolved, end);
}

std::string fault_of(const Tree& tree, const ResolvedConfig& resolved, const PlacedEnd& end) {
  return "puts the end of " + element_of(resolved, end) + " in link '" +
         tree.links[resolved.closures[end.closure].frames[end.end].link] + "' at " + in_brackets(end.place) +
         " m";
}

double usual_length(const Tree& tree, const LoopJoints& loops) {
  std::vector<double> lengths;
  for (const std::size_t joint : loops.all())
    if (const double length = tree.joints[joint].origin.translation().norm(); length > 0.0)
      lengths.push_back(length);
  if (lengths.empty()) return 0.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

Corrections closure_unit_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                     const LoopJoints& loops, const SourceNames& files) {
  const double usual = usual_length(tree, loops);
  std::vector<PlacedEnd> far;
  for (const PlacedEnd& end : placed_ends(resolved.closures))
    if (usual > 0.0 && end.place.norm() > far_out_of_scale * usual) far.push_back(end);
  if (far.empty()) return {};
  std::string fault, remedy;
  for (const PlacedEnd& end : far) {
    fault += (fault.empty() ? "" : " and ") + fault_of(tree, resolved, end);
    remedy +=
        (remedy.empty() ? "" : " and ") + remedy_of(tree, resolved, end, metres_of_millimetre * end.place);
  }
  return {{far.size() == 1 ? element_of(resolved, far.front()) : "places of closures",
           file_of_closures(resolved, files) + " " + fault + ", as if in millimetres", remedy, true,
           [far](Tree&, ResolvedConfig& changed) {
             for (const PlacedEnd& end : far)
               changed.closures[end.closure].frames[end.end].in_link.translation() *= metres_of_millimetre;
           }}};
}

Corrections closure_place_corrections(const Tree& tree, const ResolvedConfig& resolved,
                                      const std::vector<std::size_t>& closures, const SourceNames& files) {
  Corrections found;
  for (const PlacedEnd& end : placed_ends(resolved.closures)) {
    if (std::count(closures.begin(), closures.end(), end.closure) == 0) continue;
    const auto add = [&](const Vector3d& place) {
      if ((place - end.place).norm() <= rank_tolerance * end.place.norm()) return;
      found.push_back(
          {element_of(resolved, end), file_of_closures(resolved, files) + " " + fault_of(tree, resolved, end),
           remedy_of(tree, resolved, end, place), false, [end, place](Tree&, ResolvedConfig& changed) {
             changed.closures[end.closure].frames[end.end].in_link.translation() = place;
           }});
    };
    for (Eigen::Index k = 0; k < 3; ++k) {
      Vector3d mirrored = end.place, exchanged = end.place;
      mirrored[k] = -mirrored[k];
      std::swap(exchanged[k], exchanged[(k + 1) % 3]);
      add(mirrored);
      add(exchanged);
    }
  }
  return found;
}

std::string place_remedy(const Tree& tree, const ResolvedConfig& resolved, std::size_t closure,
                         const Vector3d& place) {
  return remedy_of(tree, resolved, {closure, 1, place}, place);
}

namespace {

using Names = std::vector<std::string>;

constexpr int least_likeness = 3;  // of two ends that share a number, a letter or a word that counts legs

// A closure that holds a leg to the platform.
struct HeldLeg {
  std::size_t closure = 0;
  std::size_t anchor = 0;  // which of its frames is on the platform
};

bool are_distinct(const Names& names) {
  return std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

class NamedEnds {
 public:
  NamedEnds(const Tree& tree, const ResolvedConfig& resolved) : tree_(tree), resolved_(resolved) {
    const std::size_t platform = body_of(tree, resolved.actuated_joints.platform_link);
    for (std::size_t k = 0; k < resolved.closures.size(); ++k) {
      const auto& frames = resolved.closures[k].frames;
      const bool first = body_of(tree, frames[0].link) == platform;
      if (first != (body_of(tree, frames[1].link) == platform)) legs_.push_back({k, first ? 0U : 1U});
    }
  }

  const std::vector<HeldLeg>& legs() const { return legs_; }

  // Of each leg, the one that has its anchor by the names that tell first; nothing where none do.
  std::vector<std::size_t> pairing() const {
    if (legs_.size() < 2) return {};
    for (const Names& tips : tip_names())
      for (const Names& anchors : anchor_names()) {
        std::vector<std::size_t> pairs = paired(tips, anchors);
        if (!pairs.empty()) return pairs;
      }
    return {};
  }

 private:
  std::size_t link_of(const HeldLeg& leg, bool anchor) const {
    return resolved_.closures[leg.closure].frames[anchor ? leg.anchor : 1 - leg.anchor].link;
  }

  template <class Name>
  Names names_by(Name name) const {
    Names names;
    for (const HeldLeg& leg : legs_) names.push_back(name(leg));
    return names;
  }

  // Those that closures in a list call their ends by, too.
  std::string end_name(const HeldLeg& leg, bool anchor) const {
    const std::string& both = resolved_.closures[leg.closure].name;
    const std::size_t middle = both.find(" - ");
    if (!resolved_.closure_dialect.empty() || middle == std::string::npos)
      return tree_.links[link_of(leg, anchor)];
    return anchor == (leg.anchor == 0) ? both.substr(0, middle) : both.substr(middle + 3);
  }

  std::string joint_above(std::size_t link) const {
    const auto joint = tree_.joint_above[link];
    return joint ? tree_.joints[*joint].name : tree_.links[link];
  }

  // The link that the first joint of the chain carries.
  std::size_t start_of_chain(std::size_t link) const {
    const std::size_t base = body_of(tree_, resolved_.base);
    for (auto joint = tree_.joint_above[link]; joint && body_of(tree_, tree_.joints[*joint].parent) != base;
         joint = tree_.joint_above[link])
      link = tree_.joints[*joint].parent;
    return link;
  }

  // The names of the ends themselves come first.
  std::vector<Names> tip_names() const {
    return {
        names_by([this](const HeldLeg& leg) { return end_name(leg, false); }),
        names_by([this](const HeldLeg& leg) { return tree_.links[body_of(tree_, link_of(leg, false))]; }),
        names_by([this](const HeldLeg& leg) { return joint_above(body_of(tree_, link_of(leg, false))); }),
        names_by([this](const HeldLeg& leg) { return joint_above(start_of_chain(link_of(leg, false))); })};
  }

  std::vector<Names> anchor_names() const {
    return {names_by([this](const HeldLeg& leg) { return end_name(leg, true); }),
            names_by([this](const HeldLeg& leg) { return joint_above(link_of(leg, true)); })};
  }

  // Each with that which is most like it, either way round.
  static std::vector<std::size_t> paired(const Names& tips, const Names& anchors) {
    if (!are_distinct(tips) || !are_distinct(anchors)) return {};
    const std::size_t count = tips.size();
    Tree named;
    named.links = tips;
    named.links.insert(named.links.end(), anchors.begin(), anchors.end());
    std::vector<std::size_t> ends(2 * count);
    for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = k;
    const auto middle = ends.begin() + static_cast<std::ptrdiff_t>(count);
    const EndLikeness likeness(named, {ends.begin(), middle}, {middle, ends.end()});
    std::vector<std::size_t> pairs;
    for (std::size_t tip = 0; tip < count; ++tip) {
      const auto anchor = likest(count, [&](std::size_t k) { return likeness.between(tip, count + k); });
      if (!anchor) return {};
      const auto back = likest(count, [&](std::size_t k) { return likeness.between(k, count + *anchor); });
      if (back != tip) return {};
      pairs.push_back(*anchor);
    }
    return pairs;
  }

  // Nothing where two are as like.
  template <class Likeness>
  static std::optional<std::size_t> likest(std::size_t count, Likeness likeness) {
    std::optional<std::size_t> best;
    int most = least_likeness - 1;
    for (std::size_t k = 0; k < count; ++k) {
      const int value = likeness(k);
      if (value == most) best.reset();
      if (value > most) best = k;
      most = std::max(most, value);
    }
    return best;
  }

  const Tree& tree_;
  const ResolvedConfig& resolved_;
  std::vector<HeldLeg> legs_;
};

}  // namespace

std::optional<Correction> ends_paired_by_names(const Tree& tree, const ResolvedConfig& resolved,
                                               const SourceNames& files) {
  const NamedEnds named(tree, resolved);
  const std::vector<std::size_t> pairing = named.pairing();
  std::vector<Closure> paired = resolved.closures;
  std::string names, remedy;
  for (std::size_t k = 0; k < pairing.size(); ++k) {
    if (pairing[k] == k) continue;
    const auto& [closure, end] = named.legs()[k];
    const auto& [other, other_end] = named.legs()[pairing[k]];
    const LinkFrame& frame = resolved.closures[other].frames[other_end];
    paired[closure].frames[end] = frame;
    const std::string element = "closure '" + resolved.closures[closure].name + "'";
    names += (names.empty() ? "" : ", ") + element;
    remedy += (remedy.empty() ? "write link '" : " and write link '") + tree.links[frame.link] +
              "' in the place of '" + tree.links[resolved.closures[closure].frames[end].link] + "' in " +
              element;
  }
  if (names.empty()) return std::nullopt;
  return Correction{names, file_of_closures(resolved, files) + " has the ends of " + names + " crossed",
                    remedy, true, [paired](Tree&, ResolvedConfig& changed) { changed.closures = paired; }};
}

}  // namespace parallel_aspects
