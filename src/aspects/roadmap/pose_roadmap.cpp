// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/pose_roadmap.h"

#include "aspects/roadmap/pose_sampler.h"
#include "aspects/roadmap/roadmap_growth.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/model/constraints.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

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

}  // namespace parallel_aspects
