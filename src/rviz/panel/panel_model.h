// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_PANEL_MODEL_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_PANEL_MODEL_H

#include "model/spherical_links.h"
#include "parallel_aspects/tracking/hazards.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/AssemblyCandidates.h>
#include <parallel_aspects/ListAspects.h>
#include <parallel_aspects/MapProgress.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Distances below which a node says WARN or STOP, in `NodeView::unit`; 0 for none.
struct LevelThresholds {
  double warn = 0.0;
  double stop = 0.0;
};

/// What was last heard of one node. What the panel shows is made of this alone.
struct NodeView {
  std::string node;            ///< its name; empty where none is chosen
  bool master_answers = true;  ///< whether there is a ROS master
  bool connected = false;      ///< whether the node publishes its state
  bool hears = false;          ///< whether it listens to goals for maps, and to what cancels them
  bool read_only = false;      ///< whether it refuses what changes it
  double silence = 0.0;        ///< since its last state [s]
  std::uint64_t start = 0;     ///< counts the times that the node started anew or loaded another robot
  std::optional<AspectState> state;
  std::array<LevelThresholds, 3> thresholds;  ///< by `Hazard`
  DistanceUnit unit;                          ///< of displayed distances and of thresholds
  double largest_distance = 0.0;              ///< that was seen, of any hazard: a length [m] in either unit
  std::vector<AspectTransition> transitions;  ///< the last ones, the oldest first
  AssemblyCandidates candidates;
  std::optional<MapProgress> progress;
  bool map_goal_runs = false;                            ///< of ~compute_map
  std::shared_ptr<const ListAspects::Response> aspects;  ///< null until known
  std::shared_ptr<const std::map<std::uint32_t, double>>
      deepest_index;           ///< by id: 1/condition number; may be null
  std::uint32_t selected = 0;  ///< id of the aspect that was clicked last in the display; 0 for none
  std::uint64_t clicks = 0;    ///< how many there were
  std::string last_answer;     ///< of the last service or action that a button asked for
};

/// How something is coloured.
enum class SafetyLevel : std::uint8_t { clear, warn, stop, unknown };

/// What is to be read first.
struct Banner {
  SafetyLevel safety = SafetyLevel::unknown;
  std::string title;  ///< one word or two
  std::string text;
};

Banner banner_of(const NodeView& view);

/// Of uniqueness domains, in one line; without a text where there is nothing to say.
struct DomainLine {
  SafetyLevel safety = SafetyLevel::unknown;
  std::string text;
  std::string tip;  ///< what it means
};

DomainLine domain_line_of(const NodeView& view);

/// One distance, to be drawn as a bar.
struct DistanceGauge {
  std::string name;
  SafetyLevel safety = SafetyLevel::unknown;
  double lower = 0.0;  ///< proved, as a share of the bar, 0 to 1; not a number where not known
  double upper = 0.0;  ///< of the witness, likewise
  double warn = 0.0;   ///< thresholds, likewise; 0 for none
  double stop = 0.0;
  std::string text;  ///< such as "0.312 m, shrinks 0.05 m/s"
  std::string tip;   ///< both bounds and the thresholds
};

/// By `Hazard`, on one scale, so that the shortest bar is the nearest hazard.
std::array<DistanceGauge, 3> gauges_of(const NodeView& view);

/// The length of the scale of `gauges_of`: 1, 2 or 5 times a power of ten, in `NodeView::unit`.
double scale_of(const NodeView& view);

/// A line of the list of transitions.
struct EventLine {
  std::string time;  ///< "14:03:05.123", local time
  std::string text;
};

/// The newest first.
std::vector<EventLine> events_of(const NodeView& view);

/// One of the assembly modes to choose from.
struct CandidateLine {
  std::string name;         ///< as in the pictures, where it has `color`
  std::uint32_t color = 0;  ///< 0xRRGGBB
  std::string branch;       ///< working mode and sign of det A
  std::string text;         ///< the pose, and the aspect where it is known
};

/// Empty while the robot is followed.
std::vector<CandidateLine> candidates_of(const NodeView& view);

/// How far the map is.
struct MapLine {
  std::string text;
  double share = 0.0;  ///< 0 to 1
  bool runs = false;
};

MapLine map_line_of(const NodeView& view);

/// Whether a button may be pressed, and if not, why.
struct Permission {
  std::string refusal;  ///< empty where it may

  explicit operator bool() const noexcept { return refusal.empty(); }
};

Permission may_ask(const NodeView& view);          ///< anything
Permission may_choose(const NodeView& view);       ///< an assembly mode
Permission may_compute_map(const NodeView& view);  ///< or cancel it
Permission may_cancel_map(const NodeView& view);

/// "(+,-), det A > 0"
std::string branch_of(const std::vector<std::int8_t>& working_mode, int determinant_sign);

/// "(+,-)"; "any" without signs.
std::string mode_of(const std::vector<std::int8_t>& working_mode);

/// "x 4.5, y 8, phi 0.3", in m and rad; angles only where the platform has turned. Of a wrist, which does not
/// move, the angles alone.
std::string pose_of(const geometry_msgs::Pose& pose, DistanceUnit unit = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_PANEL_MODEL_H
