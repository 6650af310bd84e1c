// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_CONSTRAINTS_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_CONSTRAINTS_REPORT_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/manipulator.h"
#include "tools/report/answer_json.h"
#include "tools/report/report.h"

#include <string>

namespace parallel_aspects::tools {

/// What bounds the aspects of a map besides singularities, and the working modes that it leaves empty: the
/// last lines of `aspects map`, and fields of its object. Where `verbose`, notes have every name.
Report report_bounds(const AspectMap& map, bool verbose = false);

/// Which constraints bound the aspects of a manipulator: the last lines of `aspects connect` and of roadmaps,
/// and fields of their objects.
Report report_constraints(const Manipulator& manipulator, bool verbose = false);

/// An answer: its fields, and the text with the constraints below it, where `verbose` with every name.
template <class Answer>
Report constrained_report(const Manipulator& robot, const Answer& answer, const std::string& text,
                          bool verbose = false) {
  const Report constraints = report_constraints(robot, verbose);
  Report report{answer_json(robot, answer), text + constraints.text};
  report.json["mechanism"] = robot.name();
  report.json.update(constraints.json);
  return report;
}

/// The cones that the rods of a manipulator must stay in, those of universal joints among them: a line each,
/// or where it is not `verbose` one for all of the same angle.
std::string cones_text(const Manipulator& manipulator, bool verbose);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_CONSTRAINTS_REPORT_H
