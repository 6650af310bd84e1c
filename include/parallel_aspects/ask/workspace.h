// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_WORKSPACE_H
#define PARALLEL_ASPECTS_ASK_WORKSPACE_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/regular_workspace.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// All values, for whoever reads one by its name.
inline constexpr std::array<RegularShape, 5> choices(RegularShape /*tag*/) {
  return {RegularShape::box, RegularShape::square, RegularShape::disc, RegularShape::cylinder,
          RegularShape::ball};
}

/// The fields of a range.
template <class Visit>
void describe(Visit& visit, const AngleRange& range) {
  visit({"lower", "rad", "lower end"}, range.lower);
  visit({"upper", "rad", "upper end"}, range.upper);
}

namespace ask {

/// Which regular shape is searched for, as faces state it.
struct ShapeQuestion {
  std::optional<RegularShape> shape{};    ///< needed
  std::vector<HeldCoordinate> center{};   ///< coordinates of it that are held [m]
  std::vector<double> aspect_ratio{};     ///< of a cylinder diameter and height
  std::vector<NamedRange> orientation{};  ///< none, or that of the free angle
  std::optional<double> gap{};            ///< that is aimed at between the bounds, of the upper one

  /// What it asks of such a map, of all poses or of a slice.
  WorkspaceQuestion of(const Manipulator& robot, const std::optional<MapSlice>& slice,
                       ProblemList& problems) const;
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, ShapeQuestion& question) {
  visit({"shape", "disc", "Box or square, with edges along the axes; disc, cylinder along z, or ball"},
        question.shape);
  visit({"center", "\"x=1 y=2\"", "Hold all or some coordinates of the center [m]"}, question.center);
  visit({"aspect_ratio", "\"1:2\"",
         "Edges of a box to each other, or diameter to height of a cylinder; by default all equal"},
        question.aspect_ratio);
  visit({"orientation", "\"phi=-0.2:0.2\"",
         "Where an angle is free: the range of it that must be possible all over the shape [rad]; by default "
         "every one"},
        question.orientation);
  visit({"gap", "SHARE", "Between the bounds of the size, of the upper one, by default 0.01"}, question.gap);
}

/// The largest regular shape in each aspect.
struct LargestShapeQuestion {
  ShapeQuestion shape{};                           ///< which
  std::vector<Count<1, 1'000'000'000>> aspects{};  ///< by their ids; by default all
  std::vector<WorkingMode> modes{};                ///< of which aspects are examined; by default all
  MapSource map{};                                 ///< which has them
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, LargestShapeQuestion& question) {
  describe(visit, question.shape);
  visit({"aspect", "N", "In these aspects alone, by their ids in `aspects map`"}, question.aspects);
  visit({"mode", "\"(+,-)\"",
         "In these working modes alone; ids are then those of `aspects map --mode`, unless there is a map"},
        question.modes);
  describe(visit, question.map);
}

/// The largest shape in one aspect.
struct ShapeInAspect {
  RegularWorkspace found;                               ///< as of `find_regular_workspaces`
  WorkingMode mode;                                     ///< of the aspect
  int determinant_sign = 0;                             ///< likewise
  RegularShape shape = RegularShape::box;               ///< as asked
  std::vector<HeldCoordinate> center;                   ///< by free position [m]; empty where none was found
  std::vector<std::pair<std::string, double>> lengths;  ///< of the shape that is proved [m]
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const ShapeInAspect& answer) {
  visit({"aspect", "", "its id in the map"}, answer.found.aspect);
  visit({"working_mode", "", "signs of B_jj"}, answer.mode);
  visit({"determinant_sign", "", "of det A there"}, answer.determinant_sign);
  visit({"shape", "", "`box`, `square`, `disc`, `cylinder` or `ball`"}, answer.shape);
  visit({"center", "m", "of the shape that is proved, by free position; null where none was found"},
        only_if(!answer.center.empty(), answer.center));
  visit({"lengths", "m", "of that shape, by name: `radius`, `height`, `edge`, or `edge_x` and so on"},
        answer.lengths);
  visit({"lower", "m", "proved: the first of these lengths; 0 where none was found"}, answer.found.lower);
  visit({"upper", "m", "proved: no such shape in the aspect is larger"}, answer.found.upper);
  visit({"proved", "", "whether the gap between the two is as small as was asked for"}, answer.found.proved);
}

/// The largest shapes.
struct LargestShapeAnswer {
  TaskSpace task_space = TaskSpace::T2;   ///< of the robot
  std::shared_ptr<const AspectMap> map;   ///< that was asked; null in an answer of no meaning alone
  std::optional<MapSlice> slice;          ///< of the map
  bool loaded = false;                    ///< from the file
  WorkspaceQuestion question;             ///< what was asked of the map
  double gap = 0.0;                       ///< that was aimed at
  std::vector<ShapeInAspect> workspaces;  ///< one an aspect that was asked for

  const ShapeInAspect* best() const noexcept;  ///< the largest that is proved; null where none was found
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const LargestShapeAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"slice", "", "with {slice}: what is held and free, as for maps; else null"}, answer.slice);
  visit({"loaded", "", "whether the map is that of {load}"}, answer.loaded);
  visit({"shape", "", "`box`, `square`, `disc`, `cylinder` or `ball`"}, answer.question.shape);
  visit({"ratio", "",
         "edges of a box to each other, or height over diameter of a cylinder; empty for equal ones"},
        answer.question.ratio);
  visit({"angle", "rad", "`lower` and `upper` end of the angles that are asked for; null for all"},
        answer.question.angle);
  visit({"gap", "", "that is aimed at"}, answer.gap);
  visit({"best", "", "id of the aspect with the largest shape; null where there is none"},
        answer.best() != nullptr ? std::make_optional(answer.best()->found.aspect) : std::nullopt);
  visit({"workspaces", "", "one for each aspect that was asked for, as follows"}, answer.workspaces);
}

/// Looks for them.
Outcome<LargestShapeAnswer> answer(Session& session, const LargestShapeQuestion& question,
                                   const Control& control = {});

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_WORKSPACE_H
