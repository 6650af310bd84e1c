// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/regular_workspace.h"

#include "aspects/map/map_contents.h"
#include "aspects/workspace/shape_room.h"
#include "aspects/workspace/shape_search.h"
#include "interval/interval.h"
#include "model/angles.h"
#include "model/message_text.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace parallel_aspects {
namespace {

/// A shape and how it is named.
struct ShapeTraits {
  RegularShape shape;
  const char* name;
  std::size_t dimension;  ///< of positions that it takes; 0 for any number
};

constexpr std::array<ShapeTraits, 5> shapes{{{RegularShape::box, "box", 0},
                                             {RegularShape::square, "square", 2},
                                             {RegularShape::disc, "disc", 2},
                                             {RegularShape::cylinder, "cylinder", 3},
                                             {RegularShape::ball, "ball", 3}}};

const ShapeTraits& traits_of(RegularShape shape) { return shapes[static_cast<std::size_t>(shape)]; }

std::string find_shape_problem(const Manipulator& manipulator, const WorkspaceQuestion& question,
                               const std::optional<MapSlice>& slice) {
  if (slice && slice->joint)
    return "Regular workspaces are shapes of positions, but the slice holds a joint; hold pose coordinates.";
  const std::size_t free = free_positions(manipulator, slice);
  if (!slice && manipulator.task_space() == TaskSpace::SE3)
    return "'" + manipulator.name() +
           "' has six degrees of freedom, which are more than can be mapped; hold its orientation by a "
           "slice, "
           "such as roll=0 pitch=0 yaw=0.";
  if (free == 0)
    return "No position is free, so that no shape of positions fits; regular workspaces are of robots or "
           "slices with free positions.";
  const ShapeTraits& traits = traits_of(question.shape);
  if (traits.dimension == 0 || traits.dimension == free) return "";
  return "A " + std::string(traits.name) + " takes " + std::to_string(traits.dimension) +
         " free positions, but " + std::to_string(free) + (free == 1 ? " is" : " are") + " free; choose " +
         (free == 1   ? "box"
          : free == 2 ? "box, square or disc"
                      : "box, cylinder or ball") +
         ".";
}

void check_ratio(const WorkspaceQuestion& question, std::size_t free, Problems& problems) {
  const std::size_t wanted = question.shape == RegularShape::box        ? free
                             : question.shape == RegularShape::cylinder ? 1
                                                                        : 0;
  if (!question.ratio.empty() && question.ratio.size() != wanted)
    problems.push_back("The ratio of a " + std::string(name(question.shape)) + " has " +
                       std::to_string(wanted) + " numbers here, not " +
                       std::to_string(question.ratio.size()) + "; " +
                       (wanted == 0   ? "leave it out."
                        : wanted == 1 ? "give height over diameter."
                                      : "give one for each free position."));
  for (const double part : question.ratio)
    if (!std::isfinite(part) || part < 1e-3 || part > 1e3)
      problems.push_back("A part of the ratio is " + number_text(part, 6) + "; give one from 0.001 to 1000.");
}

bool has_angle(const Manipulator& manipulator, const std::optional<MapSlice>& slice) {
  return slice ? slice->rotation == MapSlice::Rotation::about_axis
               : manipulator.task_space() == TaskSpace::SE2;
}

void check_angle(const WorkspaceQuestion& question, bool is_there, Problems& problems) {
  if (!question.angle) return;
  const auto [lower, upper] = *question.angle;
  if (!is_there)
    problems.emplace_back("A range of the angle is given, but no angle is free; leave it out.");
  else if (!(lower <= upper && -EIGEN_PI <= lower && upper <= EIGEN_PI))
    problems.push_back("The angle goes from " + number_text(lower, 6) + " to " + number_text(upper, 6) +
                       " rad; give a range between -pi and pi, the smaller end first.");
}

void check_center(const WorkspaceQuestion& question, std::size_t free, Problems& problems) {
  for (std::size_t i = 0; i < question.center.size(); ++i)
    if (question.center[i] && (i >= free || !std::isfinite(*question.center[i])))
      problems.push_back("The center has a coordinate " + std::to_string(i + 1) +
                         " that is not a finite number of a free position; correct it, or leave it out.");
}

/// Half turns of an angle, moved past two roundings of half a unit in the last place.
double half_turns(double angle, double towards) {
  double value = angle / EIGEN_PI;
  for (int i = 0; i < 3; ++i) value = std::nextafter(value, towards);
  return std::clamp(value, -1.0, 1.0);
}

/// The region of the map, with the angles that are asked for.
AngleBounds angles_of(const Box& region, std::size_t free, const WorkspaceQuestion& question) {
  AngleBounds bounds{region, region};
  if (!question.angle || region.dimension == free) return bounds;
  const auto [lower, upper] = *question.angle;
  bounds.outer.lower[free] = half_turns(lower, -2.0);
  bounds.outer.upper[free] = half_turns(upper, 2.0);
  bounds.inner.lower[free] = half_turns(lower, 2.0);
  bounds.inner.upper[free] = half_turns(upper, -2.0);
  return bounds;
}

/// Boxes of centers: all positions of the region, or those that are held.
Box centers_of(Box positions, const WorkspaceQuestion& question) {
  for (std::size_t i = 0; i < positions.dimension; ++i)
    if (question.center[i]) positions.lower[i] = positions.upper[i] = *question.center[i];
  return positions;
}

/// Shapes below this share of the largest are not distinguished.
constexpr double share_of_interest = 0.01;

/// Aspects of one working mode and one sign of det A, which share their leaves.
struct Group {
  std::vector<std::size_t> places;  ///< in the answer
  std::unique_ptr<UsableLeaves> leaves;
  double seed = 0.0;  ///< a shape that one of them holds
};

class Survey {
 public:
  Survey(const AspectMap& map, const std::vector<int>& ids, const WorkspaceQuestion& question,
         const WorkspaceOptions& options)
      : map_(map),
        ids_(ids),
        turns_(has_hinges(map.manipulator()->task_space())),
        question_(turns_ ? in_half_turns(question) : question),
        options_(options),
        free_(free_positions(*map.manipulator(), map.slice())),
        gauge_(made_under_upward_rounding<ShapeGauge>(question_, free_, turns_)),
        found_(ids.size()) {}

