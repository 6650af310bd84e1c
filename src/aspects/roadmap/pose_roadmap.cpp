// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/pose_roadmap.h"

#include "aspects/roadmap/pose_sampler.h"
#include "aspects/roadmap/roadmap_growth.h"
#include "aspects/roadmap/violation_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_samples = 100000, max_neighbors = 100;
constexpr std::size_t draws_for_each_sample = 20000;
constexpr std::size_t draws_between_looks = 256;
constexpr double share_of_sampling = 0.1;

RoadmapResult refused(const std::string& message) { return {MapStatus::refused, message, nullptr}; }

bool is_usable(const Box& box, TaskSpace space) {
  if (box.dimension < directions(space)) return false;
  for (std::size_t i = 0; i < box.dimension; ++i)
    if (!std::isfinite(box.width(i)) || box.width(i) < 0.0) return false;
  return true;
}

std::string problem_of(const Manipulator& manipulator, const RoadmapOptions& options) {
  if (options.samples < 1 || options.samples > max_samples)
    return "The number of samples is " + std::to_string(options.samples) + "; give 1 to 100000.";
  if (options.neighbors < 1 || options.neighbors > max_neighbors)
    return "The number of neighbors is " + std::to_string(options.neighbors) + "; give 1 to 100.";
  if (!(options.largest_rotation >= 0.0 && options.largest_rotation <= EIGEN_PI))
    return "The largest rotation is " + std::to_string(options.largest_rotation) + " rad; give 0 to pi.";
  for (const WorkingMode& mode : options.modes)
    if (mode.leg_count() != manipulator.leg_count())
      return "Working mode " + to_string(mode) + " needs one sign for each of the " +
             std::to_string(manipulator.leg_count()) + " legs.";
  if (options.region && !is_usable(*options.region, manipulator.task_space()))
    return "The region is empty, not finite or of too few coordinates; give a box of positions.";
  return "";
}

void report(const MapControl& control, double share) {
  if (control.progress) control.progress(share);
}

// In floating point, so that hopeless poses are not proved.
bool leg_reaches(const Leg& leg, const Pose& pose) {
  const Eigen::Vector3d point = pose.transform(leg.anchor);
  if (!(squared_inverse_entry(leg, point) > 0.0)) return false;
  return (leg.has_branch(1) && leg.limits.contain(joint_value(leg, point, 1))) ||
         (leg.has_branch(-1) && leg.limits.contain(joint_value(leg, point, -1)));
}

bool is_reachable(const Manipulator& manipulator, const Pose& pose) {
  return std::all_of(manipulator.legs().begin(), manipulator.legs().end(),
                     [&pose](const Leg& leg) { return leg_reaches(leg, pose); });
}

std::vector<Pose> sample(const Manipulator& manipulator, PoseSampler& sampler, std::size_t count,
                         const MapControl& control) {
  std::vector<Pose> poses;
  for (std::size_t draws = 0; poses.size() < count && draws < count * draws_for_each_sample; ++draws) {
    if (draws % draws_between_looks == 0) {
      if (is_cancelled(control)) return {};
      report(control, share_of_sampling * static_cast<double>(poses.size()) / static_cast<double>(count));
    }
    const std::optional<Pose> pose = sampler.draw();
    if (pose && is_reachable(manipulator, *pose)) poses.push_back(*pose);
  }
  return poses;
}

/// The poses of one mode, by proved sign of det A: positive first; none left out but empty sides.
std::vector<RoadmapSide> sides_of(const RoadmapGround& ground, const WorkingMode& mode,
                                  const MapControl& control) {
  std::vector<int> signs(ground.poses.size(), 0);
  tbb::parallel_for(std::size_t{0}, signs.size(), [&](std::size_t i) {
    if (!is_cancelled(control)) signs[i] = ground.certifier.prove(ground.poses[i], mode).sign;
  });
  std::vector<RoadmapSide> sides;
  for (const int sign : {1, -1}) {
    RoadmapSide side;
    side.mode = mode;
    side.determinant_sign = sign;
    for (std::size_t i = 0; i < signs.size(); ++i)
      if (signs[i] == sign) side.poses.push_back(static_cast<std::uint32_t>(i));
    if (!side.poses.empty()) sides.push_back(std::move(side));
  }
  return sides;
}

