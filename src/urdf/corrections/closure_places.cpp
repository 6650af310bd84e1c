// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/closure_places.h"

#include "urdf/closing/assembly.h"
#include "urdf/corrections/correction_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

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

}  // namespace parallel_aspects