  std::optional<std::vector<RegularWorkspace>> run() {
    std::vector<Group> groups = groups_of_leaves();
    tbb::task_arena arena(options_.threads == 0 ? tbb::task_arena::automatic
                                                : static_cast<int>(options_.threads));
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t i) { prepare(groups[i]); });
      for (const Group& group : groups) of_interest_ = std::max(of_interest_, share_of_interest * group.seed);
      tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t i) { look_into(groups[i]); });
    });
    if (is_cancelled(options_.control)) return std::nullopt;
    if (options_.control.progress) options_.control.progress(1.0);
    if (turns_)
      for (RegularWorkspace& found : found_) take_unit(found);
    return found_;
  }

 private:
  /// The center the shorter way round.
  static WorkspaceQuestion in_half_turns(WorkspaceQuestion question) {
    for (auto& each : question.center)
      if (each) each = std::clamp(std::remainder(*each, full_turn) / pi, -1.0, 1.0);
    return question;
  }

  /// Half turns become angles. The center and pi are rounded, by far less than what the shape loses for it
  /// even along an edge that is a thousandth of the first.
  static void take_unit(RegularWorkspace& found) {
    constexpr double lost = 1e-11;  // [rad]
    for (double& each : found.center) each *= pi;
    found.lower = std::max(0.0, pi * found.lower - lost);
    found.upper = pi * found.upper + lost;
  }

  const Aspect& aspect(std::size_t place) const {
    return map_.aspects()[static_cast<std::size_t>(ids_[place] - 1)];
  }

  std::vector<Group> groups_of_leaves() const {
    std::map<std::pair<std::size_t, int>, Group> groups;
    for (std::size_t i = 0; i < ids_.size(); ++i)
      groups[{*mode_index(map_.contents(), aspect(i).mode), aspect(i).determinant_sign}].places.push_back(i);
    std::vector<Group> result;
    for (auto& [key, group] : groups) result.push_back(std::move(group));
    return result;
  }

  MapPoint deepest(std::size_t place) const {
    return map_.contents().tree.space().position(aspect(place).deepest).point;
  }

  void prepare(Group& group) const {
    const RoundingUpward rounding;
    const Aspect& first = aspect(group.places.front());
    const AspectMap::Contents& contents = map_.contents();
    group.leaves =
        std::make_unique<UsableLeaves>(contents, *mode_index(contents, first.mode), first.determinant_sign,
                                       gauge_, angles_of(contents.tree.region(), free_, question_));
    const Box centers = centers_of(group.leaves->positions(), question_);
    for (const std::size_t place : group.places)
      if (centers.contains(deepest(place)))
        group.seed = std::max(group.seed, group.leaves->room(deepest(place), HUGE_VAL, 0.0).lower);
  }

  void look_into(const Group& group) {
    const RoundingUpward rounding;
    for (const std::size_t place : group.places) {
      if (is_cancelled(options_.control)) return;
      std::vector<int> like = aspect(place).unresolved_with;
      like.push_back(ids_[place]);
      found_[place] = ShapeSearch(*group.leaves, gauge_, ids_[place], std::move(like), of_interest_, options_)
                          .run(centers_of(group.leaves->positions(), question_), deepest(place));
      tell_progress();
    }
  }

  void tell_progress() {
    const std::lock_guard<std::mutex> lock(progress_mutex_);
    ++done_;
    if (options_.control.progress)
      options_.control.progress(static_cast<double>(done_) / static_cast<double>(ids_.size()));
  }

  const AspectMap& map_;
  const std::vector<int>& ids_;
  bool turns_;  ///< whether coordinates are angles, in half turns in the map
  const WorkspaceQuestion question_;
  const WorkspaceOptions& options_;
  std::size_t free_;
  ShapeGauge gauge_;
  std::vector<RegularWorkspace> found_;
  double of_interest_ = 0.0;
  std::mutex progress_mutex_;
  std::size_t done_ = 0;
};

}  // namespace

