// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_QUESTION_PARTS_H
#define PARALLEL_ASPECTS_ASK_QUESTION_PARTS_H

#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::ask {

/// "1 aspect", "2 aspects"; `plural` where it is not the noun with an s.
std::string counted(std::size_t number, const std::string& noun, const std::string& plural = "");

/// Margins that are not zero, by name.
NamedValues margins_of(const Margins& margins);

/// The ranges of a box, one for each of the names.
std::vector<NamedRange> ranges_of(const std::vector<std::string>& names, const Box& box);

/// "x=-1:1 y=-1:1", in quotes and with units.
std::string example_of_ranges(const std::vector<std::string>& names);

/// The box with these ranges, one for each of the names. Where there are problems it is of no meaning.
Box box_of(const std::string& field, const std::vector<std::string>& names,
           const std::vector<NamedRange>& ranges, ProblemList& problems);

/// Puts a pose, typed in a few digits, onto the slice, and returns by how much [m]. Where that is more than
/// the rounding of a table to six digits it is refused, and the problem gives the nearest pose.
double put_onto_slice(const MapSlice& slice, const Manipulator& robot, const std::string& field, Pose& pose,
                      ProblemList& problems);

/// Whether there are maps of boxes of the robot, or of this slice; else there are roadmaps.
bool has_map(const std::optional<MapSlice>& slice, const Manipulator& robot) noexcept;

/// Where what is asked has a map of boxes it has no roadmap, and the other way round.
void check_sources(bool has_map, const MapSource& map, const RoadmapSource& roadmap, ProblemList& problems);

/// That configuration, which no map was asked about.
LocatedConfiguration configuration_of(const Manipulator& robot, const Pose& pose, const JointVector& q);

/// Adds what the map, or the roadmap, knows of it; either may be null.
void locate_in(const Manipulator& robot, const AspectMap* map, const PoseRoadmap* roadmap,
               LocatedConfiguration& configuration);

/// Every configuration at a pose within limits, in that working mode or in all. Where there is none, why.
std::vector<LocatedConfiguration> configurations_at(const Manipulator& robot, const Pose& pose,
                                                    const std::optional<WorkingMode>& mode,
                                                    std::string& reason);

/// Every assembly mode at these actuated joints, likewise.
DirectStatus configurations_at(const Manipulator& robot, const JointVector& q,
                               std::vector<LocatedConfiguration>& found, std::string& reason);

/// Keeps those of this working mode and sign of det A, 0 for both. A sign that is exactly zero contradicts
/// nothing. Where none is left, what they are and what is stated, a sentence; else empty.
std::string keep_stated(const Manipulator& robot, const std::optional<WorkingMode>& mode, int sign,
                        std::vector<LocatedConfiguration>& configurations);

/// Values by the names of the actuated joints, as messages and files have them, in the order of the legs.
class JointColumns {
 public:
  /// Each joint is named once, and nothing else; problems begin with `what`.
  JointColumns(const Manipulator& robot, const std::vector<std::string>& names, std::string what,
               Problems& problems);

  /// Empty for no values. A problem where these are not one for each name.
  JointVector ordered(const std::vector<double>& values, const std::string& where, Problems& problems) const;

 private:
  std::string what_;
  std::size_t count_;                 // of the names
  std::vector<std::size_t> columns_;  // of each leg
};

/// An end, understood: that of an aspect is of no meaning before there is a map. Where actuated joints
/// assemble in several poses, and none is given beside them, the problem lists these.
PathEnd path_end(const std::string& field, const Manipulator& robot, const EndQuestion& question,
                 ProblemList& problems);

/// Puts an end into the aspect that was asked for, if one was.
void place_in_aspect(const std::string& field, const AspectMap& map, const EndQuestion& question,
                     PathEnd& end, ProblemList& problems);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_QUESTION_PARTS_H
