// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/unit_corrections.h"

#include "model/number_text.h"
#include "urdf/corrections/correction_text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double out_of_scale = 30.0;   // of limits in mm against the robot in m, at least
constexpr double metres = 1e-3;         // in a millimetre
constexpr double widest_robot = 100.0;  // [m]; wider ones are taken for such in millimetres

std::string number(double value) { return number_text(value, 6); }

bool is_far(const JointLimits& limits, double size) {
  const double lower = std::abs(limits.lower), upper = std::abs(limits.upper);
  return std::isfinite(lower) && std::isfinite(upper) && std::max(lower, upper) > out_of_scale * size;
}

std::vector<std::size_t> slides_of_millimetres(const Tree& tree, const LoopJoints& loops, double size) {
  std::vector<std::size_t> slides;
  for (const std::size_t joint : loops.all())
    if (tree.joints[joint].motion == JointMotion::prismatic && is_far(tree.joints[joint].limits, size))
      slides.push_back(joint);
  return slides;
}

Correction metres_for_limits(const Tree& tree, const std::vector<std::size_t>& slides, double size,
                             const SourceNames& files) {
  std::string names, remedy;
  for (const std::size_t joint : slides) {
    const JointLimits& limits = tree.joints[joint].limits;
    names += (names.empty() ? "'" : ", '") + tree.joints[joint].name + "'";
    remedy += (remedy.empty() ? "write lower=\"" : " and write lower=\"") + number(metres * limits.lower) +
              "\" upper=\"" + number(metres * limits.upper) + "\" for joint '" + tree.joints[joint].name +
              "'";
  }
  return {"limits of " + names,
          files.urdf + " is " + number_text(size, 3) + " m wide, but has limits of slides, " + names +
              ", as if in millimetres",
          remedy, true, [slides](Tree& changed, ResolvedConfig&) {
            for (const std::size_t joint : slides) {
              JointLimits& limits = changed.joints[joint].limits;
              limits.lower *= metres;
              limits.upper *= metres;
            }
          }};
}

// The joint whose origin alone has a length, by name.
Correction metres_for_lengths(const Tree& tree, double size, const SourceNames& files) {
  std::vector<const TreeJoint*> lengths;
  for (const TreeJoint& joint : tree.joints)
    if (!joint.origin.translation().isZero(0.0)) lengths.push_back(&joint);
  const bool is_one = lengths.size() == 1;
  const std::string element = is_one ? "joint '" + lengths.front()->name + "'" : "lengths";
  return {element, files.urdf + " is " + number_text(size, 3) + " m wide, as if in millimetres",
          is_one ? "write xyz=\"" + as_attribute(metres * lengths.front()->origin.translation()) +
                       "\" in the origin of " + element
                 : "write a thousandth of each xyz in the origins of its joints",
          true, [](Tree& changed, ResolvedConfig&) {
            for (TreeJoint& joint : changed.joints) joint.origin.translation() *= metres;
          }};
}

}  // namespace

Corrections unit_corrections(const Tree& tree, const LoopJoints& loops, double size,
                             const SourceNames& files) {
  Corrections found;
  const std::vector<std::size_t> slides = slides_of_millimetres(tree, loops, size);
  if (!slides.empty()) found.push_back(metres_for_limits(tree, slides, size, files));
  if (size > widest_robot) found.push_back(metres_for_lengths(tree, size, files));
  return found;
}

std::vector<std::string> unit_notes(const Tree& tree, const LoopJoints& loops, double size,
                                    const SourceNames& files) {
  std::vector<std::string> notes;
  for (const Correction& correction : unit_corrections(tree, loops, size, files))
    notes.push_back(correction.fault + "; if so, " + correction.remedy + ".");
  return notes;
}

}  // namespace parallel_aspects
