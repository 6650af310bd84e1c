// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map_choice.h"

#include "model/task_space_traits.h"
#include "parallel_aspects/aspects/aspect_graph.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/aspects/map_file.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/report/bounds_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects::tools {

std::vector<Option> map_choice_options(MapChoice& choice, const std::string& slice_option) {
  return {{"--resolution", "R",
           "Longest edge of an undecided leaf of the base map [m or rad]; by default what suits the robot",
           &choice.resolution},
          {slice_option, "\"z=1\"",
           "Stay in a line, plane or volume of poses: what is held, with its value [m or rad]; the rest is "
           "free. In "
           "SE2 an actuated joint may be held, such as \"strut_1_joint=15\"",
           &choice.slice},
          {"--load", "FILE", "Take the map from this file if it is of this robot and these options",
           &choice.load_file},
          {"--save", "FILE", "Write the map to this file, with its gates, for --load", &choice.save_file}};
}

namespace {

constexpr int pose_digits = 10;  // to be typed again

Pose nearest_of(const MapSlice& slice, const Manipulator& manipulator, const Pose& pose) {
  if (slice.joint) return circle_of_anchor(manipulator, *slice.joint).nearest(pose);
  Pose nearest = pose;
  for (std::size_t i = 0; i < slice.moves.size(); ++i)
    if (!slice.moves[i])
      nearest.position[static_cast<Eigen::Index>(i)] = slice.held.position[static_cast<Eigen::Index>(i)];
  if (slice.rotation == MapSlice::Rotation::none) nearest.orientation = slice.held.orientation;
  return nearest;
}

double distance_to(const MapSlice& slice, const Manipulator& manipulator, const Pose& pose) {
  if (slice.joint) return std::abs(circle_of_anchor(manipulator, *slice.joint).distance(pose));
  const Pose nearest = nearest_of(slice, manipulator, pose);
  return std::hypot(
      (pose.position - nearest.position).norm(),
      manipulator.characteristic_length() * pose.orientation.angularDistance(nearest.orientation));
}

/// How far a pose of the slice is from it at most once its numbers are rounded as tables have them, to six
/// digits: each then differs by half a unit of the last one.
double tolerance_at(const Manipulator& manipulator, const Pose& pose) {
  constexpr double rounding = 5.0001e-6;  // of a number at most, and as it is rounded itself
  constexpr double largest_share = 1e-4;  // of the robot's size, however far off its frame is
  const PoseCoordinates coordinates = pose_coordinates(manipulator.task_space(), pose);
  const Eigen::Index moves = traits(manipulator.task_space()).translations;
  const double lengths = coordinates.head(moves).lpNorm<1>(),
               turned = coordinates.tail(coordinates.size() - moves).lpNorm<1>();
  // A quaternion turns by twice as much as its numbers differ, and no anchor is much farther out than this.
  const double rounded = rounding * (lengths + 2.0 * manipulator.characteristic_length() * turned);
  return held_joint_tolerance + std::min(rounded, largest_share * manipulator.size());
}

double put_onto_slice(const MapSlice& slice, const Manipulator& manipulator, const NamedPose& end,
                      Problems& problems) {
  const Pose nearest = nearest_of(slice, manipulator, *end.pose);
  const double distance = distance_to(slice, manipulator, *end.pose);
  const double tolerance = tolerance_at(manipulator, *end.pose);
  if (!(distance <= tolerance))
    problems.push_back(end.option + " lies " + shown(distance) + " m from the slice " + to_string(slice) +
                       "; give a pose within " + shown_briefly(tolerance) + " m of it. The nearest is \"" +
                       pose_argument(manipulator.task_space(), nearest, pose_digits) + "\".");
  if (distance > 0.0) *end.pose = nearest;
  return distance;
}

}  // namespace

std::optional<MapSlice> parse_slice_with_ends(const std::string& option, const Manipulator& manipulator,
                                              const std::string& text, const std::vector<NamedPose>& ends,
                                              double& moved, Problems& problems) {
  if (text.empty()) return std::nullopt;
  const MapSlice slice = parse_slice(option, manipulator, text, problems);
  if (problems.empty())
    for (const NamedPose& end : ends)
      moved = std::max(moved, put_onto_slice(slice, manipulator, end, problems));
  return slice;
}

namespace {

ChosenMap load_or_compute_map(const std::shared_ptr<const Manipulator>& manipulator, const MapChoice& choice,
                              const MapOptions& options, const Surroundings& surroundings) {
  if (!choice.load_file.empty()) {
    const MapResult loaded = load_map(manipulator, options, choice.load_file);
    if (loaded) return {loaded.map, true};
    surroundings.messages << loaded.message << std::endl;
  }
  const MapResult computed = completed(surroundings, [&](const MapControl& control) {
    return compute_aspect_map(manipulator, options, control);
  });
  return {computed.map, false};
}

}  // namespace

ChosenMap choose_map(const std::shared_ptr<const Manipulator>& manipulator, const MapChoice& choice,
                     const std::optional<MapSlice>& slice, const Surroundings& surroundings,
                     const std::vector<WorkingMode>& modes) {
  Problems problems;
  MapOptions options;
  options.modes = modes;
  if (!choice.resolution.empty())
    options.resolution = parse_positive("--resolution", choice.resolution, problems);
  options.slice = slice;
  check_output_file("--save", choice.save_file, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  ChosenMap chosen = load_or_compute_map(manipulator, choice, options, surroundings);
  save_with_gates(*chosen.map, choice.save_file, surroundings);
  return chosen;
}

void report_source(const MapChoice& choice, const ChosenMap& chosen, Report& report) {
  report.json["loaded"] = chosen.loaded;
  if (!choice.load_file.empty())
    report.text += chosen.loaded ? "the map is that of " + choice.load_file + "\n"
                                 : "the map was computed, as " + choice.load_file + " does not have it\n";
  if (!choice.save_file.empty()) report.text += "the map is saved to " + choice.save_file + "\n";
}

void save_with_gates(const AspectMap& map, const std::string& file, const Surroundings& surroundings) {
  if (file.empty()) return;
  if (!compute_aspect_graph(map, control_of(surroundings))) throw Interrupted{};
  const SaveResult result = save_map(map, file);
  if (!result.saved) throw InvalidDescription({result.message});
}

}  // namespace parallel_aspects::tools
