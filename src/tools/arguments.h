// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_ARGUMENTS_H
#define PARALLEL_ASPECTS_TOOLS_ARGUMENTS_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/map_slice.h"
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
Pose parse_pose(const std::string& option, const Motions& motions, const std::string& text,
                Problems& problems);

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

/// Values by name, such as "x=1 y=2", separated by blanks or commas. Messages give the example.
std::vector<HeldCoordinate> parse_values(const std::string& option, const std::string& text,
                                         Problems& problems, const std::string& example = "\"x=0.5\"");

/// Ranges by name, such as "x=-5:5 phi=0:1", likewise.
std::vector<ask::NamedRange> parse_ranges(const std::string& option, const std::string& text,
                                          Problems& problems, const std::string& example = "\"x=-1:1\"");

/// The range of an actuated joint that `text` names, such as "strut_1_joint=10:32", or the name alone: within
/// its limits. Messages name `option`.
HeldRange parse_held_range(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems);

/// The actuated joint that `text` holds, such as "crank_1_joint=0.3".
HeldJoint parse_held_joint(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_ARGUMENTS_H
