// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/cusp_loops.h"

#include "model/angles.h"
#include "motion/shortest_paths.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

constexpr int width = 180;     // of the grid, in each coordinate
constexpr int most_turns = 2;  // around the cusp, either way
constexpr int sides = 2 * most_turns + 1;
constexpr int looks = 16;             // along a segment
constexpr int most_tries = 20;        // each with a pose fewer, from which no segment was proved
constexpr double nearly_all = 0.999;  // of the room that a way has
constexpr double longest_turn = 0.49 * pi;

constexpr std::size_t start_node = 0;

std::size_t node_at(int x, int y) {
  const auto around = [](int i) { return static_cast<std::size_t>((i % width + width) % width); };
  return around(x) * width + around(y);
}

int x_of(std::size_t node) { return static_cast<int>(node) / width; }
int y_of(std::size_t node) { return static_cast<int>(node) % width; }

Vector2d coordinates(const AnchorCircle& circle, const Pose& pose) {
  const Vector2d rod = circle.rod(pose);
  return {std::atan2(rod.y(), rod.x()), 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w())};
}

}  // namespace

// Of the equations of the legs over the lengths of their rods: two solutions meet where what the errors of
// the joints add to them is more than half of the squared slope over the curvature, which is that of the
// shortest rod.
double room_at(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  const SingularityIndices indices = singularity_indices(robot, pose, q);
  double shortest = std::numeric_limits<double>::infinity(), errors = 0.0;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    const Leg& leg = robot.leg(j);
    const double rod = (pose.transform(leg.anchor) - leg.proximal_point(q[k])).norm();
    shortest = std::min(shortest, rod);
    errors = std::max(errors, std::abs(indices.inverse_diagonal[k]) / rod);
  }
  return 0.5 * indices.smallest_singular_value * indices.smallest_singular_value * shortest / errors;
}

std::array<Eigen::Index, 2> free_legs(std::size_t held) { return {held == 0 ? 1 : 0, held == 2 ? 1 : 2}; }

/// A search over nodes and passes of the cut. A way ends next to the goal when it has gone around the cusp.
class CuspLoops::Search {
 public:
  /// The cost of a way that goes on to a node with this room.
  using Longer = std::function<double(double cost, double room)>;

  struct Way {
    double cost = 0.0;
    std::vector<std::size_t> nodes;  // empty where there is none
  };

  Search(const CuspLoops& loops, const JointVector& cusp, const Pose& goal)
      : loops_(loops), cusp_(cusp), goal_values_(loops.values(goal)), ends_(loops.around(goal)) {}

  Way run(const Longer& longer, double least_room) const {
    ShortestPaths<double> paths;
    paths.enter(start_node * sides + most_turns, no_graph_node, longer(0.0, loops_.nodes_[start_node].room));
    for (std::size_t at = paths.take(); at != no_graph_node; at = paths.take()) {
      if (is_end(at)) return {paths.cost(at), nodes_of(paths.path_to(at))};
      for (const std::size_t node : loops_.neighbours(at / sides)) {
        const auto next = state_at(node, at);
        if (!next || loops_.nodes_[node].room < least_room) continue;
        paths.enter(*next, at, longer(paths.cost(at), loops_.nodes_[node].room));
      }
    }
    return {};
  }

 private:
  static int turns_of(std::size_t state) { return static_cast<int>(state % sides) - most_turns; }

  std::optional<std::size_t> state_at(std::size_t node, std::size_t from) const {
    const Node &before = loops_.nodes_[from / sides], &behind = loops_.nodes_[node];
    if (!(behind.room > 0.0)) return std::nullopt;
    const int turns = turns_of(from) + loops_.passes_cut(before.q, behind.q, cusp_);
    if (std::abs(turns) > most_turns) return std::nullopt;
    return node * sides + static_cast<std::size_t>(turns + most_turns);
  }

  bool is_end(std::size_t state) const {
    const std::size_t node = state / sides;
    return std::find(ends_.begin(), ends_.end(), node) != ends_.end() &&
           turns_of(state) + loops_.passes_cut(loops_.nodes_[node].q, goal_values_, cusp_) != 0;
  }

  static std::vector<std::size_t> nodes_of(std::vector<std::size_t> states) {
    for (std::size_t& state : states) state /= sides;
    return states;
  }

  const CuspLoops& loops_;
  const JointVector& cusp_;
  JointVector goal_values_;
  std::vector<std::size_t> ends_;
};

CuspLoops::CuspLoops(const AspectMap& map, const MapSegments& segments, const WorkingMode& mode, int aspect,
                     const Pose& from, const MapControl& control)
    : map_(map),
      segments_(segments),
      robot_(*map.manipulator()),
      mode_(mode),
      aspect_(aspect),
      sign_(map.aspects()[static_cast<std::size_t>(aspect - 1)].determinant_sign),
      from_(from),
      circle_(circle_of_anchor(robot_, *map.slice()->joint)),
      legs_(free_legs(map.slice()->joint->leg)),
      origin_(coordinates(circle_, from)),
      nodes_(static_cast<std::size_t>(width) * width) {
  fill(control);
}

void CuspLoops::fill(const MapControl& control) {
  for (std::size_t node = 0; node < nodes_.size() && !is_cancelled(control); ++node) {
    const Pose at = pose(node);
    if (map_.locate(at, mode_).aspect != aspect_) continue;
    nodes_[node].q = values(at);
    nodes_[node].room = room_at(robot_, at, nodes_[node].q);
  }
}