std::size_t free_positions(const Manipulator& manipulator, const std::optional<MapSlice>& slice) noexcept {
  if (slice) return slice->free_positions();
  return has_hinges(manipulator.task_space()) ? manipulator.leg_count()
                                              : directions(manipulator.task_space());
}

Problems problems_of(const Manipulator& manipulator, const std::optional<MapSlice>& slice,
                     const WorkspaceQuestion& question) {
  if (std::string problem = find_shape_problem(manipulator, question, slice); !problem.empty())
    return {std::move(problem)};
  Problems problems;
  const std::size_t free = free_positions(manipulator, slice);
  check_ratio(question, free, problems);
  check_angle(question, has_angle(manipulator, slice), problems);
  check_center(question, free, problems);
  return problems;
}

std::optional<std::vector<RegularWorkspace>> find_regular_workspaces(const AspectMap& map,
                                                                     const std::vector<int>& aspects,
                                                                     const WorkspaceQuestion& question,
                                                                     const WorkspaceOptions& options) {
  return Survey(map, aspects, question, options).run();
}

std::vector<std::pair<std::string, double>> lengths_of(const AspectMap& map,
                                                       const WorkspaceQuestion& question, double size) {
  switch (question.shape) {
    case RegularShape::square:
      return {{"edge", size}};
    case RegularShape::disc:
    case RegularShape::ball:
      return {{"radius", size}};
    case RegularShape::cylinder:
      return {{"radius", size}, {"height", 2.0 * size * (question.ratio.empty() ? 1.0 : question.ratio[0])}};
    case RegularShape::box:
      break;
  }
  std::vector<std::pair<std::string, double>> result;
  const std::vector<std::string> names = map.coordinates();
  for (std::size_t i = 0; i < free_positions(*map.manipulator(), map.slice()); ++i)
    result.emplace_back("edge_" + names[i],
                        question.ratio.empty() ? size : size * question.ratio[i] / question.ratio[0]);
  return result;
}

const char* name(RegularShape shape) noexcept { return traits_of(shape).name; }

}  // namespace parallel_aspects
