// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/session.h"

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <filesystem>
#include <utility>

namespace parallel_aspects::ask {

MapControl Control::begin(const char* step) const {
  MapControl control;
  control.cancelled = cancelled;
  if (!progress) return control;
  control.progress = [tell = progress, step](double share) { tell(step, share); };
  progress(step, 0.0);
  return control;
}

RoadmapOptions RoadmapSource::options(std::vector<WorkingMode> modes) const {
  RoadmapOptions result;
  if (samples) result.samples = samples->value;
  if (seed) result.seed = seed->value;
  result.modes = std::move(modes);
  return result;
}

bool save_with_gates(const AspectMap& map, const std::string& file, const MapControl& control,
                     ProblemList& problems) {
  if (!compute_aspect_graph(map, control)) return false;
  const SaveResult result = save_map(map, file);
  if (!result) problems.push_back(told(result.message));
  return result.saved;
}

Session::Session(std::shared_ptr<const Manipulator> robot, MapOptions options)
    : robot_(std::move(robot)),
      options_(std::move(options)),
      certifier_(std::make_shared<const SegmentCertifier>(robot_)) {}

void Session::know(std::shared_ptr<const AspectMap> map) { known_map_ = std::move(map); }

void Session::know(std::shared_ptr<const PoseRoadmap> roadmap) { known_roadmap_ = std::move(roadmap); }

void Session::know(std::shared_ptr<const DistanceMap> distances) { known_distances_ = std::move(distances); }

std::optional<MapSlice> Session::slice_of(const MapSource& source) const {
  if (source.hold) return source.hold;
  return known_map_ ? known_map_->slice() : options_.slice;
}

// A file that the map is saved to need not be there the first time.
FoundMap Session::load_or_compute(const MapOptions& options, const MapSource& files, const Control& control,
                                  ProblemList& problems) {
  if (!files.load.empty() && (files.load != files.save || std::filesystem::exists(files.load))) {
    const MapResult loaded = load_map(robot_, options, files.load);
    if (loaded) return {loaded.map, true};
    if (files.must_load) problems.push_back(told(loaded.message));
    if (files.must_load) return {};
    if (control.note) control.note(loaded.message);
  }
  const MapResult computed = compute_aspect_map(robot_, options, control.begin("Computing a map."));
  if (computed.status == MapStatus::refused) problems.push_back(told(computed.message));
  return {computed.map, false};
}

FoundMap Session::map_of(const MapOptions& options, const MapSource& files, const Control& control,
                         ProblemList& problems) {
  return saved(load_or_compute(options, files, control, problems), files.save, control, problems);
}

FoundMap Session::saved(FoundMap found, const std::string& file, const Control& control,
                        ProblemList& problems) {
  if (!found.map || file.empty()) return found;
  const bool saved = save_with_gates(*found.map, file, control.begin("Looking for gates."), problems);
  return saved ? found : FoundMap{};
}

FoundMap Session::map(const MapSource& source, const std::vector<WorkingMode>& modes, const Control& control,
                      ProblemList& problems) {
  const bool is_there = !source.hold && !source.resolution && source.load.empty();
  FoundMap found;
  if (is_there && known_map_) found.map = known_map_;
  if (is_there && !known_map_ && modes.empty()) found.map = computed_map_;
  if (!found.map) {
    found = load_or_compute(options_for(source, modes), source, control, problems);
    if (is_there && modes.empty()) computed_map_ = found.map;  // for the next question
  }
  return saved(std::move(found), source.save, control, problems);
}

// A finer map of what is known is of the same slice, modes and region.
MapOptions Session::options_for(const MapSource& source, const std::vector<WorkingMode>& modes) const {
  MapOptions options = known_map_ ? options_of(*known_map_) : options_;
  if (source.hold) {  // region and resolution are those of all poses
    options.region.reset();
    options.slice = source.hold;
  }
  if (source.hold || source.resolution) options.resolution = source.resolution;
  if (!modes.empty()) options.modes = modes;
  return options;
}

std::shared_ptr<const PoseRoadmap> Session::roadmap(const RoadmapOptions& options, const Control& control,
                                                    ProblemList& problems) {
  if (known_roadmap_) return known_roadmap_;
  const RoadmapResult result = compute_pose_roadmap(robot_, options, control.begin("Computing a roadmap."));
  if (result.status == MapStatus::refused) problems.push_back(told(result.message));
  return result.roadmap;
}

std::shared_ptr<const DistanceMap> Session::known_distances(const Control& control) {
  if (known_distances_ || !known_map_ || known_map_->slice()) return known_distances_;
  const auto made = std::make_shared<const DistanceMap>(known_map_, control.begin("Making the map ready."));
  if (!control.is_over()) known_distances_ = made;
  return known_distances_;
}

std::shared_ptr<PathPlanner> Session::planner(const std::shared_ptr<const AspectMap>& map) {
  if (planner_ && planned_map_ == map) return planner_;
  planned_map_ = map;
  planner_ = std::make_shared<PathPlanner>(map);
  return planner_;
}

}  // namespace parallel_aspects::ask
