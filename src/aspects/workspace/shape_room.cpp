// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/workspace/shape_room.h"

#include "aspects/tree/pose_tree.h"
#include "interval/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

Interval squared(const Interval& a) { return square(a); }
double squared(double a) { return a * a; }
Interval rooted(const Interval& a) { return square_root(a); }
double rooted(double a) { return std::sqrt(a); }
Interval larger_of(const Interval& a, const Interval& b) {
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}
double larger_of(double a, double b) { return std::max(a, b); }
Interval smaller_of(const Interval& a, const Interval& b) {
  return {std::min(a.lower(), b.lower()), std::min(a.upper(), b.upper())};
}
double smaller_of(double a, double b) { return std::min(a, b); }

constexpr double whole_turn = 2.0;  // in half turns

/// How far a coordinate is from a range, for angles the shorter way round.
template <class Scalar>
Scalar distance_along(double center, double lower, double upper, bool turns) {
  const Scalar c(center), below = Scalar(lower) - c, above = c - Scalar(upper), zero(0.0);
  const Scalar straight = larger_of(zero, larger_of(below, above));
  if (!turns) return straight;
  return smaller_of(straight, larger_of(zero, Scalar(whole_turn) + smaller_of(below, above)));
}

}  // namespace

ShapeGauge::ShapeGauge(const WorkspaceQuestion& question, std::size_t dimension, bool turns)
    : dimension_(dimension), turns_(turns) {
  const std::vector<double>& ratio = question.ratio;
  const bool is_round = question.shape == RegularShape::disc || question.shape == RegularShape::ball ||
                        question.shape == RegularShape::cylinder;
  for (std::size_t i = 0; i < dimension; ++i) {
    group_[i] = is_round ? 0 : i;
    // Half an edge is as far as the box goes from its center.
    scale_[i] = is_round ? 1.0 : ratio.empty() ? 2.0 : 2.0 * ratio[0] / ratio[i];
  }
  if (question.shape == RegularShape::cylinder) {
    group_[2] = 1;
    scale_[2] = ratio.empty() ? 1.0 : 1.0 / ratio[0];
  }
}

template <class Scalar>
Scalar ShapeGauge::norm(const std::array<Scalar, max_map_dimension>& displacement) const noexcept {
  std::array<Scalar, max_map_dimension> sums{};
  for (std::size_t i = 0; i < dimension_; ++i)
    sums[group_[i]] = sums[group_[i]] + squared(Scalar(scale_[i]) * displacement[i]);
  Scalar largest(0.0);
  for (std::size_t i = 0; i < dimension_; ++i) largest = larger_of(largest, sums[i]);
  return rooted(largest);
}

double ShapeGauge::distance(const MapPoint& center, const Box& box) const noexcept {
  std::array<double, max_map_dimension> displacement{};
  for (std::size_t i = 0; i < dimension_; ++i)
    displacement[i] = distance_along<double>(center[i], box.lower[i], box.upper[i], turns_);
  return norm(displacement);
}

double ShapeGauge::distance_at_least(const MapPoint& center, const Box& box) const noexcept {
  std::array<Interval, max_map_dimension> displacement{};
  for (std::size_t i = 0; i < dimension_; ++i)
    displacement[i] = distance_along<Interval>(center[i], box.lower[i], box.upper[i], turns_);
  return norm(displacement).lower();
}

MapPoint ShapeGauge::nearest(const MapPoint& center, const Box& box) const noexcept {
  MapPoint result = box.nearest(center);
  for (std::size_t i = 0; turns_ && i < dimension_; ++i) {
    const double below = box.lower[i] - center[i], above = center[i] - box.upper[i];
    if (std::max(below, above) > whole_turn + std::min(below, above))  // the other way round
      result[i] = below < above ? box.lower[i] : box.upper[i];
  }
  return result;
}

double ShapeGauge::half_extent(const Box& box) const noexcept {
  const MapPoint middle = box.middle();
  std::array<double, max_map_dimension> displacement{};
  for (std::size_t i = 0; i < dimension_; ++i)
    displacement[i] = std::max(box.upper[i] - middle[i], middle[i] - box.lower[i]);
  return norm(displacement);
}

