// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/same_aspect.h"

#include "aspects/roadmap/path_search.h"
#include "aspects/roadmap/violation_text.h"

#include <utility>

namespace parallel_aspects {
namespace {

/// Whether `proof` answers the question already; so it does where the configuration lies in no aspect.
bool is_answered(const Manipulator& manipulator, const PoseInMode& at, const ConfigurationProof& proof,
                 const std::string& which, AspectComparison& comparison) {
  if (proof.sign != 0) return false;
  const bool proved = proof.proved_violation != Violation::none;
  comparison.answer = proved ? SameAspect::no : SameAspect::unknown;
  comparison.message =
      proved ? "The " + which +
                   " configuration lies in no aspect: " + violation_text(manipulator, at, proof) + "."
             : "The " + which + " configuration is too close to a singularity or a limit to be determined.";
  comparison.failing = proof.failing;
  return true;
}

AspectComparison no(const std::string& why) { return {SameAspect::no, why, {}, 0}; }

AspectComparison yes(std::vector<Pose> path) {
  const std::string segments =
      path.size() == 2 ? "The segment between them is" : "Every segment of the path is";
  return {SameAspect::yes, segments + " proved free of singularities.", std::move(path), 0};
}

std::string signs_text(int first, int second) {
  const auto text = [](int sign) { return std::string(sign > 0 ? "+" : "-"); };
  return text(first) + " and " + text(second);
}

}  // namespace

AspectComparison same_aspect(const SegmentCertifier& certifier, const PoseInMode& first,
                             const PoseInMode& second) {
  const ConfigurationProof start = certifier.prove(first.pose, first.mode);
  const ConfigurationProof end = certifier.prove(second.pose, second.mode);
  AspectComparison comparison;
  const Manipulator& manipulator = *certifier.manipulator();
  if (is_answered(manipulator, first, start, "first", comparison) ||
      is_answered(manipulator, second, end, "second", comparison))
    return comparison;
  if (first.mode != second.mode) return no("They are in different working modes.");
  if (start.sign != end.sign) return no("det A differs in sign, " + signs_text(start.sign, end.sign) + ".");
  if (certifier.prove(first.pose, second.pose, first.mode).verdict == SegmentVerdict::free)
    return yes({first.pose, second.pose});
  comparison.message =
      "The segment between them is not free, or not proved to be; there may be a path around.";
  comparison.searched_sign = start.sign;
  return comparison;
}

AspectComparison same_aspect(const PoseRoadmap& roadmap, const PoseInMode& first, const PoseInMode& second,
                             SearchEffort effort) {
  AspectComparison comparison = same_aspect(roadmap.certifier(), first, second);
  if (comparison.searched_sign == 0) return comparison;
  auto path = PathSearch(roadmap, first.mode, comparison.searched_sign).find(first.pose, second.pose, effort);
  if (!path.empty()) return yes(std::move(path));
  comparison.message = "No path was found, which proves nothing; more samples may find one.";
  return comparison;
}

const char* name(SameAspect answer) noexcept {
  switch (answer) {
    case SameAspect::yes:
      return "yes";
    case SameAspect::no:
      return "no";
    case SameAspect::unknown:
      break;
  }
  return "unknown";
}

}  // namespace parallel_aspects