Pose CuspLoops::pose(std::size_t node) const {
  if (node == start_node) return from_;
  constexpr double step = 2.0 * pi / width;
  return circle_.pose(origin_.x() + step * x_of(node), origin_.y() + step * y_of(node));
}

// NaN where the pose is out of reach.
JointVector CuspLoops::values(const Pose& pose) const {
  const InverseSolution found = inverse(robot_, pose, mode_);
  if (found.status != InverseStatus::out_of_reach) return found.q;
  return JointVector::Constant(static_cast<Eigen::Index>(robot_.leg_count()), std::nan(""));
}

/// The four nodes next to a pose.
std::vector<std::size_t> CuspLoops::around(const Pose& pose) const {
  const Vector2d at = (coordinates(circle_, pose) - origin_) * (width / (2.0 * pi));
  const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
  return {node_at(x, y), node_at(x + 1, y), node_at(x, y + 1), node_at(x + 1, y + 1)};
}

std::array<std::size_t, 8> CuspLoops::neighbours(std::size_t node) const {
  const int x = x_of(node), y = y_of(node);
  return {node_at(x - 1, y),     node_at(x + 1, y),     node_at(x, y - 1),     node_at(x, y + 1),
          node_at(x - 1, y - 1), node_at(x - 1, y + 1), node_at(x + 1, y - 1), node_at(x + 1, y + 1)};
}

/// The cut goes down from the cusp; for angles it is half a turn long. 1 where it is passed
/// counter-clockwise.
int CuspLoops::passes_cut(const JointVector& from, const JointVector& to, const JointVector& cusp) const {
  const auto off = [&](const JointVector& q) {
    Vector2d difference;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Index leg = legs_[static_cast<std::size_t>(axis)];
      difference[axis] = q[leg] - cusp[leg];
      if (robot_.leg(static_cast<std::size_t>(leg)).actuated_by_angle())
        difference[axis] = std::remainder(difference[axis], 2.0 * pi);
    }
    return difference;
  };
  const Vector2d a = off(from), b = off(to);
  if ((a.x() < 0.0) == (b.x() < 0.0)) return 0;
  const bool is_angle = robot_.leg(static_cast<std::size_t>(legs_[0])).actuated_by_angle();
  if (is_angle && std::abs(a.x() - b.x()) > pi) return 0;  // where the angle begins anew
  const double height = a.y() + (b.y() - a.y()) * a.x() / (a.x() - b.x());
  return height >= 0.0 ? 0 : a.x() < 0.0 ? 1 : -1;
}

/// Whether the straight segment has that much room, passes the cut as often, and is proved.
bool CuspLoops::keeps(const Pose& from, const Pose& to, double room, int passes,
                      const JointVector& cusp) const {
  if (segments_.turn(from, to) > longest_turn) return false;
  JointVector last = values(from);
  for (int i = 1; i <= looks; ++i) {
    const Pose at = segments_.between(from, to, i / double{looks});
    const JointVector q = values(at);
    if (!q.allFinite() || room_at(robot_, at, q) < room) return false;
    passes -= passes_cut(last, q, cusp);
    last = q;
  }
  return passes == 0 && segments_.is_free(from, to, mode_, sign_);
}

/// With the longest segments that keep the room. Empty where one from a node to the next is not proved: that
/// node is `barred`.
std::vector<Pose> CuspLoops::shortened_beside_cusp(const std::vector<Pose>& poses, double room,
                                                   const JointVector& cusp,
                                                   std::optional<std::size_t>& barred) const {
  std::vector<int> passes(poses.size(), 0);  // up to each
  for (std::size_t i = 1; i < poses.size(); ++i)
    passes[i] = passes[i - 1] + passes_cut(values(poses[i - 1]), values(poses[i]), cusp);
  std::vector<Pose> result{poses.front()};
  for (std::size_t i = 0; i + 1 < poses.size();) {
    std::size_t next = poses.size() - 1;
    while (next > i + 1 && !keeps(poses[i], poses[next], room, passes[next] - passes[i], cusp))
      next = i + std::max<std::size_t>(1, (next - i) * 3 / 4);
    if (next == i + 1 && !segments_.is_free(poses[i], poses[next], mode_, sign_)) {
      barred = next + 1 < poses.size() ? next : i;
      return {};
    }
    result.push_back(poses[next]);
    i = next;
  }
  return result;
}

std::vector<Pose> CuspLoops::find(const JointVector& cusp, const Pose& goal) {
  for (int i = 0; i < most_tries; ++i) {
    const Search search(*this, cusp, goal);
    const Search::Way widest =
        search.run([](double cost, double room) { return std::max(cost, 1.0 / room); }, 0.0);
    if (widest.nodes.empty()) return {};
    const double enough = nearly_all / widest.cost;
    const double least = std::min(enough, nearly_all * room_at(robot_, goal, values(goal)));
    const Search::Way way = search.run([](double cost, double room) { return cost + 1.0 / room; }, enough);
    std::vector<Pose> poses;
    for (const std::size_t node : way.nodes) poses.push_back(pose(node));
    poses.push_back(goal);
    std::optional<std::size_t> barred;
    std::vector<Pose> found = shortened_beside_cusp(poses, least, cusp, barred);
    if (!barred) return found;
    if (*barred == 0) return {};
    nodes_[way.nodes[*barred]].room = 0.0;
  }
  return {};
}

}  // namespace parallel_aspects
