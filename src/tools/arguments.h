// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_ARGUMENTS_H
#define PARALLEL_ASPECTS_TOOLS_ARGUMENTS_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/singularity/indices.h"
#include "tools/command.h"
#include "tools/subcommands.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// The pose that `text` gives, in the order of `coordinate_names(space)`; where it gives none, messages that
/// name `option` are added to `problems` and the pose is of no meaning.
Pose parse_pose(const std::string& option, TaskSpace space, const std::string& text, Problems& problems);

/// A working mode such as "(+,-)" or "+-"; nothing, with a message, for any other text.
std::optional<WorkingMode> parse_mode(const std::string& option, const Manipulator& manipulator,
                                      const std::string& text, Problems& problems);

/// Some working modes, such as "(+,-) (-,-)"; nothing where the text is empty.
std::vector<WorkingMode> parse_modes(const std::string& option, const Manipulator& manipulator,
                                     const std::string& text, Problems& problems);

/// The slice that `text` describes, such as "z=1.3 roll=0": what is held, separated by blanks or commas (see
/// `make_slice`).
MapSlice parse_slice(const std::string& option, const Manipulator& manipulator, const std::string& text,
                     Problems& problems);

/// A section of a map of three coordinates, in quotes, that leaves two free and holds the pose, or one with
/// angles of zero where the robot comes there: "phi=0", or of SO3 "torsion=0".
std::string example_of_section(const Manipulator& manipulator, const Pose& pose);

/// A slice that does, likewise: of SE3 "z=1 roll=0 pitch=0 yaw=0". Empty where a slice leaves one or three,
/// as in SO3.
std::string example_of_plane(const Manipulator& manipulator, const Pose& pose);

/// Numbers with blanks, commas or colons between them, such as "1:2".
std::vector<double> parse_ratio(const std::string& option, std::string text, Problems& problems);

/// Values by name, such as "x=1 y=2", separated by blanks or commas.
std::vector<HeldCoordinate> parse_values(const std::string& option, const std::string& text,
                                         Problems& problems);

/// Ranges by name, such as "x=-5:5 phi=0:1", likewise.
std::vector<ask::NamedRange> parse_ranges(const std::string& option, const std::string& text,
                                          Problems& problems, const std::string& example = "\"x=-1:1\"");

/// The margins that `text` gives, such as "parallel=0.05 serial=0.1", separated by blanks or commas; those
/// that it does not name are as in `others`.
Margins parse_margins(const std::string& option, std::string text, const Margins& others, Problems& problems);

/// Which constraints bound the aspects, and of robots within which tolerance, as text from the command line;
/// empty where not given.
struct ConstraintArguments {
  std::string only, without, margins, tolerance;
};

/// `--constraint LIST`, `--no-constraint LIST`, `--margin LIST` and `--tolerance SHARE`, which fill
/// `arguments`.
std::vector<Option> constraint_options(ConstraintArguments& arguments);

/// The manipulator with the constraints and the tolerance that are chosen; by default those that its
/// description states. Throws `InvalidDescription` with every problem.
std::shared_ptr<const Manipulator> choose_constraints(std::shared_ptr<const Manipulator> manipulator,
                                                      const ConstraintArguments& arguments);

/// Of a robot with this choice: direct solutions are those of one robot, so that none has a tolerance.
void refuse_tolerance(const ConstraintArguments& arguments, const Manipulator& robot, Problems& problems);

/// Likewise, and cusps and regions of actuated values are bounded by limits of actuated joints alone.
void refuse_other_bounds(const ConstraintArguments& arguments, const Manipulator& robot, Problems& problems);

/// What is sampled for a roadmap, as text from the command line; empty where not given.
struct RoadmapArguments {
  std::string samples, seed;
};

RoadmapOptions parse_roadmap(const RoadmapArguments& arguments, Problems& problems);

/// Computes it, with a progress bar on a terminal. Throws `Interrupted`, or `InvalidDescription` where it is
/// refused.
std::shared_ptr<const PoseRoadmap> compute_roadmap(std::shared_ptr<const Manipulator> manipulator,
                                                   const RoadmapOptions& options,
                                                   const Surroundings& surroundings);

/// The same as a part of a computation that is shown.
std::shared_ptr<const PoseRoadmap> compute_roadmap(std::shared_ptr<const Manipulator> manipulator,
                                                   const RoadmapOptions& options, const MapControl& control);

/// The range of an actuated joint that `text` names, such as "strut_1_joint=10:32", or the name alone: within
/// its limits. Messages name `option`.
HeldRange parse_held_range(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems);

/// The actuated joint that `text` holds, such as "crank_1_joint=0.3".
HeldJoint parse_held_joint(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_ARGUMENTS_H