double ShapeGauge::room(const MapPoint& center, const Box& box) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < dimension_; ++i)
    least =
        std::min(least, scale_[i] * (turns_ ? 0.5 * whole_turn
                                            : std::min(box.upper[i] - center[i], center[i] - box.lower[i])));
  return std::max(0.0, least);
}

double ShapeGauge::room_at_least(const MapPoint& center, const Box& box) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < dimension_; ++i) {
    const Interval scale(scale_[i]), c(center[i]);
    const Interval to_end = turns_ ? Interval(0.5 * whole_turn)
                                   : smaller_of(Interval(box.upper[i]) - c, c - Interval(box.lower[i]));
    least = std::min(least, (scale * to_end).lower());
  }
  return std::max(0.0, least);
}

namespace {

// Leaves that are examined for one center. Where it takes more, much around it stays open.
constexpr std::size_t most_looks = 5000;

}  // namespace

UsableLeaves::UsableLeaves(const AspectMap::Contents& map, std::size_t mode, int sign,
                           const ShapeGauge& gauge, const AngleBounds& angles)
    : classifier_(*map.classifier),
      region_(map.tree.region()),
      mode_(mode),
      sign_(sign),
      gauge_(gauge),
      angles_(angles) {
  leaves_.emplace_back();
  copy(map, 0, 0);
}

UsableLeaves::State UsableLeaves::state_of(LeafState state) const {
  if (state.is_inside(sign_)) return State::usable;
  return state.may_be(sign_) ? State::open : State::obstacle;
}

void UsableLeaves::copy(const AspectMap::Contents& map, NodeIndex node, NodeIndex leaf) {
  const LeafState state = map.tree.state(node, mode_);
  if (!state.is_divided()) {
    leaves_[leaf] = {no_node, map.leaf_aspect(node, mode_), state_of(state)};
    return;
  }
  const auto first = static_cast<NodeIndex>(leaves_.size());
  leaves_[leaf] = {first, 0, State::divided};
  leaves_.resize(leaves_.size() + map.tree.children_per_node());
  for (NodeIndex rank = 0; rank < map.tree.children_per_node(); ++rank)
    copy(map, map.tree.first_child(node) + rank, first + rank);
}

void UsableLeaves::divide(NodeIndex leaf, const Box& box) {
  const auto first = static_cast<NodeIndex>(leaves_.size());
  leaves_[leaf] = {first, 0, State::divided};
  for (NodeIndex rank = 0; rank < NodeIndex{1} << box.dimension; ++rank)
    leaves_.push_back({no_node, 0, state_of(classifier_.state(0, part_of(box, rank), mode_))});
}

bool UsableLeaves::meets(const Box& box, const Box& angles) const {
  for (std::size_t i = gauge_.dimension(); i < box.dimension; ++i)
    if (box.upper[i] < angles.lower[i] || box.lower[i] > angles.upper[i]) return false;
  return true;
}

bool UsableLeaves::meets_over(const Box& positions, const Box& box) const {
  for (std::size_t i = 0; i < gauge_.dimension(); ++i)
    if (box.upper[i] < positions.lower[i] || box.lower[i] > positions.upper[i]) return false;
  return meets_angles(box);
}

Box UsableLeaves::positions() const {
  Box box = region_;
  box.dimension = gauge_.dimension();
  return box;
}

ShapeRoom UsableLeaves::room(const MapPoint& center, double extent, double enough) {
  assert_rounding_upward();
  ShapeRoom room;
  room.upper = gauge_.room(center, region_);
  room.lower = gauge_.room_at_least(center, region_);
  if (room.upper == 0.0) return room;
  queue_ = {};
  push(center, 0, region_, room);
  const std::size_t last_look = looks_ + most_looks;
  while (!queue_.empty() && queue_.top().distance < room.upper && room.upper > enough && looks_ < last_look) {
    ++looks_;
    const Near near = queue_.top();
    queue_.pop();
    look_at(center, extent, near, room);
  }
  // What is left in the queue may hold what is nearer than that.
  if (!queue_.empty() && queue_.top().distance < room.upper)
    room.lower = std::min(room.lower, queue_.top().distance);
  return room;
}

