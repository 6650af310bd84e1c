// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/roadmap_location.h"

#include "aspects/roadmap/roadmap_growth.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

// Places in the list of the side's poses, nearest first.
std::vector<std::uint32_t> nearest(const PoseRoadmap& roadmap, const RoadmapSide& side, const Pose& pose,
                                   std::size_t count) {
  const Manipulator& manipulator = *roadmap.certifier().manipulator();
  const AnchorPoint point = anchor_point(manipulator, pose);
  std::vector<std::pair<double, std::uint32_t>> found;
  for (std::uint32_t i = 0; i < side.poses.size(); ++i) {
    const AnchorPoint other = anchor_point(manipulator, roadmap.poses()[side.poses[i]]);
    found.emplace_back((other - point).squaredNorm(), i);
  }
  count = std::min(count, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back(found[i].second);
  return places;
}

}  // namespace

RoadmapLocation locate(const PoseRoadmap& roadmap, const Pose& pose, const WorkingMode& mode,
                       const LocationBudget& budget) {
  const SegmentCertifier& certifier = roadmap.certifier();
  RoadmapLocation location;
  location.determinant_sign = certifier.prove(pose, mode).sign;
  const RoadmapSide* side = roadmap.side(mode, location.determinant_sign);
  if (side == nullptr) return location;
  for (const std::uint32_t place : nearest(roadmap, *side, pose, budget.samples)) {
    const Pose& sample = roadmap.poses()[side->poses[place]];
    if (certifier.prove(pose, sample, mode, budget.parts).verdict != SegmentVerdict::free) continue;
    location.component = side->component[place];
    return location;
  }
  return location;
}

}  // namespace parallel_aspects
