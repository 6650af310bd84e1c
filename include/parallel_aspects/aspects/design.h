// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_DESIGN_H
#define PARALLEL_ASPECTS_ASPECTS_DESIGN_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/regular_workspace.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// A length or coordinate of a robot by which designs differ. Legs are counted from 1:
///  - `crank_1`, `rod_1`: links of a leg; `inner_1`, `outer_1` with an actuated elbow;
///  - `base_1_x`, `base_1_y`, `base_1_z`: its base point in the task frame, on a rail the point at q = 0;
///  - `anchor_1_x` and so on: its anchor in the platform frame.
struct DesignParameter {
  std::string name;               ///< as above
  double value = 0.0;             ///< [m]
  std::vector<std::string> tied;  ///< those that symmetries of the robot, as maps use them, let follow
};

/// Values of some parameters, by name [m].
using DesignValues = std::vector<std::pair<std::string, double>>;

/// All parameters of a robot, leg by leg. Names without a number, as `crank`, stand for those of all legs.
std::vector<DesignParameter> design_parameters(const Manipulator& manipulator);

/// Why parameters of these names cannot be set together: unknown names, the same one twice, or, where ties
/// are kept, two that are tied to each other.
Problems problems_of(const Manipulator& manipulator, const std::vector<std::string>& names,
                     bool keep_ties = true);

/// The robot with these values; where ties are kept, what is tied to them follows. There must be no
/// `problems_of` the names. Throws `InvalidDescription` where there is no such robot.
std::shared_ptr<const Manipulator> with_design(const Manipulator& manipulator, const DesignValues& values,
                                               bool keep_ties = true);

/// What a row of a sweep reports of a design.
struct DesignQuestion {
  bool count = true;                             ///< how many aspects there are
  bool measures = false;                         ///< how large they are
  bool clearance = false;                        ///< how far from singularities and limits one can be
  std::optional<WorkspaceQuestion> workspace{};  ///< how large a regular shape one of them holds
  double gap = 0.05;                             ///< that is aimed at for it
  MapOptions map{};                              ///< of each design
};

/// How a design was examined.
enum class DesignStatus {
  mapped,       ///< there are figures
  refused,      ///< there is no robot with these values
  unassembled,  ///< its legs reach no common pose
  not_mapped,   ///< its map is refused, as one that takes too many boxes
  cancelled     ///< it was not examined to its end
};

/// Figures of a design. They depend on nothing but the robot and the question.
struct DesignFigures {
  DesignStatus status = DesignStatus::cancelled;  ///< how it was examined
  std::string message;                            ///< why, unless mapped

  /// In the order of `figure_names`, all of them where mapped; nothing where a figure is not known.
  std::vector<std::optional<double>> values;
};

/// What figures a question asks for: of `count` `aspects_at_least`, `aspects_at_most` and `components`; of
/// `measures` `measure_lower` and `measure_undecided`, over all aspects and working modes, and
/// `largest_lower` and `largest_upper` of the largest aspect, in the unit of the map; of `clearance`
/// `clearance` [m]; of `workspace` `workspace_lower` and `workspace_upper` [m]. All bounds are proved.
std::vector<std::string> figure_names(const DesignQuestion& question);

/// The figures of a robot.
DesignFigures figures_of(const std::shared_ptr<const Manipulator>& manipulator,
                         const DesignQuestion& question, const MapControl& control = {});

/// "mapped", "refused", "unassembled", "not_mapped" or "cancelled".
const char* name(DesignStatus status) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_DESIGN_H
