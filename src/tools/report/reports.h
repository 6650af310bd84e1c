// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_REPORTS_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_REPORTS_H

#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "tools/report/report.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What each subcommand says about a result. Pure functions; the fields are documented in
/// docs/reference/command.md.
namespace parallel_aspects::tools {

/// How much the text says.
struct MapReportOptions {
  bool all_aspects = false;  ///< lists those below 1 % of the largest too, which are one line otherwise
  bool verbose = false;      ///< lists every joint that a note is about
};

/// How many aspects there are, claiming no more than is proved: "exactly 10 aspects (proved)".
std::string aspect_count(const AspectMap& map);

/// Those that ask something, by name.
nlohmann::json json_margins(const Margins& margins);

/// `aspects map`: the table of aspects, and what is proved and what is not.
Report report_map(const ask::MapAnswer& answer, const MapReportOptions& options);

/// `aspects map --neighbours`: the pairs of aspects that touch.
std::string neighbours_text(const ask::MapAnswer& answer);

/// `aspects map` with six degrees of freedom: samples and components by working mode and sign of det A.
Report report_roadmap(const Manipulator& robot, const ask::MapAnswer& answer, bool verbose);

/// `aspects describe`: what was recognised in the description of the robot; where `verbose`, with every name
/// in its notes.
Report report_mechanism(const std::shared_ptr<const Mechanism>& mechanism, bool verbose = false);

/// `aspects robots`: names of the shipped robots.
Report report_robots(const std::vector<std::string>& names);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_REPORTS_H