// Left out are leaves that are usable, and those that are no nearer than what limits the room already. An
// obstacle limits `upper` only where an angle of it is proved to be asked for.
void UsableLeaves::push(const MapPoint& center, NodeIndex leaf, const Box& box, ShapeRoom& room) {
  const State state = leaves_[leaf].state;
  if (state == State::usable || !meets_angles(box)) return;
  const double at_least = gauge_.distance_at_least(center, box);
  if (at_least >= room.upper) return;
  if (state != State::obstacle) return queue_.push({at_least, leaf, box});
  room.lower = std::min(room.lower, at_least);
  if (!meets(box, angles_.inner)) return;
  if (const double distance = gauge_.distance(center, box); distance < room.upper) {
    room.upper = distance;
    room.obstacle = gauge_.nearest(center, box);
  }
}

void UsableLeaves::look_at(const MapPoint& center, double extent, const Near& near, ShapeRoom& room) {
  if (leaves_[near.leaf].state == State::open) {
    // Behind what stays open, the farther a leaf is the less it tells.
    const double beyond = std::max(0.0, near.distance - room.lower);
    if (2.0 * gauge_.half_extent(near.box) <= std::max(extent, 0.5 * beyond)) {
      room.lower = std::min(room.lower, near.distance);
      return;
    }
    divide(near.leaf, near.box);
  }
  const NodeIndex first = leaves_[near.leaf].first_child;
  for (NodeIndex rank = 0; rank < NodeIndex{1} << near.box.dimension; ++rank)
    push(center, first + rank, part_of(near.box, rank), room);
}

bool UsableLeaves::holds(const MapPoint& center, double size) const {
  return size <= gauge_.room_at_least(center, region_) && holds(center, size, 0, region_);
}

bool UsableLeaves::holds(const MapPoint& center, double size, NodeIndex leaf, const Box& box) const {
  const Leaf& at = leaves_[leaf];
  if (at.state == State::usable || !meets_angles(box) || gauge_.distance_at_least(center, box) > size)
    return true;
  if (at.state != State::divided) return false;
  for (NodeIndex rank = 0; rank < NodeIndex{1} << box.dimension; ++rank)
    if (!holds(center, size, at.first_child + rank, part_of(box, rank))) return false;
  return true;
}

int UsableLeaves::aspect_of(const MapPoint& center, double size) const {
  return aspect_of(center, size, 0, region_);
}

int UsableLeaves::aspect_of(const MapPoint& center, double size, NodeIndex leaf, const Box& box) const {
  const Leaf& at = leaves_[leaf];
  if (!meets_angles(box) || gauge_.distance(center, box) > size) return 0;
  if (at.state != State::divided) return at.state == State::usable ? at.aspect : 0;
  const NodeIndex nearest = box.rank_of(center);
  for (NodeIndex rank = 0; rank < NodeIndex{1} << box.dimension; ++rank)
    if (const int found =
            aspect_of(center, size, at.first_child + (rank ^ nearest), part_of(box, rank ^ nearest));
        found != 0)
      return found;
  return 0;
}

bool UsableLeaves::may_hold(const std::vector<int>& aspects, const Box& positions) const {
  return may_hold(aspects, positions, 0, region_);
}

bool UsableLeaves::may_hold(const std::vector<int>& aspects, const Box& positions, NodeIndex leaf,
                            const Box& box) const {
  const Leaf& at = leaves_[leaf];
  if (at.state == State::obstacle || !meets_over(positions, box)) return false;
  if (at.state == State::open) return true;
  if (at.state == State::usable)
    return at.aspect == 0 || std::find(aspects.begin(), aspects.end(), at.aspect) != aspects.end();
  for (NodeIndex rank = 0; rank < NodeIndex{1} << box.dimension; ++rank)
    if (may_hold(aspects, positions, at.first_child + rank, part_of(box, rank))) return true;
  return false;
}

}  // namespace parallel_aspects
