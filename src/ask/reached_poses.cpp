// SPDX-License-Identifier: BSD-3-Clause
#include "ask/reached_poses.h"

#include "aspects/constraints/constraint_clearance.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <set>

namespace parallel_aspects::ask {
namespace {

constexpr int samples_where_flooded = 4000;
constexpr int most_looks = 12000;   // at poses of one grid
constexpr int most_grids = 6;       // that are tried
constexpr double cells_across = 3;  // of the range of one coordinate alone, at first
constexpr double enough_finer = 1.3;
constexpr double steps_along = 200.0;  // of the range that one coordinate is searched for in
constexpr int halvings = 30;
constexpr int pushes = 1000;
constexpr std::uint64_t flood_seed = 1;

// Of passive joints too, and all else that bounds the robot; margins are of what happens there.
bool keeps_constraints(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const ConstraintKinds kinds = manipulator.constraint_kinds();
  return std::all_of(all_constraint_kinds.begin(), all_constraint_kinds.end(), [&](ConstraintKind kind) {
    return !kinds[index_of(kind)] || kind == ConstraintKind::margins ||
           constraint_clearance(manipulator, kind, pose, q) >= 0.0;
  });
}

Eigen::Index turns_in(TaskSpace space) {
  return static_cast<Eigen::Index>(rotational_degrees_of_freedom(space));
}

// From -1 to 1, the same on every platform.
double signed_uniform(std::mt19937_64& random) {
  return 2.0 * std::ldexp(static_cast<double>(random() >> 11U), -53) - 1.0;
}

// Poses by what is farthest of them: one for each end of each coordinate of the operational point.
struct FarthestPoses {
  explicit FarthestPoses(const Pose& first) { poses.fill(first); }

  // By how much it is farther than that end.
  static double beyond(const Pose& pose, const Pose& end, std::size_t which) {
    const auto axis = static_cast<Eigen::Index>(which / 2);
    const double more = pose.position[axis] - end.position[axis];
    return which % 2 == 0 ? more : -more;
  }

  void add(const Pose& pose) {
    for (std::size_t end = 0; end < poses.size(); ++end)
      if (beyond(pose, poses[end], end) > 0.0) poses[end] = pose;
  }

  std::array<Pose, 6> poses;
  int drawn = 0, count = 0;
};

// Which cell of a grid, by its coordinates.
using Cell = std::array<std::int32_t, max_legs>;

class Flood {
 public:
  Flood(const Manipulator& manipulator, const Pose& home, TaskVector steps)
      : manipulator_(manipulator), home_(home), steps_(std::move(steps)) {}

  // False where there are more poses than may be examined.
  bool run() {
    std::vector<Cell> open{Cell{}};
    seen_.insert(Cell{});
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      reached_.push_back(cell);
      for (Eigen::Index i = 0; i < steps_.size(); ++i)
        for (const int way : {-1, 1}) {
          Cell next = cell;
          next[static_cast<std::size_t>(i)] += way;
          if (!seen_.insert(next).second) continue;
          if (looks() > most_looks) return false;
          const auto pose = pose_at(twist_of(next));
          if (pose && is_reached(manipulator_, *pose)) open.push_back(next);
        }
    }
    return true;
  }

  int looks() const { return static_cast<int>(seen_.size()); }
  const TaskVector& steps() const { return steps_; }

  /// Random poses where the flood has been.
  FarthestPoses sampled() const {
    FarthestPoses result(home_);
    for (const Cell& cell : reached_) result.add(*pose_at(twist_of(cell)));
    std::mt19937_64 random(flood_seed);
    for (; result.drawn < samples_where_flooded; ++result.drawn) {
      TaskVector twist = twist_of(reached_[random() % reached_.size()]);
      for (Eigen::Index i = 0; i < twist.size(); ++i) twist[i] += 0.5 * signed_uniform(random) * steps_[i];
      const auto pose = pose_at(twist);
      if (!pose || !is_reached(manipulator_, *pose)) continue;
      ++result.count;
      result.add(*pose);
    }
    return result;
  }

 private:
  TaskVector twist_of(const Cell& cell) const {
    TaskVector twist = steps_;
    for (Eigen::Index i = 0; i < twist.size(); ++i) twist[i] *= cell[static_cast<std::size_t>(i)];
    return twist;
  }

