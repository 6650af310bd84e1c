// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_SESSION_H
#define PARALLEL_ASPECTS_ASK_SESSION_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/motion/plan_path.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

class DistanceMap;
class Mechanism;

namespace ask {

/// Hooks into the answering of a question. All may be left empty.
struct Control {
  std::function<void(const char* step, double share)> progress;  ///< what is being done, share done 0 to 1
  std::function<void(const std::string& sentence)> note;         ///< what does not keep it from an answer
  const std::atomic<bool>* cancelled = nullptr;                  ///< polled

  MapControl begin(const char* step) const;  ///< for one step, whose beginning it reports
  bool is_over() const noexcept {            ///< whether it is cancelled
    return is_cancelled(MapControl{{}, cancelled});
  }
};

/// What came of a question.
template <class Answer>
struct Outcome {
  MapStatus status = MapStatus::complete;  ///< the answer means something only if complete
  ProblemList problems{};                  ///< why it is refused
  Answer answer{};                         ///< where there is one

  /// Whether there is an answer.
  explicit operator bool() const noexcept { return status == MapStatus::complete; }
};

/// How a question ended: refused where there are problems, cancelled, or with its answer.
template <class Answer>
Outcome<Answer> outcome_of(ProblemList problems, const Control& control, Answer answer) {
  if (!problems.empty()) return {MapStatus::refused, std::move(problems), {}};
  if (control.is_over()) return {MapStatus::cancelled, {}, {}};
  return {MapStatus::complete, {}, std::move(answer)};
}

/// Which roadmap a question is asked of.
struct RoadmapSource {
  std::optional<Count<1, 100000>> samples{};   ///< poses
  std::optional<Count<0, 4294967295>> seed{};  ///< of the poses

  bool is_default() const noexcept { return !samples && !seed; }  ///< whether it says nothing

  /// In these working modes, or in all where there are none.
  RoadmapOptions options(std::vector<WorkingMode> modes) const;
};

/// Which map a question is asked of.
struct MapSource {
  std::optional<double> resolution{};  ///< longest edge of an undecided leaf of the base map [m or rad]
  std::optional<MapSlice> hold{};      ///< the map of this slice
  std::string load{};                  ///< file that may have it; empty for none
  std::string save{};                  ///< file that it is written to, with its gates; empty for none
  bool must_load = false;              ///< whether it is refused where the file does not have it

  /// Whether it names no other map than that which is there, of a slice or not.
  bool is_default() const noexcept { return !resolution && load.empty() && save.empty(); }
};

/// Their fields, as all questions have them.
template <class Visit>
void describe(Visit& visit, MapSource& map) {
  visit({"resolution", "R",
         "Longest edge of an undecided leaf of the base map [m or rad]; by default what suits the robot"},
        map.resolution);
  visit(
      {"slice", "\"z=1\"",
       "Stay in a line, plane or volume of poses: what is held, with its value [m or rad]; the rest is free. "
       "In SE2 an actuated joint may be held, such as \"strut_1_joint=15\""},
      map.hold);
  visit({"load", "FILE", "Take the map from this file if it is of this robot and these options"}, map.load);
  visit({"save", "FILE", "Write the map to this file, with its gates, for {load}"}, map.save);
}
/// The fields of the source of a roadmap.
template <class Visit>
void describe(Visit& visit, RoadmapSource& roadmap) {
  visit({"samples", "N", "With six degrees of freedom: poses of the roadmap, by default 1000"},
        roadmap.samples);
  visit({"seed", "N", "Likewise: seed of its poses, by default 1"}, roadmap.seed);
}

/// Acceleration limits of the actuated joints, where a question says nothing else.
struct Acceleration {
  JointVector values{};                        ///< [rad/s^2 or m/s^2]; empty for none
  std::string remedy = "give {acceleration}";  ///< where there are none
  std::string otherwise{};                     ///< what asks for no path in time; empty for nothing
};

/// A map, and whether a file had it.
struct FoundMap {
  std::shared_ptr<const AspectMap> map;  ///< null where refused or cancelled
  bool loaded = false;                   ///< from the file
};

/// A robot that questions are asked of, and what its answers have in common. For one thread at a time.
class Session {
 public:
  /// The robot is not null. `options`: of maps, where a question says nothing else.
  explicit Session(std::shared_ptr<const Manipulator> robot, MapOptions options = {});

