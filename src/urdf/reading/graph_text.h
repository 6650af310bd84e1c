// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_GRAPH_TEXT_H
#define PARALLEL_ASPECTS_URDF_READING_GRAPH_TEXT_H

#include "urdf/reading/robot_graph.h"

#include <string>

namespace parallel_aspects {

/// The graph as a URDF of its spanning tree, with elements of this package for what a URDF cannot express:
/// <loop_closure>, which `dialects::equality` and `dialects::sdf_joint` read, <actuated_joint name/> and
/// <reader_note text/>. What these cannot express either is added to the graph's problems. A joint of several
/// axes becomes revolute joints, about fixed axes of the child one after the other.
std::string urdf_text(RobotGraph& graph, const std::string& file);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_GRAPH_TEXT_H