  // Nothing beyond half a turn, where orientations come again.
  std::optional<Pose> pose_at(const TaskVector& twist) const {
    const TaskSpace space = manipulator_.task_space();
    if (twist.head(turns_in(space)).norm() > EIGEN_PI) return std::nullopt;
    return displaced(manipulator_.motions(), home_, twist);
  }

  const Manipulator& manipulator_;
  const Pose& home_;
  TaskVector steps_;
  std::set<Cell> seen_;
  std::vector<Cell> reached_;
};

// How far an entry of the twist may go.
double farthest(const Manipulator& manipulator, Eigen::Index entry) {
  return entry < turns_in(manipulator.task_space()) ? EIGEN_PI : 2.0 * manipulator.size();
}

// By random steps of about `steps`, longer after each that goes on.
void push_on(const Manipulator& manipulator, const TaskVector& steps, FarthestPoses& farthest) {
  std::mt19937_64 random(flood_seed);
  for (std::size_t end = 0; end < 2 * directions(manipulator.task_space()); ++end) {
    double length = 0.5;
    for (int k = 0; k < pushes; ++k) {
      TaskVector twist = length * steps;
      for (Eigen::Index i = 0; i < twist.size(); ++i) twist[i] *= signed_uniform(random);
      const Pose pose = displaced(manipulator.motions(), farthest.poses[end], twist);
      const bool goes_on = FarthestPoses::beyond(pose, farthest.poses[end], end) > 0.0;
      if (!goes_on) continue;
      const bool reached = is_reached(manipulator, pose);
      if (reached) farthest.poses[end] = pose;
      length = std::clamp(length * (reached ? 1.5 : 0.9), 1e-4, 1.0);
    }
  }
}

double reach_along(const Manipulator& manipulator, const Pose& home, Eigen::Index entry, double way) {
  const auto reaches = [&](double amount) {
    TaskVector twist = TaskVector::Zero(static_cast<Eigen::Index>(manipulator.leg_count()));
    twist[entry] = way * amount;
    return is_reached(manipulator, displaced(manipulator.motions(), home, twist));
  };
  const double end = farthest(manipulator, entry), step = end / steps_along;
  double inside = 0.0, outside = step;
  while (outside <= end && reaches(outside)) {
    inside = outside;
    outside += step;
  }
  if (outside > end) return inside;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (inside + outside);
    (reaches(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

bool is_reached(const Manipulator& manipulator, const Pose& pose) {
  const auto solutions = inverse_in_all_modes(manipulator, pose);
  return std::any_of(solutions.begin(), solutions.end(), [&](const InverseSolution& solution) {
    return solution.status == InverseStatus::solved && keeps_constraints(manipulator, pose, solution.q);
  });
}

std::vector<CoordinateRange> ranges_alone(const Manipulator& manipulator, const Pose& home) {
  std::vector<CoordinateRange> ranges;
  for (Eigen::Index entry = 0; entry < static_cast<Eigen::Index>(manipulator.leg_count()); ++entry)
    ranges.push_back(
        {-reach_along(manipulator, home, entry, -1.0), reach_along(manipulator, home, entry, 1.0)});
  return ranges;
}

ReachedPoses flooded_from(const Manipulator& manipulator, const Pose& home) {
  const auto count = static_cast<Eigen::Index>(manipulator.leg_count());
  TaskVector steps(count);
  const std::vector<CoordinateRange> alone = ranges_alone(manipulator, home);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CoordinateRange& range = alone[static_cast<std::size_t>(i)];
    steps[i] = std::max(range.upper - range.lower, 1e-6 * farthest(manipulator, i)) / cells_across;
  }
  std::optional<Flood> best;
  bool has_ended = false;
  for (int grid = 0; grid < most_grids; ++grid) {
    Flood flood(manipulator, home, steps);
    const bool ended = flood.run();
    const double finer =
        std::pow(static_cast<double>(most_looks) / flood.looks(), 1.0 / static_cast<double>(count));
    if (!ended && has_ended) break;
    best.emplace(std::move(flood));
    has_ended = ended;
    if (ended && finer < enough_finer) break;
    steps *= ended ? 1.0 / (0.9 * finer) : 1.5;
  }
  FarthestPoses farthest = best->sampled();
  push_on(manipulator, best->steps(), farthest);
  ReachedPoses result;
  result.drawn = farthest.drawn;
  result.count = farthest.count;
  for (const Pose& pose : farthest.poses) result.positions.extend(pose.position);
  return result;
}

}  // namespace parallel_aspects::ask