  /// A map or a roadmap of this robot that is there already: it is asked where a question names no other.
  void know(std::shared_ptr<const AspectMap> map);
  void know(std::shared_ptr<const PoseRoadmap> roadmap);    ///< likewise
  void know(std::shared_ptr<const DistanceMap> distances);  ///< of a map, made ready
  void know(std::shared_ptr<const Mechanism> mechanism) {
    mechanism_ = std::move(mechanism);
  }  ///< of the robot

  /// For paths in time.
  void set_acceleration(Acceleration acceleration) { acceleration_ = std::move(acceleration); }
  const Acceleration& acceleration() const noexcept { return acceleration_; }  ///< see above

  /// Whom questions are about; never null.
  const std::shared_ptr<const Manipulator>& robot() const noexcept { return robot_; }
  /// Of the robot; never null.
  const std::shared_ptr<const SegmentCertifier>& certifier() const noexcept { return certifier_; }
  /// What the robot is part of; null where that was not made known.
  const std::shared_ptr<const Mechanism>& mechanism() const noexcept { return mechanism_; }
  /// What was made known; null for none.
  const std::shared_ptr<const AspectMap>& known_map() const noexcept { return known_map_; }
  const std::shared_ptr<const PoseRoadmap>& known_roadmap() const noexcept {  ///< likewise
    return known_roadmap_;
  }

  /// The slice that a question is about.
  std::optional<MapSlice> slice_of(const MapSource& source) const;

  /// Of the map of that source in these working modes, or in all.
  MapOptions options_for(const MapSource& source, const std::vector<WorkingMode>& modes) const;

  /// The map with these options, of the file where it fits, else computed; it is saved where that is asked
  /// for.
  FoundMap map_of(const MapOptions& options, const MapSource& files, const Control& control,
                  ProblemList& problems);

  /// The map of that source in these working modes, or in all: that which is known, that of the file where it
  /// fits, else computed; it is saved where that is asked for.
  FoundMap map(const MapSource& source, const std::vector<WorkingMode>& modes, const Control& control,
               ProblemList& problems);

  /// That which is known, or computed; null where refused or cancelled.
  std::shared_ptr<const PoseRoadmap> roadmap(const RoadmapOptions& options, const Control& control,
                                             ProblemList& problems);

  /// What was made known, or that of the known map, which is made once; null where there is none, and of a
  /// slice, which does not show what is beside it.
  std::shared_ptr<const DistanceMap> known_distances(const Control& control);

  /// The planner of a map; that of the map before is kept, as it knows the gates.
  std::shared_ptr<PathPlanner> planner(const std::shared_ptr<const AspectMap>& map);

 private:
  FoundMap load_or_compute(const MapOptions& options, const MapSource& files, const Control& control,
                           ProblemList& problems);
  static FoundMap saved(FoundMap found, const std::string& file, const Control& control,
                        ProblemList& problems);

  std::shared_ptr<const Manipulator> robot_;
  std::shared_ptr<const Mechanism> mechanism_;
  MapOptions options_;
  Acceleration acceleration_;
  std::shared_ptr<const SegmentCertifier> certifier_;
  std::shared_ptr<const AspectMap> known_map_, computed_map_, planned_map_;  // the last is the planner's
  std::shared_ptr<const PoseRoadmap> known_roadmap_;
  std::shared_ptr<const DistanceMap> known_distances_;
  std::shared_ptr<PathPlanner> planner_;
};

/// Writes a map with the gates between its aspects; false, with a problem unless cancelled, where it cannot.
bool save_with_gates(const AspectMap& map, const std::string& file, const MapControl& control,
                     ProblemList& problems);

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_SESSION_H