/// Sides of all modes, grown.
std::vector<RoadmapSide> grown_sides(const RoadmapGround& ground, const std::vector<WorkingMode>& modes,
                                     const MapControl& control) {
  std::vector<RoadmapSide> all;
  for (std::size_t i = 0; i < modes.size() && !is_cancelled(control); ++i) {
    for (RoadmapSide& side : sides_of(ground, modes[i], control)) {
      grow(side, ground, control);
      all.push_back(std::move(side));
    }
    const double share = static_cast<double>(i + 1) / static_cast<double>(modes.size());
    report(control, share_of_sampling + (1.0 - share_of_sampling) * share);
  }
  return all;
}

std::vector<RoadmapSide> find_sides(const SegmentCertifier& certifier, const std::vector<Pose>& poses,
                                    const Manipulator& manipulator, const RoadmapOptions& options,
                                    const MapControl& control) {
  std::vector<AnchorPoint> points;
  for (const Pose& pose : poses) points.push_back(anchor_point(manipulator, pose));
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                             : static_cast<int>(options.threads));
  return arena.execute([&] {
    const RoadmapGround ground{certifier, poses, points, options.neighbors};
    return grown_sides(ground, options.modes.empty() ? working_modes(manipulator) : options.modes, control);
  });
}

/// What leaves nothing most often.
std::string what_may_help(const Manipulator& manipulator) {
  std::string text;
  if (manipulator.constraints().margins.any()) text += "smaller margins, ";
  if (manipulator.tolerance() > 0.0) text += "a smaller tolerance, ";
  return text;
}

}  // namespace

PoseRoadmap::PoseRoadmap(SegmentCertifier certifier, std::vector<Pose> poses, std::vector<RoadmapSide> sides,
                         const RoadmapOptions& options, double seconds)
    : certifier_(std::move(certifier)),
      poses_(std::move(poses)),
      sides_(std::move(sides)),
      options_(options),
      seconds_(seconds) {}

const RoadmapSide* PoseRoadmap::side(const WorkingMode& mode, int sign) const noexcept {
  const auto found = std::find_if(sides_.begin(), sides_.end(), [&](const RoadmapSide& each) {
    return each.mode == mode && each.determinant_sign == sign;
  });
  return found == sides_.end() ? nullptr : &*found;
}

std::size_t PoseRoadmap::component_count() const noexcept {
  std::size_t count = 0;
  for (const RoadmapSide& each : sides_) count += each.component_sizes.size();
  return count;
}

RoadmapResult compute_pose_roadmap(std::shared_ptr<const Manipulator> manipulator,
                                   const RoadmapOptions& options, const MapControl& control) {
  const auto start = std::chrono::steady_clock::now();
  if (const std::string problem = problem_of(*manipulator, options); !problem.empty())
    return refused(problem);
  PoseSampler sampler(manipulator, options.seed, options.region, options.largest_rotation);
  if (!sampler.is_bounded())
    return refused(
        "The legs of '" + manipulator->name() +
        "' have no limits that bound the workspace; limit the actuated joints in the URDF or give a region.");
  std::vector<Pose> poses = sample(*manipulator, sampler, options.samples, control);
  SegmentCertifier certifier(manipulator);
  std::vector<RoadmapSide> sides = find_sides(certifier, poses, *manipulator, options, control);
  if (is_cancelled(control)) return {MapStatus::cancelled, "The computation was cancelled.", nullptr};
  if (sides.empty())
    return refused("No pose was found that '" + manipulator->name() +
                   "' reaches away from singularities and within its constraints; give " +
                   what_may_help(*manipulator) +
                   "another region, or check limits, lengths and the workspace.");
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {MapStatus::complete, "",
          std::make_shared<const PoseRoadmap>(std::move(certifier), std::move(poses), std::move(sides),
                                              options, seconds)};
}

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
