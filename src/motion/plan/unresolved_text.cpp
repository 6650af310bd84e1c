// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/unresolved_text.h"

#include "aspects/map/gate_leaves.h"
#include "aspects/map/map_contents.h"
#include "aspects/tree/neighbour_leaves.h"
#include "model/message_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_looks = 500;  // leaves of a meeting that are examined
constexpr double least_sine = 1e-9;     // for a quotient

/// The two legs whose rows of A point most nearly the same way or opposite ways.
struct NearestRows {
  std::size_t one = 0, other = 0;
  double sine = 1.0;  // of the angle between them
};

NearestRows nearest_rows(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  TaskMatrix rows = homogenised_matrix(robot, pose, q);
  NearestRows nearest;
  for (Eigen::Index j = 0; j < rows.rows(); ++j) rows.row(j).normalize();
  for (Eigen::Index j = 0; j < rows.rows(); ++j)
    for (Eigen::Index k = j + 1; k < rows.rows(); ++k) {
      const double cosine = rows.row(j).dot(rows.row(k));
      const double sine = (rows.row(j) - cosine * rows.row(k)).norm();
      if (sine < nearest.sine) nearest = {static_cast<std::size_t>(j), static_cast<std::size_t>(k), sine};
    }
  return nearest;
}

/// Where leaves that lie at the one aspect share faces with leaves that lie at the other.
class Meeting {
 public:
  Meeting(const AspectMap& map, int first, int second)
      : map_(map.contents()), robot_(*map.manipulator()), first_(first), second_(second) {
    const Aspect& aspect = map_.aspects[static_cast<std::size_t>(first - 1)];
    mode_ = *mode_index(map_, aspect.mode);
    sign_ = aspect.determinant_sign;
  }

  std::string text(const MapControl& control) {
    find_leaves(control);
    const auto place = clearest();
    if (!place) return "";
    const WorkingMode mode = map_.modes[mode_];
    const JointVector q = inverse(robot_, *place, mode).q;
    const NearestRows rows = nearest_rows(robot_, *place, q);
    std::string text = " They meet in " + std::to_string(leaves_.size()) + " undecided leaves, as about " +
                       to_string(robot_.task_space(), *place) + ". There the parallel index is " +
                       number_text(parallel_index(robot_, *place, q), 2) +
                       ", and the rows of A of the legs '" + robot_.leg(rows.one).name + "' and '" +
                       robot_.leg(rows.other).name + "' are " +
                       number_text(std::asin(std::min(1.0, rows.sine)) * 180.0 / EIGEN_PI, 2) +
                       " degrees apart. Where aspects only touch, the smallest change of a length joins them "
                       "or parts them, so that no map decides.";
    return text;
  }

 private:
  void find_leaves(const MapControl& control) {
    const std::vector<int> nearest = nearest_aspects(map_, mode_, sign_, control);
    visit_faces(
        map_.tree, mode_,
        [&](NodeIndex a, NodeIndex b) {
          const bool meet = (nearest[a] == first_ && nearest[b] == second_) ||
                            (nearest[a] == second_ && nearest[b] == first_);
          if (!meet) return;
          for (const NodeIndex leaf : {a, b})
            if (map_.tree.state(leaf, mode_).is_undecided()) leaves_.push_back(leaf);
        },
        control);
    std::sort(leaves_.begin(), leaves_.end());
    leaves_.erase(std::unique(leaves_.begin(), leaves_.end()), leaves_.end());
  }

  /// The middle of a leaf with rows as near to each other as any, in proportion to how far from serial
  /// singularities it is; nothing where legs reach none.
  std::optional<Pose> clearest() const {
    std::optional<Pose> best;
    double largest = 0.0;
    const std::size_t step = leaves_.size() / max_looks + 1;
    for (std::size_t i = 0; i < leaves_.size(); i += step) {
      const Pose pose =
          map_.tree.space().pose({map_.tree.place(leaves_[i]).root, map_.tree.box(leaves_[i]).middle()});
      const InverseSolution solution = inverse(robot_, pose, map_.modes[mode_]);
      if (solution.status != InverseStatus::solved) continue;
      const double index = serial_indices(robot_, pose, solution.q).minCoeff() /
                           (nearest_rows(robot_, pose, solution.q).sine + least_sine);
      if (index > largest) largest = index, best = pose;
    }
    return best;
  }

  const AspectMap::Contents& map_;
  const Manipulator& robot_;
  int first_, second_;
  std::size_t mode_ = 0;
  int sign_ = 1;
  std::vector<NodeIndex> leaves_;  // rising
};

}  // namespace

std::string unresolved_text(const AspectMap& map, int first, int second, const MapControl& control) {
  const Aspect& aspect = map.aspects()[static_cast<std::size_t>(first - 1)];
  return "in " + to_string(aspect.mode) + " the map cannot decide whether aspects " +
         std::to_string(std::min(first, second)) + " and " + std::to_string(std::max(first, second)) +
         " are one." + Meeting(map, first, second).text(control);
}

}  // namespace parallel_aspects
